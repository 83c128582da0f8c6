#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "tagmint/codec/decoder.h"
#include "tagmint/codec/family.h"

namespace tagmint::bench {

/// One level of a family, the codes whose false accepts are counted.
struct MeasuredCode {
  codec::SharedFamily family;
  std::size_t codes = 0;  ///< of the level: ids 0 .. codes - 1
  int min_hamming = 0;
  int safe_errors = 0;
  std::shared_ptr<const codec::Decoder> at_two;   ///< corrects min(2, safe_errors)
  std::shared_ptr<const codec::Decoder> at_safe;  ///< corrects safe_errors

  /// "rot36, 60 tags at 16".
  std::string name() const;
  /// Share of random words exactly `errors` bits from some turn of a tag: 4 codes C(bits, errors) /
  /// 2^bits. Exact for errors up to safe_errors.
  double share_at(int errors) const;
  /// The sum of share_at() up to `errors`.
  double share_within(int errors) const;
};

/// Every level of those families (names or paths).
std::vector<MeasuredCode> measured_codes(const std::vector<std::string>& families);

/// An interval of probabilities.
struct Interval {
  double low = 0;
  double high = 0;
};

/// Where the probability of an event seen `hits` times in `trials` lies with 95 % confidence:
/// Wilson's score interval.
Interval confidence(std::uint64_t hits, std::uint64_t trials);

/// Rows of cells; the first is the header.
using Table = std::vector<std::vector<std::string>>;
/// "12 (10.4)": counted, and what the formula expects.
std::string beside(std::uint64_t counted, double expected);
std::string as_markdown(const Table& table);
std::string as_csv(const Table& table);

}  // namespace tagmint::bench
