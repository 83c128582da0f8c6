#include "tagmint/codec/family_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <limits>
#include <utility>

#include "pair_distances.h"
#include "search/parallel.h"
#include "tagmint/codec/rotation.h"

namespace tagmint::codec {
namespace {

/// What the levels declare, told as the end of a message.
std::string declared(const Family& family, const Level& level) {
  if (level.codes == family.size()) {
    return fmt::format("the family declares {}", level.min_hamming);
  }
  return fmt::format("its first {} ids declare {}", level.codes, level.min_hamming);
}

/// The first level that holds the id: the largest distance that the tag must keep.
const Level& level_of(const Family& family, TagId id) {
  return *std::find_if(family.levels().begin(), family.levels().end(),
                       [id](const Level& level) { return id < level.codes; });
}

std::string bits_text(int bits) { return fmt::format("{} bit{}", bits, bits == 1 ? "" : "s"); }

/// Collects what the single proofs find.
class Findings {
 public:
  void prove(std::string line) { check_.proven.push_back(std::move(line)); }

  /// Of several violations the one with the lowest ids stays; of equal ids the first told.
  void violate(std::vector<TagId> ids, std::string message) {
    if (check_.violation && !(ids < check_.violation->ids)) return;
    check_.violation = Violation{std::move(ids), std::move(message)};
  }

  FamilyCheck take() { return std::move(check_); }

 private:
  FamilyCheck check_;
};

void check_self_distances(const Family& family, Findings& findings) {
  int least = std::numeric_limits<int>::max();
  bool sound = true;
  for (TagId id = 0; id < family.size(); ++id) {
    const int distance = self_distance(family.codeword(id), family.bits());
    least = std::min(least, distance);
    const Level& level = level_of(family, id);
    if (distance >= level.min_hamming) continue;
    findings.violate({id}, fmt::format("tag {} is {} from one of its own turns; {}", id,
                                       bits_text(distance), declared(family, level)));
    sound = false;
    break;
  }
  if (!sound) return;
  findings.prove(fmt::format("every tag is at least {} from its own turns ({} declared)",
                             bits_text(least), family.min_hamming()));
}

std::string near_pair_message(const Family& family, TagId a, TagId b) {
  const int bits = family.bits();
  int distance = kMaxBits + 1;
  int turns = 0;
  for (int turn = 0; turn < 4; ++turn) {
    const int turned = hamming_distance(family.codeword(a), rotate(family.codeword(b), bits, turn));
    if (turned >= distance) continue;
    distance = turned;
    turns = turn;
  }
  const std::string turned =
      turns == 0 ? std::string()
                 : fmt::format(" when tag {} is turned by {} degrees", b, 90 * turns);
  return fmt::format("tags {} and {} are {} apart{}; {}", a, b, bits_text(distance), turned,
                     declared(family, level_of(family, b)));
}

void check_pair_distances(const Family& family, int threads, Findings& findings) {
  const std::vector<Codeword> codewords = first_codewords(family, family.size());
  const std::vector<DistanceHistogram> histograms =
      pair_histograms(codewords, family.bits(), family.levels(), threads);
  // The least distance among the first ids falls from level to level.
  int least = kMaxBits + 1;
  bool sound = true;
  for (std::size_t i = 0; i < histograms.size(); ++i) {
    const auto& histogram = histograms[i];
    const Level& level = family.levels()[i];
    const auto used =
        std::find_if(histogram.begin(), histogram.end(), [](auto pairs) { return pairs > 0; });
    least = std::min(least, static_cast<int>(used - histogram.begin()));
    if (least < level.min_hamming) {
      sound = false;
    } else if (level.codes >= 2) {
      const std::string whose = level.codes == family.size()
                                    ? fmt::format("all {} tags", level.codes)
                                    : fmt::format("the first {} tags", level.codes);
      findings.prove(fmt::format("{} are at least {} apart in every rotation ({} declared)", whose,
                                 bits_text(least), level.min_hamming));
    }
  }
  if (sound) return;
  const auto pair = first_near_pair(codewords, family.bits(), family.levels(), threads);
  findings.violate({pair->first, pair->second},
                   near_pair_message(family, pair->first, pair->second));
}

/// What a rule's measure counts, for messages.
std::string measure_text(ComplexityRule rule, double measure) {
  if (rule == ComplexityRule::Rectangles) return fmt::format("{} rectangles", measure);
  return fmt::format("energy {:.4f}", measure);
}

void check_complexity(const Family& family, int threads, Findings& findings) {
  const Complexity& rule = family.complexity();
  if (rule.rule == ComplexityRule::None) return;
  const ComplexityJudge judge(family.layout(), rule);
  struct Judged {
    double measure = 0;
    bool accepted = false;
  };
  std::vector<Judged> judged(family.size());
  std::atomic<std::size_t> next{0};
  run_workers(thread_count(threads), [&](int) {
    for (std::size_t id; (id = next.fetch_add(1)) < family.size();) {
      const Codeword word = family.codeword(static_cast<TagId>(id));
      judged[id] = {judge.measure(word), judge.accepts(word)};
    }
  });
  const auto plain =
      std::find_if(judged.begin(), judged.end(), [](const Judged& tag) { return !tag.accepted; });
  if (plain != judged.end()) {
    const auto id = static_cast<TagId>(plain - judged.begin());
    findings.violate({id}, fmt::format("tag {} is too plain: it has {}, the family declares {}", id,
                                       measure_text(rule.rule, plain->measure),
                                       measure_text(rule.rule, rule.threshold)));
    return;
  }
  const auto least =
      std::min_element(judged.begin(), judged.end(),
                       [](const Judged& a, const Judged& b) { return a.measure < b.measure; });
  findings.prove(fmt::format("every tag has at least {} ({} declared)",
                             measure_text(rule.rule, least->measure), to_string(rule)));
}

}  // namespace

FamilyCheck check_family(const Family& family, int threads) {
  Findings findings;
  // A Layout and a Family that broke these could not have been made.
  findings.prove("the layout looks the same after a quarter turn");
  findings.prove(fmt::format("no codeword comes twice among {}", family.size()));
  check_self_distances(family, findings);
  check_pair_distances(family, threads, findings);
  check_complexity(family, threads, findings);
  return findings.take();
}

}  // namespace tagmint::codec
