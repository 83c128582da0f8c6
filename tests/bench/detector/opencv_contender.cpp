#include <algorithm>
#include <array>
#include <memory>
#include <opencv2/aruco.hpp>
#include <utility>

#include "detector/contender.h"

namespace tagmint::bench {
namespace {

namespace aruco = cv::aruco;

constexpr std::array<std::pair<const char*, aruco::PREDEFINED_DICTIONARY_NAME>, 4> kDictionaries = {
    {{"tag16h5", aruco::DICT_APRILTAG_16h5},
     {"tag25h9", aruco::DICT_APRILTAG_25h9},
     {"tag36h10", aruco::DICT_APRILTAG_36h10},
     {"tag36h11", aruco::DICT_APRILTAG_36h11}}};

/// ArUco with its AprilTag dictionary, corners refined.
class OpencvContender : public Contender {
 public:
  OpencvContender(std::string family, aruco::PREDEFINED_DICTIONARY_NAME name, int threads,
                  int refinement)
      : family_(std::move(family)),
        dictionary_(aruco::getPredefinedDictionary(name)),
        parameters_(aruco::DetectorParameters::create()),
        threads_(threads) {
    parameters_->cornerRefinementMethod = refinement;
    offset_ = refinement == aruco::CORNER_REFINE_APRILTAG ? 0 : 0.5;
  }

  void detect(detect::ImageView image) override {
    cv::setNumThreads(threads_);
    const cv::Mat picture(image.height, image.width, CV_8UC1, const_cast<std::uint8_t*>(image.data),
                          static_cast<std::size_t>(image.stride));
    corners_.clear();
    ids_.clear();
    aruco::detectMarkers(picture, dictionary_, corners_, ids_, parameters_);
  }

  /// Its coordinates begin in the middle of the first pixel, but for the corners of its own copy of
  /// the AprilTag method, which begin at the pixel's corner as ours do (measured: without that, all
  /// are 0.7 px off). Its dictionary shows the tags turned by 180 degrees, and corners go clockwise
  /// from the top left one.
  std::vector<FoundTag> found() const override {
    constexpr std::array<std::size_t, 4> kTheirs = {1, 0, 3, 2};
    std::vector<FoundTag> tags;
    for (std::size_t i = 0; i < ids_.size(); ++i) {
      FoundTag& tag = tags.emplace_back();
      tag.family = family_;
      tag.id = static_cast<codec::TagId>(ids_[i]);
      for (std::size_t k = 0; k < 4; ++k) {
        const cv::Point2f corner = corners_[i][kTheirs[k]];
        tag.corners[k] = {corner.x + offset_, corner.y + offset_};
      }
    }
    return tags;
  }

 private:
  std::string family_;
  cv::Ptr<aruco::Dictionary> dictionary_;
  cv::Ptr<aruco::DetectorParameters> parameters_;
  int threads_;
  double offset_ = 0.5;
  std::vector<std::vector<cv::Point2f>> corners_;
  std::vector<int> ids_;
};

/// It looks for one dictionary at a time.
std::unique_ptr<Contender> make_opencv(const Task& task, double /*decimate*/, int refinement) {
  if (task.families.size() != 1) return nullptr;
  const auto at = std::find_if(kDictionaries.begin(), kDictionaries.end(),
                               [&](const auto& each) { return task.families[0] == each.first; });
  if (at == kDictionaries.end()) return nullptr;
  return std::make_unique<OpencvContender>(at->first, at->second, task.threads, refinement);
}

}  // namespace

std::vector<ContenderKind> opencv_contenders() {
  return {
      {.name = "OpenCV subpix", .make = make_opencv, .variant = aruco::CORNER_REFINE_SUBPIX},
      {.name = "OpenCV apriltag", .make = make_opencv, .variant = aruco::CORNER_REFINE_APRILTAG}};
}

}  // namespace tagmint::bench
