// libapriltag reads our printed sheets: every id, at its place, upright.
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
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <memory>
#include <string>

#include "draw/sheet_writer.h"
#include "support/rasterise.h"
#include "support/sheet_samples.h"

namespace tagmint::draw {
namespace {

struct Peer {
  const char* name;
  apriltag_family_t* (*create)();
  void (*destroy)(apriltag_family_t*);
};

const Peer kPeers[] = {
    {"tag16h5", tag16h5_create, tag16h5_destroy},
    {"tag25h9", tag25h9_create, tag25h9_destroy},
    {"tag36h10", tag36h10_create, tag36h10_destroy},
    {"tag36h11", tag36h11_create, tag36h11_destroy},
    {"tagCircle21h7", tagCircle21h7_create, tagCircle21h7_destroy},
    {"tagCircle49h12", tagCircle49h12_create, tagCircle49h12_destroy},
    {"tagCustom48h12", tagCustom48h12_create, tagCustom48h12_destroy},
    {"tagStandard41h12", tagStandard41h12_create, tagStandard41h12_destroy},
    {"tagStandard52h13", tagStandard52h13_create, tagStandard52h13_destroy},
};

/// libapriltag's detector with one family; corrects no errors, so that the large families' tables
/// stay small.
class PeerDetector {
 public:
  explicit PeerDetector(const Peer& peer)
      : peer_(peer), family_(peer.create()), detector_(apriltag_detector_create()) {
    apriltag_detector_add_family_bits(detector_, family_, 0);
    detector_->quad_decimate = 1.0f;
  }
  ~PeerDetector() {
    apriltag_detector_destroy(detector_);
    peer_.destroy(family_);
  }
  PeerDetector(const PeerDetector&) = delete;
  PeerDetector& operator=(const PeerDetector&) = delete;

  zarray_t* detect(detect::Image& page) {
    image_u8_t image = {page.width(), page.height(), page.width(), page.row(0)};
    return apriltag_detector_detect(detector_, &image);
  }

 private:
  const Peer& peer_;
  apriltag_family_t* family_;
  apriltag_detector_t* detector_;
};

/// Largest distance between a detection's corners and those of the border square in the plan, in
/// pixels. libapriltag's first corner is the bottom-left one of an upright tag, the next the
/// bottom-right one.
double corner_error_px(const apriltag_detection_t& found, const detect::Corners& planned) {
  double largest = 0;
  for (int i = 0; i < 4; ++i) {
    largest =
        std::max(largest, std::hypot(found.p[i][0] - planned[i].x, found.p[i][1] - planned[i].y));
  }
  return largest;
}

TEST(SheetVsLibapriltag, EveryTagOfEveryFamilyIsReadUprightAtItsPlace) {
  constexpr double kDpi = 150;
  for (const Peer& peer : kPeers) {
    const auto sheet = test::sample_sheet(peer.name, 24, 20);
    auto pages = test::pdf_pages(sheet_pdf(sheet.plan, sheet.decor, "test"), kDpi);
    ASSERT_EQ(pages.size(), sheet.plan.pages.size());
    PeerDetector detector(peer);
    for (std::size_t page = 0; page < pages.size(); ++page) {
      std::map<codec::TagId, const PlacedTag*> places;
      for (const PlacedTag& tag : sheet.plan.pages[page].tags) places[tag.id] = &tag;
      zarray_t* const found = detector.detect(pages[page]);
      EXPECT_EQ(zarray_size(found), static_cast<int>(places.size())) << peer.name;
      for (int i = 0; i < zarray_size(found); ++i) {
        apriltag_detection_t* detection = nullptr;
        zarray_get(found, i, &detection);
        const auto place = places.find(static_cast<codec::TagId>(detection->id));
        ASSERT_NE(place, places.end()) << peer.name << " id " << detection->id;
        EXPECT_EQ(detection->hamming, 0) << peer.name;
        EXPECT_LT(
            corner_error_px(*detection, test::planned_corners(sheet.plan, *place->second, kDpi)),
            1.0)
            << peer.name << " id " << detection->id;
        places.erase(place);
      }
      apriltag_detections_destroy(found);
    }
  }
}

}  // namespace
}  // namespace tagmint::draw
