#pragma once

#include "tagmint/codec/layout_presets.h"
#include "tagmint/codec/search/lexicode.h"

namespace tagmint::testing {

/// A search from the text forms of its settings; no limits, all threads.
inline codec::LexicodeOptions options_for(const char* layout, int min_hamming, const char* order,
                                          const char* complexity) {
  return {.layout = codec::parse_layout(layout),
          .min_hamming = min_hamming,
          .order = codec::parse_order(order),
          .complexity = codec::parse_complexity(complexity)};
}

}  // namespace tagmint::testing
