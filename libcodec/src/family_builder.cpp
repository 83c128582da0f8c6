#include "family_builder.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include "codeword_digest.h"
#include "family_rules.h"

namespace tagmint::codec {
namespace {

/// Turns a document into a Family, telling each fault with its line.
class FamilyBuilder {
 public:
  FamilyBuilder(FamilyDocument document, const std::string& source)
      : document_(std::move(document)), source_(source) {}

  Family build() {
    check_kind();
    const std::string name = read_name();
    Layout layout = read_layout();
    const int min_hamming = read_min_hamming(layout.bits());
    const SharedRotationCode generator = read_generator(layout.bits());
    std::vector<Codeword> codewords;
    if (generator == nullptr) codewords = read_codewords(layout.bits());
    std::vector<Level> levels = generator ? read_levels_of(*generator, layout.bits(), min_hamming)
                                          : read_levels(codewords.size(), min_hamming);
    const Placed<std::string>& digest = need(document_.sha256, "sha256");
    if (generator == nullptr) check_digest(digest, codewords);
    return Family(
        {.name = name,
         .layout = std::move(layout),
         .min_hamming = min_hamming,
         .codewords = std::move(codewords),
         .complexity = read_complexity(),
         .origin = {document_.origin_method, document_.origin_order, document_.origin_seed,
                    document_.origin_searched, document_.origin_program},
         .levels = std::move(levels),
         .generator = generator,
         .declared_digest = generator ? digest.value : std::string()});
  }

 private:
  [[noreturn]] void fail(int line, std::string_view what, std::string_view mend) const {
    fail_in_line(what, source_, line, mend);
  }

  /// The value of a key that must be there.
  template <typename T>
  const Placed<T>& need(const std::optional<Placed<T>>& value, std::string_view key) const {
    if (!value) {
      fail(document_.last_line, fmt::format("the key \"{}\" is missing", key),
           "see docs/family-format.md");
    }
    return *value;
  }

  /// Runs a check that throws std::invalid_argument and tells its message with the line.
  template <typename Check>
  auto checked(int line, Check check) const {
    try {
      return check();
    } catch (const std::invalid_argument& error) {
      fail(line, error.what(), "correct this line or make the file anew");
    }
  }

  void check_kind() const {
    if (!document_.format || document_.format->value != kFamilyFormat) {
      fail(document_.format ? document_.format->line : 1, "this is not a tagmint family file",
           fmt::format("its \"format\" must be \"{}\"", kFamilyFormat));
    }
    const Placed<std::uint64_t>& version = need(document_.version, "version");
    if (version.value != kFamilyVersion) {
      fail(version.line, fmt::format("family file version {} is unknown", version.value),
           fmt::format("this tagmint reads version {}", kFamilyVersion));
    }
  }

  std::string read_name() const {
    const Placed<std::string>& name = need(document_.name, "name");
    checked(name.line, [&] { check_family_name(name.value); });
    return name.value;
  }

  Layout read_layout() const {
    const Placed<std::vector<std::string>>& rows = need(document_.layout, "layout");
    Layout layout =
        checked(rows.line, [&] { return Layout(fmt::format("{}", fmt::join(rows.value, "/"))); });
    const Placed<std::uint64_t>& bits = need(document_.bits, "bits");
    if (bits.value != static_cast<std::uint64_t>(layout.bits())) {
      fail(bits.line,
           fmt::format("\"bits\" is {}, but the layout has {} data cells", bits.value,
                       layout.bits()),
           "correct one of them");
    }
    return layout;
  }

  int read_min_hamming(int bits) const {
    const Placed<std::uint64_t>& distance = need(document_.min_hamming, "min_hamming");
    const int min_hamming = to_int(distance.value);
    checked(distance.line, [&] { check_min_hamming(min_hamming, bits); });
    return min_hamming;
  }

