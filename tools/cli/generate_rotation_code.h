#pragma once

#include <string>

#include "cli/command.h"
#include "tagmint/codec/layout.h"

namespace tagmint::cli {

/// `generate --method rotation-code`: the options as they were given; empty = not given.
struct RotationCodeRequest {
  codec::Layout layout;
  int min_hamming = 0;
  std::string levels;      ///< "16,12,10"
  std::string codes;       ///< how many are enough
  std::string complexity;  ///< energy:0.3333 where it is not given
  std::string order;       ///< seed:N or nothing
  int attempts = 1;
  std::string name;
  std::string output;
};

/// Searches the family, writes it and tells on stderr how it was made, its levels, what the
/// complexity rule left, and how many tags there could be at most. Returns the exit code; throws
/// UsageError, OutputError and Interrupted.
int generate_rotation_code(const RotationCodeRequest& request, const Common& common);

}  // namespace tagmint::cli
