#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "evaluate/contender.h"

namespace tagmint::evaluate {

/// Where peers are looked for: the folder that the environment's TAGMINT_PEERS names, else `peers`
/// beside the running program (a build folder), else where `cmake --install` puts them.
std::vector<std::filesystem::path> peer_folders();

/// Detectors of others, found at run time (peers/peer_interface.h).
struct Peers {
  std::vector<ContenderKind> kinds;
  std::vector<std::string> left_out;  ///< a line for each library that could not be used, and why
};

/// Opens the shared libraries of the first folder that has any, in the order of their names. They
/// stay open.
Peers find_peers(const std::vector<std::filesystem::path>& folders = peer_folders());

}  // namespace tagmint::evaluate
