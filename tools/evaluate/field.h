#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "evaluate/contender.h"
#include "evaluate/sighting.h"
#include "evaluate/work.h"
#include "scene/scene.h"
#include "tagmint/detect/image.h"

namespace tagmint::evaluate {

struct Settings;

/// Those who take part in an experiment: contenders under one or several decimations, with a
/// detector for each thread, made when it is first needed and kept.
class Field {
 public:
  /// One of them.
  struct Entrant {
    std::string contender;
    double decimate = 1;
  };

  /// Those of the contenders that can do the task; the others are left out.
  ///   decimations   each contender enters under each of them
  Field(const Settings& settings, const codec::SharedFamily& family,
        const std::vector<double>& decimations);

  const std::vector<Entrant>& entrants() const { return entrants_; }

  /// What an entrant sees; its detector for that thread is used.
  std::vector<FoundTag> see(std::size_t entrant, int thread, detect::ImageView image);
  /// The detector itself.
  Contender& detector(std::size_t entrant, int thread);

  using SceneOf = std::function<scene::Scene(int picture)>;
  using Finish = std::function<detect::Image(detect::Image)>;
  /// Draws `pictures` scenes and shows each to all entrants, on the threads of the work.
  ///   scene_of   the scene of a number, always the same; called from several threads
  ///   finish     what is done to the drawn picture before it is shown; nothing = nothing
  ///   returns    what each entrant saw, by picture and entrant
  std::vector<std::vector<View>> views(int pictures, const SceneOf& scene_of, const Work& work,
                                       const Finish& finish = {});
  /// The same as a tally for each entrant.
  std::vector<Tally> show(int pictures, const SceneOf& scene_of, const Work& work,
                          const Finish& finish = {});

 private:
  std::vector<Entrant> entrants_;
  std::vector<std::function<std::unique_ptr<Contender>()>> makers_;
  std::vector<std::vector<std::unique_ptr<Contender>>> detectors_;  // by thread, then entrant
};

}  // namespace tagmint::evaluate
