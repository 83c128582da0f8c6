#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include "io/family_kinds/apriltag_c.h"
#include "io/family_kinds/bit_places.h"
#include "io/family_kinds/data_square.h"
#include "io/family_kinds/imported_family.h"
#include "io/family_kinds/source_facts.h"

namespace tagmint::io {
namespace {

using codec::Codeword;
using codec::Layout;

/// The note of the comment that make_apriltag_c() writes.
std::optional<std::string> find_note(std::string_view content) {
  const std::size_t mark = content.find(kNoteMark);
  if (mark == std::string_view::npos) return std::nullopt;
  const std::string_view note = content.substr(mark + kNoteMark.size());
  return std::string(note.substr(0, note.find_first_of("\r\n")));
}

/// "tag36h11", "t36h11", "Tag36h11": 36 and 11.
std::optional<std::pair<int, int>> figures_of_name(std::string_view name) {
  const std::size_t begin = name.find_first_of("0123456789");
  if (begin == std::string_view::npos) return std::nullopt;
  int bits = 0;
  int distance = 0;
  const char* const end = name.data() + name.size();
  const auto first = std::from_chars(name.data() + begin, end, bits);
  if (first.ec != std::errc() || first.ptr == end || *first.ptr != 'h') return std::nullopt;
  const auto second = std::from_chars(first.ptr + 1, end, distance);
  if (second.ec != std::errc() || second.ptr != end) return std::nullopt;
  return std::pair{bits, distance};
}

/// Makes a family of the facts of a source.
class FamilyOfSource {
 public:
  FamilyOfSource(const FamilySource& source, const FamilyReadOptions& options)
      : source_(source), options_(options), facts_(collect_source_facts(source)) {
    find_codes();
    if (facts_.name.empty() && list_name_ != "codes" && list_name_ != "codedata") {
      named_ = figures_of_name(list_name_);
    } else {
      named_ = figures_of_name(facts_.name);
    }
  }

  ReadFamily read() {
    std::vector<std::string> notes;
    Tags tags = list("bit_x") || list("bit_y") ? read_placed() : read_bare(notes);
    const int bits = tags.layout.bits();
    ReadFamily result = make_imported({.name = facts_.name,
                                       .layout = std::move(tags.layout),
                                       .min_hamming = distance(bits),
                                       .codewords = std::move(tags.codewords),
                                       .lines = codes_->lines,
                                       .kind = "apriltag-c",
                                       .note = find_note(source_.content)},
                                      source_, options_);
    result.notes.insert(result.notes.begin(), notes.begin(), notes.end());
    return result;
  }

 private:
  struct Tags {
    Layout layout;
    std::vector<Codeword> codewords;
  };

  [[noreturn]] void fail(int line, std::string_view what, std::string_view mend) const {
    fail_in_source(what, source_, line, mend);
  }

  /// Runs a check that throws std::invalid_argument and tells its message with the line.
  template <typename Check>
  auto checked(int line, Check check) const {
    try {
      return check();
    } catch (const std::invalid_argument& fault) {
      fail(line, fault.what(), "correct the file");
    }
  }

  std::optional<PlacedNumber> field(std::string_view name) const {
    const auto place = facts_.fields.find(name);
    if (place == facts_.fields.end()) return std::nullopt;
    return place->second;
  }

  PlacedNumber need(std::string_view name) const {
    const std::optional<PlacedNumber> number = field(name);
    if (!number) fail(0, fmt::format("'{}' is not set", name), "give a whole source file");
    return *number;
  }

  const NumberList* list(std::string_view name) const {
    const auto place = facts_.lists.find(name);
    return place == facts_.lists.end() ? nullptr : &place->second;
  }

  /// The list of codewords is called as libapriltag's is, or is the only one.
  void find_codes() {
    for (const auto& [name, numbers] : facts_.lists) {
      if (name == "bit_x" || name == "bit_y") continue;
      const bool usual = name == "codedata" || name == "codes";
      if (usual || !codes_) {
        codes_ = &numbers;
        list_name_ = name;
        if (usual) break;
      } else {
        fail(numbers.line, fmt::format("two lists of numbers, '{}' and '{}'", list_name_, name),
             "give a file with one family");
      }
    }
    if (!codes_) {
      fail(0, "there is no list of codewords",
           "give the file with the numbers: NAME.c, not NAME.h");
    }
    const std::size_t found = codes_->values.size();
    for (const std::optional<PlacedNumber>& count : {codes_->size, field("ncodes")}) {
      if (count && static_cast<std::uint64_t>(count->value) != found) {
        fail(count->line,
             fmt::format("{} codewords are declared, {} are listed", count->value, found),
             "get the file anew");
      }
    }
  }

