#include "cli/tag_request.h"

#include <fmt/format.h>

#include <numeric>

#include "cli/command.h"
#include "cli/id_list.h"
#include "cli/length.h"
#include "tagmint/codec/builtin_families.h"

namespace tagmint::cli {
namespace {

/// Below this the cells come near the steps of 1/256 pt in which a PDF is drawn.
constexpr double kMinEdge_mm = 0.1;

/// "0-3" and "1,2": ids where the size would stand. A lone number is more likely a bare length.
bool looks_like_ids(std::string_view text) {
  return text.find_first_of("-,") != std::string_view::npos && !text.starts_with('-') &&
         text.find_first_not_of("0123456789-,") == std::string_view::npos;
}

double edge_of(const TagRequest& request, const std::string& text, const TagDefaults& defaults,
               const codec::Layout& layout) {
  double edge_mm = 0.0;
  if (looks_like_ids(request.edge)) {
    throw UsageError(fmt::format("'{}' stands where the size belongs", request.edge), text,
                     fmt::format("write {0}::{1} or {0}:40mm:{1}", request.family, request.edge));
  }
  if (!request.edge.empty()) {
    edge_mm = parse_length_mm(request.edge, text);
  } else if (defaults.edge_mm) {
    edge_mm = *defaults.edge_mm;
  } else if (defaults.outer_mm) {
    edge_mm = draw::edge_of_outer(layout, *defaults.outer_mm);
  } else {
    throw UsageError("the size of the tags is missing", text,
                     fmt::format("give --edge 40mm (side of the border square), --outer 50mm (side "
                                 "of the whole tag) or {}:40mm",
                                 request.family));
  }
  if (edge_mm < kMinEdge_mm) {
    throw UsageError(fmt::format("tags with an edge below {} mm cannot be printed", kMinEdge_mm),
                     text, "give a larger size, like 40mm");
  }
  return edge_mm;
}

}  // namespace

TagRequest split_tag_request(std::string_view text) {
  const auto cut = [&text]() -> std::optional<std::string> {
    const std::size_t colon = text.rfind(':');
    if (colon == std::string_view::npos) return std::nullopt;
    std::string part(text.substr(colon + 1));
    text.remove_suffix(text.size() - colon);
    return part;
  };
  TagRequest request;
  std::optional<std::string> last = cut();
  // Ids hold nothing but digits, '-' and ','; a size ends with its unit.
  if (last && text.find(':') != std::string_view::npos &&
      last->find_first_not_of("0123456789-,") == std::string::npos) {
    request.ids = *last;
    last = cut();
  }
  request.edge = last.value_or("");
  request.family = text;
  return request;
}

draw::TagGroup resolve_tag_request(const std::string& text, const TagDefaults& defaults) {
  const TagRequest request = split_tag_request(text);
  draw::TagGroup group;
  group.family = codec::load_family(request.family);
  group.edge_mm = edge_of(request, text, defaults, group.family->layout());
  const std::size_t size = group.family->size();
  if (!request.ids.empty()) {
    group.ids = parse_id_list(request.ids, size, text);
  } else if (!defaults.ids.empty()) {
    group.ids = parse_id_list(defaults.ids, size, "--ids");
  } else {
    group.ids.resize(size);
    std::iota(group.ids.begin(), group.ids.end(), codec::TagId{0});
  }
  return group;
}

}  // namespace tagmint::cli
