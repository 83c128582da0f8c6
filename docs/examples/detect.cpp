// docs/examples/detect.cpp: several families in many pictures, a detector for each thread.
#include <cmath>
#include <iostream>
#include <memory>
#include <thread>
#include <vector>

#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/decoder.h"
#include "tagmint/codec/tag_cells.h"
#include "tagmint/detect/detector.h"
#include "tagmint/detect/image.h"

namespace codec = tagmint::codec;
namespace detect = tagmint::detect;

/// A picture of one tag, ten pixels a cell, to have something to look at.
detect::Image picture_of(const codec::Family& family, codec::TagId id) {
  const codec::TagCells cells = codec::tag_cells(family.layout(), family.codeword(id));
  detect::Image picture(200, 200, 220);
  for (int y = 0; y < 10 * cells.width(); ++y) {
    for (int x = 0; x < 10 * cells.width(); ++x) {
      if (cells.at(x / 10, y / 10) == codec::Cell::Black) picture.at(40 + x, 40 + y) = 30;
    }
  }
  return picture;
}

int main() {
  // Families and decoders are constant: all threads share them.
  std::vector<std::shared_ptr<const codec::Decoder>> decoders;
  for (const char* name : {"tag36h11", "tagStandard41h12", "tagCircle21h7"}) {
    decoders.push_back(std::make_shared<const codec::Decoder>(codec::find_family(name)));
  }
  std::vector<detect::Image> pictures;
  for (codec::TagId id = 0; id < 8; ++id) {
    pictures.push_back(picture_of(*decoders[id % 3]->family(), id));
  }

  std::vector<std::vector<detect::Detection>> found(pictures.size());
  constexpr std::size_t kThreads = 2;
  std::vector<std::jthread> threads;
  for (std::size_t first = 0; first < kThreads; ++first) {
    threads.emplace_back([&, first] {
      detect::Detector detector(decoders);  // its scratch memory serves one thread
      for (std::size_t i = first; i < pictures.size(); i += kThreads) {
        found[i] = detector.detect(pictures[i]);
      }
    });
  }
  threads.clear();  // waits for all of them

  for (const auto& tags : found) {
    for (const detect::Detection& tag : tags) {
      std::cout << tag.family->name() << ' ' << tag.id << " at " << std::lround(tag.center.x)
                << ", " << std::lround(tag.center.y) << '\n';
    }
  }
}
