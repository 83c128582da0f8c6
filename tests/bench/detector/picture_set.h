#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "detector/contender.h"
#include "tagmint/detect/image.h"

namespace tagmint::bench {

/// A tag that is in a picture.
struct TrueTag {
  std::string family;
  codec::TagId id = 0;
  detect::Corners corners;  ///< exact to rounding where the picture was rendered
};

/// A picture in memory and what is true of it.
struct Picture {
  detect::Image image;
  std::vector<TrueTag> tags;
};

/// Pictures of one kind. Sets of one group differ in one quantity: `small-10` and `small-12` are
/// both of the group `small`.
struct PictureSet {
  std::string name;   ///< "group" or "group-value"
  std::string about;  ///< what the pictures show, for the head of the table
  Task task{};
  int most = 0;        ///< pictures that there are; 0 = any number
  bool whole = false;  ///< all of them are measured, however few were asked for
  std::function<Picture(int index, std::uint64_t seed)> draw{};  ///< depends on its arguments alone

  std::string group() const { return name.substr(0, name.find('-')); }
};

/// Size of the pictures of all rendered sets but the large one, px.
struct PictureSize {
  int width = 1280;
  int height = 960;
};

/// The sets that the renderer makes.
std::vector<PictureSet> rendered_sets(const PictureSize& size);

/// Tags pasted into the photographs of a folder, and the photographs as they are (no tags).
/// Throws codec::InputError when the folder cannot be read or holds no picture.
std::vector<PictureSet> photograph_sets(const std::string& folder, const PictureSize& size);

/// The pictures of a folder with labels.json: [{"file","tags":[{"id","corners"}]}]. Labels are
/// another detector's answer, not the truth: recall is agreement with it.
/// Throws codec::InputError when the folder or its labels cannot be read.
PictureSet labelled_set(const std::string& folder);

}  // namespace tagmint::bench
