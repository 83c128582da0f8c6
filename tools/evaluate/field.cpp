#include "evaluate/field.h"

#include <utility>

#include "evaluate/experiment.h"
#include "scene/render.h"

namespace tagmint::evaluate {

Field::Field(const Settings& settings, const codec::SharedFamily& family,
             const std::vector<double>& decimations) {
  std::vector<std::unique_ptr<Contender>> first;
  for (const double decimate : decimations) {
    for (const ContenderKind& kind : settings.contenders) {
      const Task task{
          .family = family, .decimate = decimate, .max_hamming = usual_max_hamming(*family)};
      std::unique_ptr<Contender> detector = kind.make(task);
      if (detector == nullptr) continue;
      entrants_.push_back({kind.name, decimate});
      makers_.emplace_back([make = kind.make, task] { return make(task); });
      first.push_back(std::move(detector));
    }
  }
  detectors_.resize(static_cast<std::size_t>(settings.threads));
  detectors_[0] = std::move(first);
}

Contender& Field::detector(std::size_t entrant, int thread) {
  auto& own = detectors_.at(static_cast<std::size_t>(thread));
  own.resize(entrants_.size());
  if (own[entrant] == nullptr) own[entrant] = makers_[entrant]();
  return *own[entrant];
}

std::vector<FoundTag> Field::see(std::size_t entrant, int thread, detect::ImageView image) {
  Contender& contender = detector(entrant, thread);
  contender.detect(image);
  return contender.found();
}

std::vector<std::vector<View>> Field::views(int pictures, const SceneOf& scene_of, const Work& work,
                                            const Finish& finish) {
  std::vector<std::vector<View>> views(static_cast<std::size_t>(pictures));  // by picture, entrant
  work.for_each(pictures, [&](int picture, int thread) {
    const scene::Scene scene = scene_of(picture);
    scene::Rendering rendering = scene::render(scene, 1);
    if (finish) rendering.image = finish(std::move(rendering.image));
    std::vector<View>& own = views[static_cast<std::size_t>(picture)];
    for (std::size_t i = 0; i < entrants_.size(); ++i) {
      own.push_back(judge(see(i, thread, rendering.image.view()), scene, rendering.truth));
      own.back().candidates = detector(i, thread).candidates();
    }
  });
  return views;
}

std::vector<Tally> Field::show(int pictures, const SceneOf& scene_of, const Work& work,
                               const Finish& finish) {
  std::vector<Tally> tallies(entrants_.size());
  for (const std::vector<View>& of_picture : views(pictures, scene_of, work, finish)) {
    for (std::size_t i = 0; i < entrants_.size(); ++i) tallies[i].add(of_picture[i]);
  }
  return tallies;
}

}  // namespace tagmint::evaluate
