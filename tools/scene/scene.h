#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "tagmint/codec/family.h"
#include "tagmint/codec/layout.h"
#include "tagmint/detect/camera.h"
#include "tagmint/detect/geometry.h"
#include "tagmint/detect/image.h"
#include "tagmint/detect/pose.h"

namespace tagmint::scene {

/// Where a tag is in space: its pose before the scene's camera and the side of its border square.
struct PosedTag {
  detect::Pose pose;  ///< tag frame to camera frame, metres; `error` is not used
  double edge_m = 0;  ///< side of the border square, > 0
};

/// In space, or by the corners of the border square in pixels (order of detect::Corners; sides are
/// straight then, whatever the camera).
using TagPlace = std::variant<PosedTag, detect::Corners>;

/// How a tag of a board is printed.
struct OnSheet {
  std::size_t sheet = 0;  ///< index of Scene::sheets; its white is the tag's
  codec::Layout layout;   ///< the family's, or that with a wider black border
};

/// One tag of a scene: what it is, and where.
struct SceneTag {
  codec::SharedFamily family;
  codec::TagId id = 0;
  TagPlace place;
  std::shared_ptr<const OnSheet> on_sheet{};  ///< of a tag that is no paper of its own

  const codec::Layout& layout() const { return on_sheet ? on_sheet->layout : family->layout(); }
};

/// A rectangle on a sheet, metres; x right, y down.
struct SheetBox {
  double left = 0;
  double top = 0;
  double width = 0;
  double height = 0;
};

/// White paper with tags on it and black boxes beside them: a board.
struct Sheet {
  detect::Pose pose;              ///< sheet frame (as a tag's) to camera frame, metres
  SheetBox paper;                 ///< about any place
  std::vector<SheetBox> black{};  ///< inside the paper, apart from each other
  std::size_t first_tag = 0;      ///< lies on tags before this one and below those from it on
};

/// One gray level everywhere.
struct PlainBackground {
  double gray = 128;  ///< 0..255
};

/// A gray level that changes evenly along one direction, from one end of the image to the other.
struct GradientBackground {
  double from = 80;      ///< 0..255
  double to = 180;       ///< 0..255
  double angle_deg = 0;  ///< direction of the change; 0 = to the right, 90 = downwards
};

/// A smooth random texture: four octaves of noise, each half as large and half as strong as the one
/// before.
struct TextureBackground {
  double gray = 128;      ///< middle level, 0..255
  double amplitude = 40;  ///< largest distance from the middle, gray levels, 0..255
  double scale_px = 48;   ///< size of the coarsest blobs, >= 1
};

/// Convex shapes of three to six corners and any gray level over one another, sizes spread evenly
/// over their logarithm: edges and corners everywhere, as on a full desk.
struct ClutterBackground {
  int shapes = 500;     ///< 0 .. kMaxShapes
  double min_px = 6;    ///< smallest longest diameter, above 0
  double max_px = 250;  ///< largest one, >= min_px
};
inline constexpr int kMaxShapes = 1'000'000;

/// A photograph behind the tags, scaled to cover the scene and cut evenly.
struct PhotoBackground {
  std::string path;     ///< as it is named in messages and scene files
  detect::Image image;  ///< not empty
};

using Background = std::variant<PlainBackground, GradientBackground, TextureBackground,
                                ClutterBackground, PhotoBackground>;

/// Light that falls off evenly: full at one end of the image, (1 - strength) of it at the other.
struct Shading {
  double strength = 0;   ///< 0 = even light, below 1
  double angle_deg = 0;  ///< direction in which it gets darker; 0 = to the right, 90 = downwards
};

/// A hard-edged shadow: the light inside a polygon, any number of corners >= 3 in either direction.
struct Shadow {
  std::vector<detect::Point> polygon{};  ///< px, inside the image or not
  double light = 0.5;                    ///< share of the light that is left, 0..1
};

/// A reflection of a lamp: light added in a round spot, falling off as a Gaussian.
struct Glare {
  detect::Point centre{};  ///< px
  double radius_px = 40;   ///< where exp(-1/2) of it is left, above 0
  double strength = 200;   ///< gray levels in the middle, >= 0; beyond white the picture is white
};

/// A camera that moves during the exposure, evenly along a line.
struct MotionBlur {
  double length_px = 0;  ///< 0 .. 1000
  double angle_deg = 0;  ///< 0 = along rows, 90 = along columns
};

/// What the light and the camera do to the picture, in this order: shading, shadows, glare,
/// vignetting, motion blur, defocus, blur, shot noise, gamma, noise, rounding, JPEG.
struct Effects {
  double black = 30;   ///< gray level of black cells in full light, 0..255
  double white = 220;  ///< of white cells, above `black`
  Shading shading{};
  std::vector<Shadow> shadows{};
  std::vector<Glare> glare{};
  double vignetting = 0;  ///< share of the light that is lost in the corners, below 1
  MotionBlur motion_blur{};
  double defocus_px = 0;           ///< radius of the disc that a point becomes, 0 .. 100
  double blur_sigma_px = 0;        ///< Gaussian blur, >= 0
  double electrons_per_level = 0;  ///< of the shot noise, 0 = none, else 0.001 .. 1e6
  double gamma = 1;  ///< of the camera, 0.1 .. 10; levels up to here are in light, 1 = the same
  double noise_sigma = 0;  ///< Gaussian noise, gray levels, >= 0
  int jpeg_quality = 0;    ///< the picture is what a JPEG of that quality keeps, 1 .. 100; 0 = all
};

/// A pen's stroke along a path, or a speck of dirt: a path of one point. Lies over all tags.
struct Mark {
  std::vector<detect::Point> path{};  ///< px, at least one point
  double width_px = 2;                ///< above 0
  double gray = 20;                   ///< in full light, 0..255
};

inline constexpr int kMaxSide_px = 1 << 14;  ///< of a scene; 2^28 pixels in all
inline constexpr int kMaxQuietZone_cells = 64;

/// A synthetic camera image, described. The same scene always gives the same picture.
struct Scene {
  int width = 640;        ///< px, 1 .. kMaxSide_px
  int height = 480;       ///< px, 1 .. kMaxSide_px
  detect::Camera camera;  ///< for tags placed in space; default_camera() where none is known
  Background background;
  int quiet_zone_cells = 1;     ///< width of the white paper around each tag, in cells,
                                ///< 0 .. kMaxQuietZone_cells
  std::vector<SceneTag> tags;   ///< later ones lie on top of earlier ones
  std::vector<Sheet> sheets{};  ///< in the order of their first_tag
  std::vector<Mark> marks{};    ///< on top of all tags
  Effects effects;
  std::uint64_t seed = 1;  ///< of the noise and the background texture
};

/// A camera without distortion that looks through the middle of the image, focal length = width
/// (53 degrees across).
detect::Camera default_camera(int width, int height);

/// Throws std::invalid_argument, naming the field, its value and the allowed range, when the scene
/// cannot be drawn: a size, level, sigma or camera out of range, an id that the family lacks, a
/// pose that is no rotation, a tag or sheet that faces away from the camera or lies behind it,
/// corners that are not a convex quad in counter-clockwise order as seen, or a tag where the
/// distortion folds back on itself.
void check_scene(const Scene& scene);

}  // namespace tagmint::scene
