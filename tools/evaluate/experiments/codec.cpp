// What looking words up takes: memory and time, by family and by the way it is done.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "evaluate/curves.h"
#include "evaluate/experiments/kinds.h"
#include "evaluate/family_measures.h"
#include "scene/counter_random.h"
#include "tagmint/codec/decoder.h"
#include "tagmint/codec/rotation.h"

namespace tagmint::evaluate {
namespace {

using codec::DecoderEngine;
using Clock = std::chrono::steady_clock;

/// Larger hash tables are not made.
constexpr std::size_t kMostHashBytes = std::size_t{64} << 20;
/// Brute force takes long with many tags.
constexpr std::size_t kMostBruteCodes = 10'000;

struct Engine {
  const char* name;
  DecoderEngine engine;
  int style;
};
constexpr Engine kEngines[] = {{"hash", DecoderEngine::Hash, 1},
                               {"chunks", DecoderEngine::Chunks, 0},
                               {"information sets", DecoderEngine::InformationSets, 5},
                               {"brute force", DecoderEngine::BruteForce, 4}};

bool can_do(const codec::Family& family, DecoderEngine engine, int errors) {
  switch (engine) {
    case DecoderEngine::Hash:
      return family.is_listed() &&
             codec::Decoder::hash_table_bytes(family, errors) <= kMostHashBytes;
    case DecoderEngine::InformationSets:
      return !family.is_listed();
    case DecoderEngine::BruteForce:
      return family.size() <= kMostBruteCodes;
    default:
      return family.is_listed();
  }
}

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Words to look up: random ones, or those of tags in any turn with `errors` wrong bits.
std::vector<codec::Codeword> words_for(const codec::Family& family, bool of_tags, int errors,
                                       std::size_t count, std::uint64_t seed) {
  scene::RandomStream random(seed);
  std::vector<codec::Codeword> words;
  const int bits = family.bits();
  for (std::size_t i = 0; i < count; ++i) {
    codec::Codeword word = random.word() >> (64 - bits);
    if (of_tags) {
      word = family.codeword(static_cast<codec::TagId>(random.below(family.size())));
      for (std::uint64_t turn = random.below(4); turn > 0; --turn) {
        word = codec::rotate_quarter(word, bits);
      }
      codec::Codeword wrong = 0;
      for (int bit = 0; bit < errors;) {
        const codec::Codeword mask = codec::Codeword{1}
                                     << random.below(static_cast<std::uint64_t>(bits));
        if ((wrong & mask) != 0) continue;
        wrong |= mask;
        ++bit;
      }
      word ^= wrong;
    }
    words.push_back(word);
  }
  return words;
}

/// Nanoseconds a word: the fastest of some rounds.
double look_up_ns(const codec::Decoder& decoder, const std::vector<codec::Codeword>& words,
                  int rounds, std::int64_t& accepted) {
  double best = HUGE_VAL;
  for (int round = 0; round < rounds; ++round) {
    accepted = 0;
    const Clock::time_point start = Clock::now();
    for (const codec::Codeword word : words) accepted += decoder.decode(word).has_value();
    best = std::min(best, seconds_since(start));
  }
  return 1e9 * best / static_cast<double>(words.size());
}

class Codec : public Experiment {
 public:
  explicit Codec(const Settings& settings)
      : settings_(settings),
        rounds_(samples_of(settings, 3, 9)),
        families_(bundled_families_and(settings.family)) {
    for (const codec::SharedFamily& family : families_) {
      for (const Engine& engine : kEngines) {
        if (can_do(*family, engine.engine, usual_max_hamming(*family))) {
          steps_.push_back({family, &engine});
        }
      }
      if (std::any_of(settings.contenders.begin(), settings.contenders.end(),
                      [](const ContenderKind& kind) { return bool(kind.table_cost); })) {
        steps_.push_back({family, nullptr});
      }
    }
  }

  std::vector<Column> columns() const override {
    return {{"family", "bundled, or the one asked for"},
            {"codes", "tags"},
            {"bits", "of a word"},
            {"corrected_bits", "errors that are corrected"},
            {"look_up", "how: a way of tagmint's, or a contender whose tables were measured"},
            {"auto", "1 = what tagmint takes when it is not told"},
            {"bytes", "of the tables; of contenders, growth of the heap"},
            {"made_in_s", "time to make the tables (measured)"},
            {"tag_ns",
             "time to look up the word of a tag with as many errors as are corrected "
             "(measured, one thread); contenders offer no look-up"},
            {"random_ns", "the same of a random word"},
            {"accepted", "of the words of tags, those recognised: all of them"},
            {"words", "of each kind"}};
  }

  std::vector<std::string> points() const override {
    std::vector<std::string> names;
    for (const Step& step : steps_) {
      names.push_back(fmt::format("{}, {}", step.family->name(),
                                  step.engine != nullptr ? step.engine->name : "contenders"));
    }
    return names;
  }

  Rows run(std::size_t point, const Work& work) override {
    const auto& [family, engine] = steps_[point];
    work.throw_if_stopped();
    return engine != nullptr ? measure(family, *engine) : measure_contenders(family);
  }

