#pragma once

#include <string_view>

/// Files of this folder, compiled in (cmake/embed_text.cmake).
namespace tagmint::cli {

extern const std::string_view page_style;      ///< page.css
extern const std::string_view gallery_script;  ///< gallery.js

}  // namespace tagmint::cli
