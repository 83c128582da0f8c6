#include "support/libapriltag_reader.h"

#include <cstdint>
#include <string>

// libapriltag's own headers mark only some of its functions as C.
extern "C" {
#include <apriltag/apriltag.h>
}

namespace tagmint::test {

struct LibapriltagReader::Impl {
  std::vector<std::uint64_t> codes;
  std::vector<std::uint32_t> bit_x;
  std::vector<std::uint32_t> bit_y;
  std::string name;
  apriltag_family_t family = {};
  apriltag_detector_t* detector = nullptr;
};

LibapriltagReader::LibapriltagReader(const codec::Family& family)
    : impl_(std::make_unique<Impl>()) {
  const codec::Layout& layout = family.layout();
  impl_->codes = codec::first_codewords(family, family.size());
  impl_->name = family.name();
  for (const codec::CellPosition cell : layout.data_cells()) {
    // Counted from the border square; cells outside it are negative, as libapriltag has them.
    impl_->bit_x.push_back(static_cast<std::uint32_t>(cell.x - layout.border_offset()));
    impl_->bit_y.push_back(static_cast<std::uint32_t>(cell.y - layout.border_offset()));
  }
  apriltag_family_t& peer = impl_->family;
  peer.ncodes = static_cast<std::uint32_t>(impl_->codes.size());
  peer.codes = impl_->codes.data();
  peer.width_at_border = layout.width_at_border();
  peer.total_width = layout.width();
  peer.reversed_border = layout.reversed_border();
  peer.nbits = static_cast<std::uint32_t>(layout.bits());
  peer.bit_x = impl_->bit_x.data();
  peer.bit_y = impl_->bit_y.data();
  peer.h = static_cast<std::uint32_t>(family.min_hamming());
  peer.name = impl_->name.data();
  impl_->detector = apriltag_detector_create();
  apriltag_detector_add_family_bits(impl_->detector, &peer, 1);
  impl_->detector->quad_decimate = 1.0f;
}

LibapriltagReader::~LibapriltagReader() { apriltag_detector_destroy(impl_->detector); }

std::vector<PeerTag> LibapriltagReader::read(detect::Image image) {
  image_u8_t view = {.width = image.width(),
                     .height = image.height(),
                     .stride = image.width(),
                     .buf = image.row(0)};
  zarray_t* const found = apriltag_detector_detect(impl_->detector, &view);
  std::vector<PeerTag> tags;
  for (int i = 0; i < zarray_size(found); ++i) {
    apriltag_detection_t* one = nullptr;
    zarray_get(found, i, &one);
    PeerTag& tag = tags.emplace_back(PeerTag{static_cast<codec::TagId>(one->id), one->hamming, {}});
    for (std::size_t k = 0; k < 4; ++k) tag.corners[k] = {one->p[k][0], one->p[k][1]};
  }
  apriltag_detections_destroy(found);
  return tags;
}

}  // namespace tagmint::test
