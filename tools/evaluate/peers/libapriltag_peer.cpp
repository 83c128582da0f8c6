// libapriltag as a peer.
#include <malloc.h>

#include <chrono>
#include <cstdlib>
#include <exception>
#include <memory>
#include <string>

// Its own headers mark only some of its functions as C.
extern "C" {
#include <apriltag/apriltag.h>
}

#include "evaluate/peers/peer_interface.h"

namespace {

/// A family as it knows them. It is told of any family, not only of its own.
class Family {
 public:
  explicit Family(const tagmint_peer_family& told) : name_(told.name) {
    family_.ncodes = told.codes;
    family_.codes = const_cast<std::uint64_t*>(told.codewords);
    family_.width_at_border = told.width_at_border;
    family_.total_width = told.total_width;
    family_.reversed_border = told.reversed_border != 0;
    family_.nbits = told.bits;
    family_.bit_x = const_cast<std::uint32_t*>(told.bit_x);
    family_.bit_y = const_cast<std::uint32_t*>(told.bit_y);
    family_.h = told.min_hamming;
    family_.name = name_.data();
  }
  apriltag_family_t* get() { return &family_; }

 private:
  std::string name_;
  apriltag_family_t family_{};
};

/// Its table has three slots of 16 bytes for each word within two errors, ordered pairs counted
/// twice.
double table_bytes(const tagmint_peer_task& task) {
  const double bits = task.family->bits;
  double words = 1;
  if (task.max_hamming >= 1) words += bits;
  if (task.max_hamming >= 2) words += bits * (bits - 1);
  return 48 * words * task.family->codes;
}
/// A detector for each thread has one of them.
constexpr double kMostTableBytes = 300e6;

class Detector {
 public:
  explicit Detector(const tagmint_peer_task& task)
      : family_(*task.family), detector_(apriltag_detector_create()) {
    apriltag_detector_add_family_bits(detector_, family_.get(), task.max_hamming);
    detector_->quad_decimate = static_cast<float>(task.decimate);
    detector_->nthreads = task.threads;
    detector_->refine_edges = true;
  }
  ~Detector() {
    release();
    apriltag_detector_destroy(detector_);
  }
  Detector(const Detector&) = delete;
  Detector& operator=(const Detector&) = delete;

  void detect(const std::uint8_t* pixels, int width, int height, std::ptrdiff_t stride) {
    release();
    // It only reads the picture, though it asks for a pointer to pixels that may be written to.
    image_u8_t view = {.width = width,
                       .height = height,
                       .stride = static_cast<std::int32_t>(stride),
                       .buf = const_cast<std::uint8_t*>(pixels)};
    detections_ = apriltag_detector_detect(detector_, &view);
  }

  int count() const { return detections_ == nullptr ? 0 : zarray_size(detections_); }

  tagmint_peer_tag tag(int index) const {
    apriltag_detection_t* one = nullptr;
    zarray_get(detections_, index, &one);
    tagmint_peer_tag tag = {.id = one->id, .hamming = one->hamming, .corners = {}};
    for (int k = 0; k < 4; ++k) {
      tag.corners[2 * k] = one->p[k][0];
      tag.corners[2 * k + 1] = one->p[k][1];
    }
    return tag;
  }

  std::int64_t candidates() const { return detector_->nquads; }

 private:
  void release() {
    if (detections_ != nullptr) apriltag_detections_destroy(detections_);
    detections_ = nullptr;
  }

  Family family_;
  apriltag_detector_t* detector_;
  zarray_t* detections_ = nullptr;
};

Detector& cast(void* detector) { return *static_cast<Detector*>(detector); }

void* open_detector(const tagmint_peer_task* task) {
  if (task->max_hamming > 2 || table_bytes(*task) > kMostTableBytes) return nullptr;
  return new Detector(*task);
}

std::int32_t table_cost(const tagmint_peer_task* task, std::int64_t* bytes, double* seconds) {
  if (task->max_hamming > 2 || table_bytes(*task) > 4 * kMostTableBytes) return 0;
  const auto used = [] {
    const struct mallinfo2 now = mallinfo2();
    return static_cast<std::int64_t>(now.uordblks + now.hblkhd);
  };
  Family family(*task->family);
  apriltag_detector_t* const detector = apriltag_detector_create();
  const std::int64_t before = used();
  const auto start = std::chrono::steady_clock::now();
  apriltag_detector_add_family_bits(detector, family.get(), task->max_hamming);
  const auto end = std::chrono::steady_clock::now();
  *bytes = used() - before;
  *seconds = std::chrono::duration<double>(end - start).count();
  apriltag_detector_destroy(detector);
  return 1;
}

}  // namespace

extern "C" const tagmint_peer* tagmint_peer_entry() {
  static const tagmint_peer peer = {
      .version = TAGMINT_PEER_VERSION,
      .style = 2,
      .name = "libapriltag",
      .release = "libapriltag " TAGMINT_PEER_RELEASE,
      .open = open_detector,
      .detect = [](void* detector, const std::uint8_t* pixels, std::int32_t width,
                   std::int32_t height,
                   std::ptrdiff_t stride) { cast(detector).detect(pixels, width, height, stride); },
      .count = [](void* detector) -> std::int32_t { return cast(detector).count(); },
      .tag = [](void* detector, std::int32_t index) { return cast(detector).tag(index); },
      .candidates = [](void* detector) { return cast(detector).candidates(); },
      .close = [](void* detector) { delete &cast(detector); },
      .table_cost = table_cost};
  return &peer;
}
