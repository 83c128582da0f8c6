#pragma once

#include <string>

#include "draw/path.h"

namespace tagmint::draw {

/// Appends the operators m, l, c and h that build a path in a PDF, and in PostScript with our
/// prolog; points are in the path's unit.
///   digits   kept after the point
void append_path_operators(std::string& out, const Path& path, int digits);

}  // namespace tagmint::draw
