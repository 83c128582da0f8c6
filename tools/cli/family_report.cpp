#include "cli/family_report.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>
#include <thread>

#include "tagmint/codec/complexity.h"
#include "tagmint/codec/family_file.h"

namespace tagmint::cli {
namespace {

using codec::ComplexityRule;
using codec::DecoderEngine;

/// Codewords that a thread takes at a time.
constexpr std::size_t kCodewordsAtATime = 1024;

/// Threads worth their start.
int worker_count(int threads, std::size_t codewords) {
  const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  const auto most = static_cast<int>(codewords / kCodewordsAtATime + 1);
  return std::min(threads > 0 ? threads : cores, most);
}

/// Whole numbers divide without a remainder, so that bars have round names.
constexpr double kEnergySteps = 1 / kEnergyStep;

/// The nearest pairs that are named.
constexpr std::size_t kNearestNamed = 3;

/// Index of the first entry that is not zero; nothing when all are.
std::optional<int> first_used(const std::vector<std::uint64_t>& histogram) {
  const auto used = std::find_if(histogram.begin(), histogram.end(), [](auto n) { return n > 0; });
  if (used == histogram.end()) return std::nullopt;
  return static_cast<int>(used - histogram.begin());
}

using ComplexityHistogram = std::map<double, std::size_t>;

ComplexityHistogram complexity_histogram(const codec::Family& family, int threads) {
  const bool rectangles = family.complexity().rule == ComplexityRule::Rectangles;
  const codec::Complexity measure = {
      .rule = rectangles ? ComplexityRule::Rectangles : ComplexityRule::Energy, .threshold = 0.0};
  const codec::ComplexityJudge judge(family.layout(), measure);
  std::mutex adding;
  ComplexityHistogram histogram;
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    ComplexityHistogram own;
    for (std::size_t first; (first = next.fetch_add(kCodewordsAtATime)) < family.size();) {
      for (const codec::Codeword word :
           codec::some_codewords(family, static_cast<codec::TagId>(first), kCodewordsAtATime)) {
        const double value = judge.measure(word);
        ++own[rectangles ? value : std::floor(value * kEnergySteps) / kEnergySteps];
      }
    }
    const std::scoped_lock lock(adding);
    for (const auto& [value, tags] : own) histogram[value] += tags;
  };
  {
    std::vector<std::jthread> others;
    for (int i = 1; i < worker_count(threads, family.size()); ++i) others.emplace_back(work);
    work();
  }
  return histogram;
}

constexpr int kMostHashErrors = 2;

LookupMemory memory_of(const codec::SharedFamily& family, DecoderEngine engine, int max_errors) {
  codec::DecoderOptions options;
  options.max_errors = max_errors;
  options.engine = engine;
  return {engine, max_errors, codec::Decoder(family, options).table_bytes()};
}

/// Of generated families the engine that needs no list. The hash tables of listed ones are
/// reckoned, not built: those of a large family would fill the memory.
std::vector<LookupMemory> lookup_memory(const codec::SharedFamily& family) {
  std::vector<LookupMemory> all;
  for (int radius = 0; radius <= family->max_safe_errors(); ++radius) {
    if (!family->is_listed()) {
      all.push_back(memory_of(family, DecoderEngine::InformationSets, radius));
      continue;
    }
    if (radius <= kMostHashErrors) {
      all.push_back(
          {DecoderEngine::Hash, radius, codec::Decoder::hash_table_bytes(*family, radius)});
    }
    all.push_back(memory_of(family, DecoderEngine::Chunks, radius));
  }
  return all;
}

}  // namespace

std::optional<int> FamilyReport::safe_errors() const {
  const int distance = std::min(family->min_hamming(), stats.min_hamming);
  return distance > 0 ? std::optional((distance - 1) / 2) : std::nullopt;
}

FamilyReport make_family_report(codec::SharedFamily family, int threads) {
  FamilyReport report;
  report.digest =
      family->declared_digest().empty() ? codec::family_digest(*family) : family->declared_digest();
  report.stats = codec::family_stats(*family, threads);
  report.between = first_used(report.stats.distance_histogram);
  report.self_distance = first_used(report.stats.self_histogram).value_or(family->bits());
  if (report.between) {
    report.nearest = codec::near_pairs(*family, *report.between, kNearestNamed, threads);
  }
  report.complexity_measure =
      family->complexity().rule == ComplexityRule::Rectangles ? "rectangles" : "energy";
  report.complexity_histogram = complexity_histogram(*family, threads);
  report.lookup = lookup_memory(family);
  report.family = std::move(family);
  return report;
}

std::string engine_name(DecoderEngine engine) {
  switch (engine) {
    case DecoderEngine::BruteForce:
      return "brute-force";
    case DecoderEngine::Hash:
      return "hash";
    case DecoderEngine::Chunks:
      return "chunks";
    case DecoderEngine::InformationSets:
      return "information-sets";
    case DecoderEngine::Auto:
      break;
  }
  return "auto";
}

}  // namespace tagmint::cli
