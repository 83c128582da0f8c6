#pragma once

#include <stddef.h>
#include <stdint.h>

/// What `tagmint evaluate` and a detector of somebody else say to each other: plain C, so that a
/// peer is a shared library of its own. It is compiled where the detector's headers are, links with
/// the detector and nothing of tagmint, and is opened at run time where it is found; a peer that
/// cannot be opened (its detector is not installed) takes no part.
///
/// A peer exports one function, `const tagmint_peer* tagmint_peer_entry(void)`. Pixel coordinates,
/// order of corners and turn of a tag are those of libapriltag: (0, 0) is the corner of the first
/// pixel.
extern "C" {

#define TAGMINT_PEER_VERSION 1

/// A family of tags. All pointers are valid as long as a detector for it is open.
struct tagmint_peer_family {
  const char* name;
  uint32_t codes;
  const uint64_t* codewords;  ///< first bit = most significant
  uint32_t bits;
  const uint32_t* bit_x;  ///< cells from the border square's top left corner, may be negative
  const uint32_t* bit_y;
  int32_t width_at_border;  ///< cells
  int32_t total_width;      ///< cells
  int32_t reversed_border;
  uint32_t min_hamming;
};

struct tagmint_peer_task {
  const tagmint_peer_family* family;
  double decimate;
  int32_t threads;
  int32_t max_hamming;
};

struct tagmint_peer_tag {
  int32_t id;
  int32_t hamming;    ///< -1 = not said
  double corners[8];  ///< x, y; bottom-left, bottom-right, top-right, top-left
};

struct tagmint_peer {
  int32_t version;  ///< TAGMINT_PEER_VERSION
  int32_t style;    ///< of its curves: 2 to 7
  const char* name;
  const char* release;  ///< name and version of the detector that runs
  /// Null where the task cannot be done.
  void* (*open)(const tagmint_peer_task* task);
  void (*detect)(void* detector, const uint8_t* pixels, int32_t width, int32_t height,
                 ptrdiff_t stride);
  /// Tags and candidate quads (-1 = not said) of the last detect().
  int32_t (*count)(void* detector);
  tagmint_peer_tag (*tag)(void* detector, int32_t index);
  int64_t (*candidates)(void* detector);
  void (*close)(void* detector);
  /// Bytes and seconds of the look-up tables for a task; 0 = cannot say. May be null.
  int32_t (*table_cost)(const tagmint_peer_task* task, int64_t* bytes, double* seconds);
};

}  // extern "C"
