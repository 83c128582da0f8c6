#include "tagmint/codec/builtin_families.h"

#include <fmt/format.h>

#include <filesystem>
#include <mutex>
#include <system_error>
#include <vector>

#include "embedded_families.h"
#include "tagmint/codec/errors.h"
#include "tagmint/codec/family_file.h"
#include "tagmint/codec/suggest.h"

namespace tagmint::codec {
namespace {

/// A bundled family that is parsed when it is first asked for.
class LazyFamily {
 public:
  explicit LazyFamily(const EmbeddedFamily& embedded) : embedded_(embedded) {}

  std::string_view name() const { return embedded_.name; }
  SharedFamily get() {
    std::call_once(parsed_, [this] {
      family_ = std::make_shared<const Family>(
          parse_family(embedded_.json, fmt::format("bundled {}.json", embedded_.name)));
    });
    return family_;
  }

 private:
  EmbeddedFamily embedded_;
  std::once_flag parsed_;
  SharedFamily family_;
};

/// A cache, not state: what it gives never changes.
std::vector<std::unique_ptr<LazyFamily>>& lazy_families() {
  static std::vector<std::unique_ptr<LazyFamily>> all = [] {
    std::vector<std::unique_ptr<LazyFamily>> families;
    for (const EmbeddedFamily& embedded : embedded_families()) {
      families.push_back(std::make_unique<LazyFamily>(embedded));
    }
    return families;
  }();
  return all;
}

}  // namespace

std::span<const std::string> family_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const EmbeddedFamily& embedded : embedded_families()) all.emplace_back(embedded.name);
    return all;
  }();
  return names;
}

SharedFamily find_family(std::string_view name) {
  for (const auto& family : lazy_families()) {
    if (family->name() == name) return family->get();
  }
  return nullptr;
}

SharedFamily load_family(const std::string& name_or_path) {
  if (SharedFamily family = find_family(name_or_path)) return family;
  std::error_code unknown;
  if (std::filesystem::exists(name_or_path, unknown)) {
    return std::make_shared<const Family>(read_family(name_or_path));
  }
  std::string hint = did_you_mean(name_or_path, family_names());
  if (!hint.empty()) hint += ' ';
  throw InputError(fmt::format("no family '{}' is bundled and no file has that name", name_or_path),
                   {}, hint + "`tagmint families` lists the bundled ones");
}

}  // namespace tagmint::codec
