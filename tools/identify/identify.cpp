#include "identify/identify.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>

#include "identify/cell_grid.h"
#include "identify/evidence.h"
#include "identify/nearest_tags.h"
#include "identify/places.h"
#include "identify/reduce.h"
#include "tagmint/codec/rotation.h"
#include "tagmint/detect/homography.h"
#include "tagmint/detect/image.h"

namespace tagmint::identify {
namespace {

using codec::Cell;
using codec::Layout;
using codec::SharedFamily;
using detect::Corners;
using detect::Homography;
using detect::ImageView;
using detect::Point;

/// Families of one layout.
struct LayoutGroup {
  Layout layout;
  std::vector<SharedFamily> families;
};

std::vector<LayoutGroup> grouped(const std::vector<SharedFamily>& families) {
  std::vector<LayoutGroup> groups;
  for (const SharedFamily& family : families) {
    const auto known = std::find_if(groups.begin(), groups.end(), [&](const LayoutGroup& group) {
      return group.layout == family->layout();
    });
    if (known == groups.end()) {
      groups.push_back({family->layout(), {family}});
    } else {
      known->families.push_back(family);
    }
  }
  return groups;
}

/// Outer rings without a data cell.
int rings_without_data(const Layout& layout) {
  for (int ring = 0; 2 * ring < layout.width(); ++ring) {
    for (int i = ring; i < layout.width() - ring; ++i) {
      if (layout.cell(i, ring) == Cell::Data) return ring;
    }
  }
  return 0;
}

/// Cells around the tag that nothing should be printed in: none where its outer ring is white.
int quiet_cells(const Layout& layout) {
  for (int i = 0; i < layout.width(); ++i) {
    if (layout.cell(i, 0) != Cell::White) return 1;
  }
  return 0;
}

/// The angle of the tag's upward direction, clockwise from that of the picture; degrees, 0 <= . <
/// 360, to a tenth.
double turned_deg(const Corners& corners) {
  const Point up = (corners[2] + corners[3]) - (corners[0] + corners[1]);
  const double angle = std::atan2(up.x, -up.y) * 180 / std::numbers::pi;
  const double rounded = std::round(angle * 10) / 10;
  return rounded < 0 ? rounded + 360 : rounded + 0.0;
}

/// Whether the square of the tag and the cells around it that should stay empty is in the picture.
bool sees_quiet_zone(ImageView picture, const Homography& tag_to_image, const Layout& layout) {
  const double cell = 2.0 / layout.width_at_border();
  // To the middle of the last cell: half of it may be missing.
  const double reach = (layout.width() / 2.0 + quiet_cells(layout) - 0.5) * cell;
  return std::all_of(detect::kTagCorners.begin(), detect::kTagCorners.end(), [&](Point corner) {
    const Point p = tag_to_image.project(reach * corner);
    return p.x >= 0 && p.y >= 0 && p.x <= picture.width && p.y <= picture.height;
  });
}

Doubt doubt_of(const Reading& reading, bool mirrored) {
  return {.unclear = !reading.clear,
          .oddity = mirrored + reading.inverted + static_cast<int>(reading.border)};
}

bool more_convincing(const Candidate& a, const Candidate& b) {
  const auto key = [](const Candidate& c) {
    return std::make_tuple(c.accept_rate, c.doubt.unclear, c.doubt.oddity, c.family->size(), c.id);
  };
  return key(a) < key(b);
}

/// `has_rival`: a better candidate explains the same place otherwise.
bool is_believed(const Candidate& candidate, bool has_rival) {
  const bool doubtful = candidate.doubt.unclear || has_rival;
  return candidate.expected_accidents <= (doubtful ? kMostAccidentsDoubtful : kMostAccidents);
}

/// Whether a match may be believed at all: with no more errors than the family always corrects;
/// plain tags, which texture comes near to, without any.
bool is_possible(const codec::Family& family, const codec::Match& match) {
  return match.hamming <= (is_declared_plain(family, match.id) ? 0 : family.max_safe_errors());
}

double side_of(const Corners& corners) { return std::sqrt(std::abs(detect::signed_area(corners))); }

Point middle_of(const Corners& corners) {
  return 0.25 * (corners[0] + corners[1] + corners[2] + corners[3]);
}

/// Two tags do not share a place; a tag in the hole of another one is much smaller.
bool same_place(const Candidate& a, const Candidate& b) {
  const double larger = std::max(side_of(a.corners), side_of(b.corners));
  const double smaller = std::min(side_of(a.corners), side_of(b.corners));
  return smaller > larger / 2 &&
         detect::length(middle_of(a.corners) - middle_of(b.corners)) < smaller / 2;
}

/// The same cells in the picture: equal codewords in some turn, of one layout, read alike.
bool same_cells(const Candidate& a, const Candidate& b) {
  if (a.family->layout() != b.family->layout() || a.mirrored != b.mirrored ||
      a.inverted != b.inverted) {
    return false;
  }
  return codec::rotation_distance(a.family->codeword(a.id), b.family->codeword(b.id),
                                  a.family->bits()) == 0;
}

bool same_answer(const Candidate& a, const Candidate& b) {
  return a.family == b.family && a.id == b.id && a.mirrored == b.mirrored &&
         a.inverted == b.inverted;
}

/// Where a candidate was read, in a picture that may be a reduced one.
struct View {
  ImageView picture;
  double scale = 1;  ///< pixels of the user's picture for each one here
};

/// Reads places of one picture and gathers what they may be.
class Search {
 public:
  Search(const std::vector<LayoutGroup>& groups, NearestTags& nearest_tags)
      : groups_(groups), nearest_tags_(nearest_tags) {}

