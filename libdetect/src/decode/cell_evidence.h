#pragma once

#include "decode/read_word.h"
#include "tagmint/codec/family.h"

namespace tagmint::detect {

/// How much more probable the cells' values are where the tag is there than where a border holds
/// something else, natural logarithm (docs/refinement.md).
///
/// Where the tag is there, a cell's value is that of its colour, drawn together by blur with its
/// neighbours, and off by as much as the rings are off their planes; now and then a cell is
/// covered. Where it is not, values between black and white are as common as black and white.
///   word       of the tag as it is seen: turned to the quad
///   scatter    of the rings, in units of the values
///   colours    scratch
///   returns    at least -kMostDoubt: light and dirt may explain some of it
///   cost       some hundred operations a data cell
double cell_evidence(const codec::Layout& layout, const Whiteness& cells, codec::Codeword word,
                     const Print& print, double scatter, std::vector<std::int8_t>& colours);

inline constexpr double kMostDoubt = 5;

/// What speaks for a tag in all: the evidence of the cells against how often a word that is none
/// is taken for one with so many errors, and against how many more quads are none than are.
///   tries   readings of the quad that were looked up
double log_odds(const codec::Family& family, int hamming, double evidence, int tries);

}  // namespace tagmint::detect
