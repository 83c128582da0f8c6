#pragma once

#include "io/family_kinds/family_kind.h"

namespace tagmint::io {

/// A table `id,codeword,cells`: the codeword as 0x and 16 hex digits in the layout's order, the
/// cells of the whole tag as rows of b, w and x with '/' between them.
FamilyKind csv_kind();

}  // namespace tagmint::io
