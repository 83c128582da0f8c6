#pragma once

#include <cstdint>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace tagmint::cli {

/// Adds --seed N, any whole number of 64 bits; `seed` as it is is the default.
CLI::Option* add_seed(CLI::App& app, std::uint64_t& seed);

}  // namespace tagmint::cli
