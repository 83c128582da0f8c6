#include "false_accepts/measured_codes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/family_stats.h"

namespace tagmint::bench {
namespace {

std::shared_ptr<const codec::Decoder> decoder_of(const MeasuredCode& code, int max_errors) {
  codec::DecoderOptions options;
  options.max_errors = max_errors;
  if (code.codes < code.family->size()) {
    options.ids.resize(code.codes);
    std::iota(options.ids.begin(), options.ids.end(), codec::TagId{0});
  }
  return std::make_shared<const codec::Decoder>(code.family, options);
}

}  // namespace

std::string MeasuredCode::name() const {
  return fmt::format("{}, {} tags at {}", family->name(), codes, min_hamming);
}

double MeasuredCode::share_within(int errors) const {
  return errors < 0 ? 0 : codec::false_accept_rate(codes, family->bits(), errors);
}

double MeasuredCode::share_at(int errors) const {
  double words = 4.0 * static_cast<double>(codes);
  for (int i = 1; i <= errors; ++i) words *= (family->bits() - i + 1.0) / i;
  return std::ldexp(words, -family->bits());
}

std::vector<MeasuredCode> measured_codes(const std::vector<std::string>& families) {
  std::vector<MeasuredCode> codes;
  for (const std::string& name : families) {
    const codec::SharedFamily family = codec::load_family(name);
    for (const codec::Level& level : family->levels()) {
      MeasuredCode code{family, level.codes, level.min_hamming, (level.min_hamming - 1) / 2,
                        {},     {}};
      code.at_two = decoder_of(code, std::min(2, code.safe_errors));
      code.at_safe = code.safe_errors <= 2 ? code.at_two : decoder_of(code, code.safe_errors);
      codes.push_back(std::move(code));
    }
  }
  return codes;
}

Interval confidence(std::uint64_t hits, std::uint64_t trials) {
  if (trials == 0) return {0, 1};
  constexpr double kTwoSided = 1.959964;  // standard deviations that hold 95 %
  const double z2 = kTwoSided * kTwoSided;
  const auto n = static_cast<double>(trials);
  const double p = static_cast<double>(hits) / n;
  const double middle = (p + z2 / (2 * n)) / (1 + z2 / n);
  const double half = kTwoSided / (1 + z2 / n) * std::sqrt(p * (1 - p) / n + z2 / (4 * n * n));
  return {hits == 0 ? 0 : middle - half, hits == trials ? 1 : middle + half};
}

std::string beside(std::uint64_t counted, double expected) {
  const char* form = expected >= 1000  ? "{} ({:.0f})"
                     : expected >= 0.1 ? "{} ({:.1f})"
                                       : "{} ({:.0e})";
  return fmt::format(fmt::runtime(form), counted, expected);
}

std::string as_markdown(const Table& table) {
  std::string text;
  for (std::size_t i = 0; i < table.size(); ++i) {
    text += fmt::format("| {} |\n", fmt::join(table[i], " | "));
    if (i > 0) continue;
    for (std::size_t column = 0; column < table[i].size(); ++column) text += "|---";
    text += "|\n";
  }
  return text;
}

std::string as_csv(const Table& table) {
  std::string text;
  for (const auto& row : table) text += fmt::format("{}\n", fmt::join(row, ","));
  return text;
}

}  // namespace tagmint::bench
