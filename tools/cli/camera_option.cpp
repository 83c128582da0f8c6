#include "cli/camera_option.h"

#include <fmt/format.h>

#include <stdexcept>

#include "cli/command.h"
#include "cli/number.h"
#include "cli/options.h"

namespace tagmint::cli {

std::vector<double> parse_numbers(std::string_view text, std::size_t count, std::string_view option,
                                  std::string_view names) {
  std::vector<double> numbers;
  const auto fault = [&](const std::string& what) {
    return UsageError(what, option, fmt::format("give {}", names));
  };
  std::string_view rest = text;
  while (true) {
    const std::size_t comma = rest.find(',');
    const std::string_view part = trimmed(rest.substr(0, comma));
    const auto number = leading_number(part);
    if (!number || !number->rest.empty()) throw fault(fmt::format("'{}' is no number", part));
    numbers.push_back(number->value);
    if (comma == std::string_view::npos) break;
    rest.remove_prefix(comma + 1);
  }
  if (numbers.size() != count) {
    throw fault(fmt::format("'{}' has {} numbers, {} are needed", text, numbers.size(), count));
  }
  return numbers;
}

detect::Camera parse_camera(std::string_view camera, std::string_view distortion) {
  const std::vector<double> pinhole = parse_numbers(camera, 4, "--camera", "FX,FY,CX,CY in pixels");
  detect::Camera result{.fx = pinhole[0], .fy = pinhole[1], .cx = pinhole[2], .cy = pinhole[3]};
  if (!distortion.empty()) {
    const std::vector<double> d = parse_numbers(distortion, 5, "--distortion", "K1,K2,P1,P2,K3");
    result.k1 = d[0];
    result.k2 = d[1];
    result.p1 = d[2];
    result.p2 = d[3];
    result.k3 = d[4];
  }
  try {
    detect::check_camera(result);
  } catch (const std::invalid_argument& complaint) {
    throw usage_error(complaint, "--camera");
  }
  return result;
}

}  // namespace tagmint::cli
