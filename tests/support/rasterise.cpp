#include "support/rasterise.h"

#include <fmt/format.h>

#include <array>
#include <cstdio>
#include <stdexcept>

#include "io/images.h"
#include "support/scratch_folder.h"

namespace tagmint::test {

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
  const ScratchFolder folder;
  const std::string path = folder.write("sheet.pdf", pdf);
  output_of(fmt::format("pdftoppm -gray -r {} '{}' '{}' 2>&1", dpi, path, folder.file("page")));
  std::vector<detect::Image> pages;
  for (const std::string& name : folder.names()) {
    if (name.ends_with(".pgm")) pages.push_back(io::read_gray_image(folder.file(name)));
  }
  return pages;
}

detect::Image svg_picture(const std::string& svg, double dpi) {
  const ScratchFolder folder;
  const std::string path = folder.write("sheet.svg", svg);
  const std::string png = folder.file("sheet.png");
  output_of(fmt::format("rsvg-convert -d {0} -p {0} -b white -o '{1}' '{2}' 2>&1", dpi, png, path));
  return io::read_gray_image(png);
}

detect::Image ghostscript_picture(const std::string& document, double dpi) {
  const ScratchFolder folder;
  const std::string path = folder.write("sheet", document);
  const std::string picture = folder.file("page.pgm");
  output_of(
      fmt::format("gs -q -dSAFER -dNOPAUSE -dBATCH -dEPSCrop -dFirstPage=1 -dLastPage=1 "
                  "-dTextAlphaBits=4 -dGraphicsAlphaBits=4 -sDEVICE=pgmraw -r{} "
                  "-sOutputFile='{}' '{}' 2>&1",
                  dpi, picture, path));
  return io::read_gray_image(picture);
}

std::string chromium_pdf(const std::string& svg, const std::string& program) {
  const ScratchFolder folder;
  const std::string path = folder.write("sheet.svg", svg);
  const std::string pdf = folder.file("sheet.pdf");
  output_of(
      fmt::format("timeout 60 '{}' --headless --no-sandbox --disable-gpu "
                  "--user-data-dir='{}' --no-pdf-header-footer --print-to-pdf='{}' "
                  "'file://{}' 2>&1",
                  program, folder.file("profile"), pdf, path));
  return read_file(pdf);
}

}  // namespace tagmint::test
