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

/// The first page of a PDF, PostScript or EPS file, drawn by Ghostscript with smooth edges.
detect::Image ghostscript_picture(const std::string& document, double dpi);

/// The PDF that headless Chromium prints of an SVG.
///   program   its path
std::string chromium_pdf(const std::string& svg, const std::string& program);

}  // namespace tagmint::test
