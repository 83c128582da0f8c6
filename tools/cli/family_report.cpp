#include "cli/family_report.h"

#include <algorithm>
#include <cmath>

#include "tagmint/codec/complexity.h"
#include "tagmint/codec/family_file.h"

namespace tagmint::cli {
namespace {

using codec::ComplexityRule;
using codec::DecoderEngine;

/// Energy is counted in steps of 1 / kEnergySteps.
constexpr double kEnergySteps = 20.0;

std::map<double, std::size_t> complexity_histogram(const codec::Family& family) {
  const bool rectangles = family.complexity().rule == ComplexityRule::Rectangles;
  const codec::Complexity measure = {
      .rule = rectangles ? ComplexityRule::Rectangles : ComplexityRule::Energy, .threshold = 0.0};
  const codec::ComplexityJudge judge(family.layout(), measure);
  std::map<double, std::size_t> histogram;
  for (const codec::Codeword word : codec::first_codewords(family, family.size())) {
    const double value = judge.measure(word);
    ++histogram[rectangles ? value : std::floor(value * kEnergySteps) / kEnergySteps];
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

FamilyReport make_family_report(codec::SharedFamily family, int threads) {
  FamilyReport report;
  report.digest = codec::family_digest(*family);
  report.stats = codec::family_stats(*family, threads);
  report.complexity_measure =
      family->complexity().rule == ComplexityRule::Rectangles ? "rectangles" : "energy";
  report.complexity_histogram = complexity_histogram(*family);
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
