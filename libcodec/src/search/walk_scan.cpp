#include "search/walk_scan.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "search/parallel.h"

namespace tagmint::codec {
namespace {

int checked_distance(const LexicodeOptions& options) {
  const int bits = options.layout.bits();
  if (options.min_hamming < 1 || options.min_hamming > bits) {
    throw std::invalid_argument(
        fmt::format("minimum Hamming distance {} is not possible with {} bits; 1 to {} are",
                    options.min_hamming, bits, bits));
  }
  return options.min_hamming;
}

Walk walk_of(const LexicodeOptions& options) {
  return Walk(options.layout, options.order,
              walk_seed(options.order, options.layout, options.min_hamming, options.complexity));
}

}  // namespace

WalkScan::WalkScan(const LexicodeOptions& options)
    : options_(options),
      control_(options),
      walk_(walk_of(options)),
      greedy_(options.layout, checked_distance(options), options.complexity, walk_,
              thread_count(options.threads)),
      last_(low_mask(options.layout.bits())),
      max_codes_(options.limit_codes.value_or(std::numeric_limits<std::size_t>::max())) {
  if (options.limit_words && *options.limit_words <= last_) last_ = *options.limit_words - 1;
}

SearchEnd WalkScan::end_of_words() const {
  return last_ == low_mask(walk_.bits()) ? SearchEnd::Complete : SearchEnd::LimitWords;
}

std::optional<SearchEnd> WalkScan::step() {
  if (options_.limit_words == 0) return SearchEnd::LimitWords;
  if (greedy_.codewords().size() >= max_codes_) return SearchEnd::LimitCodes;
  if (const auto end = control_.must_end()) return end;

  const std::uint64_t beyond_first = last_ - next_;  // words left but one: 2^64 do not fit
  const std::uint64_t count = std::min(pacer_.words() - 1, beyond_first) + 1;
  const auto before = control_.elapsed();
  const Greedy::Round round = greedy_.judge(
      [this](std::uint64_t first, std::span<Codeword> words) {
        const Codeword mask = low_mask(walk_.bits());
        Codeword word = walk_.visited(first + 1);
        for (Codeword& slot : words) {
          slot = word;
          word = (word + Walk::kStep) & mask;
        }
      },
      next_, count, max_codes_);
  pacer_.learn(round, control_.elapsed() - before);
  remember(round);
  next_ += round.judged;
  control_.report(next_, words_total(), greedy_.codewords().size());
  if (greedy_.codewords().size() >= max_codes_) return SearchEnd::LimitCodes;
  if (next_ == last_ + 1) return end_of_words();
  return std::nullopt;
}

void WalkScan::remember(const Greedy::Round& round) {
  constexpr double kOpenWordsRemembered = 60;  // a recent share, right to some 15 per cent
  if (recent_open_ > kOpenWordsRemembered) {
    recent_open_ /= 2;
    recent_words_ /= 2;
  }
  recent_words_ += static_cast<double>(round.judged);
  recent_open_ += static_cast<double>(round.distant);
}

LexicodeResult WalkScan::result(SearchEnd end) const { return {greedy_.codewords(), next_, end}; }

}  // namespace tagmint::codec
