#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "draw/ruler.h"
#include "draw/sheet_plan.h"
#include "draw/text_format.h"

namespace tagmint::draw {

/// What is printed besides the tags.
struct SheetDecor {
  std::optional<TextFormat> label;      ///< below each tag; its fields are label_fields()
  std::string title;                    ///< at the top of every page; empty = none
  bool notes = true;                    ///< at the bottom of every page: sizes, scale, page number
  RulerPlace ruler = RulerPlace::None;  ///< lying above the notes, or upright at the left
  bool cut_marks = false;               ///< at the slots' corners, in the gaps
  bool cut_lines = false;               ///< around each tag, see cut_outline()
  bool inverted = false;                ///< ink where tags and their quiet zones are white
};

/// Names of the fields that a tag's label may have.
std::span<const std::string_view> label_fields();

/// The values of a tag's fields; lengths as format_mm() writes them with that separator.
std::vector<FieldValue> tag_fields(const TagGroup& group, codec::TagId id,
                                   const char* unit_separator);

/// Heights for SheetOptions that `decor` needs, in mm.
double header_height_mm(const SheetDecor& decor);
double footer_height_mm(const SheetDecor& decor, std::size_t groups);
/// Width for SheetOptions that an upright ruler needs, in mm.
double side_width_mm(const SheetDecor& decor);
/// The height of labels, in proportion to the smallest tag.
double label_height_mm(const SheetDecor& decor, std::span<const TagGroup> groups);

// Heights on the page.
inline constexpr double kTitleHeightMm = 10.0;
inline constexpr double kNoteLineMm = 3.8;
inline constexpr double kNoteGapMm = 3.0;  ///< between the tags and what stands below them

}  // namespace tagmint::draw
