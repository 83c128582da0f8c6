#pragma once

#include <string>

namespace tagmint::test {

/// What a headless Chromium made of a page.
struct LoadedPage {
  std::string dom;  ///< after its scripts ran, as HTML
  /// Lines of the console: what its scripts wrote, their errors, and what it asked for although its
  /// own policy forbids it.
  std::string console;
};

/// Opens the file `page` with a profile of its own and waits for it to be loaded.
///   fragment   "" or "#..."
LoadedPage load_page(const std::string& page, const std::string& fragment = "");

/// Writes a picture of the page as a window of that many pixels shows it.
///   dark       as a user who prefers dark pages sees it
void picture_page(const std::string& page, const std::string& fragment, int width, int height,
                  bool dark, const std::string& png);

}  // namespace tagmint::test
