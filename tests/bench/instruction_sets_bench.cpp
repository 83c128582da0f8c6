// The search for tag36h11 with each instruction set that this machine has.

#define HWY_WANT_AVX3_DL  // as the kernels: the AVX-512 that counts bits is one of the sets
#include <benchmark/benchmark.h>
#include <hwy/targets.h>

#include <cstdint>
#include <string>

#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/search/lexicode.h"

namespace tagmint::codec {
namespace {

/// One thread. Checks the number of codes.
void search_36h11(benchmark::State& state, std::int64_t target) {
  const SharedFamily family = find_family("tag36h11");
  const LexicodeOptions options{.layout = family->layout(),
                                .min_hamming = family->min_hamming(),
                                .order = parse_order(family->origin().order),
                                .complexity = family->complexity(),
                                .threads = 1};
  hwy::SetSupportedTargetsForTest(target);
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  for (auto _ : state) {
    if (search_lexicode(options).codewords.size() != family->size()) {
      state.SkipWithError("wrong number of codes");
    }
  }
  hwy::SetSupportedTargetsForTest(0);
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

const bool kRegistered = [] {
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    const std::string name = std::string("search_36h11/") + hwy::TargetName(target);
    benchmark::RegisterBenchmark(name.c_str(), search_36h11, target)
        ->Unit(benchmark::kMillisecond)
        ->Iterations(1);
  }
  return true;
}();

}  // namespace
}  // namespace tagmint::codec