  void read(const View& view, const std::vector<Place>& places) {
    for (const Place& place : places) read_place(view, place);
  }

  bool believes_something() const { return !believed().empty(); }
  Identification result() const;

 private:
  void read_place(const View& view, const Place& place);
  void take_reading(const View& view, const Homography& tag_to_image, const LayoutGroup& group,
                    const Reading& reading, bool mirrored);
  bool is_new_word(const LayoutGroup& group, codec::Codeword word, const Doubt& doubt);
  std::vector<std::vector<Candidate>> by_place() const;
  std::vector<TagInPicture> believed() const;

  const std::vector<LayoutGroup>& groups_;
  NearestTags& nearest_tags_;
  Evidence evidence_;
  /// That were compared, by their doubt.
  std::map<std::tuple<const LayoutGroup*, bool, int>, std::set<codec::Codeword>> words_;
  std::vector<Candidate> candidates_;  // with few enough wrong cells to be believed
  std::optional<Candidate> nearest_;   // the least unlikely of all
};

void Search::read_place(const View& view, const Place& place) {
  const std::optional<Homography> tag_to_image = Homography::from_corners(place.corners);
  if (!tag_to_image) return;
  std::map<Frame, CellGrid> grids;
  for (const LayoutGroup& group : groups_) {
    const Frame frame = frame_of(group.layout);
    if (place.cells_at_border && *place.cells_at_border != frame.cells_at_border()) continue;
    auto known = grids.find(frame);
    if (known == grids.end()) {
      known = grids.emplace(frame, read_cells(view.picture, *tag_to_image, frame)).first;
    }
    const CellGrid& grid = known->second;
    for (const Reading& reading : read_tag(grid, group.layout)) {
      take_reading(view, *tag_to_image, group, reading, false);
    }
    // Columns from right to left: the tag plane is mirrored before it is mapped.
    const auto& h = tag_to_image->row_major();
    const Homography from_mirrored({-h[0], h[1], h[2], -h[3], h[4], h[5], -h[6], h[7], h[8]});
    for (const Reading& reading : read_tag(grid.mirrored(), group.layout)) {
      take_reading(view, from_mirrored, group, reading, true);
    }
  }
}

/// Whether this is the first time that the word is seen, whichever way up. The same print is seen
/// several times, in reduced pictures for one, and that is no further chance of an accident.
bool Search::is_new_word(const LayoutGroup& group, codec::Codeword word, const Doubt& doubt) {
  const int bits = group.layout.bits();
  codec::Codeword least = word;
  for (int turns = 1; turns < 4; ++turns) least = std::min(least, codec::rotate(word, bits, turns));
  return words_[{&group, doubt.unclear, doubt.oddity}].insert(least).second;
}

void Search::take_reading(const View& view, const Homography& tag_to_image,
                          const LayoutGroup& group, const Reading& reading, bool mirrored) {
  const Doubt doubt = doubt_of(reading, mirrored);
  const bool is_new = is_new_word(group, reading.word, doubt);
  for (const SharedFamily& family : group.families) {
    if (is_new) evidence_.count(*family, doubt);
    for (const codec::Match& match : nearest_tags_.find(family, reading.word)) {
      if (is_plain(group.layout, family->codeword(match.id))) continue;
      const Homography upright = tag_to_image.rotated(match.rotation);
      Candidate candidate{.family = family,
                          .id = match.id,
                          .hamming = match.hamming,
                          .mirrored = mirrored,
                          .turned_deg = 0,
                          .inverted = reading.inverted,
                          .border = reading.border,
                          .quiet_zone = sees_quiet_zone(view.picture, upright, group.layout),
                          .corners = {},
                          .doubt = doubt,
                          .accept_rate = Evidence::accept_rate(*family, match.hamming),
                          .expected_accidents = 0};
      for (std::size_t i = 0; i < candidate.corners.size(); ++i) {
        candidate.corners[i] = view.scale * upright.project(detect::kTagCorners[i]);
      }
      candidate.turned_deg = turned_deg(candidate.corners);
      if (!nearest_ || more_convincing(candidate, *nearest_)) nearest_ = candidate;
      if (is_possible(*family, match)) candidates_.push_back(std::move(candidate));
    }
  }
}

/// Candidates of one place together, the most convincing first; an answer only once.
std::vector<std::vector<Candidate>> Search::by_place() const {
  std::vector<Candidate> sorted = candidates_;
  std::stable_sort(sorted.begin(), sorted.end(), more_convincing);
  std::vector<std::vector<Candidate>> places;
  for (Candidate& candidate : sorted) {
    const auto place = std::find_if(places.begin(), places.end(), [&](const auto& known) {
      return same_place(known.front(), candidate);
    });
    if (place == places.end()) {
      places.push_back({std::move(candidate)});
    } else if (std::none_of(place->begin(), place->end(), [&](const Candidate& known) {
                 return same_answer(known, candidate);
               })) {
      place->push_back(std::move(candidate));
    }
  }
  return places;
}

/// Different tags, the best candidates of their places, that are about equally convincing share the
/// accidents that are to be expected, as in the rate of false discoveries [BenjaminiHochberg1995];
/// much more convincing ones lend nothing to a weak one beside them. A further candidate of a place
/// that is explained already must convince by itself, or be the same tag under another name.
std::vector<TagInPicture> Search::believed() const {
  constexpr double kAboutEqual = 100;  // tags of one family with a bit error more or less
  std::vector<TagInPicture> tags;
  const std::vector<std::vector<Candidate>> places = by_place();  // by their best candidates
  for (std::size_t i = 0; i < places.size(); ++i) {
    const double rate = places[i].front().accept_rate;
    std::set<std::pair<const codec::Family*, codec::TagId>> as_good;
    for (const auto& place : places) {
      const Candidate& best = place.front();
      if (best.accept_rate > rate || best.accept_rate < rate / kAboutEqual) continue;
      as_good.emplace(best.family.get(), best.id);
    }
    TagInPicture tag;
    for (Candidate candidate : places[i]) {
      const double expected = evidence_.expected_accidents(candidate.accept_rate, candidate.doubt);
      const bool same = !tag.empty() && same_cells(tag.front(), candidate);
      const bool shares = same || (tag.empty() && candidate.accept_rate == rate);
      candidate.expected_accidents =
          shares ? expected / static_cast<double>(as_good.size()) : expected;
      const bool has_rival = !tag.empty() && !same;
      if (is_believed(candidate, has_rival)) tag.push_back(std::move(candidate));
    }
    if (!tag.empty()) tags.push_back(std::move(tag));
  }
  return tags;
}

Identification Search::result() const {
  Identification found{.tags = believed(), .nearest = {}};
  std::stable_sort(found.tags.begin(), found.tags.end(),
                   [](const TagInPicture& a, const TagInPicture& b) {
                     return side_of(a.front().corners) > side_of(b.front().corners);
                   });
  if (found.tags.empty() && nearest_) {
    found.nearest = nearest_;
    found.nearest->expected_accidents =
        evidence_.expected_accidents(nearest_->accept_rate, nearest_->doubt);
  }
  return found;
}

/// The picture and its halves, down to those in which a tag would hardly have its cells.
class Reductions {
 public:
  explicit Reductions(ImageView picture) {
    constexpr int kSmallest_px = 64;
    views_.push_back({picture, 1});
    halves_.reserve(32);  // views point at them
    while (std::min(views_.back().picture.width, views_.back().picture.height) >=
           2 * kSmallest_px) {
      halves_.push_back(half_size(views_.back().picture));
      views_.push_back({halves_.back().view(), 2 * views_.back().scale});
    }
  }
  const std::vector<View>& views() const { return views_; }

