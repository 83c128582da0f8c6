#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "tagmint/codec/family.h"

namespace tagmint::scene {

/// The families that a scene file names; reads each once, however many tags name it.
class SceneFamilies {
 public:
  ///   folder   where the paths of family files start
  explicit SceneFamilies(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// A bundled family or a family file. Throws InputError where there is neither.
  codec::SharedFamily get(const std::string& name);

 private:
  std::filesystem::path folder_;
  std::map<std::string, codec::SharedFamily> loaded_;
};

}  // namespace tagmint::scene
