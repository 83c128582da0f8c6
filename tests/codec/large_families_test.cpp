// Proofs over all pairs of the families with tens of thousands of tags.

#include <gtest/gtest.h>

#include <string>

#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/decoder.h"
#include "tagmint/codec/family_check.h"
#include "tagmint/codec/rotation.h"

namespace tagmint::codec {
namespace {

class LargeFamily : public testing::TestWithParam<const char*> {};

TEST_P(LargeFamily, KeepsItsWord) {
  const FamilyCheck check = check_family(*find_family(GetParam()));
  EXPECT_FALSE(check.violation) << check.violation->message;
}

TEST_P(LargeFamily, EveryTagIsFoundWithOneErrorInEveryTurn) {
  const SharedFamily family = find_family(GetParam());
  const int bits = family->bits();
  const Decoder decoder(family);
  for (TagId id = 0; id < family->size(); ++id) {
    for (int i = 0; i < bits; ++i) {
      const Codeword damaged = family->codeword(id) ^ (Codeword{1} << i);
      const int turns = i % 4;
      ASSERT_EQ(decoder.decode(rotate(damaged, bits, 4 - turns)), (Match{id, 1, turns}));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Published, LargeFamily,
                         testing::Values("tagCustom48h12", "tagCircle49h12", "tagStandard52h13"),
                         [](const auto& info) { return std::string(info.param); });

}  // namespace
}  // namespace tagmint::codec
