#include "io/family_kinds/gzip.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <limits>
#include <new>
#include <vector>

#include "tagmint/codec/errors.h"

namespace tagmint::io {
namespace {

constexpr int kGzipWindow = 15 + 16;                         // zlib: largest window, gzip frame
constexpr std::size_t kMostUnpacked = std::size_t{1} << 31;  // a small file may claim anything
constexpr std::size_t kBlock = std::size_t{1} << 20;

/// zlib counts input in 32 bits.
uInt clipped(std::size_t count) {
  return static_cast<uInt>(std::min<std::size_t>(count, std::numeric_limits<uInt>::max()));
}

/// zlib takes its input as not constant but does not write there.
Bytef* input_of(std::string_view bytes) {
  return reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
}

struct Unpacking : z_stream {
  Unpacking() : z_stream{} {
    if (inflateInit2(this, kGzipWindow) != Z_OK) throw std::bad_alloc();
  }
  ~Unpacking() { inflateEnd(this); }
  Unpacking(const Unpacking&) = delete;
  Unpacking& operator=(const Unpacking&) = delete;
};

struct Packing : z_stream {
  Packing() : z_stream{} {
    constexpr int kMemoryLevel = 8;  // zlib's default
    if (deflateInit2(this, Z_BEST_COMPRESSION, Z_DEFLATED, kGzipWindow, kMemoryLevel,
                     Z_DEFAULT_STRATEGY) != Z_OK) {
      throw std::bad_alloc();
    }
  }
  ~Packing() { deflateEnd(this); }
  Packing(const Packing&) = delete;
  Packing& operator=(const Packing&) = delete;
};

}  // namespace

bool is_gzip(std::string_view bytes) { return bytes.starts_with("\x1f\x8b"); }

std::string gunzip(std::string_view bytes, const std::string& source) {
  Unpacking stream;
  std::string content;
  std::vector<char> block(kBlock);
  for (;;) {
    stream.next_in = input_of(bytes);
    stream.avail_in = clipped(bytes.size());
    stream.next_out = reinterpret_cast<Bytef*>(block.data());
    stream.avail_out = clipped(block.size());
    const uInt given = stream.avail_in;
    const int state = inflate(&stream, Z_NO_FLUSH);
    bytes.remove_prefix(given - stream.avail_in);
    content.append(block.data(), block.size() - stream.avail_out);
    if (content.size() > kMostUnpacked) {
      throw codec::InputError("the gzip file unpacks to more than 2 GiB", source,
                              "unpack it and take the part that is meant");
    }
    if (state == Z_STREAM_END) {
      if (bytes.empty()) return content;
      inflateReset(&stream);  // another member follows
    } else if (state != Z_OK) {
      // Without input left there was no progress: the end is missing.
      throw codec::InputError(
          fmt::format("the gzip file is {}", bytes.empty() ? "cut short" : "damaged"), source,
          "get the file anew");
    }
  }
}

std::string gzip(std::string_view content) {
  Packing stream;
  std::string bytes;
  std::vector<char> block(kBlock);
  int state = Z_OK;
  while (state != Z_STREAM_END) {
    stream.next_in = input_of(content);
    stream.avail_in = clipped(content.size());
    stream.next_out = reinterpret_cast<Bytef*>(block.data());
    stream.avail_out = clipped(block.size());
    const uInt given = stream.avail_in;
    state = deflate(&stream, given == content.size() ? Z_FINISH : Z_NO_FLUSH);
    content.remove_prefix(given - stream.avail_in);
    bytes.append(block.data(), block.size() - stream.avail_out);
  }
  return bytes;
}

}  // namespace tagmint::io
