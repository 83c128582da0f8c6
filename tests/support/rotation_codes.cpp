#include "support/rotation_codes.h"

#include <ios>
#include <sstream>
#include <string>
#include <vector>

namespace tagmint::test {
namespace {

using codec::RotationCodeParts;

/// Hex words between blanks.
std::vector<codec::Codeword> words(const std::string& text) {
  std::istringstream stream(text);
  std::vector<codec::Codeword> all;
  for (codec::Codeword word = 0; stream >> std::hex >> word;) all.push_back(word);
  return all;
}

}  // namespace

RotationCodeParts chain_of_36_bits() {
  return {.bits = 36,
          .basis = words(
              "321ef4119 3de823264 d0464c87b 8c990f7a0 ce32cefd c659dfa19 b3bf4338c 7e8671967 "
              "811c0c1b4 a27c90090 83b61a100 3981c82a 80ff16a11 303940a8 804907818 8151818b8 "
              "3b01e091 919c200 909b821"),
          .translation = 0xc964b2592,
          .levels = {{8}, {13}, {15}, {19}}};
}

RotationCodeParts chain_of_48_bits() {
  return {.bits = 48,
          .basis =
              words("c77c77c77c77 752b25752b25 9c0e925b72e5 149d3e149d3e 3de07248cb57 ac66b1ac66b1 "
                    "7f0962cd5e30 e5dd21f1401f 551db54c8640 9e49e49e49e4 562c86562c86 214b01bf02e5 "
                    "8a36c01b6631 811b178e0202 5d36b2d257a0 6b1ff24e6031 efe2fe101d01 9b274c5b24b3 "
                    "a6fea44b3d8 233a2d29bf98 7343d1e0761b eb2285664a05 3170e7ecca92 a5046c29d233"),
          .translation = 0x166166166166,
          .levels = {{5}, {9}, {16}, {24}}};
}

RotationCodeParts chain_of_25_bits() {
  return {.bits = 25,
          .basis = words("9a69a6 17df7de 764765 22e22f ef731 10f39b 337ec 15b27 47bd 4b794 1e79"),
          .levels = {{8}, {9}, {11}}};
}

RotationCodeParts coset_of_25_bits() {
  RotationCodeParts parts = chain_of_25_bits();
  parts.basis.resize(8);
  parts.translation = 0x47bc;
  parts.levels = {{8}};
  return parts;
}

RotationCodeParts chain_of_16_bits() {
  return {.bits = 16,
          .basis = words("3333 8b8b 5d6e 149f b38 536 355 1d2 b8"),
          .levels = {{4}, {7}, {8}, {9}}};
}

RotationCodeParts cosets_of_16_bits() {
  RotationCodeParts parts{
      .bits = 16, .basis = words("5555 8d8d"), .translation = 0x7, .levels = {{2, 4}, {2, 16}}};
  parts.cosets = words("7 70 700 2555 bb bb0 368d 3d86 14a 14a0 1f54 2d99 2c4 2c40 1cda 1579");
  for (codec::Codeword& coset : parts.cosets) coset ^= parts.translation;
  return parts;
}

}  // namespace tagmint::test
