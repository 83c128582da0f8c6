// Proves the bundled rotation codes a second time, with plain loops of its own: no code of the
// library but rotate_quarter() and reading the files.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/complexity.h"
#include "tagmint/codec/layout_presets.h"
#include "tagmint/codec/rotation.h"

namespace tagmint::codec {
namespace {

/// Up to so many tags all pairs are compared; above, the weights of all words tell the distance.
constexpr std::size_t kMostPairs = 20'000;

std::vector<SharedFamily> rotation_families() {
  std::vector<SharedFamily> families;
  for (const std::string& name : family_names()) {
    if (name.starts_with("rot")) families.push_back(find_family(name));
  }
  return families;
}

/// The least distance between two tags in any rotation, and between a tag and its own turns.
int distance_by_pairs(const std::vector<Codeword>& tags, int bits) {
  std::vector<Codeword> turns[4];
  for (Codeword word : tags) {
    for (std::vector<Codeword>& turned : turns) {
      turned.push_back(word);
      word = rotate_quarter(word, bits);
    }
  }
  int least = 64;
  for (std::size_t i = 0; i < tags.size(); ++i) {
    for (int turn = 0; turn < 4; ++turn) {
      const std::size_t others = turn == 0 ? i : i + 1;  // itself only when it is turned
      for (std::size_t j = 0; j < others; ++j) {
        least = std::min(least, std::popcount(tags[i] ^ turns[turn][j]));
      }
    }
  }
  return least;
}

/// All words of the code that `basis` spans, one after the other.
template <typename Visit>
void visit_span(const std::vector<Codeword>& basis, const Visit& visit) {
  Codeword word = 0;
  visit(word);
  for (std::uint64_t step = 1; step < std::uint64_t{1} << basis.size(); ++step) {
    word ^= basis[std::countr_zero(step)];
    visit(word);
  }
}

/// Reduces words by those before, to tell whether a word is a sum of them.
class Span {
 public:
  explicit Span(const std::vector<Codeword>& words) {
    for (const Codeword word : words) {
      const Codeword rest = reduce(word);
      if (rest != 0) rows_.push_back(rest);
    }
  }
  std::size_t rank() const { return rows_.size(); }
  Codeword reduce(Codeword word) const {
    for (const Codeword row : rows_) {
      if ((word & std::bit_floor(row)) != 0) word ^= row;
    }
    return word;
  }

