#include "evaluate/photographs.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <regex>
#include <set>

#include "io/images.h"
#include "tagmint/codec/errors.h"

namespace tagmint::evaluate {
namespace {

namespace fs = std::filesystem;

constexpr int kLeastSide_px = 500;

bool is_picture(const fs::path& path) {
  static const std::set<std::string> kKinds = {".png",  ".jpg", ".jpeg", ".tif",
                                               ".tiff", ".pgm", ".ppm"};
  return kKinds.contains(path.extension().string());
}

}  // namespace

std::vector<std::string> find_photographs(const std::vector<std::string>& folders) {
  static const std::regex size_name("(\\d+)x(\\d+)\\.\\w+");
  std::set<std::string> files;
  std::map<std::string, std::pair<long, std::string>> largest;  // by folder
  for (const std::string& folder : folders) {
    if (fs::is_regular_file(folder)) {
      files.insert(folder);
      continue;
    }
    std::error_code error;
    for (fs::recursive_directory_iterator at(folder, error), end; !error && at != end;
         at.increment(error)) {
      if (at->is_symlink() || !at->is_regular_file() || !is_picture(at->path())) continue;
      const std::string name = at->path().filename().string();
      std::smatch sizes;
      if (!std::regex_match(name, sizes, size_name)) {
        files.insert(at->path().string());
        continue;
      }
      auto& best = largest[at->path().parent_path().string()];
      best = std::max(best, {std::stol(sizes[1]) * std::stol(sizes[2]), at->path().string()});
    }
    if (error) {
      throw codec::InputError("the folder cannot be read: " + error.message(), folder,
                              "name a folder of pictures");
    }
  }
  for (const auto& [folder, best] : largest) files.insert(best.second);
  return {files.begin(), files.end()};
}

detect::Image halved(const detect::Image& image) {
  detect::Image half(image.width() / 2, image.height() / 2);
  for (int y = 0; y < half.height(); ++y) {
    for (int x = 0; x < half.width(); ++x) {
      const int sum = image.at(2 * x, 2 * y) + image.at(2 * x + 1, 2 * y) +
                      image.at(2 * x, 2 * y + 1) + image.at(2 * x + 1, 2 * y + 1);
      half.at(x, y) = static_cast<std::uint8_t>((sum + 2) / 4);
    }
  }
  return half;
}

void for_each_size(const std::string& path, const std::function<void(const detect::Image&)>& show) {
  detect::Image image = io::read_gray_image(path);
  while (true) {
    show(image);
    if (std::min(image.width(), image.height()) < 2 * kLeastSide_px) return;
    image = halved(image);
  }
}

}  // namespace tagmint::evaluate
