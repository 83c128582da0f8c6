#include "cluster/launcher.h"

#include <charconv>
#include <cstdlib>
#include <string_view>

namespace tagmint::cluster {
namespace {

std::optional<int> number_in_environment(const char* name) {
  const char* value = std::getenv(name);
  if (value == nullptr) return std::nullopt;
  const std::string_view text = value;
  int number = 0;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || rest != text.data() + text.size() || number < 0) return std::nullopt;
  return number;
}

}  // namespace

std::optional<Launch> read_launch() {
  if (const auto rank = number_in_environment("OMPI_COMM_WORLD_RANK")) {
    return Launch{*rank, number_in_environment("OMPI_COMM_WORLD_SIZE").value_or(0)};
  }
  if (const auto rank = number_in_environment("PMI_RANK")) {
    return Launch{*rank, number_in_environment("PMI_SIZE").value_or(0)};
  }
  if (const auto rank = number_in_environment("PMIX_RANK")) {
    return Launch{*rank, number_in_environment("SLURM_STEP_NUM_TASKS").value_or(0)};
  }
  return std::nullopt;
}

}  // namespace tagmint::cluster
