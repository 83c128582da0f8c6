#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tagmint/codec/family.h"
#include "tagmint/detect/geometry.h"
#include "tagmint/detect/image_view.h"

namespace tagmint::bench {

/// A tag that a detector reports, in the conventions of detect::Detection.
struct FoundTag {
  std::string family;
  codec::TagId id = 0;
  detect::Corners corners;
};

/// What all contenders look for in a set of pictures.
struct Task {
  std::vector<std::string> families = {"tag36h11"};  ///< bundled names
  int threads = 1;
};

/// A detector under one setting. Keeps its memory from picture to picture, as a user's program
/// would.
class Contender {
 public:
  virtual ~Contender() = default;
  /// The detection alone: this is what the clock measures.
  virtual void detect(detect::ImageView image) = 0;
  /// What the last detect() found.
  virtual std::vector<FoundTag> found() const = 0;
};

/// How to make a contender for a task.
struct ContenderKind {
  std::string name;
  /// Null when it cannot do the task (families that it does not know).
  std::unique_ptr<Contender> (*make)(const Task& task, double decimate, int variant);
  double decimate = 1;
  int variant = 0;  ///< of the program named: an algorithm, a profile, a way to refine corners

  std::unique_ptr<Contender> make_for(const Task& task) const {
    return make(task, decimate, variant);
  }
};

/// tagmint's algorithms and profiles; libapriltag and OpenCV where they were found at build time.
std::vector<ContenderKind> tagmint_contenders();
std::vector<ContenderKind> libapriltag_contenders();
std::vector<ContenderKind> opencv_contenders();

/// All of them. Ratios are against the one named kYardstick.
std::vector<ContenderKind> all_contenders();
inline constexpr const char* kYardstick = "libapriltag";

}  // namespace tagmint::bench
