#include <algorithm>
#include <array>
#include <memory>

// libapriltag's own headers mark only some of its functions as C.
extern "C" {
#include <apriltag/apriltag.h>
#include <apriltag/tag16h5.h>
#include <apriltag/tag25h9.h>
#include <apriltag/tag36h10.h>
#include <apriltag/tag36h11.h>
#include <apriltag/tagCircle21h7.h>
#include <apriltag/tagCircle49h12.h>
#include <apriltag/tagCustom48h12.h>
#include <apriltag/tagStandard41h12.h>
#include <apriltag/tagStandard52h13.h>
}

#include "detector/contender.h"

namespace tagmint::bench {
namespace {

struct PeerFamily {
  const char* name;
  apriltag_family_t* (*create)();
  void (*destroy)(apriltag_family_t*);
};

constexpr std::array kPeerFamilies = {
    PeerFamily{"tag16h5", tag16h5_create, tag16h5_destroy},
    PeerFamily{"tag25h9", tag25h9_create, tag25h9_destroy},
    PeerFamily{"tag36h10", tag36h10_create, tag36h10_destroy},
    PeerFamily{"tag36h11", tag36h11_create, tag36h11_destroy},
    PeerFamily{"tagCircle21h7", tagCircle21h7_create, tagCircle21h7_destroy},
    PeerFamily{"tagCircle49h12", tagCircle49h12_create, tagCircle49h12_destroy},
    PeerFamily{"tagCustom48h12", tagCustom48h12_create, tagCustom48h12_destroy},
    PeerFamily{"tagStandard41h12", tagStandard41h12_create, tagStandard41h12_destroy},
    PeerFamily{"tagStandard52h13", tagStandard52h13_create, tagStandard52h13_destroy}};

const PeerFamily* peer_family(const std::string& name) {
  const auto at = std::find_if(kPeerFamilies.begin(), kPeerFamilies.end(),
                               [&](const PeerFamily& family) { return name == family.name; });
  return at == kPeerFamilies.end() ? nullptr : &*at;
}

/// Edge refinement on, two bits corrected, as it comes.
class LibapriltagContender : public Contender {
 public:
  LibapriltagContender(const Task& task, double decimate) : detector_(apriltag_detector_create()) {
    for (const std::string& name : task.families) {
      const PeerFamily* family = peer_family(name);
      families_.push_back({family->create(), family->destroy});
      apriltag_detector_add_family_bits(detector_, families_.back().family, 2);
    }
    detector_->quad_decimate = static_cast<float>(decimate);
    detector_->nthreads = task.threads;
    detector_->refine_edges = true;
  }
  ~LibapriltagContender() override {
    release();
    apriltag_detector_destroy(detector_);
    for (const Owned& owned : families_) owned.destroy(owned.family);
  }
  LibapriltagContender(const LibapriltagContender&) = delete;
  LibapriltagContender& operator=(const LibapriltagContender&) = delete;

  void detect(detect::ImageView image) override {
    release();
    // It only reads the picture, though it asks for a pointer to pixels that may be written to.
    image_u8_t view = {.width = image.width,
                       .height = image.height,
                       .stride = static_cast<std::int32_t>(image.stride),
                       .buf = const_cast<std::uint8_t*>(image.data)};
    detections_ = apriltag_detector_detect(detector_, &view);
  }

  std::vector<FoundTag> found() const override {
    std::vector<FoundTag> tags;
    for (int i = 0; detections_ != nullptr && i < zarray_size(detections_); ++i) {
      apriltag_detection_t* one = nullptr;
      zarray_get(detections_, i, &one);
      FoundTag& tag = tags.emplace_back();
      tag.family = one->family->name;
      tag.id = static_cast<codec::TagId>(one->id);
      for (std::size_t k = 0; k < 4; ++k) tag.corners[k] = {one->p[k][0], one->p[k][1]};
    }
    return tags;
  }

 private:
  struct Owned {
    apriltag_family_t* family;
    void (*destroy)(apriltag_family_t*);
  };

  void release() {
    if (detections_ != nullptr) apriltag_detections_destroy(detections_);
    detections_ = nullptr;
  }

  apriltag_detector_t* detector_;
  std::vector<Owned> families_;
  zarray_t* detections_ = nullptr;
};

std::unique_ptr<Contender> make_libapriltag(const Task& task, double decimate, int /*variant*/) {
  const auto known = [](const std::string& name) { return peer_family(name) != nullptr; };
  if (!std::all_of(task.families.begin(), task.families.end(), known)) return nullptr;
  return std::make_unique<LibapriltagContender>(task, decimate);
}

}  // namespace

std::vector<ContenderKind> libapriltag_contenders() {
  return {{.name = kYardstick, .make = make_libapriltag},
          {.name = "libapriltag decimate 2", .make = make_libapriltag, .decimate = 2}};
}

}  // namespace tagmint::bench
