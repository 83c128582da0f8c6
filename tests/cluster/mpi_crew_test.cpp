// Run by mpirun: the first rank runs the tests, the others work for it.
#include "cluster/mpi_crew.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "cluster/cluster.h"
#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/search/crew.h"

namespace tagmint::cluster {
namespace {

Cluster* g_cluster = nullptr;  // made by main(), as MPI wants

/// The rules of tag36h11 without its rectangles, which are dear as long as few codes are known, and
/// its first codes.
struct Sample {
  codec::SharedFamily family = codec::find_family("tag36h11");
  codec::SearchRules rules{family->layout(), 11, {codec::Order::Kind::AprilTag2, 0}, {}};

  std::vector<codec::Codeword> codes(codec::TagId first, codec::TagId count) const {
    std::vector<codec::Codeword> codes;
    for (codec::TagId id = first; id < first + count; ++id) codes.push_back(family->codeword(id));
    return codes;
  }
};

void expect_same_sifting(codec::SearchCrew& crew, codec::SearchCrew& reference, std::uint64_t first,
                         std::uint64_t count) {
  const codec::SiftedWords sifted = crew.sift(first, count);
  const codec::SiftedWords expected = reference.sift(first, count);
  EXPECT_EQ(sifted.distant, expected.distant);
  ASSERT_EQ(sifted.kept.size(), expected.kept.size());
  for (std::size_t i = 0; i < sifted.kept.size(); ++i) {
    EXPECT_EQ(sifted.kept[i].index, expected.kept[i].index);
    EXPECT_EQ(sifted.kept[i].word, expected.kept[i].word);
  }
}

std::vector<codec::Codeword> sorted(std::vector<codec::Codeword> words) {
  std::sort(words.begin(), words.end());
  return words;
}

TEST(MpiCrew, SiftsLikeTheLocalOneWhileItLearns) {
  const Sample sample;
  const auto crew = g_cluster->crew_maker()(sample.rules, 1);
  const auto reference = codec::local_crew(sample.rules, 1);
  std::uint64_t first = 0;
  // Rounds of growing length: the leader's own at first, then shared.
  for (codec::TagId known = 0; known < 40; known += 10) {
    const std::uint64_t count = std::uint64_t{1} << (known / 2 + 6);
    expect_same_sifting(*crew, *reference, first, count);
    first += count;
    crew->learn(sample.codes(known, 10));
    reference->learn(sample.codes(known, 10));
  }
  expect_same_sifting(*crew, *reference, first, 1 << 20);
}

TEST(MpiCrew, ListsTheSameOpenTagsAsTheLocalOne) {
  const Sample sample;
  const auto crew = g_cluster->crew_maker()(sample.rules, 1);
  const auto reference = codec::local_crew(sample.rules, 1);
  crew->learn(sample.codes(0, 300));
  reference->learn(sample.codes(0, 300));
  std::uint64_t first = 0;
  for (const std::uint64_t count : {1, 16, 512}) {
    EXPECT_EQ(sorted(crew->list_open(first, count)), sorted(reference->list_open(first, count)));
    first += count;
  }
}

TEST(MpiCrew, OneSearchFollowsAnother) {
  const Sample sample;
  codec::SearchRules rules = sample.rules;
  for (const int distance : {11, 8}) {
    rules.min_hamming = distance;
    const auto crew = g_cluster->crew_maker()(rules, 0);
    const auto reference = codec::local_crew(rules, 1);
    expect_same_sifting(*crew, *reference, 5, 1000);
    expect_same_sifting(*crew, *reference, 1005, 1 << 20);
  }
}

}  // namespace
}  // namespace tagmint::cluster

int main(int argc, char** argv) {
  tagmint::cluster::Cluster cluster;
  if (!cluster.leads()) return cluster.serve();
  tagmint::cluster::g_cluster = &cluster;
  testing::InitGoogleTest(&argc, argv);
  const int exit_code = RUN_ALL_TESTS();
  cluster.end(exit_code);
  return exit_code;
}
