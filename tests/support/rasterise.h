#pragma once

#include <string>
#include <vector>

#include "tagmint/detect/image.h"

namespace tagmint::test {

/// Runs a shell command line; its stdout. Throws std::runtime_error when it fails.
std::string output_of(const std::string& command);

/// All pages of a PDF, drawn by pdftoppm (Poppler).
std::vector<detect::Image> pdf_pages(const std::string& pdf, double dpi);

/// An SVG, drawn by rsvg-convert (librsvg) on white.
detect::Image svg_picture(const std::string& svg, double dpi);

}  // namespace tagmint::test
