#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tagmint/codec/family.h"
#include "tagmint/detect/detection.h"
#include "tagmint/detect/geometry.h"
#include "tagmint/detect/image_view.h"

namespace tagmint::evaluate {

/// A tag that a contender reports, in the conventions of detect::Detection.
struct FoundTag {
  codec::TagId id = 0;
  std::optional<int> hamming;  ///< corrected bits, where the contender says it
  detect::Corners corners;
  std::optional<detect::CornerCovariance> covariance;
};

/// A detector under one setting. Keeps its memory from picture to picture, as a user's program
/// would; serves one thread.
class Contender {
 public:
  virtual ~Contender() = default;
  /// The detection alone: this is what a clock measures. The picture's rows are without padding.
  virtual void detect(detect::ImageView image) = 0;
  /// What the last detect() found.
  virtual std::vector<FoundTag> found() const = 0;
  /// Quads that the last detect() tried to decode; nothing where the contender does not say.
  virtual std::optional<std::int64_t> candidates() const = 0;
};

/// What contenders are to do.
struct Task {
  codec::SharedFamily family;
  double decimate = 1;
  int threads = 1;
  int max_hamming = 2;  ///< bits to correct, at most the family's safe radius
};

/// Two bits, as the paper corrects, or as many as the family safely can.
int usual_max_hamming(const codec::Family& family);

/// Memory and time of the tables that a detector makes to look words up.
struct TableCost {
  std::int64_t bytes = 0;
  double seconds = 0;
};

/// A program that finds tags.
struct ContenderKind {
  std::string name;     ///< "libapriltag"; the word in tables and legends
  std::string release;  ///< "libapriltag 3.3.0"
  int style = 0;        ///< of its curves, plot::Series::style
  /// Null where it cannot do the task: a family that it does not know, or that would take too much
  /// memory; decimation that it lacks.
  std::function<std::unique_ptr<Contender>(const Task&)> make;
  /// What its look-up tables take; nothing where it has none or cannot say. May be empty.
  std::function<std::optional<TableCost>(const Task&)> table_cost = {};
};

/// tagmint as it comes ("tagmint"), and by the paper's method alone ("paper's method": components,
/// clusters and line fits, edges by gradient, no photometric step, no second reading).
std::vector<ContenderKind> own_contenders();

}  // namespace tagmint::evaluate
