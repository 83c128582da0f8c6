#include "tagmint/codec/errors.h"

namespace tagmint::codec {
namespace {

std::string one_line(std::string_view what, std::string_view where, std::string_view mend) {
  std::string line(what);
  if (!where.empty()) line.append(" (").append(where).append(")");
  if (!mend.empty()) line.append("; ").append(mend);
  return line;
}

}  // namespace

Fault::Fault(std::string_view what, std::string_view where, std::string_view mend)
    : std::runtime_error(one_line(what, where, mend)) {}

}  // namespace tagmint::codec
