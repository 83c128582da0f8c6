#pragma once

#include "tagmint/codec/search/lexicode.h"

namespace tagmint::codec {

/// search_lexicode() by visiting every word of the walk: the reference.
LexicodeResult search_plain(const LexicodeOptions& options);

}  // namespace tagmint::codec
