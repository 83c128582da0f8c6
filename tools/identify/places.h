#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "identify/cell_grid.h"
#include "tagmint/detect/geometry.h"
#include "tagmint/detect/image_view.h"

namespace tagmint::identify {

/// Where the border square of a tag may be.
struct Place {
  /// Counter-clockwise as seen, in pixels; may lie outside of the picture.
  detect::Corners corners;
  /// Cells along its side, where only tags with as many fit.
  std::optional<int> cells_at_border = {};
};

/// Finds the squares that are darker or lighter than what is around them: the first stages of the
/// detector. Keeps its scratch memory.
class SquareFinder {
 public:
  /// `threads`: 0 = all cores.
  explicit SquareFinder(int threads);
  ~SquareFinder();
  SquareFinder(const SquareFinder&) = delete;
  SquareFinder& operator=(const SquareFinder&) = delete;

  std::vector<Place> find(detect::ImageView picture);
  /// The same where the picture's own edge may be that of the border square: the picture is
  /// continued in white and in black.
  std::vector<Place> find_at_edges(detect::ImageView picture);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// The largest cells, in pixels, that find_cell_grids() looks for; larger ones are seen as squares.
inline constexpr int kLargestGridCell_px = 4;

/// Finds border squares whose cells are whole pixels, from one pixel a cell on, in a picture of two
/// gray levels; a picture of more levels has none. The ring inside of the square has one colour,
/// and as far as it is in the picture, the ring outside has the other.
///   frames   of the tags that are looked for
///   cost     a few comparisons a pixel, number of cells at the border and size of a cell
std::vector<Place> find_cell_grids(detect::ImageView picture, const std::set<Frame>& frames);

/// The border squares of tags that fill the picture, or its part without even margins: whole ones,
/// and those whose outer rings, up to the first one with data cells, were cut away.
///   rings_of_frames   of each frame, how many of its rings, from outside, may be cut away
std::vector<Place> filled_places(detect::ImageView picture,
                                 const std::map<Frame, int>& rings_of_frames);

}  // namespace tagmint::identify
