#include "false_accepts/random_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <thread>

#include "support/fixed_random.h"
#include "tagmint/codec/codeword.h"

namespace tagmint::bench {
namespace {

/// Words that a thread takes at once; each block has its own seed.
constexpr std::uint64_t kBlock = std::uint64_t{1} << 16;

void decode_block(const codec::Decoder& decoder, std::uint64_t seed, std::uint64_t words,
                  std::vector<std::uint64_t>& by_errors) {
  testing::FixedRandom random(seed);
  const codec::Codeword mask = codec::low_mask(decoder.family()->bits());
  for (std::uint64_t i = 0; i < words; ++i) {
    if (const auto match = decoder.decode(random.bits() & mask)) ++by_errors[match->hamming];
  }
}

int threads_of(int asked) {
  return asked > 0 ? asked : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

std::vector<std::string> row_of(const MeasuredCode& code, int errors, const WordCounts& counts) {
  const double expected = code.share_within(errors);
  const std::uint64_t hits = counts.accepted[errors];
  const Interval interval = confidence(hits, counts.words);
  const bool agrees = interval.low <= expected && expected <= interval.high;
  return {code.family->name(),
          fmt::to_string(code.codes),
          fmt::to_string(code.min_hamming),
          fmt::to_string(errors),
          fmt::format("{:.1e}", static_cast<double>(counts.words)),
          fmt::to_string(hits),
          fmt::format("{:.3e}", static_cast<double>(hits) / static_cast<double>(counts.words)),
          fmt::format("{:.3e} to {:.3e}", interval.low, interval.high),
          fmt::format("{:.3e}", expected),
          agrees ? "yes" : "no"};
}

}  // namespace

WordCounts decode_random_words(const codec::Decoder& decoder, std::uint64_t words,
                               std::uint64_t seed, int threads) {
  const auto entries = static_cast<std::size_t>(decoder.max_errors()) + 1;
  std::vector<std::vector<std::uint64_t>> counts(static_cast<std::size_t>(threads_of(threads)),
                                                 std::vector<std::uint64_t>(entries));
  std::atomic<std::uint64_t> next_block = 0;
  std::vector<std::thread> crew;
  for (auto& mine : counts) {
    crew.emplace_back([&] {
      for (std::uint64_t block = next_block++; block * kBlock < words; block = next_block++) {
        // Blocks start far apart in the generator's sequence of 2^64.
        decode_block(decoder, (seed << 32) + (block << 40),
                     std::min(kBlock, words - block * kBlock), mine);
      }
    });
  }
  for (std::thread& thread : crew) thread.join();
  WordCounts result{words, std::vector<std::uint64_t>(entries)};
  for (const auto& of_thread : counts) {
    for (std::size_t i = 0; i < entries; ++i) result.accepted[i] += of_thread[i];
  }
  for (std::size_t i = 1; i < entries; ++i) result.accepted[i] += result.accepted[i - 1];
  return result;
}

Table random_words_table(std::span<const MeasuredCode> codes, const RandomWordsPlan& plan) {
  Table table = {{"family", "tags", "distance", "corrected bits", "random words", "accepted",
                  "measured rate", "95 % interval", "4 N sum C(n, i) / 2^n", "agrees"}};
  for (const MeasuredCode& code : codes) {
    fmt::print(stderr, "random words: {}\n", code.name());
    const WordCounts near =
        decode_random_words(*code.at_two, plan.words_at_two, plan.seed, plan.threads);
    for (int errors = 0; errors <= code.at_two->max_errors(); ++errors) {
      table.push_back(row_of(code, errors, near));
    }
    if (code.safe_errors <= 2) continue;
    const WordCounts safe =
        decode_random_words(*code.at_safe, plan.words_at_safe, plan.seed + 1, plan.threads);
    table.push_back(row_of(code, code.safe_errors, safe));
  }
  return table;
}

}  // namespace tagmint::bench
