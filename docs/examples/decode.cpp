// docs/examples/decode.cpp: from a word to the tag that it is nearest to.
#include <iostream>
#include <memory>

#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/decoder.h"
#include "tagmint/codec/rotation.h"

namespace codec = tagmint::codec;

void tell(const codec::Decoder& decoder, codec::Codeword seen) {
  if (const auto match = decoder.decode(seen)) {
    std::cout << "id " << match->id << ", " << match->hamming << " errors, turned "
              << match->rotation << " times\n";
  } else {
    std::cout << "no tag is near enough\n";
  }
}

int main() {
  const codec::SharedFamily family = codec::find_family("tag36h11");
  // As a camera might read tag 40: turned, and with five cells wrong.
  const codec::Codeword seen = codec::rotate(family->codeword(40), family->bits(), 1) ^ 0x10101050;

  tell(codec::Decoder(family), seen);  // two errors, unless told otherwise

  codec::DecoderOptions all_safe;
  all_safe.max_errors = family->max_safe_errors();  // 5
  tell(codec::Decoder(family, all_safe), seen);

  // Few ids may be farther apart than the whole family, and then correct more.
  const codec::Decoder few(family, {.max_errors = 7, .ids = {5, 40}});
  std::cout << "5 and 40 are " << few.min_hamming() << " apart\n";
  tell(few, seen ^ 0x6);
}
