// How long a random word and a word with two errors take to be looked up, by family and engine.

#include <benchmark/benchmark.h>

#include <string>
#include <utility>
#include <vector>

#include "support/fixed_random.h"
#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/decoder.h"

namespace tagmint {
namespace {

enum class Words { Random, TwoErrors };

std::vector<codec::Codeword> words_of(const codec::Family& family, Words kind) {
  testing::FixedRandom random(3);
  std::vector<codec::Codeword> words;
  for (int i = 0; i < 4096; ++i) {
    if (kind == Words::Random) {
      words.push_back(random.bits() & codec::low_mask(family.bits()));
      continue;
    }
    const auto id = static_cast<codec::TagId>(random.bits() % family.size());
    const codec::Codeword first = codec::Codeword{1} << random.bits() % family.bits();
    const codec::Codeword second = codec::Codeword{1} << random.bits() % family.bits();
    words.push_back(family.codeword(id) ^ first ^ second);
  }
  return words;
}

void look_up(benchmark::State& state, const char* name, codec::DecoderEngine engine, Words kind) {
  const codec::SharedFamily family = codec::find_family(name);
  const codec::Decoder decoder(
      family, {.max_errors = 2, .allow_unsafe_radius = false, .engine = engine, .ids = {}});
  const std::vector<codec::Codeword> words = words_of(*family, kind);
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(decoder.decode(words[i++ % words.size()]));
  state.counters["table_bytes"] = static_cast<double>(decoder.table_bytes());
}

const int registered = [] {
  using codec::DecoderEngine;
  for (const char* name :
       {"tag36h11", "tag36h10", "tagStandard41h12", "tagCustom48h12", "tagStandard52h13"}) {
    for (const auto& [engine, label] :
         {std::pair{DecoderEngine::Hash, "hash"}, std::pair{DecoderEngine::Chunks, "chunks"}}) {
      const codec::SharedFamily family = codec::find_family(name);
      if (engine == DecoderEngine::Hash && family->size() > 10000) continue;  // gigabytes
      for (const auto& [kind, what] :
           {std::pair{Words::Random, "random"}, std::pair{Words::TwoErrors, "two_errors"}}) {
        benchmark::RegisterBenchmark((std::string(name) + "/" + label + "/" + what).c_str(),
                                     look_up, name, engine, kind);
      }
    }
  }
  return 0;
}();

}  // namespace
}  // namespace tagmint
