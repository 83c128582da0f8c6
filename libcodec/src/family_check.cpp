#include "tagmint/codec/family_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <span>
#include <utility>

#include "codeword_stretches.h"
#include "level_distances.h"
#include "pair_distances.h"
#include "tagmint/codec/family_file.h"
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

  /// Of several violations the one with the lowest ids stays; of equal ids the first told. One that
  /// concerns no tag comes after those that do.
  void violate(std::vector<TagId> ids, std::string message) {
    if (check_.violation) {
      const std::vector<TagId>& told = check_.violation->ids;
      if (ids.empty() || (!told.empty() && !(ids < told))) return;
    }
    check_.violation = Violation{std::move(ids), std::move(message)};
  }

  FamilyCheck take() { return std::move(check_); }

 private:
  FamilyCheck check_;
};

/// What was seen of some tags: the least of a figure, and the first tag at fault.
struct Seen {
  double least = std::numeric_limits<double>::infinity();
  std::optional<TagId> at_fault;

  void take(double figure) { least = std::min(least, figure); }
  /// Ids come in ascending order.
  void blame(TagId id) {
    if (!at_fault) at_fault = id;
  }
};

Seen together(const std::vector<Seen>& parts) {
  Seen all;
  for (const Seen& part : parts) {
    all.take(part.least);
    if (part.at_fault && (!all.at_fault || *part.at_fault < *all.at_fault)) {
      all.at_fault = part.at_fault;
    }
  }
  return all;
}

