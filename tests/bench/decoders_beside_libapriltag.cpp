#include "decoders_beside_libapriltag.h"

#include <apriltag/apriltag.h>
#include <apriltag/tag36h11.h>
#include <apriltag/tagStandard41h12.h>
#include <apriltag/tagStandard52h13.h>
#include <fmt/format.h>
#include <malloc.h>
#include <time.h>

#include <algorithm>
#include <bit>
#include <cstdio>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "published_table.h"
#include "support/fixed_random.h"
#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/decoder.h"
#include "tagmint/codec/rotation.h"

namespace tagmint::bench {
namespace {

using codec::Codeword;
using codec::DecoderEngine;

/// Words of a round: so many that large tables do not stay in the caches.
constexpr std::size_t kWords = std::size_t{1} << 18;
constexpr int kRounds = 15;
constexpr int kErrors = 2;

/// Processor time of this thread, so that other work on the machine counts little.
double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double seconds_of(const std::function<void()>& work) {
  const double start = thread_seconds();
  work();
  return thread_seconds() - start;
}

std::vector<Codeword> random_words(const codec::Family& family) {
  testing::FixedRandom random(3);
  std::vector<Codeword> words(kWords);
  for (Codeword& word : words) word = random.bits() & codec::low_mask(family.bits());
  return words;
}

/// Tags with two errors, in any turn.
std::vector<Codeword> damaged_tags(const codec::Family& family) {
  testing::FixedRandom random(4);
  std::vector<Codeword> words;
  for (std::size_t i = 0; i < kWords; ++i) {
    Codeword flips = 0;
    while (std::popcount(flips) < kErrors) {
      flips |= Codeword{1} << random.between(0, family.bits() - 1);
    }
    const auto id = static_cast<codec::TagId>(random.bits() % family.size());
    words.push_back(codec::rotate(family.codeword(id) ^ flips, family.bits(),
                                  static_cast<int>(random.bits() % 4)));
  }
  return words;
}

/// Something that looks words up, and its fastest rounds.
struct Contender {
  std::string name;
  double build_s = 0;
  std::size_t bytes = 0;
  double damaged_s = std::numeric_limits<double>::infinity();
  double random_s = std::numeric_limits<double>::infinity();
};

/// Looks all words up; returns how many were found. A template, so that a call costs as much for
/// each contender as it does in a program.
template <typename Decode>
std::size_t count_found(const std::vector<Codeword>& words, const Decode& decode) {
  std::size_t found = 0;
  for (const Codeword word : words) found += decode(word).has_value();
  return found;
}

std::size_t heap_bytes() {
  const struct mallinfo2 info = mallinfo2();
  return info.uordblks + info.hblkhd;
}

/// What libapriltag itself takes to make its table, in time and heap.
std::string library_line(const std::string& name) {
  apriltag_family_t* family = nullptr;
  void (*destroy)(apriltag_family_t*) = nullptr;
  if (name == "tag36h11") {
    family = tag36h11_create();
    destroy = tag36h11_destroy;
  } else if (name == "tagStandard41h12") {
    family = tagStandard41h12_create();
    destroy = tagStandard41h12_destroy;
  } else {
    family = tagStandard52h13_create();
    destroy = tagStandard52h13_destroy;
  }
  apriltag_detector_t* const detector = apriltag_detector_create();
  const std::size_t before = heap_bytes();
  const double build_s =
      seconds_of([&] { apriltag_detector_add_family_bits(detector, family, kErrors); });
  const std::size_t bytes = heap_bytes() - before;
  apriltag_detector_destroy(detector);
  destroy(family);
  return fmt::format("| {} | libapriltag 3.3, its own table | {:.1f} ms | {} | - | - |\n", name,
                     1e3 * build_s, bytes);
}

/// One of our engines.
struct Engine {
  std::optional<codec::Decoder> decoder;
  Contender result;
};

void measure(const codec::SharedFamily& family) {
  const std::vector<Codeword> random = random_words(*family);
  const std::vector<Codeword> damaged = damaged_tags(*family);
  fmt::print("{}", library_line(family->name()));

  std::optional<PublishedTable> table;
  Contender published{.name = "the same table, timed"};
  published.build_s = seconds_of([&] { table.emplace(*family); });
  published.bytes = table->bytes();

  std::vector<Engine> engines;
  for (const auto& [name, engine] :
       {std::pair{"hash", DecoderEngine::Hash}, std::pair{"chunks", DecoderEngine::Chunks}}) {
    constexpr std::size_t kMostBytes = std::size_t{64} << 20;
    if (engine == DecoderEngine::Hash &&
        codec::Decoder::hash_table_bytes(*family, kErrors) > kMostBytes) {
      continue;
    }
    Engine& made = engines.emplace_back();
    made.result.name = name;
    codec::DecoderOptions options;
    options.max_errors = kErrors;
    options.engine = engine;
    made.result.build_s = seconds_of([&] { made.decoder.emplace(family, options); });
    made.result.bytes = made.decoder->table_bytes();
  }

  // All take turns, and the fastest round of each counts.
  std::size_t wrong = 0;
  const auto time = [&](const auto& decoder, Contender& result) {
    const auto decode = [&](Codeword word) { return decoder.decode(word); };
    std::size_t found = 0;
    result.damaged_s =
        std::min(result.damaged_s, seconds_of([&] { found = count_found(damaged, decode); }));
    wrong += found != kWords;
    result.random_s =
        std::min(result.random_s, seconds_of([&] { found = count_found(random, decode); }));
  };
  for (int round = 0; round < kRounds; ++round) {
    time(*table, published);
    for (Engine& engine : engines) time(*engine.decoder, engine.result);
  }
  for (const Codeword word : random) {
    for (const Engine& engine : engines)
      wrong += engine.decoder->decode(word) != table->decode(word);
  }

  const auto print = [&](const Contender& one) {
    fmt::print("| {} | {} | {:.1f} ms | {} | {:.1f} ns | {:.1f} ns |\n", family->name(), one.name,
               1e3 * one.build_s, one.bytes, 1e9 * one.damaged_s / kWords,
               1e9 * one.random_s / kWords);
  };
  print(published);
  for (const Engine& engine : engines) print(engine.result);
  std::fflush(stdout);
  if (wrong > 0) fmt::print("{}: {} answers differ\n", family->name(), wrong);
}

}  // namespace

void print_decoders_beside_libapriltag() {
  fmt::print("| family | table | made in | bytes | tag with two errors | random word |\n");
  fmt::print("|---|---|---|---|---|---|\n");
  for (const char* name : {"tag36h11", "tagStandard41h12", "tagStandard52h13"}) {
    measure(codec::find_family(name));
  }
}

}  // namespace tagmint::bench