 private:
  std::vector<detect::Image> halves_;
  std::vector<View> views_;
};

}  // namespace

struct Identifier::Impl {
  Impl(const std::vector<SharedFamily>& families, int threads)
      : groups(grouped(families)), squares(threads) {
    for (const LayoutGroup& group : groups) {
      const Frame frame = frame_of(group.layout);
      frames.insert(frame);
      int& rings = rings_of_frames[frame];
      rings = std::max(rings, rings_without_data(group.layout));
    }
  }

  std::vector<LayoutGroup> groups;
  std::set<Frame> frames;
  std::map<Frame, int> rings_of_frames;  ///< outer rings without data that some layout has
  NearestTags nearest_tags;
  SquareFinder squares;
};

Identifier::Identifier(std::vector<SharedFamily> families, int threads) {
  for (auto family = families.begin(); family != families.end(); ++family) {
    if (*family == nullptr) {
      throw std::invalid_argument("a family to identify is null; each must be a Family");
    }
    if (std::find(families.begin(), family, *family) != family) {
      throw std::invalid_argument("the family " + (*family)->name() +
                                  " is given twice; give each once");
    }
  }
  impl_ = std::make_unique<Impl>(families, threads);
}

Identifier::~Identifier() = default;
Identifier::Identifier(Identifier&&) noexcept = default;
Identifier& Identifier::operator=(Identifier&&) noexcept = default;

Identification Identifier::identify(ImageView picture) {
  if (picture.empty()) return {};
  Search search(impl_->groups, impl_->nearest_tags);
  const View whole{picture, 1};
  search.read(whole, find_cell_grids(picture, impl_->frames));
  if (search.believes_something()) return search.result();
  const Reductions reductions(picture);
  for (const View& view : reductions.views()) {
    search.read(view, impl_->squares.find(view.picture));
    if (search.believes_something()) return search.result();
  }
  for (const View& view : reductions.views()) {
    search.read(view, impl_->squares.find_at_edges(view.picture));
    if (search.believes_something()) return search.result();
  }
  search.read(whole, filled_places(picture, impl_->rings_of_frames));
  return search.result();
}

}  // namespace tagmint::identify
