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
  const std::uint64_t hits = counts.accepted[errors];
  const Interval interval = confidence(hits, counts.words);
  return {code.family->name(),
          fmt::to_string(code.codes),
          fmt::to_string(code.min_hamming),
          fmt::to_string(errors),
          fmt::to_string(counts.words),
          fmt::to_string(hits),
          fmt::format("{:.4g}", interval.low),
          fmt::format("{:.4g}", interval.high),
          fmt::format("{:.4g}", code.share_within(errors))};
}

std::string cell_of(const MeasuredCode& code, int errors, const WordCounts& counts) {
  return beside(counts.accepted[errors],
                static_cast<double>(counts.words) * code.share_within(errors));
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

std::vector<RandomWords> count_random_words(std::span<const MeasuredCode> codes,
                                            const RandomWordsPlan& plan) {
  std::vector<RandomWords> counts;
  for (const MeasuredCode& code : codes) {
    fmt::print(stderr, "random words: {}\n", code.name());
    RandomWords& of_code = counts.emplace_back();
    of_code.at_two = decode_random_words(*code.at_two, plan.words_at_two, plan.seed, plan.threads);
    if (code.safe_errors <= 2) continue;
    of_code.at_safe =
        decode_random_words(*code.at_safe, plan.words_at_safe, plan.seed + 1, plan.threads);
  }
  return counts;
}

Table random_words_table(std::span<const RandomWords> counts, std::span<const MeasuredCode> codes) {
  Table table = {{"family", "tags", "distance", "words", "up to 0 errors", "1", "2", "words",
                  "up to the safe radius"}};
  for (std::size_t i = 0; i < codes.size(); ++i) {
    const MeasuredCode& code = codes[i];
    const auto& [at_two, at_safe] = counts[i];
    std::vector<std::string> row = {code.family->name(), fmt::to_string(code.codes),
                                    fmt::to_string(code.min_hamming),
                                    fmt::format("{:.0e}", static_cast<double>(at_two.words))};
    for (int errors = 0; errors <= 2; ++errors) {
      row.push_back(errors > code.safe_errors ? "-" : cell_of(code, errors, at_two));
    }
    row.push_back(at_safe.words == 0 ? "-"
                                     : fmt::format("{:.0e}", static_cast<double>(at_safe.words)));
    row.push_back(at_safe.words == 0 ? "-"
                                     : fmt::format("{}: {}", code.safe_errors,
                                                   cell_of(code, code.safe_errors, at_safe)));
    table.push_back(std::move(row));
  }
  return table;
}

Table random_words_by_errors(std::span<const RandomWords> counts,
                             std::span<const MeasuredCode> codes) {
  Table table = {{"family", "tags", "distance", "corrected", "words", "accepted", "low", "high",
                  "expected_rate"}};
  for (std::size_t i = 0; i < codes.size(); ++i) {
    const MeasuredCode& code = codes[i];
    for (int errors = 0; errors <= code.at_two->max_errors(); ++errors) {
      table.push_back(row_of(code, errors, counts[i].at_two));
    }
    if (counts[i].at_safe.words == 0) continue;
    table.push_back(row_of(code, code.safe_errors, counts[i].at_safe));
  }
  return table;
}

std::string agreement(std::span<const RandomWords> counts, std::span<const MeasuredCode> codes) {
  int intervals = 0;
  int holding = 0;
  const auto add = [&](const MeasuredCode& code, int errors, const WordCounts& of_words) {
    const Interval interval = confidence(of_words.accepted[errors], of_words.words);
    const double expected = code.share_within(errors);
    ++intervals;
    if (interval.low <= expected && expected <= interval.high) ++holding;
  };
  for (std::size_t i = 0; i < codes.size(); ++i) {
    for (int errors = 0; errors <= codes[i].at_two->max_errors(); ++errors) {
      add(codes[i], errors, counts[i].at_two);
    }
    if (counts[i].at_safe.words > 0) add(codes[i], codes[i].safe_errors, counts[i].at_safe);
  }
  return fmt::format("{} of {} intervals of 95 % confidence hold the formula's rate", holding,
                     intervals);
}

}  // namespace tagmint::bench
