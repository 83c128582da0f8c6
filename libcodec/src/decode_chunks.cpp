// The word is cut into radius + 1 chunks. If it has at most `radius` errors, at least one chunk has
// none: whichever codeword it came from agrees with it there. So a list of codewords for each value
// of each chunk gives all candidates, and the distance of each decides.
//
//     word      [ chunk 0 | chunk 1 | chunk 2 ]        radius 2
//     bucket       value of the chunk -> begin, end in one list of codeword indices
//
// With many codewords there are few in a bucket, since a chunk has bits / (radius + 1) bits. Where
// a chunk has many more values than there are codewords, its value is hashed to fewer buckets.

#include <algorithm>
#include <bit>
#include <cstdint>
#include <numeric>
#include <vector>

#include "decode_lookup.h"

namespace tagmint::codec {
namespace {

/// The codewords by the value of one chunk.
class ChunkIndex {
 public:
  /// The chunk is the `width` bits above the lowest `shift`; 0 <= width, width + shift <= 64.
  ChunkIndex(std::span<const Codeword> codewords, int shift, int width)
      : shift_(shift),
        mask_(low_mask(width)),
        bucket_bits_(std::min(width, static_cast<int>(std::bit_width(codewords.size())))),
        hashed_(bucket_bits_ < width) {
    // Counting sort of the indices by bucket.
    begins_.assign((std::size_t{1} << bucket_bits_) + 1, 0);
    for (const Codeword word : codewords) ++begins_[bucket_of(word) + 1];
    std::partial_sum(begins_.begin(), begins_.end(), begins_.begin());
    std::vector<std::uint32_t> next(begins_.begin(), begins_.end() - 1);
    members_.resize(codewords.size());
    for (std::size_t i = 0; i < codewords.size(); ++i) {
      members_[next[bucket_of(codewords[i])]++] = static_cast<std::uint32_t>(i);
    }
  }

  /// Indices of all codewords that agree with `word` in this chunk, and perhaps others.
  std::span<const std::uint32_t> candidates(Codeword word) const {
    const std::size_t bucket = bucket_of(word);
    return std::span(members_).subspan(begins_[bucket], begins_[bucket + 1] - begins_[bucket]);
  }

  std::size_t bytes() const { return (begins_.size() + members_.size()) * sizeof(std::uint32_t); }

 private:
  std::size_t bucket_of(Codeword word) const {
    constexpr Codeword kMultiplier = 0x9e3779b97f4a7c15u;  // 2^64 / golden ratio, odd
    const Codeword value = (word >> shift_) & mask_;
    return static_cast<std::size_t>(hashed_ ? (value * kMultiplier) >> (kMaxBits - bucket_bits_)
                                            : value);
  }

  int shift_;
  Codeword mask_;
  int bucket_bits_;
  bool hashed_;
  std::vector<std::uint32_t> begins_;   // of each bucket in members_, and the end of the last
  std::vector<std::uint32_t> members_;  // codeword indices, bucket by bucket
};

class ChunkLookup final : public ListLookup {
 public:
  ChunkLookup(const TagList& tags, int radius) : ListLookup(tags, radius) {
    // Chunks of equal width, give or take one. With radius == bits the first is empty: it agrees
    // with everything, and a word may indeed differ from its codeword in every bit.
    const int chunks = radius + 1;
    for (int chunk = 0; chunk < chunks; ++chunk) {
      const int begin = chunk * tags.bits / chunks;
      const int end = (chunk + 1) * tags.bits / chunks;
      chunks_.emplace_back(tags.codewords, begin, end - begin);
    }
  }

  std::size_t table_bytes() const override {
    std::size_t bytes = 0;
    for (const ChunkIndex& chunk : chunks_) bytes += chunk.bytes();
    return bytes;
  }

 private:
  Nearest nearest(Codeword word) const override {
    Nearest nearest;
    for (const ChunkIndex& chunk : chunks_) {
      for (const std::uint32_t index : chunk.candidates(word)) compare(word, index, nearest);
    }
    return nearest;
  }

  std::vector<ChunkIndex> chunks_;
};

}  // namespace

std::unique_ptr<const Decoder::Lookup> make_chunk_lookup(const TagList& tags, int radius) {
  return std::make_unique<const ChunkLookup>(tags, radius);
}

}  // namespace tagmint::codec
