#pragma once

#define HWY_WANT_AVX3_DL  // as the kernels: the AVX-512 that counts bits is one of the sets
#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <cstdint>

namespace tagmint::testing {

/// Runs `check` with each instruction set that was compiled and that this machine has.
template <typename Check>
void with_every_instruction_set(const Check& check) {
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    SCOPED_TRACE(hwy::TargetName(target));
    check();
  }
  hwy::SetSupportedTargetsForTest(0);
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

}  // namespace tagmint::testing
