#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "draw/sheet_plan.h"

namespace tagmint::cli {

/// The parts of FAMILY[:EDGE[:IDS]]; empty where they are not given.
struct TagRequest {
  std::string family;
  std::string edge;
  std::string ids;
};

/// Splits FAMILY[:EDGE[:IDS]] from its end, so that the path of a family file may hold colons. An
/// edge may be left out before ids: "tag36h11::0-9".
TagRequest split_tag_request(std::string_view text);

/// What holds for requests that do not say it themselves.
struct TagDefaults {
  std::optional<double> edge_mm;
  std::optional<double> outer_mm;  ///< used where neither the request nor edge_mm gives a size
  std::string ids;                 ///< an id list; empty = all of the family
};

/// Loads the family and reads size and ids. Throws UsageError when there is no size or it is zero,
/// or the ids are not the family's; InputError when the family cannot be read.
draw::TagGroup resolve_tag_request(const std::string& text, const TagDefaults& defaults);

}  // namespace tagmint::cli