 private:
  std::vector<Codeword> rows_;
};

/// What an enumeration of all words of a level finds.
struct LevelProof {
  int distance = 64;
  std::size_t tags = 0;
};

LevelProof proof_by_weights(const RotationCode& code, std::size_t number) {
  const int bits = code.bits();
  const RotationCodeLevel& level = code.levels()[number];
  EXPECT_EQ(level.cosets, 1u);
  EXPECT_EQ(code.cosets().size(), 1u);
  const std::vector<Codeword> basis(code.basis().begin(), code.basis().begin() + level.dimension);
  const Span span(basis);
  EXPECT_EQ(span.rank(), basis.size());
  for (const Codeword word : basis) EXPECT_EQ(span.reduce(rotate_quarter(word, bits)), 0u);
  const Codeword shift = code.translation() ^ code.cosets().front();
  EXPECT_EQ(span.reduce(shift ^ rotate_quarter(shift, bits)), 0u);
  // Two words of the level differ by a word of the span, and a tag is four words of the level that
  // are all different.
  LevelProof proof;
  std::size_t kept = 0;
  visit_span(basis, [&](Codeword word) {
    if (word != 0) proof.distance = std::min(proof.distance, std::popcount(word));
    const Codeword shifted = word ^ shift;
    kept += rotate_quarter(rotate_quarter(shifted, bits), bits) == shifted;
  });
  proof.tags = ((std::size_t{1} << level.dimension) - kept) / 4;
  return proof;
}

/// What docs/rotation-codes.md says of a family; levels without `plain`, which the rule decides.
struct Documented {
  std::string name;
  std::string layout;
  std::vector<std::pair<std::size_t, int>> levels;  // tags and distance
};

// clang-format off
const std::vector<Documented> kDocumented = {
    {"rot16h5", "classic:8", {{3, 8}, {60, 5}}},
    {"rot21h7", "circle:9", {{140, 7}}},
    {"rot25h8", "classic:9", {{3, 12}, {1008, 8}}},
    {"rot25h9", "classic:9", {{64, 9}}},
    {"rot36", "classic:10", {{60, 16}, {2016, 12}, {8128, 10}, {130816, 8}}},
    {"rot36h10", "classic:10", {{120, 14}, {240, 12}, {16320, 10}}},
    {"rot41", "standard:9", {{256, 16}, {16320, 12}}},
    {"rot48", "custom:dddddddddd/dbbbbbbbbd/dbwwwwwwbd/dbwddddwbd/dbwdxxdwbd/dbwdxxdwbd/dbwddddwbd/dbwwwwwwbd/dbbbbbbbbd/dddddddddd", {{120, 20}, {16320, 16}, {4193280, 12}}},
    {"rot49", "circle:11", {{120, 20}, {16320, 16}, {4193280, 12}}},
    {"rot52", "standard:10", {{32, 24}, {1008, 20}, {65280, 16}, {4192256, 12}}},
    {"rot52h14", "standard:10", {{32, 24}, {1008, 20}, {65280, 16}, {261888, 14}}},
    {"rot64", "classic:12", {{32, 32}, {240, 28}, {16128, 24}, {65280, 22}, {4177920, 16}}},
};
// clang-format on

TEST(BundledRotationCodes, HaveTheDocumentedLevels) {
  const std::vector<SharedFamily> families = rotation_families();
  ASSERT_EQ(families.size(), kDocumented.size());
  for (std::size_t i = 0; i < families.size(); ++i) {
    EXPECT_EQ(families[i]->name(), kDocumented[i].name);
    EXPECT_EQ(layout_name(families[i]->layout()), kDocumented[i].layout) << kDocumented[i].name;
    std::vector<std::pair<std::size_t, int>> levels;
    for (const Level& level : families[i]->levels()) {
      levels.emplace_back(level.codes, level.min_hamming);
    }
    EXPECT_EQ(levels, kDocumented[i].levels) << kDocumented[i].name;
    EXPECT_EQ(families[i]->origin().method, "rotation-code");
  }
}

TEST(BundledRotationCodes, EachLevelOfUpTo20000TagsKeepsItsDistanceByAllPairs) {
  for (const SharedFamily& family : rotation_families()) {
    for (const Level& level : family->levels()) {
      if (level.codes > kMostPairs) continue;
      const std::vector<Codeword> tags = first_codewords(*family, level.codes);
      ASSERT_EQ(tags.size(), level.codes);
      EXPECT_EQ(distance_by_pairs(tags, family->bits()), level.min_hamming)
          << family->name() << ", " << level.codes << " tags";
    }
  }
}

TEST(BundledRotationCodes, EachGeneratedLevelKeepsItsDistanceByTheWeightsOfAllWords) {
  for (const SharedFamily& family : rotation_families()) {
    if (family->is_listed()) continue;
    for (std::size_t i = 0; i < family->levels().size(); ++i) {
      const LevelProof proof = proof_by_weights(*family->generator(), i);
      EXPECT_EQ(proof.distance, family->levels()[i].min_hamming) << family->name() << " " << i;
      EXPECT_EQ(proof.tags, family->levels()[i].codes) << family->name() << " " << i;
    }
  }
}

TEST(BundledRotationCodes, TagsOfALevelThatPassTheRuleComeFirst) {
  for (const SharedFamily& family : rotation_families()) {
    const ComplexityJudge judge(family->layout(), family->complexity());
    std::size_t first = 0;
    for (const Level& level : family->levels()) {
      const std::vector<Codeword> own =
          some_codewords(*family, static_cast<TagId>(first), level.codes - first);
      const auto plain =
          std::find_if(own.begin(), own.end(), [&](Codeword word) { return !judge.accepts(word); });
      EXPECT_EQ(own.end() - plain, static_cast<std::ptrdiff_t>(level.plain)) << family->name();
      EXPECT_TRUE(std::none_of(plain, own.end(), [&](Codeword word) {
        return judge.accepts(word);
      })) << family->name();
      first = level.codes;
    }
  }
}

}  // namespace
}  // namespace tagmint::codec
