#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "tagmint/detect/image.h"

namespace tagmint::test {

/// A folder for a test's files, removed with all its content at the end.
class ScratchFolder {
 public:
  explicit ScratchFolder(const std::string& name);
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  std::string file(const std::string& name) const { return (path_ / name).string(); }
  /// Writes a file here; returns its path.
  std::string write(const std::string& name, std::string_view content) const;
  /// Names of the files here that end so, sorted.
  std::vector<std::string> files(const std::string& ending) const;

 private:
  std::filesystem::path path_;
};

/// Runs a shell command line; its stdout. Throws std::runtime_error when it fails.
std::string output_of(const std::string& command);

/// All pages of a PDF, drawn by pdftoppm (Poppler).
std::vector<detect::Image> pdf_pages(const std::string& pdf, double dpi);

/// An SVG, drawn by rsvg-convert (librsvg) on white.
detect::Image svg_picture(const std::string& svg, double dpi);

}  // namespace tagmint::test