void check_self_distances(const Family& family, int threads, Findings& findings) {
  const int workers = thread_count(threads);
  std::vector<Seen> parts(workers);
  for_each_stretch(family, workers,
                   [&](int worker, TagId first, std::span<const Codeword> codewords) {
                     for (TagId i = 0; i < codewords.size(); ++i) {
                       const int distance = self_distance(codewords[i], family.bits());
                       parts[worker].take(distance);
                       if (distance < level_of(family, first + i).min_hamming) {
                         parts[worker].blame(first + i);
                       }
                     }
                   });
  const Seen seen = together(parts);
  if (!seen.at_fault) {
    findings.prove(fmt::format("every tag is at least {} from its own turns ({} declared)",
                               bits_text(static_cast<int>(seen.least)), family.min_hamming()));
    return;
  }
  const TagId id = *seen.at_fault;
  findings.violate({id}, fmt::format("tag {} is {} from one of its own turns; {}", id,
                                     bits_text(self_distance(family.codeword(id), family.bits())),
                                     declared(family, level_of(family, id))));
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

/// "all 30 tags", "the first 10 tags".
std::string tags_of(const Family& family, const Level& level) {
  return fmt::format("{} {} tags", level.codes == family.size() ? "all" : "the first", level.codes);
}

/// Tells that the level's tags are apart; false where they are nearer than the level declares.
bool prove_distance(const Family& family, const Level& level, int least, Findings& findings) {
  if (least < level.min_hamming) return false;
  if (level.codes >= 2) {
    findings.prove(fmt::format("{} are at least {} apart in every rotation ({} declared)",
                               tags_of(family, level), bits_text(least), level.min_hamming));
  }
  return true;
}

void check_listed_pairs(const Family& family, int threads, Findings& findings) {
  const std::vector<DistanceHistogram> histograms =
      pair_histograms(family.codewords(), family.bits(), family.levels(), threads);
  // The least distance among the first ids falls from level to level.
  int least = kMaxBits + 1;
  bool sound = true;
  for (std::size_t i = 0; i < histograms.size(); ++i) {
    const auto& histogram = histograms[i];
    const auto used =
        std::find_if(histogram.begin(), histogram.end(), [](auto pairs) { return pairs > 0; });
    least = std::min(least, static_cast<int>(used - histogram.begin()));
    sound = prove_distance(family, family.levels()[i], least, findings) && sound;
  }
  if (sound) return;
  const auto pair = first_near_pair(family.codewords(), family.bits(), family.levels(), threads);
  findings.violate({pair->first, pair->second},
                   near_pair_message(family, pair->first, pair->second));
}

/// By the distances that the words of the code have, not tag by tag. A tag too near to itself is
/// for check_self_distances() to tell.
void check_generated_pairs(const Family& family, int threads, Findings& findings) {
  const TagIndex& index = *family.index();
  for (std::size_t i = 0; i < family.levels().size(); ++i) {
    const Level& level = family.levels()[i];
    const DistanceHistogram distances = level_distances(*index.code(), i, threads);
    const int least = tag_distance(index, i, distances, threads);
    if (prove_distance(family, level, least, findings)) continue;
    const std::vector<TagId> near = near_tags(index, i, level.min_hamming);
    if (near.size() < 2) continue;
    findings.violate(near, near_pair_message(family, near[0], near[1]));
  }
}

/// What a rule's measure counts, for messages.
std::string measure_text(ComplexityRule rule, double measure) {
  if (rule == ComplexityRule::Rectangles) return fmt::format("{} rectangles", measure);
  return fmt::format("energy {:.4f}", measure);
}

/// Whether the family declares that the tag fails its complexity rule.
bool declared_plain(const Family& family, TagId id) {
  const Level& level = level_of(family, id);
  return id >= level.codes - level.plain;
}

std::size_t plain_tags(const Family& family) {
  std::size_t plain = 0;
  for (const Level& level : family.levels()) plain += level.plain;
  return plain;
}

std::string complexity_violation(const Family& family, const ComplexityJudge& judge, TagId id) {
  const Complexity& rule = family.complexity();
  const std::string found = measure_text(rule.rule, judge.measure(family.codeword(id)));
  if (declared_plain(family, id)) {
    return fmt::format("tag {} is declared plain, but it has {}, enough for {}", id, found,
                       to_string(rule));
  }
  return fmt::format("tag {} is too plain: it has {}, the family declares {}", id, found,
                     measure_text(rule.rule, rule.threshold));
}

/// That the tags which are not declared plain pass the rule, and the plain ones fail.
void check_complexity(const Family& family, int threads, Findings& findings) {
  const Complexity& rule = family.complexity();
  if (rule.rule == ComplexityRule::None) return;
  const ComplexityJudge judge(family.layout(), rule);
  const int workers = thread_count(threads);
  std::vector<Seen> parts(workers);
  for_each_stretch(family, workers,
                   [&](int worker, TagId first, std::span<const Codeword> codewords) {
                     for (TagId i = 0; i < codewords.size(); ++i) {
                       const bool plain = declared_plain(family, first + i);
                       if (judge.accepts(codewords[i]) == plain) parts[worker].blame(first + i);
                       if (!plain) parts[worker].take(judge.measure(codewords[i]));
                     }
                   });
  const Seen seen = together(parts);
  if (seen.at_fault) {
    const TagId id = *seen.at_fault;
    findings.violate({id}, complexity_violation(family, judge, id));
    return;
  }
  const std::size_t plain = plain_tags(family);
  if (plain == family.size()) {
    findings.prove(fmt::format("every tag fails {}, as declared", to_string(rule)));
    return;
  }
  const std::string enough =
      fmt::format("{} ({} declared)", measure_text(rule.rule, seen.least), to_string(rule));
  if (plain == 0) {
    findings.prove(fmt::format("every tag has at least {}", enough));
  } else {
    findings.prove(fmt::format("{} of {} tags have at least {}, the {} plain ones less",
                               family.size() - plain, family.size(), enough, plain));
  }
}

void check_digest(const Family& family, Findings& findings) {
  if (family.declared_digest().empty()) return;
  const std::string found = family_digest(family);
  if (found == family.declared_digest()) {
    findings.prove(
        fmt::format("the SHA-256 of all {} codewords is the declared one", family.size()));
  } else {
    findings.violate({}, fmt::format("the SHA-256 of the codewords is {}; the family declares {}",
                                     found, family.declared_digest()));
  }
}

}  // namespace

FamilyCheck check_family(const Family& family, int threads) {
  Findings findings;
  // A Layout, a RotationCode and a Family that broke these could not have been made.
  findings.prove("the layout looks the same after a quarter turn");
  if (const SharedRotationCode& code = family.generator()) {
    const std::size_t cosets = code->cosets().size();
    findings.prove(fmt::format("the {} words of the basis are independent{}", code->dimension(),
                               cosets == 1 ? "" : fmt::format(", the {} cosets differ", cosets)));
    const std::size_t levels = family.levels().size();
    findings.prove(
        fmt::format("{} closed under quarter turns and has as many tags as declared",
                    levels == 1 ? "the code is" : fmt::format("each of the {} levels is", levels)));
  } else {
    findings.prove(fmt::format("no codeword comes twice among {}", family.size()));
  }
  check_self_distances(family, threads, findings);
  if (family.is_listed()) {
    check_listed_pairs(family, threads, findings);
  } else {
    check_generated_pairs(family, threads, findings);
  }
  check_complexity(family, threads, findings);
  check_digest(family, findings);
  return findings.take();
}

}  // namespace tagmint::codec
