#pragma once

#include <cstdint>
#include <vector>

#include "evaluate/field.h"
#include "evaluate/work.h"
#include "tagmint/codec/family.h"

namespace tagmint::evaluate {

/// The bundled families and the one asked for, which replaces one of the same name.
std::vector<codec::SharedFamily> bundled_families_and(const codec::SharedFamily& family);

/// Side of the border square of a tag whose whole side is `outer_px`.
double edge_px(const codec::Family& family, double outer_px);

/// Up to 12 tags of one size on a smooth texture, tilted by up to 30 degrees.
scene::Scene sized_scene(const codec::SharedFamily& family, double edge_px, std::uint64_t seed);

/// Random words that a decoder took for tags.
struct AcceptedWords {
  std::int64_t words = 0;
  std::int64_t accepted = 0;
};
/// Decodes `words` random words with as many errors corrected as usual.
AcceptedWords accepted_words(const codec::SharedFamily& family, std::uint64_t seed,
                             std::int64_t words, const Work& work);

/// Quads of pictures without tags that an entrant took for tags.
struct AcceptedQuads {
  std::int64_t candidates = 0;  ///< 0 where the contender does not say
  std::int64_t accepted = 0;
};
/// For each entrant of a field, over `pictures` pictures of clutter.
std::vector<AcceptedQuads> accepted_in_clutter(Field& field, std::uint64_t seed, int pictures,
                                               const Work& work);

}  // namespace tagmint::evaluate
