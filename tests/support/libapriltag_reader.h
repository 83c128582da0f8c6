#pragma once

#include <memory>
#include <vector>

#include "tagmint/codec/family.h"
#include "tagmint/detect/geometry.h"
#include "tagmint/detect/image.h"

namespace tagmint::test {

/// A tag that libapriltag found.
struct PeerTag {
  codec::TagId id = 0;
  int hamming = 0;
  detect::Corners corners;
};

/// libapriltag's detector with one of our families, handed over as its own structure. Corrects at
/// most one bit, so that the tables of large families stay small.
class LibapriltagReader {
 public:
  explicit LibapriltagReader(const codec::Family& family);
  ~LibapriltagReader();
  LibapriltagReader(const LibapriltagReader&) = delete;
  LibapriltagReader& operator=(const LibapriltagReader&) = delete;

  std::vector<PeerTag> read(detect::Image image);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace tagmint::test
