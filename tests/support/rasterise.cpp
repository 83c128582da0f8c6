#include "support/rasterise.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <stdexcept>

#include "io/images.h"

namespace tagmint::test {

namespace fs = std::filesystem;

ScratchFolder::ScratchFolder(const std::string& name)
    : path_(fs::temp_directory_path() / fmt::format("tagmint_{}_{}", name, getpid())) {
  fs::create_directories(path_);
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

std::string ScratchFolder::write(const std::string& name, std::string_view content) const {
  std::ofstream(file(name), std::ios::binary) << content;
  return file(name);
}

std::vector<std::string> ScratchFolder::files(const std::string& ending) const {
  std::vector<std::string> found;
  for (const auto& entry : fs::directory_iterator(path_)) {
    if (entry.path().string().ends_with(ending)) found.push_back(entry.path().string());
  }
  std::sort(found.begin(), found.end());
  return found;
}

std::string output_of(const std::string& command) {
  std::FILE* const pipe = popen(command.c_str(), "r");
  if (!pipe) throw std::runtime_error("cannot run " + command);
  std::string out;
  std::array<char, 4096> block;
  while (const std::size_t count = std::fread(block.data(), 1, block.size(), pipe)) {
    out.append(block.data(), count);
  }
  if (pclose(pipe) != 0) throw std::runtime_error(command + " failed: " + out);
  return out;
}

std::vector<detect::Image> pdf_pages(const std::string& pdf, double dpi) {
  const ScratchFolder folder("pdf");
  const std::string path = folder.write("sheet.pdf", pdf);
  output_of(fmt::format("pdftoppm -gray -r {} '{}' '{}' 2>&1", dpi, path, folder.file("page")));
  std::vector<detect::Image> pages;
  for (const std::string& page : folder.files(".pgm")) pages.push_back(io::read_gray_image(page));
  return pages;
}

detect::Image svg_picture(const std::string& svg, double dpi) {
  const ScratchFolder folder("svg");
  const std::string path = folder.write("sheet.svg", svg);
  const std::string png = folder.file("sheet.png");
  output_of(fmt::format("rsvg-convert -d {0} -p {0} -b white -o '{1}' '{2}' 2>&1", dpi, png, path));
  return io::read_gray_image(png);
}

}  // namespace tagmint::test
