#include "io/family_kinds/older_systems.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <stdexcept>

#include "io/family_kinds/data_square.h"
#include "io/family_kinds/imported_family.h"

namespace tagmint::io {
namespace {

using codec::Codeword;

/// The remainder of `word` by the polynomial `divisor` over GF(2), whose degree is `degree`.
Codeword remainder(Codeword word, Codeword divisor, int degree) {
  for (int bit = std::bit_width(word) - 1; bit >= degree; bit = std::bit_width(word) - 1) {
    word ^= divisor << (bit - degree);
  }
  return word;
}

/// A systematic cyclic code: the message, then its remainder.
Codeword cyclic_word(Codeword message, Codeword generator) {
  const int degree = std::bit_width(generator) - 1;
  const Codeword shifted = message << degree;
  return shifted | remainder(shifted, generator, degree);
}

// Each function gives the cells of an id, row by row from the top left, the first one in the most
// significant bit; 1 is white.

/// Each row is one of four words that tell two bits of the id, the first row the highest.
Codeword aruco_original(Codeword id) {
  constexpr std::array<Codeword, 4> kRows = {0b10000, 0b10111, 0b01001, 0b01110};
  Codeword word = 0;
  for (int row = 0; row < 5; ++row) word = word << 5 | kRows[id >> (8 - 2 * row) & 3];
  return word;
}

/// Nine bits of the id four times, each time under another mask.
Codeword artoolkitplus_simple(Codeword id) {
  constexpr Codeword kMask = 0x027 | 0x14eULL << 9 | 0x109ULL << 18 | 0x0dbULL << 27;
  return (id | id << 9 | id << 18 | id << 27) ^ kMask;
}

/// A BCH code of 63 bits that corrects four errors, shortened to 36.
Codeword artoolkitplus_bch(Codeword id) {
  constexpr Codeword kMask = 0x8f80b8750;
  return cyclic_word(id, 0x1db2777) ^ kMask;
}

/// Ten bits of the id and their CRC through a convolutional code of rate 1/2, the first 36 bits of
/// it. [Fiala2005], as Chilitags publishes it.
Codeword artag(Codeword id) {
  constexpr Codeword kPolynomial = 0x11021;  // x^16 + x^12 + x^5 + 1
  const Codeword message = cyclic_word(id ^ 0b1010101010, kPolynomial);
  constexpr int kMessageBits = 26;
  constexpr std::array<std::array<Codeword, 2>, 4> kOutput = {
      {{0b00, 0b11}, {0b01, 0b10}, {0b11, 0b00}, {0b10, 0b01}}};
  constexpr std::array<std::array<std::size_t, 2>, 4> kNext = {{{0, 2}, {0, 2}, {1, 3}, {1, 3}}};
  Codeword word = 0;
  std::size_t state = 0;
  for (int step = 0; step < 18; ++step) {
    const auto bit = static_cast<std::size_t>(message >> (kMessageBits - 1 - step) & 1);
    word = word << 2 | kOutput[state][bit];
    state = kNext[state][bit];
  }
  return word;
}

/// ARToolKit's matrix of 4 x 4 cells: three corners tell the orientation, the other 13 cells are
/// the bits; there 1 is black.
Codeword artoolkit_4x4(Codeword bits) {
  Codeword black = 0;
  for (int place = 0, next = 12; place < 16; ++place) {
    const bool orientation = place == 0 || place == 12 || place == 15;
    black = black << 1 | (orientation ? place != 15 : bits >> next & 1);
    next -= !orientation;
  }
  return ~black & 0xffff;
}

struct OlderSystem {
  std::string_view name;
  int side;
  int border;  // cells
  Codeword ids;
  Codeword (*word)(Codeword id);
};

constexpr std::array kSystems = {
    OlderSystem{"aruco-original", 5, 1, 1024, aruco_original},
    OlderSystem{"artoolkitplus-simple", 6, 1, 512, artoolkitplus_simple},
    OlderSystem{"artoolkitplus-bch", 6, 1, 4096, artoolkitplus_bch},
    OlderSystem{"artag", 6, 2, 1024, artag},
    OlderSystem{"artoolkit-4x4", 4, 2, 8192, artoolkit_4x4},
    OlderSystem{"artoolkit-4x4-bch-13-9-3", 4, 2, 512,
                [](Codeword id) { return artoolkit_4x4(cyclic_word(id, 0x13)); }},
    OlderSystem{"artoolkit-4x4-bch-13-5-5", 4, 2, 32,
                [](Codeword id) { return artoolkit_4x4(cyclic_word(id, 0x1d1)); }},
};

codec::Layout layout_of(const OlderSystem& system, const FamilyReadOptions& options) {
  if (!options.layout) return square_layout(system.side, system.border);
  const codec::Layout& layout = *options.layout;
  const int border = (layout.width() - system.side) / 2 - 1;
  if (layout.bits() != system.side * system.side || border < 1 ||
      !DataSquare::fits(layout, border)) {
    throw std::invalid_argument(
        fmt::format("{0} has {1} x {1} data cells inside a black border; give such a --layout",
                    system.name, system.side));
  }
  return layout;
}

}  // namespace

std::vector<std::string> older_system_names() {
  std::vector<std::string> names;
  for (const OlderSystem& system : kSystems) names.emplace_back(system.name);
  return names;
}

std::optional<ReadFamily> find_older_system(std::string_view name,
                                            const FamilyReadOptions& options) {
  const auto system = std::find_if(kSystems.begin(), kSystems.end(),
                                   [&](const OlderSystem& s) { return s.name == name; });
  if (system == kSystems.end()) return std::nullopt;
  ImportedFamily imported{.name = std::string(name),
                          .layout = layout_of(*system, options),
                          .codewords = {},
                          .lines = {},
                          .kind = "its construction"};
  const DataSquare square(imported.layout);
  for (Codeword id = 0; id < system->ids; ++id) {
    imported.codewords.push_back(square.codeword_of_rows(system->word(id)));
  }
  return make_imported(std::move(imported), {.path = {}, .name = std::string(name), .content = {}},
                       options);
}

}  // namespace tagmint::io
