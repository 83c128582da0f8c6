// How long a random word and a word with errors take to be looked up: first, without a filter, as a
// table beside libapriltag's way where that is installed; then by family, engine and number of
// corrected errors. Family files given as arguments are measured beside the bundled families:
//   decoder_bench my.json --benchmark_filter=my

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdio>
#include <exception>
#include <numeric>
#include <set>
#include <string>
#include <utility>
#include <vector>

#ifdef TAGMINT_HAVE_APRILTAG
#include "decoders_beside_libapriltag.h"
#endif
#include "support/fixed_random.h"
#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/decoder.h"

namespace tagmint {
namespace {

using codec::DecoderEngine;

/// One way to look up the ids of one level.
struct Case {
  codec::SharedFamily family;
  std::size_t level = 0;
  DecoderEngine engine = DecoderEngine::Auto;
  int errors = 0;
};

enum class Words { Random, Damaged };

std::vector<codec::Codeword> words_of(const Case& one, Words kind) {
  const codec::Family& family = *one.family;
  testing::FixedRandom random(3);
  std::vector<codec::Codeword> words;
  for (int i = 0; i < 4096; ++i) {
    if (kind == Words::Random) {
      words.push_back(random.bits() & codec::low_mask(family.bits()));
      continue;
    }
    const std::size_t ids = family.levels()[one.level].codes;
    const codec::Codeword tag = family.codeword(static_cast<codec::TagId>(random.bits() % ids));
    codec::Codeword flips = 0;
    while (std::popcount(flips) < one.errors) {
      flips |= codec::Codeword{1} << random.between(0, family.bits() - 1);
    }
    words.push_back(tag ^ flips);
  }
  return words;
}

codec::Decoder decoder_of(const Case& one) {
  codec::DecoderOptions options;
  options.max_errors = one.errors;
  options.engine = one.engine;
  if (one.level + 1 < one.family->levels().size()) {
    options.ids.resize(one.family->levels()[one.level].codes);
    std::iota(options.ids.begin(), options.ids.end(), 0);
  }
  return codec::Decoder(one.family, std::move(options));
}

void look_up(benchmark::State& state, const Case& one, Words kind) {
  const codec::Decoder decoder = decoder_of(one);
  const std::vector<codec::Codeword> words = words_of(one, kind);
  std::size_t found = 0;
  for (const codec::Codeword word : words) found += decoder.decode(word).has_value();
  if (kind == Words::Damaged && found < words.size()) state.SkipWithError("a tag was not found");
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(decoder.decode(words[i++ % words.size()]));
  state.counters["table_bytes"] = static_cast<double>(decoder.table_bytes());
}

void register_case(const Case& one, const std::string& engine) {
  const std::string name = fmt::format("{}/{}/{}/{}_errors", one.family->name(),
                                       one.family->levels()[one.level].codes, engine, one.errors);
  for (const auto& [kind, what] :
       {std::pair{Words::Random, "random"}, std::pair{Words::Damaged, "tags"}}) {
    benchmark::RegisterBenchmark(
        fmt::format("{}/{}", name, what).c_str(),
        [one, words = kind](benchmark::State& state) { look_up(state, one, words); });
  }
}

/// Lists are measured at two errors, generators level by level at 2, 5 and all safe errors.
void register_family(const codec::SharedFamily& family) {
  const std::size_t levels = family->levels().size();
  if (family->is_listed()) {
    if (family->size() <= 10000) {  // else gigabytes
      register_case({family, levels - 1, DecoderEngine::Hash, 2}, "hash");
    }
    register_case({family, levels - 1, DecoderEngine::Chunks, 2}, "chunks");
    return;
  }
  for (std::size_t level = 0; level < levels; ++level) {
    const int safe = (family->levels()[level].min_hamming - 1) / 2;
    for (const int errors : std::set<int>{std::min(2, safe), std::min(5, safe), safe}) {
      register_case({family, level, DecoderEngine::InformationSets, errors}, "information_sets");
    }
  }
}

int run(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
#ifdef TAGMINT_HAVE_APRILTAG
  if (benchmark::GetBenchmarkFilter().empty()) bench::print_decoders_beside_libapriltag();
#endif
  try {
    for (const char* name : {"tag16h5", "tagCircle21h7", "tag25h9", "tag36h11", "tag36h10",
                             "tagStandard41h12", "tagCustom48h12", "tagStandard52h13"}) {
      register_family(codec::find_family(name));
    }
    for (const std::string& name : codec::family_names()) {
      const codec::SharedFamily family = codec::find_family(name);
      if (!family->is_listed()) register_family(family);
    }
    for (int i = 1; i < argc; ++i) register_family(codec::load_family(argv[i]));
  } catch (const std::exception& fault) {
    fmt::print(stderr, "{}\n", fault.what());
    return 3;
  }
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}

}  // namespace
}  // namespace tagmint

int main(int argc, char** argv) { return tagmint::run(argc, argv); }
