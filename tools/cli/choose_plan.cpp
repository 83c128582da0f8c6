#include "cli/choose_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

#include "cli/reading_curve.h"
#include "draw/sheet_plan.h"
#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/family_stats.h"
#include "tagmint/codec/id_distance.h"
#include "tagmint/codec/layout_presets.h"

namespace tagmint::cli {
namespace {

using codec::Family;
using codec::Layout;

/// A family that programs know by themselves.
struct KnownFamily {
  const char* name;
  bool opencv;  ///< a predefined dictionary there; libapriltag knows them all
};
constexpr std::array kKnownFamilies = {
    KnownFamily{"tag16h5", true},          KnownFamily{"tag25h9", true},
    KnownFamily{"tag36h11", true},         KnownFamily{"tag36h10", true},
    KnownFamily{"tagCircle21h7", false},   KnownFamily{"tagStandard41h12", false},
    KnownFamily{"tagCustom48h12", false},  KnownFamily{"tagCircle49h12", false},
    KnownFamily{"tagStandard52h13", false}};

/// Whether `known` has all of these ids, as the same pictures.
bool has_same_tags(const Family& known, const Family& family, std::span<const IdRange> ids) {
  if (known.layout() != family.layout() || ids.back().last >= known.size()) return false;
  return std::all_of(ids.begin(), ids.end(), [&](const IdRange& range) {
    for (codec::TagId id = range.first; id <= range.last; ++id) {
      if (known.codeword(id) != family.codeword(id)) return false;
    }
    return true;
  });
}

void find_readers(FamilyChoice& choice) {
  for (const KnownFamily& entry : kKnownFamilies) {
    const codec::SharedFamily known = codec::find_family(entry.name);
    if (!known || !has_same_tags(*known, *choice.family, choice.ids)) continue;
    choice.known_as = entry.name;
    choice.read_by = {"libapriltag"};
    if (entry.opencv) choice.read_by.emplace_back("OpenCV");
    return;
  }
}

/// Adds the first ids of first .. end - 1 to `ids`, `wanted` at most; how many were added.
std::size_t take(std::vector<IdRange>& ids, std::size_t first, std::size_t end,
                 std::size_t wanted) {
  const std::size_t taken = std::min(end - first, wanted);
  if (taken > 0) {
    ids.push_back({static_cast<codec::TagId>(first), static_cast<codec::TagId>(first + taken - 1)});
  }
  return taken;
}

/// Sorts ranges that do not overlap and joins those that follow each other.
std::vector<IdRange> joined(std::vector<IdRange> ranges) {
  std::sort(ranges.begin(), ranges.end(),
            [](const IdRange& a, const IdRange& b) { return a.first < b.first; });
  std::vector<IdRange> result;
  for (const IdRange& range : ranges) {
    if (!result.empty() && result.back().last + 1 == range.first) {
      result.back().last = range.last;
    } else {
      result.push_back(range);
    }
  }
  return result;
}

/// Ids of the level, `tags` of them: as many as there are that pass the complexity rule, then the
/// plain ones, which each level has at the end of its own ids.
void choose_ids(FamilyChoice& choice, std::size_t tags) {
  const auto levels = choice.family->levels().first(choice.level + 1);
  std::vector<IdRange> ids;
  std::size_t missing = tags;
  for (const bool plain : {false, true}) {
    std::size_t begin = 0;
    if (plain) choice.plain_ids = missing;
    for (const codec::Level& level : levels) {
      const std::size_t first_plain = level.codes - level.plain;
      missing -= plain ? take(ids, first_plain, level.codes, missing)
                       : take(ids, begin, first_plain, missing);
      begin = level.codes;
    }
  }
  choice.ids = joined(std::move(ids));
}

/// The most errors that are safe, with no more false accepts than are acceptable; 0 at the least.
int errors_to_correct(std::size_t tags, int bits, int safe_errors) {
  int errors = safe_errors;
  while (errors > 0 && codec::false_accept_rate(tags, bits, errors) > kAcceptedRate) --errors;
  return errors;
}

std::vector<codec::TagId> list_of(std::span<const IdRange> ranges) {
  std::vector<codec::TagId> ids;
  for (const IdRange& range : ranges) {
    for (codec::TagId id = range.first; id <= range.last; ++id) ids.push_back(id);
  }
  return ids;
}

void fill_distances(FamilyChoice& choice, std::size_t tags, int threads) {
  const int bits = choice.family->bits();
  choice.min_hamming = codec::distance_of_ids(*choice.family, list_of(choice.ids), threads);
  choice.safe_errors = (choice.min_hamming - 1) / 2;
  choice.max_hamming = errors_to_correct(tags, bits, choice.safe_errors);
  choice.accepted = codec::false_accept_rate(tags, bits, choice.max_hamming);
  choice.accepted_at_2 = codec::false_accept_rate(tags, bits, std::min(2, bits));
  choice.accepted_at_safe = codec::false_accept_rate(tags, bits, choice.safe_errors);
}

void fill_sizes(FamilyChoice& choice, const TagUse& use) {
  const Layout& layout = choice.family->layout();
  choice.edge_mm = use.outer ? draw::edge_of_outer(layout, use.size_mm) : use.size_mm;
  const double cell_mm = choice.edge_mm / layout.width_at_border();
  choice.outer_mm = cell_mm * layout.width();
  choice.with_quiet_zone_mm = cell_mm * (layout.width() + 2 * draw::quiet_cells(layout));
  choice.cell_px = cell_mm * use.focal_px / use.distance_mm;
  choice.found = share_found(layout, choice.cell_px, choice.max_hamming);
  const double needed_px = cell_px_for_share(layout, choice.max_hamming, kReliableShare);
  choice.range_mm = cell_mm * use.focal_px / needed_px;
  choice.readability = choice.range_mm >= kRangeReserve * use.distance_mm ? Readability::Well
                       : choice.range_mm >= use.distance_mm               ? Readability::Just
                                                                          : Readability::Beyond;
}

bool has_hole(const Layout& layout) {
  const int middle = layout.width() / 2;
  return layout.cell(middle, middle) == codec::Cell::None;
}

void fill_cautions(FamilyChoice& choice) {
  const Layout& layout = choice.family->layout();
  const auto add = [&](bool holds, Caution caution) {
    if (holds) choice.cautions.push_back(caution);
  };
  add(choice.readability == Readability::Beyond, Caution::BeyondRange);
  add(choice.readability == Readability::Just, Caution::LittleReserve);
  add(choice.accepted > kAcceptedRate, Caution::ManyFalseAccepts);
  add(choice.plain_ids > 0, Caution::PlainTags);
  add(has_hole(layout), Caution::Hole);
  add(codec::layout_name(layout).starts_with("custom:"), Caution::CustomLayout);
  add(choice.ids.back().last >= kMostForeignTags, Caution::LargeIds);
}

/// nullopt when the family has too few tags.
std::optional<FamilyChoice> choose_level(const Candidate& candidate, const TagUse& use,
                                         int threads) {
  const auto levels = candidate.family->levels();
  const auto level = std::find_if(levels.begin(), levels.end(),
                                  [&](const codec::Level& l) { return l.codes >= use.tags; });
  if (level == levels.end()) return std::nullopt;
  FamilyChoice choice;
  choice.source = candidate.source;
  choice.family = candidate.family;
  choice.level = static_cast<std::size_t>(level - levels.begin());
  choose_ids(choice, use.tags);
  fill_distances(choice, use.tags, threads);
  fill_sizes(choice, use);
  find_readers(choice);
  fill_cautions(choice);
  return choice;
}

long percent_of_cells(int errors, int bits) { return std::lround(100.0 * errors / bits); }

/// Smaller is better; the order that choose_families() promises.
auto rank(const FamilyChoice& choice) {
  const int bits = choice.family->bits();
  const double nearest = choice.readability == Readability::Beyond ? -choice.range_mm : 0;
  return std::tuple(choice.readability, nearest, choice.accepted > kAcceptedRate,
                    -percent_of_cells(choice.max_hamming, bits),
                    -percent_of_cells(choice.min_hamming - choice.max_hamming, bits),
                    choice.outer_mm, choice.read_by.empty());
}

}  // namespace

std::string id_list_text(std::span<const IdRange> ranges) {
  std::string text;
  for (const IdRange& range : ranges) {
    if (!text.empty()) text += ',';
    text += range.first == range.last ? fmt::to_string(range.first)
                                      : fmt::format("{}-{}", range.first, range.last);
  }
  return text;
}

ChoosePlan choose_families(std::span<const Candidate> candidates, const TagUse& use, int threads) {
  ChoosePlan plan;
  for (const Candidate& candidate : candidates) {
    if (std::optional<FamilyChoice> choice = choose_level(candidate, use, threads)) {
      plan.ranked.push_back(std::move(*choice));
    } else {
      plan.too_small.push_back({candidate.source, candidate.family->size()});
    }
  }
  std::stable_sort(plan.ranked.begin(), plan.ranked.end(),
                   [](const auto& a, const auto& b) { return rank(a) < rank(b); });
  return plan;
}

}  // namespace tagmint::cli
