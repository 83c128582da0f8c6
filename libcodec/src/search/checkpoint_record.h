#pragma once

#include <cstddef>
#include <cstdint>
#include <istream>
#include <string>
#include <string_view>
#include <vector>

#include "tagmint/codec/codeword.h"

namespace tagmint::codec {

/// One record of a checkpoint file, all numbers little-endian:
///
///     kind (8 bytes) | done (8) | n (8) | digest (16 hexadecimal digits)
///     n words (8 bytes each)            | digest
///
/// A digest is the beginning of SHA-256 over the digest before it and the bytes between the two, so
/// that no record can be changed, left out or exchanged unseen, and that the length of a record
/// that was cut off is known.
struct CheckpointRecord {
  enum class Kind : std::uint64_t { Walk = 1, List = 2, Choose = 3, EndOfAttempt = 4 };
  Kind kind = Kind::Walk;
  /// As SearchStep; EndOfAttempt: words searched.
  std::uint64_t done = 0;
  /// As SearchStep; EndOfAttempt: one word, the SearchEnd.
  std::vector<Codeword> words;
};

/// Beginning of the SHA-256 of both texts together, 16 digits.
std::string chained_digest(std::string_view before, std::string_view bytes);

/// The record as bytes. `digest` is the one before it, and then the one at its end.
std::string format_record(const CheckpointRecord& record, std::string& digest);

/// What came of reading a record.
enum class RecordReading {
  Whole,
  CutOff,      ///< the file ends before the record does
  Damaged,     ///< a digest is wrong
  Unreadable,  ///< the stream gave fewer bytes than it holds
};

/// Reads one record from a stream that holds `bytes_left` more bytes.
///   digest       the one before the record, and then, if it is whole, the one at its end
///   bytes_read   length of a whole record
RecordReading read_record(std::istream& stream, std::uint64_t bytes_left, std::string& digest,
                          CheckpointRecord& record, std::uint64_t& bytes_read);

}  // namespace tagmint::codec