  std::vector<Codeword> read_codewords(int bits) {
    need(document_.codes, "codes");
    Placed<std::vector<Codeword>>& codes = *document_.codes;
    if (codes.value.empty()) fail(codes.line, "\"codes\" is empty", "list at least one codeword");
    if (codes.value.size() > std::numeric_limits<TagId>::max()) {
      fail(codes.line, fmt::format("{} codewords are more than ids can count", codes.value.size()),
           "split the family");
    }
    if (const auto fault = find_codeword_fault(codes.value, bits)) {
      fail(document_.code_lines[fault->id], fault->message, "correct or remove this codeword");
    }
    return std::move(codes.value);
  }

  /// The generator; null where the codewords are listed.
  SharedRotationCode read_generator(int bits) const {
    if (!document_.generator) return nullptr;
    const auto& [entry, line] = *document_.generator;
    if (document_.codes) {
      fail(line, "both \"codes\" and \"generator\" are given", "keep one of them");
    }
    if (!entry.basis) fail(line, "the generator has no \"basis\"", "see docs/family-format.md");
    RotationCodeParts parts{.bits = bits, .basis = *entry.basis};
    parts.translation = entry.translation.value_or(0);
    if (entry.cosets) parts.cosets = *entry.cosets;
    if (entry.levels) parts.levels = read_generator_levels(*entry.levels, line);
    return checked(line, [&] { return std::make_shared<const RotationCode>(std::move(parts)); });
  }

  std::vector<RotationCodeLevel> read_generator_levels(
      const std::vector<GeneratorLevelEntry>& entries, int line) const {
    std::vector<RotationCodeLevel> levels;
    for (const GeneratorLevelEntry& entry : entries) {
      if (!entry.dimension) {
        fail(line, fmt::format("level {} of the generator lacks \"dimension\"", levels.size()),
             "each level has one");
      }
      levels.push_back({to_int(entry.dimension->value), entry.cosets ? entry.cosets->value : 1});
    }
    return levels;
  }

  std::vector<Level> read_levels(std::size_t size, int min_hamming) const {
    if (!document_.levels) return {};
    const auto& [entries, line] = *document_.levels;
    std::vector<Level> levels;
    for (const LevelEntry& entry : entries) {
      if (!entry.codes || !entry.min_hamming) {
        fail(line, fmt::format("level {} lacks \"codes\" or \"min_hamming\"", levels.size()),
             "each level has both");
      }
      levels.push_back({entry.codes->value, to_int(entry.min_hamming->value),
                        entry.plain ? entry.plain->value : 0});
    }
    checked(line, [&] { check_levels(levels, size, min_hamming); });
    return levels;
  }

  std::vector<Level> read_levels_of(const RotationCode& generator, int bits,
                                    int min_hamming) const {
    std::vector<Level> levels = read_levels(generator.tags(), min_hamming);
    if (levels.empty()) levels = {{generator.tags(), min_hamming}};
    checked(document_.generator->line, [&] { check_generator(generator, bits, levels); });
    return levels;
  }

  void check_digest(const Placed<std::string>& declared,
                    std::span<const Codeword> codewords) const {
    CodewordDigest digest;
    digest.add(codewords);
    const std::string found = digest.hex();
    if (declared.value != found) {
      fail(declared.line, "the codewords are not those that \"sha256\" was made of",
           fmt::format("get the file anew or, if they are meant so, write {}", found));
    }
  }

  Complexity read_complexity() const {
    const auto& rule = document_.complexity_rule;
    const auto& threshold = document_.complexity_threshold;
    if (!rule && !threshold) return {};
    if (!rule) fail(threshold->line, "\"complexity\" has no \"rule\"", "name the rule");
    return checked(rule->line, [&] {
      if (!threshold || rule->value == "none") return parse_complexity(rule->value);
      return parse_complexity(fmt::format("{}:{}", rule->value, threshold->value));
    });
  }

  /// Numbers too large for an int become the largest one, which every check refuses.
  static int to_int(std::uint64_t number) {
    constexpr int most = std::numeric_limits<int>::max();
    return static_cast<int>(std::min<std::uint64_t>(number, most));
  }

  FamilyDocument document_;
  const std::string& source_;
};

}  // namespace

Family build_family(FamilyDocument document, const std::string& source) {
  return FamilyBuilder(std::move(document), source).build();
}

}  // namespace tagmint::codec
