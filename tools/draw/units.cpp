#include "draw/units.h"

#include <fmt/format.h>

namespace tagmint::draw {

std::string format_mm(double length_mm, const char* separator) {
  std::string number = fmt::format("{:.3f}", length_mm);
  number.erase(number.find_last_not_of('0') + 1);
  if (number.back() == '.') number.pop_back();
  return number + separator + "mm";
}

}  // namespace tagmint::draw
