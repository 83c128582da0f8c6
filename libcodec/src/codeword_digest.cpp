#include "codeword_digest.h"

namespace tagmint::codec {

void CodewordDigest::add(std::span<const Codeword> codewords) {
  constexpr std::size_t kDigits = 16;
  constexpr const char* kHex = "0123456789abcdef";
  std::string lines;
  lines.reserve(codewords.size() * (kDigits + 1));
  for (const Codeword word : codewords) {
    for (int shift = 60; shift >= 0; shift -= 4) lines += kHex[(word >> shift) & 0xf];
    lines += '\n';
  }
  sha256_.add(lines);
}

}  // namespace tagmint::codec
