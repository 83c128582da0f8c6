#pragma once

#include "io/family_kinds/family_kind.h"

namespace tagmint::io {

/// A folder of pictures in the form of the apriltag-imgs collection: tag36_11_00000.png, ... with
/// one pixel a cell, transparent where the layout has no cell, and mosaic.png with all tags.
FamilyKind png_folder_kind();

}  // namespace tagmint::io
