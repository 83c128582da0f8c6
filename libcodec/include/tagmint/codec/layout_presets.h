#pragma once

#include <string>
#include <string_view>

#include "tagmint/codec/export.h"
#include "tagmint/codec/layout.h"

namespace tagmint::codec {

/// The classic AprilTag look, `width` cells wide in all: a white ring, a black ring, data inside.
/// width 5..12.
TAGMINT_API Layout classic_layout(int width);

/// The AprilTag 3 look: a ring of data, a black ring, a white ring, data inside. width 7..13.
TAGMINT_API Layout standard_layout(int width);

/// The round AprilTag 3 look: like standard, but cells whose centre is farther than width/2 - 0.25
/// from the middle are left out. width 7..15, those with at most 64 data cells.
TAGMINT_API Layout circle_layout(int width);

/// A layout from its name: `classic:W`, `standard:W`, `circle:W`, `custom:ROWS`.
/// Throws std::invalid_argument with what is wrong and the nearest name that would do.
TAGMINT_API Layout parse_layout(std::string_view name);

/// The shortest name that parse_layout() turns back into this layout.
TAGMINT_API std::string layout_name(const Layout& layout);

/// "", "Standard", "Circle" or "Custom": the part of a family's name that its layout gives (tag +
/// this + 36h11).
TAGMINT_API std::string layout_family_prefix(const Layout& layout);

}  // namespace tagmint::codec
