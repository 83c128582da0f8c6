#include "draw/debug_writer.h"

#include <cmath>
#include <vector>

#include "draw/colour.h"
#include "draw/overlay.h"
#include "draw/picture_canvas.h"
#include "io/images.h"
#include "tagmint/codec/errors.h"

namespace tagmint::draw {
namespace {

using detect::Corners;
using detect::ImageView;
using detect::Point;

constexpr double kDimmed = 0.5;

void paint(std::uint8_t* pixel, const Colour& colour) {
  pixel[0] = static_cast<std::uint8_t>(std::lround(255 * colour.red));
  pixel[1] = static_cast<std::uint8_t>(std::lround(255 * colour.green));
  pixel[2] = static_cast<std::uint8_t>(std::lround(255 * colour.blue));
}

}  // namespace

DebugWriter::DebugWriter(std::filesystem::path folder, ImageView image)
    : folder_(std::move(folder)), image_(image) {
  std::error_code error;
  std::filesystem::create_directories(folder_, error);
  if (error || !std::filesystem::is_directory(folder_, error)) {
    throw codec::OutputError(
        "the debug folder cannot be made" + (error ? ": " + error.message() : std::string()),
        folder_.string(), "choose another place");
  }
}

void DebugWriter::preprocessed(ImageView working) {
  working_.resize(working.width, working.height);
  for (int y = 0; y < working.height; ++y) {
    std::copy(working.row(y), working.row(y) + working.width, working_.row(y));
  }
  if (!working.empty()) io::write_png(folder_ / "1-preprocessed.png", working_.view());
}

void DebugWriter::threshold(ImageView three_valued) {
  if (!three_valued.empty()) io::write_png(folder_ / "2-threshold.png", three_valued);
}

void DebugWriter::components(std::span<const std::uint32_t> labels, int width, int height) {
  if (labels.empty()) return;
  io::RgbImage picture(width, height);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const bool known = labels[i] != kNoComponent;
    paint(picture.rgb.data() + 3 * i, known ? distinct_colour(labels[i]) : Colour{});
  }
  io::write_png(folder_ / "3-components.png", picture);
}

void DebugWriter::clusters(std::span<const Point> points,
                           std::span<const std::size_t> cluster_begin) {
  constexpr int kScale = 2;  // boundary points lie on a lattice of half pixels
  io::RgbImage picture(kScale * working_.width(), kScale * working_.height());
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const double level = kDimmed * working_.at(x / kScale, y / kScale) / 255;
      paint(picture.pixel(x, y), {level, level, level});
    }
  }
  for (std::size_t cluster = 0; cluster + 1 < cluster_begin.size(); ++cluster) {
    const Colour colour = distinct_colour(cluster);
    for (std::size_t i = cluster_begin[cluster]; i < cluster_begin[cluster + 1]; ++i) {
      const int x = static_cast<int>(kScale * points[i].x);
      const int y = static_cast<int>(kScale * points[i].y);
      if (x >= 0 && y >= 0 && x < picture.width && y < picture.height) {
        paint(picture.pixel(x, y), colour);
      }
    }
  }
  if (!picture.rgb.empty()) io::write_png(folder_ / "4-clusters.png", picture);
}

void DebugWriter::quads(std::span<const Corners> quads) { write_quads("5-quads.png", quads); }

void DebugWriter::refined_quads(std::span<const Corners> quads) {
  write_quads("6-refined-quads.png", quads);
}

void DebugWriter::write_quads(std::string_view file, std::span<const Corners> quads) const {
  if (image_.empty()) return;
  PictureCanvas canvas(image_, kDimmed);
  for (std::size_t i = 0; i < quads.size(); ++i) {
    canvas.set_colour(distinct_colour(i));
    canvas.outline(quads[i], 1.0);
  }
  io::write_png(folder_ / file, canvas.picture());
}

void DebugWriter::detections(std::span<const detect::Detection> detections) {
  if (image_.empty()) return;
  std::vector<io::FoundTag> tags;
  for (const detect::Detection& detection : detections) tags.push_back({detection, {}});
  io::write_png(folder_ / "7-detections.png", draw_overlay(image_, tags));
}

}  // namespace tagmint::draw
