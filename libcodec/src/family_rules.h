#pragma once

#include <optional>
#include <span>
#include <string>

#include "tagmint/codec/family.h"

/// What a family must obey, one rule a function: Family's constructor and the reader of family
/// files share them; the reader adds the line of the file.
namespace tagmint::codec {

/// Throws std::invalid_argument for an empty name or one with other characters than letters,
/// digits, '_', '-', '.'.
void check_family_name(const std::string& name);

/// Throws std::invalid_argument for a distance outside 1..bits.
void check_min_hamming(int min_hamming, int bits);

/// A codeword that cannot be.
struct CodewordFault {
  std::size_t id = 0;
  std::string message;
};

/// The first codeword with more than `bits` bits, else the first that repeats an earlier one. Cost:
/// O(n log n).
std::optional<CodewordFault> find_codeword_fault(std::span<const Codeword> codewords, int bits);

/// Throws std::invalid_argument unless the generator has the layout's bits, tags, and the levels of
/// the family.
void check_generator(const RotationCode& generator, int bits, std::span<const Level> levels);

/// Throws std::invalid_argument unless the levels grow in size and fall in distance down to the
/// whole family, and have no more plain tags than they add.
void check_levels(std::span<const Level> levels, std::size_t size, int min_hamming);

}  // namespace tagmint::codec
