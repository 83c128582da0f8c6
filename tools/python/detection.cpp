#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <variant>

#include "python/bindings.h"
#include "tagmint/codec/decoder.h"
#include "tagmint/detect/detector.h"
#include "tagmint/detect/pixel_view.h"
#include "tagmint/detect/pose.h"

namespace tagmint::python {
namespace {

using FamilyPointer = std::shared_ptr<codec::Family>;
using DecoderPointer = std::shared_ptr<codec::Decoder>;
using Corners = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// The pixels of an array of height x width, or height x width x 3 (RGB), as they lie in memory.
detect::PixelView pixels_of(const py::array& image) {
  const bool colour = image.ndim() == 3 && image.shape(2) == 3;
  if (!image.dtype().is(py::dtype::of<std::uint8_t>()) || (image.ndim() != 2 && !colour)) {
    throw std::invalid_argument(
        "an image is an array of uint8, height x width or height x width x 3 (red, green, blue)");
  }
  if (image.shape(0) > detect::Detector::kMaxSide_px ||
      image.shape(1) > detect::Detector::kMaxSide_px) {
    throw std::invalid_argument("an image has at most 32768 rows and columns");
  }
  detect::PixelView view;
  view.data = static_cast<const std::uint8_t*>(image.data());
  view.width = static_cast<int>(image.shape(1));
  view.height = static_cast<int>(image.shape(0));
  view.stride = image.strides(0);
  view.step = image.strides(1);
  if (colour) {
    view.green = image.strides(2);
    view.blue = 2 * image.strides(2);
  }
  return view;
}

/// A detector that refuses a second caller at a time: calls run without the interpreter's lock.
class Detector {
 public:
  Detector(const std::vector<std::variant<FamilyPointer, DecoderPointer>>& sought,
           const detect::DetectorOptions& options)
      : detector_(decoders_of(sought), options) {}

  std::vector<detect::Detection> detect(const py::array& image) {
    const detect::PixelView pixels = pixels_of(image);
    const py::gil_scoped_release released;
    const std::unique_lock lock(busy_, std::try_to_lock);
    if (!lock) throw std::runtime_error("another thread is using this detector; make one a thread");
    return detector_.detect(detect::gray_view(pixels, gray_));
  }

 private:
  static std::vector<std::shared_ptr<const codec::Decoder>> decoders_of(
      const std::vector<std::variant<FamilyPointer, DecoderPointer>>& sought) {
    std::vector<std::shared_ptr<const codec::Decoder>> decoders;
    for (const auto& one : sought) {
      if (const auto* decoder = std::get_if<DecoderPointer>(&one)) {
        decoders.push_back(*decoder);
      } else {
        decoders.push_back(std::make_shared<const codec::Decoder>(std::get<FamilyPointer>(one)));
      }
    }
    return decoders;
  }