  plot::Figure figure(const Table& table) const override {
    plot::Axis x{.label = "", .categories = {}};
    for (const codec::SharedFamily& family : families_) x.categories.push_back(family->name());
    plot::Figure figure{
        .title = "Looking codewords up: memory and speed", .panels = {}, .columns = 1};
    const auto panel = [&](const char* title, const char* label, const char* column) {
      plot::Panel made{
          .title = title, .x = x, .y = {.label = label, .logarithmic = true}, .series = {}};
      for (const Engine& engine : kEngines) {
        made.series.push_back(series(table, engine.name, engine.style, column));
      }
      for (const ContenderKind& kind : settings_.contenders) {
        plot::Series own = series(table, kind.name, kind.style, column);
        if (!own.spots.empty()) made.series.push_back(std::move(own));
      }
      figure.panels.push_back(std::move(made));
    };
    panel("Tables", "memory, bytes", "bytes");
    panel("Word of a tag with as many errors as are corrected", "time, ns", "tag_ns");
    panel("Random word", "time, ns", "random_ns");
    return figure;
  }

  std::string summary(const Table& table) const override {
    std::vector<std::vector<std::string>> lines = {
        {"family, what tagmint takes", "bytes", "tag", "random word"}};
    for (const Row& row : table.rows) {
      if (table.number(row, "auto") != 1) continue;
      lines.push_back(
          {fmt::format("  {}, {}", table.word(row, "family"), table.word(row, "look_up")),
           fmt::format("{}", *table.number(row, "bytes")),
           fmt::format("{:.0f} ns", *table.number(row, "tag_ns")),
           fmt::format("{:.0f} ns", *table.number(row, "random_ns"))});
    }
    return aligned(lines);
  }

  std::vector<std::string> conditions() const override {
    return {fmt::format("the fastest of {} rounds over {} words, one thread; up to two errors",
                        rounds_, kWords),
            "contenders: " + contestants(settings_)};
  }

 private:
  static constexpr std::size_t kWords = 1 << 16;
  struct Step {
    codec::SharedFamily family;
    const Engine* engine;  // null = the contenders' tables
  };

  Rows measure(const codec::SharedFamily& family, const Engine& engine) const {
    const int errors = usual_max_hamming(*family);
    const Clock::time_point start = Clock::now();
    const codec::Decoder decoder(family,
                                 {.max_errors = errors, .engine = engine.engine, .ids = {}});
    const double made_in = seconds_since(start);
    const auto of_tags = words_for(*family, true, errors, kWords, settings_.seed);
    const auto random = words_for(*family, false, 0, kWords, settings_.seed);
    std::int64_t accepted = 0, ignored = 0;
    look_up_ns(decoder, of_tags, 1, accepted);  // what is made at the first use
    const double tag_ns = look_up_ns(decoder, of_tags, rounds_, accepted);
    const double random_ns = look_up_ns(decoder, random, rounds_, ignored);
    const codec::Decoder usual(family, {.max_errors = errors, .ids = {}});
    return {{family->name(), static_cast<std::int64_t>(family->size()),
             std::int64_t{family->bits()}, std::int64_t{errors}, std::string(engine.name),
             std::int64_t{usual.engine() == engine.engine},
             static_cast<std::int64_t>(decoder.table_bytes()), made_in, tag_ns, random_ns, accepted,
             static_cast<std::int64_t>(kWords)}};
  }

  Rows measure_contenders(const codec::SharedFamily& family) const {
    Rows rows;
    const int errors = usual_max_hamming(*family);
    for (const ContenderKind& kind : settings_.contenders) {
      if (!kind.table_cost) continue;
      const auto cost = kind.table_cost({.family = family, .max_hamming = errors});
      if (!cost) continue;
      rows.push_back({family->name(), static_cast<std::int64_t>(family->size()),
                      std::int64_t{family->bits()}, std::int64_t{errors}, kind.name,
                      std::int64_t{0}, cost->bytes, cost->seconds, Cell(), Cell(), Cell(), Cell()});
    }
    return rows;
  }

  plot::Series series(const Table& table, const std::string& look_up, int style,
                      const char* column) const {
    plot::Series made{.label = look_up, .style = style, .spots = {}, .line = false};
    for (std::size_t place = 0; place < families_.size(); ++place) {
      for (const Row& row : table.rows) {
        const auto value = table.number(row, column);
        if (table.word(row, "family") == families_[place]->name() &&
            table.word(row, "look_up") == look_up && value) {
          made.spots.push_back({.x = static_cast<double>(place), .y = *value});
        }
      }
    }
    return made;
  }

  Settings settings_;
  int rounds_;
  std::vector<codec::SharedFamily> families_;
  std::vector<Step> steps_;
};

}  // namespace

ExperimentKind codec_kind() {
  return {.name = "codec",
          .summary = "memory and speed of looking codewords up",
          .make = [](const Settings& settings) -> std::unique_ptr<Experiment> {
            return std::make_unique<Codec>(settings);
          }};
}

}  // namespace tagmint::evaluate