  /// With the places of the bits: the form of AprilTag 3.
  Tags read_placed() const {
    if (options_.bit_order != BitOrder::AsRecognised) {
      throw std::invalid_argument("the file says where each bit is; leave --bit-order out");
    }
    const NumberList empty;
    const NumberList& xs = list("bit_x") ? *list("bit_x") : empty;
    const NumberList& ys = list("bit_y") ? *list("bit_y") : empty;
    const int line = std::max(xs.line, ys.line);
    const std::size_t bits =
        field("nbits") ? static_cast<std::size_t>(field("nbits")->value) : xs.values.size();
    if (xs.values.size() != bits || ys.values.size() != bits) {
      fail(line,
           fmt::format("{} bits, but {} places bit_x and {} places bit_y", bits, xs.values.size(),
                       ys.values.size()),
           "give each bit its place");
    }
    const PlacedNumber total = need("total_width");
    BitPlaces places{.cells = {},
                     .width_at_border = to_int(need("width_at_border")),
                     .total_width = to_int(total),
                     .reversed_border = need("reversed_border").value != 0};
    for (std::size_t i = 0; i < bits; ++i) {
      // Outside of the border square they are negative, kept in 32 bits without a sign.
      places.cells.push_back({static_cast<std::int32_t>(static_cast<std::uint32_t>(xs.values[i])),
                              static_cast<std::int32_t>(static_cast<std::uint32_t>(ys.values[i]))});
    }
    Tags tags{.layout = options_.layout
                            ? *options_.layout
                            : checked(total.line, [&] { return layout_of_places(places); }),
              .codewords = {}};
    const std::vector<int> order =
        checked(line, [&] { return order_of_places(places, tags.layout); });
    for (std::size_t id = 0; id < codes_->values.size(); ++id) {
      require_bits(id, static_cast<int>(bits));
      tags.codewords.push_back(in_order(codes_->values[id], order));
    }
    return tags;
  }

  /// Without places: tables that are older than AprilTag 3, row by row unless the user says
  /// otherwise.
  Tags read_bare(std::vector<std::string>& notes) const {
    const int bits = bare_bits();
    Tags tags{.layout = options_.layout ? *options_.layout : bare_layout(bits), .codewords = {}};
    const Layout& layout = tags.layout;
    if (layout.bits() != bits) {
      fail(codes_->line,
           fmt::format("the table has {} bits, the layout {} data cells", bits, layout.bits()),
           "give the layout of these tags with --layout");
    }
    for (std::size_t id = 0; id < codes_->values.size(); ++id) require_bits(id, bits);
    if (options_.bit_order == BitOrder::QuarterBlocks) {
      tags.codewords = codes_->values;
      return tags;
    }
    const int side = static_cast<int>(std::lround(std::sqrt(bits)));
    const int border = (layout.width() - side) / 2 - 1;
    if (border < 1 || !DataSquare::fits(layout, border)) {
      fail(codes_->line, "the file does not say where the bits are",
           "a table in the layout's own order is read with --bit-order quarter-blocks");
    }
    const DataSquare square(layout);
    for (const Codeword rows : codes_->values) {
      tags.codewords.push_back(square.codeword_of_rows(rows));
    }
    if (options_.bit_order == BitOrder::AsRecognised) {
      notes.emplace_back(
          "no places of bits, so the codewords are read row by row, as old tables "
          "have them; --bit-order quarter-blocks reads them otherwise");
    }
    return tags;
  }

  int bare_bits() const {
    if (const auto nbits = field("nbits")) return to_int(*nbits);
    if (facts_.table_bits) return to_int(*facts_.table_bits);
    if (const auto side = field("d")) return to_int(*side) * to_int(*side);
    if (options_.layout) return options_.layout->bits();
    if (named_) return named_->first;
    fail(codes_->line, "the file does not say how many bits a codeword has",
         "give the layout with --layout");
  }

  Layout bare_layout(int bits) const {
    const int side = static_cast<int>(std::lround(std::sqrt(std::clamp(bits, 0, codec::kMaxBits))));
    if (side * side != bits) {
      fail(codes_->line,
           fmt::format("{} bits fill no square, and the file does not say where they are", bits),
           "give the layout with --layout");
    }
    const auto border = field("black_border");
    return checked(border ? border->line : codes_->line,
                   [&] { return square_layout(side, border ? to_int(*border) : 1); });
  }

  void require_bits(std::size_t id, int bits) const {
    if (bits >= 0 && bits < codec::kMaxBits && codes_->values[id] >> bits != 0) {
      fail(codes_->lines[id],
           fmt::format("codeword {} is {:#x}, which has more than {} bits", id, codes_->values[id],
                       bits),
           "correct it");
    }
  }

  std::optional<int> distance(int bits) const {
    std::optional<PlacedNumber> declared = field("h");
    if (!declared) declared = facts_.table_distance;
    if (!declared && named_ && named_->first == bits) declared = PlacedNumber{named_->second, 0};
    if (!declared) return std::nullopt;
    if (declared->value < 1 || declared->value > bits) {
      fail(declared->line, fmt::format("a distance of {} cannot be", declared->value),
           fmt::format("with {0} bits it is 1 to {0}", bits));
    }
    return to_int(*declared);
  }

  /// A number that counts cells or bits.
  int to_int(PlacedNumber number) const {
    constexpr std::int64_t kMost = 64;
    if (number.value < 0 || number.value > kMost) {
      fail(number.line, fmt::format("{} cells or bits cannot be", number.value),
           fmt::format("it is at most {}", kMost));
    }
    return static_cast<int>(number.value);
  }

  const FamilySource& source_;
  const FamilyReadOptions& options_;
  SourceFacts facts_;
  const NumberList* codes_ = nullptr;
  std::string list_name_;
  std::optional<std::pair<int, int>> named_;  // bits and distance that the name tells
};

}  // namespace

ReadFamily read_apriltag_c(const FamilySource& source, const FamilyReadOptions& options) {
  return FamilyOfSource(source, options).read();
}

}  // namespace tagmint::io
