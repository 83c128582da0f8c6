#include "evaluate/family_measures.h"

#include <algorithm>

#include "evaluate/scenes.h"
#include "scene/counter_random.h"
#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/decoder.h"

namespace tagmint::evaluate {
namespace {

// Streams of random numbers apart from those of pictures with tags.
constexpr std::uint64_t kClutterStream = 1'000'001;
constexpr std::uint64_t kWordStream = 1'000'002;

}  // namespace

std::vector<codec::SharedFamily> bundled_families_and(const codec::SharedFamily& family) {
  std::vector<codec::SharedFamily> all;
  bool there = false;
  for (const std::string& name : codec::family_names()) {
    there = there || name == family->name();
    all.push_back(name == family->name() ? family : codec::find_family(name));
  }
  if (!there) all.push_back(family);
  return all;
}

double edge_px(const codec::Family& family, double outer_px) {
  return outer_px * family.layout().width_at_border() / family.layout().width();
}

scene::Scene sized_scene(const codec::SharedFamily& family, double edge_px, std::uint64_t seed) {
  constexpr double kTilt_deg = 30;
  return scattered_scene(
      family,
      {.min_side_px = edge_px, .max_side_px = edge_px, .max_tilt_deg = kTilt_deg, .clutter = false},
      seed);
}

AcceptedWords accepted_words(const codec::SharedFamily& family, std::uint64_t seed,
                             std::int64_t words, const Work& work) {
  constexpr std::int64_t kBatch = 1 << 14;
  const codec::Decoder decoder(family, {.max_errors = usual_max_hamming(*family), .ids = {}});
  const auto batches = static_cast<int>((words + kBatch - 1) / kBatch);
  std::vector<std::int64_t> accepted(static_cast<std::size_t>(batches));
  const std::uint64_t stream = scene::random_word(seed, kWordStream);
  work.for_each(batches, [&](int batch, int) {
    for (std::int64_t i = batch * kBatch; i < std::min(words, (batch + 1) * kBatch); ++i) {
      const codec::Codeword word =
          scene::random_word(stream, static_cast<std::uint64_t>(i)) >> (64 - family->bits());
      accepted[static_cast<std::size_t>(batch)] += decoder.decode(word).has_value();
    }
  });
  AcceptedWords sum{.words = words};
  for (const std::int64_t count : accepted) sum.accepted += count;
  return sum;
}

std::vector<AcceptedQuads> accepted_in_clutter(Field& field, std::uint64_t seed, int pictures,
                                               const Work& work) {
  const auto views = field.views(
      pictures,
      [&](int picture) { return clutter_scene(picture_seed(seed, kClutterStream, picture)); },
      work);
  std::vector<AcceptedQuads> sums(field.entrants().size());
  for (const std::vector<View>& of_picture : views) {
    for (std::size_t i = 0; i < sums.size(); ++i) {
      sums[i].candidates += of_picture[i].candidates.value_or(0);
      sums[i].accepted += of_picture[i].wrong;
    }
  }
  return sums;
}

}  // namespace tagmint::evaluate
