#include "kernels/orbit_kernels.h"

#include <gtest/gtest.h>

#include <memory>

#include "support/fixed_random.h"
#include "support/instruction_sets.h"

namespace tagmint::codec {
namespace {

/// Addresses of few bits, so that equal ones occur.
struct Sample {
  explicit Sample(testing::FixedRandom& random, int address_bits) {
    const auto address = [&] {
      return static_cast<std::uint32_t>(random.bits() & low_mask(address_bits));
    };
    for (auto& turn : low.turned) {
      for (std::uint32_t& turned : turn) turned = address();
    }
    for (ChangeBits& changes : low.changes) {
      for (std::uint64_t& word : changes) word = random.bits() & random.bits();
    }
    high.address = address() & ~std::uint32_t{63};
    for (std::uint32_t& turned : high.turned) turned = address();
    for (std::uint64_t& word : high.changes) word = random.bits() & random.bits();
  }

  LowAddresses low;
  HighAddress high;
};

TEST(OrbitKernels, EqualTheScalarReference) {
  testing::with_every_instruction_set([] {
    testing::FixedRandom random(5);
    for (int i = 0; i < 400; ++i) {
      const auto sample = std::make_unique<Sample>(random, i % 4 == 0 ? 30 : 7);
      ASSERT_EQ(smallest_of_orbit(sample->low, sample->high),
                scalar::smallest_of_orbit(sample->low, sample->high));
      const std::uint64_t chosen = random.bits();
      const int least = random.between(60, 100);
      ASSERT_EQ(with_changes(chosen, sample->low, sample->high, least),
                scalar::with_changes(chosen, sample->low, sample->high, least));
    }
  });
}

}  // namespace
}  // namespace tagmint::codec
