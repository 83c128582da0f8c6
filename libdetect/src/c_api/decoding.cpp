#include "c_api/boundary.h"
#include "c_api/objects.h"

namespace {

using namespace tagmint;
using c_api::guarded;
using c_api::required;

codec::DecoderOptions decoder_options(std::int32_t max_errors, const std::uint32_t* ids,
                                      std::size_t id_count) {
  codec::DecoderOptions options;
  if (max_errors != TAGMINT_DEFAULT_ERRORS) options.max_errors = max_errors;
  if ((ids == nullptr) != (id_count == 0)) {
    throw std::invalid_argument(
        fmt::format("ids and their number do not agree: {}, {}; give NULL and 0 for all ids",
                    ids == nullptr ? "NULL" : "an array", id_count));
  }
  if (ids != nullptr) options.ids.assign(ids, ids + id_count);
  return options;
}

}  // namespace

extern "C" {

tagmint_status tagmint_decoder_create(const tagmint_family* family, int32_t max_errors,
                                      const uint32_t* ids, size_t id_count,
                                      tagmint_decoder** decoder) {
  return guarded([&] {
    const codec::SharedFamily& of = required(family, "family").family;
    required(decoder, "decoder");
    auto made =
        std::make_shared<const codec::Decoder>(of, decoder_options(max_errors, ids, id_count));
    *decoder = new tagmint_decoder{std::move(made)};
    return TAGMINT_OK;
  });
}

void tagmint_decoder_free(tagmint_decoder* decoder) { delete decoder; }

tagmint_status tagmint_decoder_decode(const tagmint_decoder* decoder, uint64_t word,
                                      tagmint_match* match) {
  return guarded([&] {
    const codec::Decoder& d = *required(decoder, "decoder").decoder;
    required(match, "match");
    const int bits = d.family()->bits();
    if ((word & ~codec::low_mask(bits)) != 0) {
      throw std::invalid_argument(fmt::format("the word {:#x} has more than the {} bits of {}",
                                              word, bits, d.family()->name()));
    }
    const std::optional<codec::Match> found = d.decode(word);
    if (!found) return TAGMINT_NOTHING;
    *match = {.id = found->id, .hamming = found->hamming, .rotation = found->rotation};
    return TAGMINT_OK;
  });
}

}  // extern "C"
