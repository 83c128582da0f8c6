// OpenCV's ArUco detector with its dictionaries of AprilTags as a peer.
#include <array>
#include <cstring>
#include <opencv2/aruco.hpp>
#include <string>
#include <utility>
#include <vector>

#include "evaluate/peers/peer_interface.h"

namespace {

namespace aruco = cv::aruco;

constexpr std::array<std::pair<const char*, aruco::PREDEFINED_DICTIONARY_NAME>, 4> kDictionaries = {
    {{"tag16h5", aruco::DICT_APRILTAG_16h5},
     {"tag25h9", aruco::DICT_APRILTAG_25h9},
     {"tag36h10", aruco::DICT_APRILTAG_36h10},
     {"tag36h11", aruco::DICT_APRILTAG_36h11}}};

class Detector {
 public:
  Detector(aruco::PREDEFINED_DICTIONARY_NAME name, const tagmint_peer_task& task)
      : dictionary_(cv::makePtr<aruco::Dictionary>(*aruco::getPredefinedDictionary(name))),
        parameters_(aruco::DetectorParameters::create()) {
    cv::setNumThreads(task.threads);
    parameters_->cornerRefinementMethod = aruco::CORNER_REFINE_SUBPIX;
    // It corrects int(rate * maxCorrectionBits) bits; its own dictionaries of AprilTags say 0.
    dictionary_->maxCorrectionBits = task.max_hamming;
    parameters_->errorCorrectionRate = 1;
  }

  void detect(const std::uint8_t* pixels, int width, int height, std::ptrdiff_t stride) {
    const cv::Mat picture(height, width, CV_8UC1, const_cast<std::uint8_t*>(pixels),
                          static_cast<std::size_t>(stride));
    corners_.clear();
    ids_.clear();
    rejected_.clear();
    aruco::detectMarkers(picture, dictionary_, corners_, ids_, parameters_, rejected_);
  }

  int count() const { return static_cast<int>(ids_.size()); }

  /// Its coordinates begin in the middle of the first pixel, its dictionaries show the tags turned
  /// by 180 degrees, and corners go clockwise from the top left one.
  tagmint_peer_tag tag(int index) const {
    constexpr std::array<std::size_t, 4> kTheirs = {1, 0, 3, 2};
    const auto i = static_cast<std::size_t>(index);
    tagmint_peer_tag tag = {.id = ids_[i], .hamming = -1, .corners = {}};
    for (std::size_t k = 0; k < 4; ++k) {
      const cv::Point2f corner = corners_[i][kTheirs[k]];
      tag.corners[2 * k] = corner.x + 0.5;
      tag.corners[2 * k + 1] = corner.y + 0.5;
    }
    return tag;
  }

  std::int64_t candidates() const {
    return static_cast<std::int64_t>(ids_.size() + rejected_.size());
  }

 private:
  cv::Ptr<aruco::Dictionary> dictionary_;
  cv::Ptr<aruco::DetectorParameters> parameters_;
  std::vector<std::vector<cv::Point2f>> corners_;
  std::vector<std::vector<cv::Point2f>> rejected_;
  std::vector<int> ids_;
};

Detector& cast(void* detector) { return *static_cast<Detector*>(detector); }

void* open_detector(const tagmint_peer_task* task) {
  if (task->decimate != 1) return nullptr;
  for (const auto& [name, dictionary] : kDictionaries) {
    if (std::strcmp(name, task->family->name) == 0) return new Detector(dictionary, *task);
  }
  return nullptr;
}

}  // namespace

extern "C" const tagmint_peer* tagmint_peer_entry() {
  static const std::string release = "OpenCV " + std::string(cv::getVersionString());
  static const tagmint_peer peer = {
      .version = TAGMINT_PEER_VERSION,
      .style = 3,
      .name = "OpenCV",
      .release = release.c_str(),
      .open = open_detector,
      .detect = [](void* detector, const std::uint8_t* pixels, std::int32_t width,
                   std::int32_t height,
                   std::ptrdiff_t stride) { cast(detector).detect(pixels, width, height, stride); },
      .count = [](void* detector) -> std::int32_t { return cast(detector).count(); },
      .tag = [](void* detector, std::int32_t index) { return cast(detector).tag(index); },
      .candidates = [](void* detector) { return cast(detector).candidates(); },
      .close = [](void* detector) { delete &cast(detector); },
      .table_cost = nullptr};
  return &peer;
}
