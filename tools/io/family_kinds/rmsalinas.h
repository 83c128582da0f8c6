#pragma once

#include "io/family_kinds/family_kind.h"

namespace tagmint::io {

/// The dictionary of the ArUco library of R. Munoz-Salinas: `name X`, `nbits N`, then one tag a
/// line as characters 0 and 1, row by row from the top left, 1 = white.
FamilyKind rmsalinas_kind();

}  // namespace tagmint::io
