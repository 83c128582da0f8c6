#include "draw/sheet_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <memory>
#include <set>
#include <vector>

#include "draw/units.h"
#include "tagmint/codec/decoder.h"

namespace tagmint::draw {
namespace {

constexpr double kTolerance_mm = 0.05;
constexpr double kTolerance_px = 0.3;
constexpr double kCell_px = 8.0;  // with fewer, a picture is enlarged
constexpr double kLeastDpi = 200.0;
constexpr double kMostPixels = 1 << 26;  // of a page that is drawn to be read: 256 MB

/// Corners from the lines of the border square alone: exact on drawn edges, which have no blur.
detect::DetectorOptions reading_options() {
  detect::DetectorOptions options;
  options.refine_photometric = false;
  return options;
}

/// Decoders without corrected errors: what was written has none.
std::vector<std::shared_ptr<const codec::Decoder>> decoders_of(std::span<const TagGroup> groups) {
  std::vector<std::shared_ptr<const codec::Decoder>> decoders;
  std::set<const codec::Family*> seen;
  for (const TagGroup& group : groups) {
    if (!seen.insert(group.family.get()).second) continue;
    decoders.push_back(std::make_shared<const codec::Decoder>(
        group.family, codec::DecoderOptions{.max_errors = 0,
                                            .allow_unsafe_radius = false,
                                            .engine = codec::DecoderEngine::Auto,
                                            .ids = {}}));
  }
  return decoders;
}

double smallest_cell_mm(const SheetPlan& plan, std::size_t page) {
  double smallest = kMaxPageMm;
  for (const PlacedTag& tag : plan.pages[page].tags) {
    const TagGroup& group = plan.groups[tag.group];
    smallest = std::min(smallest, group.edge_mm / group.family->layout().width_at_border());
  }
  return smallest;
}

void invert(detect::Image& picture) {
  for (int y = 0; y < picture.height(); ++y) {
    std::uint8_t* const row = picture.row(y);
    std::transform(row, row + picture.width(), row,
                   [](std::uint8_t gray) { return static_cast<std::uint8_t>(255 - gray); });
  }
}

/// The picture with each pixel as a square of `factor` pixels.
detect::Image enlarged(const detect::Image& picture, int factor) {
  detect::Image large(picture.width() * factor, picture.height() * factor);
  for (int y = 0; y < large.height(); ++y) {
    const std::uint8_t* const source = picture.row(y / factor);
    std::uint8_t* const row = large.row(y);
    for (int x = 0; x < large.width(); ++x) row[x] = source[x / factor];
  }
  return large;
}

/// Largest distance between corners, in mm.
double corner_error_mm(const detect::Detection& found, const detect::Corners& planned_mm,
                       double pixels_a_mm) {
  double largest = 0.0;
  for (int k = 0; k < 4; ++k) {
    largest = std::max(largest, std::hypot(found.corners[k].x / pixels_a_mm - planned_mm[k].x,
                                           found.corners[k].y / pixels_a_mm - planned_mm[k].y));
  }
  return largest;
}

}  // namespace

detect::Corners planned_corners_mm(const SheetPlan& plan, const PlacedTag& tag) {
  const double edge = plan.groups[tag.group].edge_mm;
  const double border = (tag.outer.width_mm - edge) / 2;
  const double left = tag.outer.x_mm + border;
  const double top = tag.outer.y_mm + border;
  return {{{left, top + edge}, {left + edge, top + edge}, {left + edge, top}, {left, top}}};
}

SheetChecker::SheetChecker(std::span<const TagGroup> groups, bool inverted)
    : inverted_(inverted), detector_(decoders_of(groups), reading_options()) {}

double SheetChecker::reading_dpi(const SheetPlan& plan, std::size_t page) {
  const double wanted = std::max(kLeastDpi, kCell_px * kMmAnInch / smallest_cell_mm(plan, page));
  const double area = plan.options.page_width_mm * plan.options.page_height_mm;
  return std::min(wanted, std::sqrt(kMostPixels / area) * kMmAnInch);
}

PageCheck SheetChecker::check(ReadPage drawn, const SheetPlan& plan, std::size_t page,
                              double slack_mm) {
  if (inverted_) invert(drawn.picture);
  const double cell_px = smallest_cell_mm(plan, page) * drawn.pixels_a_mm;
  const double tolerance_mm = slack_mm + std::max(kTolerance_mm, kTolerance_px / drawn.pixels_a_mm);
  const int factor = std::max(1, static_cast<int>(std::ceil(kCell_px / cell_px - 0.5)));
  const double area_px = double(drawn.picture.width()) * drawn.picture.height();
  if (factor > 1 && area_px * factor * factor <= kMostPixels) {
    drawn = {enlarged(drawn.picture, factor), drawn.pixels_a_mm * factor};
  }
  std::multimap<codec::TagId, detect::Detection> found;
  for (detect::Detection& tag : detector_.detect(drawn.picture)) {
    const codec::TagId id = tag.id;
    found.emplace(id, std::move(tag));
  }
  PageCheck result;
  for (const PlacedTag& tag : plan.pages[page].tags) {
    const TagGroup& group = plan.groups[tag.group];
    const detect::Corners planned = planned_corners_mm(plan, tag);
    std::optional<double> nearest;
    const auto [first, last] = found.equal_range(tag.id);
    for (auto candidate = first; candidate != last; ++candidate) {
      if (candidate->second.family != group.family) continue;
      const double error = corner_error_mm(candidate->second, planned, drawn.pixels_a_mm);
      if (!nearest || error < *nearest) nearest = error;
    }
    if (!nearest || *nearest > tolerance_mm) {
      result.fault = TagFault{
          group.family->name(), tag.id,
          !nearest ? "is not found" : fmt::format("is {} from its place", format_mm(*nearest))};
      return result;
    }
    ++result.tags;
    result.largest_error_mm = std::max(result.largest_error_mm, *nearest);
  }
  return result;
}

}  // namespace tagmint::draw
