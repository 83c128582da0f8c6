#pragma once

#include <vector>

#include "tagmint/detect/detect_stats.h"
#include "tagmint/detect/detection.h"

namespace tagmint::detect {

/// Stage 8: one detection for each tag. Where several families were read from one quad, the reading
/// stays that is least likely an accident (codec::false_accept_rate() of its family and errors),
/// then the one with the larger decision margin. Where detections of the same family and id
/// overlap, the one with fewer corrected errors stays, then the one with the larger decision
/// margin, then the one whose centre and corners come first. Nested or neighbouring tags of other
/// ids all stay.
///   detections   candidates in any order; become what stays, sorted by family name, id, then
///                centre (y, x). At most one candidate of each family and quad
///   stats        duplicates and detections are added to
///   cost         O(n log n), and a comparison for each pair of the same family and id; no memory
void reconcile(std::vector<Detection>& detections, DetectStats& stats);

/// Sorts by family name, id, then centre (y, x): once more where corners have changed since.
void sort_detections(std::vector<Detection>& detections);

}  // namespace tagmint::detect
