#include "families_table/family_row.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "tagmint/codec/family_stats.h"
#include "tagmint/codec/near_pairs.h"
#include "tagmint/codec/rotation.h"

namespace tagmint::bench {
namespace {

using codec::Codeword;
using codec::Family;
using codec::TagId;

/// Levels of generated families up to this size are compared pair by pair.
constexpr std::size_t kMostCompared = 20'000;
/// Examples in a cell of the table.
constexpr std::size_t kExamples = 3;

int first_used(const std::vector<std::uint64_t>& histogram, int none) {
  const auto used = std::find_if(histogram.begin(), histogram.end(), [](auto n) { return n > 0; });
  return used == histogram.end() ? none : static_cast<int>(used - histogram.begin());
}

/// "65,535".
std::string with_commas(std::uint64_t count) {
  std::string digits = fmt::to_string(count);
  for (std::ptrdiff_t at = std::ssize(digits) - 3; at > 0; at -= 3) {
    digits.insert(static_cast<std::size_t>(at), 1, ',');
  }
  return digits;
}

std::string with_more(std::vector<std::string> examples, std::uint64_t all) {
  std::string text = fmt::format("{}", fmt::join(examples, ", "));
  return all > examples.size() ? text + ", ..." : text;
}

/// "12 pairs: 0 and 17, 3 and 9, ...".
std::string nearest_pairs(const Family& family, int between, std::uint64_t pairs) {
  std::vector<std::string> examples;
  for (const codec::NearPair& pair : codec::near_pairs(family, between, kExamples)) {
    examples.push_back(fmt::format("{} and {}", pair.first, pair.second));
  }
  return fmt::format("{} pair{}: {}", with_commas(pairs), pairs == 1 ? "" : "s",
                     with_more(examples, pairs));
}

/// Tags that a turn maps to themselves: nobody can tell how they lie.
std::string equal_to_a_turn(const Family& family, std::uint64_t tags) {
  std::vector<std::string> examples;
  for (TagId id = 0; id < family.size() && examples.size() < kExamples; ++id) {
    if (codec::self_distance(family.codeword(id), family.bits()) == 0) {
      examples.push_back(fmt::to_string(id));
    }
  }
  return fmt::format("{} equal to a turn of itself: {}", tags, with_more(examples, tags));
}

/// What the codewords of a listed family say, pair by pair.
void look_at_pairs(const Family& family, FamilyRow& row) {
  const codec::FamilyStats stats = codec::family_stats(family);
  row.between = first_used(stats.distance_histogram, family.bits());
  row.self = first_used(stats.self_histogram, family.bits());
  if (family.size() > 1) {
    row.alike = nearest_pairs(family, row.between, stats.distance_histogram[row.between]);
  }
  if (row.self == 0) row.alike += "; " + equal_to_a_turn(family, stats.self_histogram[0]);
}

/// The same of many generated codewords, by the words of the code.
void look_at_words(const Family& family, std::size_t level, FamilyRow& row) {
  constexpr std::size_t kAtATime = 100'000;
  row.between = codec::family_stats(family).levels[level].min_hamming;
  row.self = family.bits();
  for (std::size_t first = 0; first < row.codes; first += kAtATime) {
    const std::size_t count = std::min(kAtATime, row.codes - first);
    for (const Codeword word : codec::some_codewords(family, static_cast<TagId>(first), count)) {
      row.self = std::min(row.self, codec::self_distance(word, family.bits()));
    }
  }
}

/// How the tags of two families are related, id by id, or nothing: "the tags of B, turned ...".
std::optional<std::string> relation(const Family& family, const Family& other) {
  if (family.bits() != other.bits()) return std::nullopt;
  const int bits = family.bits();
  const std::size_t both = std::min(family.size(), other.size());
  for (const bool inverted : {false, true}) {
    for (int turn = 0; turn < 4; ++turn) {
      TagId id = 0;
      const Codeword exchanged = inverted ? codec::low_mask(bits) : 0;
      while (id < both &&
             (codec::rotate(family.codeword(id), bits, turn) ^ exchanged) == other.codeword(id)) {
        ++id;
      }
      if (id < both) continue;
      const std::string how = fmt::format("{}{}",
                                          turn == 0   ? ""
                                          : turn == 2 ? ", turned by 180 degrees"
                                                      : ", turned",
                                          inverted ? ", black and white exchanged" : "");
      const char* which = family.size() == other.size()  ? "the tags of"
                          : family.size() < other.size() ? "the first tags of"
                                                         : "begins with the tags of";
      return fmt::format("{} {}{}", which, other.name(), how);
    }
  }
  return std::nullopt;
}

void add_notes(const std::vector<FamilyRow>& earlier, FamilyRow& row) {
  const ShippedFamily& shipped = *row.shipped;
  if (!shipped.note.empty()) row.notes.push_back(shipped.note);
  const bool whole = row.codes == shipped.family.size();
  for (const FamilyRow& other : earlier) {
    if (!whole || other.codes != other.shipped->family.size()) continue;
    if (auto text = relation(shipped.family, other.shipped->family)) {
      row.notes.push_back(*text);
      break;
    }
  }
  const int least = std::min(row.between, row.self);
  if (shipped.declared && least < *shipped.declared) {
    row.notes.push_back(fmt::format("**{} is said, {} is true**", *shipped.declared, least));
  }
  if (shipped.corrects && *shipped.corrects > row.safe_radius.value_or(-1)) {
    row.notes.push_back(row.safe_radius ? fmt::format("**{} errors corrected, {} are safe**",
                                                      *shipped.corrects, *row.safe_radius)
                                        : "**ambiguous even without an error**");
  } else if (!row.safe_radius) {
    row.notes.emplace_back("**ambiguous even without an error**");
  }
}

std::string or_dash(std::optional<int> number) {
  return number ? fmt::to_string(*number) : std::string("-");
}

std::vector<std::string> cells_of(const FamilyRow& row) {
  const ShippedFamily& shipped = *row.shipped;
  const auto rate = [&row](int errors) { return fmt::format("{:.2g}", row.false_accepts(errors)); };
  return {shipped.name,
          fmt::to_string(shipped.family.bits()),
          with_commas(row.codes),
          or_dash(shipped.declared),
          or_dash(shipped.corrects),
          fmt::to_string(row.between),
          fmt::to_string(row.self),
          or_dash(row.safe_radius),
          rate(0),
          rate(1),
          rate(2),
          row.safe_radius ? rate(*row.safe_radius) : "-",
          row.alike,
          fmt::format("{}", fmt::join(row.notes, "; "))};
}

}  // namespace

double FamilyRow::false_accepts(int errors) const {
  return codec::false_accept_rate(codes, shipped->family.bits(), errors);
}

FamilyRow family_row(const ShippedFamily& shipped, const std::vector<FamilyRow>& earlier) {
  const Family& family = shipped.family;
  FamilyRow row{.shipped = &shipped,
                .codes = family.levels()[shipped.level].codes,
                .between = 0,
                .self = 0,
                .safe_radius = {},
                .alike = std::string(1, '-'),
                .notes = {}};
  if (family.is_listed() && row.codes == family.size()) {
    look_at_pairs(family, row);
  } else if (family.is_listed() || row.codes <= kMostCompared) {
    look_at_pairs(codec::first_tags(family, row.codes), row);
  } else {
    look_at_words(family, shipped.level, row);
  }
  const int least = std::min(row.between, row.self);
  if (least > 0) row.safe_radius = (least - 1) / 2;
  add_notes(earlier, row);
  return row;
}

std::string as_markdown(const std::vector<FamilyRow>& rows) {
  std::vector<std::vector<std::string>> columns = {
      {"family"},  {"bits"},    {"tags"},        {"said"},         {"corrects"},
      {"between"}, {"self"},    {"safe radius"}, {"accepts at 0"}, {"at 1"},
      {"at 2"},    {"at safe"}, {"most alike"},  {"notes"}};
  for (const FamilyRow& row : rows) {
    const std::vector<std::string> cells = cells_of(row);
    for (std::size_t i = 0; i < cells.size(); ++i) columns[i].push_back(cells[i]);
  }
  // A column that says nothing is left out.
  std::erase_if(columns, [](const std::vector<std::string>& column) {
    return std::all_of(column.begin() + 1, column.end(),
                       [](const std::string& cell) { return cell.empty() || cell == "-"; });
  });
  std::string text;
  for (std::size_t line = 0; line <= rows.size(); ++line) {
    for (const auto& column : columns) text += fmt::format("| {} ", column[line]);
    text += "|\n";
    if (line > 0) continue;
    for (std::size_t i = 0; i < columns.size(); ++i) text += "|---";
    text += "|\n";
  }
  return text;
}

}  // namespace tagmint::bench
