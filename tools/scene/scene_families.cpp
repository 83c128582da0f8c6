#include "scene/scene_families.h"

#include <memory>
#include <system_error>

#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/family_file.h"

namespace tagmint::scene {

codec::SharedFamily SceneFamilies::get(const std::string& name) {
  codec::SharedFamily& family = loaded_[name];
  if (family) return family;
  family = codec::find_family(name);
  const std::filesystem::path file = folder_ / name;
  std::error_code error;
  if (!family && std::filesystem::exists(file, error)) {
    family = std::make_shared<const codec::Family>(codec::read_family(file));
  }
  // Neither: load_family() knows how to say so.
  if (!family) family = codec::load_family(name);
  return family;
}

}  // namespace tagmint::scene