  detect::Detector detector_;
  detect::Image gray_;
  std::mutex busy_;
};

std::unique_ptr<Detector> make_detector(
    const std::vector<std::variant<FamilyPointer, DecoderPointer>>& sought, double decimate,
    double blur_sigma_px, int threads, bool report_inverted, bool report_mirrored) {
  detect::DetectorOptions options;
  options.decimate = decimate;
  options.blur_sigma_px = blur_sigma_px;
  options.threads = threads;
  options.report_inverted = report_inverted;
  options.report_mirrored = report_mirrored;
  return std::make_unique<Detector>(sought, options);
}

std::optional<detect::PoseEstimate> pose_of_corners(const Corners& corners,
                                                    const detect::Camera& camera, double edge_m) {
  if (corners.ndim() != 2 || corners.shape(0) != 4 || corners.shape(1) != 2) {
    throw std::invalid_argument("corners are an array of 4 x 2 numbers");
  }
  detect::Corners points;
  for (int i = 0; i < 4; ++i) points[i] = {corners.at(i, 0), corners.at(i, 1)};
  return detect::estimate_pose(points, camera, edge_m);
}

std::optional<detect::PoseEstimate> pose_of_tag(const detect::Detection& tag,
                                                const detect::Camera& camera, double edge_m) {
  return detect::estimate_pose(tag.corners, camera, edge_m, tag.corner_covariance);
}

void add_detections(py::module_& module) {
  using detect::Detection;
  static_assert(sizeof(detect::Point) == 2 * sizeof(double));
  py::class_<Detection>(module, "Detection")
      .def_property_readonly("family", [](const Detection& d) { return d.family->name(); })
      .def_readonly("id", &Detection::id)
      .def_readonly("hamming", &Detection::hamming)
      .def_readonly("decision_margin", &Detection::decision_margin)
      .def_readonly("inverted", &Detection::inverted)
      .def_readonly("mirrored", &Detection::mirrored)
      .def_property_readonly(
          "center",
          [](py::object d) { return view_of(&d.cast<const Detection&>().center.x, {2}, d); })
      .def_property_readonly("corners",
                             [](py::object d) {
                               return view_of(&d.cast<const Detection&>().corners[0].x, {4, 2}, d);
                             })
      .def_property_readonly(
          "homography",
          [](py::object d) {
            return view_of(d.cast<const Detection&>().homography.row_major().data(), {3, 3}, d);
          })
      .def_property_readonly("corner_covariance", [](py::object d) -> py::object {
        const auto& covariance = d.cast<const Detection&>().corner_covariance;
        if (!covariance) return py::none();
        return view_of(covariance->data(), {8, 8}, d);
      });
  py::class_<Detector>(module, "Detector")
      .def(py::init(&make_detector), py::arg("families"), py::kw_only(), py::arg("decimate") = 1.0,
           py::arg("blur_sigma_px") = 0.0, py::arg("threads") = 1,
           py::arg("report_inverted") = false, py::arg("report_mirrored") = false)
      .def("detect", &Detector::detect, py::arg("image"));
}

}  // namespace

void add_detection(py::module_& module) {
  add_detections(module);
  using detect::Camera, detect::Pose, detect::PoseEstimate;
  py::class_<Camera>(module, "Camera")
      .def(py::init([](double fx, double fy, double cx, double cy, double k1, double k2, double p1,
                       double p2, double k3) {
             Camera camera{fx, fy, cx, cy, k1, k2, p1, p2, k3};
             detect::check_camera(camera);
             return camera;
           }),
           py::arg("fx"), py::arg("fy"), py::arg("cx"), py::arg("cy"), py::kw_only(),
           py::arg("k1") = 0.0, py::arg("k2") = 0.0, py::arg("p1") = 0.0, py::arg("p2") = 0.0,
           py::arg("k3") = 0.0)
      .def_readonly("fx", &Camera::fx)
      .def_readonly("fy", &Camera::fy)
      .def_readonly("cx", &Camera::cx)
      .def_readonly("cy", &Camera::cy);
  py::class_<Pose>(module, "Pose")
      .def_property_readonly("R",
                             [](py::object p) {
                               return view_of(p.cast<const Pose&>().R.data(), {3, 3}, p);
                             })
      .def_property_readonly(
          "t", [](py::object p) { return view_of(p.cast<const Pose&>().t.data(), {3}, p); })
      .def_readonly("error", &Pose::error);
  py::class_<PoseEstimate>(module, "PoseEstimate")
      .def_readonly("best", &PoseEstimate::best)
      .def_readonly("alternative", &PoseEstimate::alternative)
      .def_readonly("alternative_probability", &PoseEstimate::alternative_probability)
      .def_property_readonly("ambiguous", &PoseEstimate::ambiguous);
  module.def("estimate_pose", &pose_of_tag, py::arg("tag"), py::arg("camera"), py::arg("edge_m"));
  module.def("estimate_pose", &pose_of_corners, py::arg("tag"), py::arg("camera"),
             py::arg("edge_m"));
}

}  // namespace tagmint::python
