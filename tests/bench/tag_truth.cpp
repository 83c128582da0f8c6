// How true the corners of detected tags are, with and without the photometric step, beside
// libapriltag on the same rendered scenes; whether their covariances are what the errors say; and
// what the step costs.
//
//   tag_truth [SCENES]      pictures of each kind; 6 by default

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <memory>
#include <string>
#include <vector>

#include "refine/refine_photometric.h"
#include "scene/random_scene.h"
#include "scene/render.h"
#include "tagmint/codec/builtin_families.h"
#include "tagmint/detect/detector.h"
#include "tagmint/detect/pose.h"

#ifdef TAGMINT_HAVE_APRILTAG
extern "C" {
#include <apriltag/apriltag.h>
#include <apriltag/tag36h11.h>
}
#endif

namespace tagmint {
namespace {

/// Scenes of one kind.
struct Kind {
  std::string name;
  scene::RandomSceneOptions options;
  double gamma = 1;  ///< exponent of the camera's tone curve, applied to light between 0 and 255
  std::string family = "tag36h11";
};

struct Picture {
  detect::Image image;
  scene::Scene scene;
  std::vector<scene::TagTruth> truth;
};

Picture draw(const Kind& kind, std::uint64_t seed) {
  scene::RandomSceneOptions options = kind.options;
  options.seed = seed;
  options.effects.gamma = kind.gamma;
  const std::vector<scene::TagChoice> choices = {{codec::find_family(kind.family), {}}};
  Picture picture;
  picture.scene = random_scene(choices, options);
  scene::Rendering rendering = render(picture.scene);
  picture.image = std::move(rendering.image);
  picture.truth = std::move(rendering.truth);
  return picture;
}

/// One tag found and its true place.
struct Found {
  detect::Corners corners;
  detect::Corners truth;
  std::optional<detect::CornerCovariance> covariance;
};

struct Tally {
  int tags = 0;
  std::vector<Found> found;
};

void judge(const Picture& picture, codec::TagId id, const detect::Corners& corners,
           const std::optional<detect::CornerCovariance>& covariance, Tally& tally) {
  for (std::size_t i = 0; i < picture.truth.size(); ++i) {
    if (picture.scene.tags[i].id != id) continue;
    const detect::Corners& truth = picture.truth[i].corners;
    const double side = std::sqrt(std::abs(signed_area(truth)));
    if (length(corners[0] - truth[0]) > side / 4) continue;
    tally.found.push_back({corners, truth, covariance});
    return;
  }
}

double quantile(std::vector<double> values, double q) {
  if (values.empty()) return 0;
  const auto at = std::min(values.size() - 1, static_cast<std::size_t>(q * values.size()));
  std::nth_element(values.begin(), values.begin() + static_cast<long>(at), values.end());
  return values[at];
}

double mean_square_normalised(const Found& f) {
  Eigen::Matrix<double, 8, 8> covariance;
  Eigen::Matrix<double, 8, 1> error;
  for (int i = 0; i < 8; ++i) {
    const detect::Point e = f.corners[i / 2] - f.truth[i / 2];
    error(i) = i % 2 == 0 ? e.x : e.y;
    for (int j = 0; j < 8; ++j) covariance(i, j) = (*f.covariance)[i * 8 + j];
  }
  return error.dot(covariance.ldlt().solve(error)) / 8;
}

void print_row(const std::string& kind, const std::string& who, const Tally& tally) {
  std::vector<double> errors;
  std::vector<double> normalised;
  double radial = 0;
  double log_side = 0;
  for (const Found& f : tally.found) {
    detect::Point middle{0, 0};
    for (const detect::Point p : f.truth) middle = middle + 0.25 * p;
    for (int k = 0; k < 4; ++k) {
      const detect::Point e = f.corners[k] - f.truth[k];
      errors.push_back(length(e));
      const detect::Point out = f.truth[k] - middle;
      radial += dot(e, out) / length(out);
    }
    log_side += 0.5 * std::log(signed_area(f.corners) / signed_area(f.truth));
    if (f.covariance) normalised.push_back(mean_square_normalised(f));
  }
  const auto n = static_cast<double>(std::max<std::size_t>(1, tally.found.size()));
  double mean_normalised = 0;
  for (const double v : normalised) mean_normalised += v / static_cast<double>(normalised.size());
  fmt::print(
      "| {} | {} | {:.1f} % | {:.4f} | {:.4f} | {:+.4f} | {:+.3f} % | {:.2f} / {:.2f} | {:.0f} % "
      "|\n",
      kind, who, 100.0 * static_cast<double>(tally.found.size()) / tally.tags,
      quantile(errors, 0.5), quantile(errors, 0.95), radial / (4 * n), 100 * log_side / n,
      mean_normalised, quantile(normalised, 0.5), 100 * static_cast<double>(normalised.size()) / n);
  std::fflush(stdout);
}

#ifdef TAGMINT_HAVE_APRILTAG
void detect_theirs(Picture& picture, Tally& tally) {
  apriltag_family_t* family = tag36h11_create();
  apriltag_detector_t* detector = apriltag_detector_create();
  apriltag_detector_add_family_bits(detector, family, 2);
  detector->quad_decimate = 1;
  image_u8_t view = {picture.image.width(), picture.image.height(), picture.image.width(),
                     picture.image.row(0)};
  zarray_t* detections = apriltag_detector_detect(detector, &view);
  for (int i = 0; i < zarray_size(detections); ++i) {
    apriltag_detection_t* d = nullptr;
    zarray_get(detections, i, &d);
    detect::Corners corners;
    for (int k = 0; k < 4; ++k) corners[k] = {d->p[k][0], d->p[k][1]};
    judge(picture, static_cast<codec::TagId>(d->id), corners, std::nullopt, tally);
  }
  apriltag_detections_destroy(detections);
  apriltag_detector_destroy(detector);
  tag36h11_destroy(family);
}
#endif

double cpu_microseconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e6 * static_cast<double>(now.tv_sec) + 1e-3 * static_cast<double>(now.tv_nsec);
}

/// Means over the tags of what the fits found.
void print_parameters(const Picture& picture, const std::vector<detect::Detection>& tags) {
  detect::PhotometricScratch scratch;
  double tone = 0, tails = 0, spread = 0, black = 0, contrast = 0, noise = 0, pixels = 0;
  int n = 0;
  for (const detect::Detection& tag : tags) {
    const auto fit =
        detect::refine_photometric(picture.image, *tag.family, tag.id, tag.corners, {}, scratch);
    if (!fit) continue;
    ++n;
    tone += fit->parameters.tone;
    tails += fit->parameters.tails;
    spread += std::exp(fit->parameters.log_spread);
    black += fit->parameters.black;
    contrast += fit->parameters.contrast;
    noise += fit->noise;
    pixels += static_cast<double>(scratch.pixels.size());
  }
  fmt::print(
      "  tone {:.4f}, tails {:.3f}, spread {:.4f} px, black {:.2f}, contrast {:.2f}, noise {:.3f}, "
      "pixels {:.0f}\n",
      tone / n, tails / n, spread / n, black / n, contrast / n, noise / n, pixels / n);
}

/// Microseconds of this thread a tag, the least of several rounds over the tags of a picture.
double microseconds_a_tag(const Picture& picture, const std::vector<detect::Detection>& tags) {
  detect::PhotometricScratch scratch;
  double best = 1e9;
  for (int round = 0; round < 20; ++round) {
    const double start = cpu_microseconds();
    for (const detect::Detection& tag : tags) {
      (void)detect::refine_photometric(picture.image, *tag.family, tag.id, tag.corners, {},
                                       scratch);
    }
    const double took = cpu_microseconds() - start;
    best = std::min(best, took / static_cast<double>(std::max<std::size_t>(1, tags.size())));
  }
  return best;
}

void measure(const Kind& kind, int scenes, bool peers) {
  const auto decoder = std::make_shared<const codec::Decoder>(codec::find_family(kind.family));
  detect::DetectorOptions plain;
  plain.refine_photometric = false;
  detect::Detector ours({decoder});
  detect::Detector edges({decoder}, plain);
  Tally with, without, theirs;
  double micros = 0;
  for (int i = 0; i < scenes; ++i) {
    Picture picture = draw(kind, static_cast<std::uint64_t>(i) + 1);
    for (Tally* tally : {&with, &without, &theirs}) {
      tally->tags += static_cast<int>(picture.scene.tags.size());
    }
    for (const auto& d : ours.detect(picture.image)) {
      judge(picture, d.id, d.corners, d.corner_covariance, with);
    }
    const auto unrefined = edges.detect(picture.image);
    for (const auto& d : unrefined) judge(picture, d.id, d.corners, {}, without);
    if (i == 0) print_parameters(picture, unrefined);
    micros += microseconds_a_tag(picture, unrefined) / scenes;
#ifdef TAGMINT_HAVE_APRILTAG
    if (peers && kind.family == "tag36h11") detect_theirs(picture, theirs);
#endif
  }
  print_row(kind.name, fmt::format("photometric, {:.1f} us/tag", micros), with);
  print_row(kind.name, "edges", without);
  if (!theirs.found.empty()) print_row(kind.name, "libapriltag", theirs);
}

std::vector<Kind> kinds() {
  const auto options = [](double least, double most, double tilt, double blur, double noise) {
    scene::RandomSceneOptions o;
    o.width = 1280;
    o.height = 960;
    o.count = 54;
    o.min_side_px = least;
    o.max_side_px = most;
    o.max_tilt_deg = tilt;
    o.effects.black = 30;
    o.effects.white = 220;
    o.effects.blur_sigma_px = blur;
    o.effects.noise_sigma = noise;
    return o;
  };
  std::vector<Kind> kinds;
  kinds.push_back({"crowded", options(12, 100, 60, 0.7, 5)});
  kinds.back().options.effects.shading = {.strength = 0.4, .angle_deg = 30};
  kinds.push_back(kinds.back());
  kinds.back().name = "crowded, gamma 2.2";
  kinds.back().gamma = 2.2;
  kinds.push_back({"10-12 px", options(10, 12, 0.1, 0.5, 2)});
  kinds.push_back({"10-12 px, gamma 2.2", options(10, 12, 0.1, 0.5, 2), 2.2});
  kinds.push_back({"12-20 px", options(12, 20, 10, 0.5, 2)});
  kinds.push_back({"20-40 px", options(20, 40, 10, 0.5, 2)});
  kinds.push_back({"20-40 px, gamma 2.2", options(20, 40, 10, 0.5, 2), 2.2});
  kinds.push_back({"20-40 px, no noise, blur 0.7", options(20, 40, 10, 0.7, 0)});
  kinds.push_back({"tilt 60-75", options(40, 100, 75, 0.7, 2)});
  kinds.push_back({"noise 0, blur 0.5", options(15, 80, 40, 0.5, 0)});
  kinds.push_back({"noise 1, no blur", options(15, 80, 40, 0, 1)});
  kinds.push_back({"noise 2, blur 1.5", options(30, 100, 40, 1.5, 2)});
  kinds.push_back({"noise 2, blur 2", options(40, 100, 40, 2, 2)});
  kinds.push_back({"noise 15", options(20, 100, 40, 0.7, 15)});
  kinds.push_back({"standard41h12", options(15, 80, 40, 0.7, 3), 1, "tagStandard41h12"});
  kinds.push_back({"circle49h12", options(15, 80, 40, 0.7, 3), 1, "tagCircle49h12"});
  kinds.push_back({"custom48h12", options(15, 80, 40, 0.7, 3), 1, "tagCustom48h12"});
  kinds.push_back({"16h5", options(15, 80, 40, 0.7, 3), 1, "tag16h5"});
  return kinds;
}

}  // namespace
}  // namespace tagmint

int main(int count, char** words) {
  const int scenes = count > 1 ? std::atoi(words[1]) : 6;
  const std::string only = count > 2 ? words[2] : "";
  fmt::print(
      "| scenes | corners from | found | median px | 95 % px | radial px | side | normalised error "
      "squared: mean / median | refined |\n"
      "|---|---|---|---|---|---|---|---|---|\n");
  for (const tagmint::Kind& kind : tagmint::kinds()) {
    if (kind.name.find(only) != std::string::npos) tagmint::measure(kind, scenes, true);
  }
}
