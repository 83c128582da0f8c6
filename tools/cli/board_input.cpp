#include "cli/board_input.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>

#include "cli/command.h"
#include "cli/drawing_target.h"
#include "cli/length.h"
#include "cli/number.h"
#include "io/streams.h"
#include "scene/json_reader.h"
#include "tagmint/codec/builtin_families.h"

namespace tagmint::cli {
namespace {

using board::BoardTag;

// Of numbers in files: places that a page can hold.
constexpr double kFarMm = draw::kMaxPageMm;

std::optional<std::uint64_t> whole_number(std::string_view text) {
  std::uint64_t value = 0;
  const char* end_of_text = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), end_of_text, value);
  if (error != std::errc() || end != end_of_text || text.empty()) return std::nullopt;
  return value;
}

/// A length that may be negative: a place.
double parse_place_mm(std::string_view text, std::string_view option) {
  const std::string_view trim = trimmed(text);
  if (trim.starts_with('-')) return -parse_length_mm(trim.substr(1), option);
  return parse_length_mm(trim, option);
}

double parse_turn_deg(std::string_view text, std::string_view option) {
  const auto number = leading_number(trimmed(text));
  if (!number || trimmed(number->rest) != "deg" || number->value < -360 || number->value > 360) {
    throw UsageError(fmt::format("'{}' is not a turn", text), option,
                     "write degrees clockwise from -360deg to 360deg, like 90deg");
  }
  return number->value;
}

double parse_edge_mm(std::string_view text, std::string_view option) {
  const double edge = parse_length_mm(text, option);
  if (edge < kLeastEdgeMm) {
    throw UsageError(fmt::format("tags with an edge below {} mm cannot be printed", kLeastEdgeMm),
                     option, "give a larger size, like 40mm");
  }
  return edge;
}

codec::TagId parse_id(std::string_view text, const codec::Family& family, std::string_view option) {
  const auto id = whole_number(text);
  if (!id) {
    throw UsageError(fmt::format("'{}' is not an id", text), option, "write a number, like 7");
  }
  if (*id >= family.size()) {
    throw UsageError(fmt::format("id {} is not in {}", text, family.name()), option,
                     fmt::format("its ids are 0-{}", family.size() - 1));
  }
  return static_cast<codec::TagId>(*id);
}

std::vector<std::string_view> parts(std::string_view text) {
  std::vector<std::string_view> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    parts.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

/// Takes what follows the last colon from `text`; nothing where there is none.
std::optional<std::string_view> cut_last(std::string_view& text) {
  const std::size_t colon = text.rfind(':');
  if (colon == std::string_view::npos) return std::nullopt;
  const std::string_view part = text.substr(colon + 1);
  text = text.substr(0, colon);
  return part;
}

BoardTag bundle_tag(const scene::JsonValue& json) {
  json.require_keys({"family", "id", "edge_mm", "outer_mm", "center_mm", "turn_deg"});
  const codec::SharedFamily family = codec::load_family(json.at("family").text());
  const auto id = static_cast<codec::TagId>(json.at("id").whole(0, family->size() - 1));
  if (json.has("edge_mm") == json.has("outer_mm")) {
    json.fail("needs one of edge_mm and outer_mm", "give the side of the border square or of all");
  }
  const double edge =
      json.has("edge_mm")
          ? json.at("edge_mm").number(kLeastEdgeMm, kFarMm)
          : draw::edge_of_outer(family->layout(), json.at("outer_mm").number(kLeastEdgeMm, kFarMm));
  const auto place = json.at("center_mm").numbers<2>();
  const double turn = json.has("turn_deg") ? json.at("turn_deg").number(-360, 360) : 0.0;
  return board::make_tag(family, id, edge, {place[0], place[1]}, turn);
}

}  // namespace

GridSize parse_grid(std::string_view text) {
  const std::size_t cross = text.find('x');
  const std::string_view after = cross == std::string_view::npos ? "" : text.substr(cross + 1);
  const std::uint64_t columns = whole_number(text.substr(0, cross)).value_or(0);
  const std::uint64_t rows = whole_number(after).value_or(0);
  for (const std::uint64_t count : {columns, rows}) {
    if (count < 1 || count > kMostGridSide) {
      throw UsageError(
          fmt::format("'{}' is not a grid", text), "--grid",
          fmt::format("write columns x rows, each from 1 to {}, like 6x7", kMostGridSide));
    }
  }
  return {static_cast<int>(columns), static_cast<int>(rows)};
}

double parse_spacing_mm(std::string_view text, double edge_mm) {
  constexpr std::string_view kOption = "--spacing";
  const auto number = leading_number(trimmed(text));
  if (number && number->value <= 0) {
    throw UsageError(fmt::format("the spacing '{}' is not above 0", text), kOption,
                     "give the gap between border squares as a share of the edge, like 0.3, or as "
                     "a length, like 12mm");
  }
  if (number && trimmed(number->rest).empty()) return number->value * edge_mm;
  return parse_length_mm(text, kOption);
}

draw::NestedRequest parse_nested(std::string_view text) {
  constexpr std::string_view kOption = "--nested";
  std::string_view rest = text;
  std::optional<std::string_view> id = cut_last(rest);
  draw::NestedRequest request;
  if (id && !whole_number(*id)) {
    request.edge_mm = parse_edge_mm(*id, kOption);
    id = cut_last(rest);
  }
  if (!id || rest.empty()) {
    throw UsageError(fmt::format("'{}' names no tag", text), kOption,
                     "write FAMILY:ID or FAMILY:ID:EDGE, like tag36h11:7");
  }
  request.family = codec::load_family(std::string(rest));
  request.id = parse_id(*id, *request.family, kOption);
  return request;
}

BoardTag parse_bundle_tag(std::string_view text) {
  constexpr std::string_view kOption = "--tag";
  const std::size_t at = text.rfind('@');
  std::string_view rest = text.substr(0, at);
  const auto edge = cut_last(rest);
  const auto id = cut_last(rest);
  const std::vector<std::string_view> place =
      at == std::string_view::npos ? std::vector<std::string_view>{} : parts(text.substr(at + 1));
  if (!edge || !id || rest.empty() || place.size() < 2 || place.size() > 3) {
    throw UsageError(fmt::format("'{}' is not a tag with its place", text), kOption,
                     "write FAMILY:ID:EDGE@X,Y or FAMILY:ID:EDGE@X,Y,TURN, like "
                     "tag36h11:0:60mm@-40mm,0mm,90deg");
  }
  const codec::SharedFamily family = codec::load_family(std::string(rest));
  return board::make_tag(family, parse_id(*id, *family, kOption), parse_edge_mm(*edge, kOption),
                         {parse_place_mm(place[0], kOption), parse_place_mm(place[1], kOption)},
                         place.size() > 2 ? parse_turn_deg(place[2], kOption) : 0.0);
}

std::vector<BoardTag> read_bundle(const std::string& path) {
  const std::string source = io::input_name(path);
  const nlohmann::json json = scene::parse_json(io::read_input(path), source);
  const scene::JsonValue root(json, source, "", "the bundle");
  root.require_keys({"tags"});
  std::vector<BoardTag> tags;
  for (const scene::JsonValue& tag : root.at("tags").elements()) tags.push_back(bundle_tag(tag));
  if (tags.empty()) root.at("tags").fail("is empty", "give at least one tag");
  return tags;
}

}  // namespace tagmint::cli
