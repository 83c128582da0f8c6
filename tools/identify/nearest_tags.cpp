#include "identify/nearest_tags.h"

#include <array>

#include "identify/evidence.h"
#include "tagmint/codec/rotation.h"

namespace tagmint::identify {
namespace {

/// Comparing a word with so many tags, in four rotations, takes some 10 us.
constexpr std::size_t kMostCompared = 1024;

bool is_compared(const codec::Family& family) {
  return family.is_listed() && (family.size() <= kMostCompared || family.max_safe_errors() == 0);
}

std::vector<codec::Match> compare_with_all(const codec::Family& family, codec::Codeword word) {
  std::array<codec::Codeword, 4> turned;
  for (int turn = 0; turn < 4; ++turn) turned[turn] = codec::rotate(word, family.bits(), turn);
  std::vector<codec::Match> nearest;
  int least = codec::kMaxBits;
  const std::span<const codec::Codeword> codewords = family.codewords();
  for (std::size_t id = 0; id < codewords.size(); ++id) {
    int distance = codec::kMaxBits + 1;
    int rotation = 0;
    for (int turn = 0; turn < 4; ++turn) {
      const int turned_distance = codec::hamming_distance(turned[turn], codewords[id]);
      if (turned_distance < distance) {
        distance = turned_distance;
        rotation = turn;
      }
    }
    if (distance > least) continue;
    if (distance < least) nearest.clear();
    least = distance;
    nearest.push_back({static_cast<codec::TagId>(id), distance, rotation});
  }
  return nearest;
}

}  // namespace

std::vector<codec::Match> NearestTags::find(const codec::SharedFamily& family,
                                            codec::Codeword word) {
  if (is_compared(*family)) return compare_with_all(*family, word);
  std::unique_ptr<codec::Decoder>& decoder = decoders_[family.get()];
  if (!decoder) {
    codec::DecoderOptions options;
    options.max_errors = nearest_miss_radius(*family);
    options.allow_unsafe_radius = true;
    options.engine =
        family->is_listed() ? codec::DecoderEngine::Chunks : codec::DecoderEngine::InformationSets;
    decoder = std::make_unique<codec::Decoder>(family, std::move(options));
  }
  const std::optional<codec::Match> match = decoder->decode(word);
  if (!match) return {};
  return {*match};
}

}  // namespace tagmint::identify
