#include "tagmint/codec/layout_presets.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <vector>

#include "tagmint/codec/codeword.h"
#include "tagmint/codec/suggest.h"

namespace tagmint::codec {
namespace {

/// Rings are counted from the outer edge: ring 0 holds the outermost cells.
int ring_of(int x, int y, int width) { return std::min({x, y, width - 1 - x, width - 1 - y}); }

/// A layout whose cells are given by a function of (x, y).
template <typename CellAt>
Layout draw(int width, CellAt cell_at) {
  std::string rows;
  for (int y = 0; y < width; ++y) {
    for (int x = 0; x < width; ++x) rows += static_cast<char>(cell_at(x, y));
  }
  return Layout(rows);
}

struct Preset {
  std::string name;
  std::string family_prefix;
  int least_width;
  Layout (*make)(int);
};

const std::array<Preset, 3>& presets() {
  static const std::array<Preset, 3> all = {{{"classic", "", 5, classic_layout},
                                             {"standard", "Standard", 7, standard_layout},
                                             {"circle", "Circle", 7, circle_layout}}};
  return all;
}

void require_width(std::string_view name, int width, int least) {
  if (width < least || width > kMaxBits) {
    throw std::invalid_argument(fmt::format("layout {}:{} cannot be; its width is {} to {} cells",
                                            name, width, least, kMaxBits));
  }
}

/// The preset that draws exactly this layout.
const Preset* find_preset(const Layout& layout) {
  for (const Preset& preset : presets()) {
    if (layout.width() < preset.least_width) continue;
    try {
      if (preset.make(layout.width()) == layout) return &preset;
    } catch (const std::invalid_argument&) {  // a preset of this width has more than 64 data cells
    }
  }
  return nullptr;
}

}  // namespace

Layout classic_layout(int width) {
  require_width("classic", width, 5);
  return draw(width, [width](int x, int y) {
    const int ring = ring_of(x, y, width);
    return ring == 0 ? Cell::White : ring == 1 ? Cell::Black : Cell::Data;
  });
}

Layout standard_layout(int width) {
  require_width("standard", width, 7);
  return draw(width, [width](int x, int y) {
    const int ring = ring_of(x, y, width);
    return ring == 1 ? Cell::Black : ring == 2 ? Cell::White : Cell::Data;
  });
}

Layout circle_layout(int width) {
  require_width("circle", width, 7);
  const double cutoff = width / 2.0 - 0.25;
  const int border_ring = static_cast<int>(std::ceil(width / 2.0 - cutoff * std::sqrt(0.5) - 0.5));
  return draw(width, [=](int x, int y) {
    const int ring = ring_of(x, y, width);
    if (ring == border_ring) return Cell::Black;
    if (ring == border_ring + 1) return Cell::White;
    const double dx = x + 0.5 - width / 2.0;
    const double dy = y + 0.5 - width / 2.0;
    return std::hypot(dx, dy) <= cutoff ? Cell::Data : Cell::None;
  });
}

Layout parse_layout(std::string_view name) {
  const std::size_t colon = name.find(':');
  const std::string kind(name.substr(0, colon));
  std::vector<std::string> kinds;
  for (const Preset& preset : presets()) kinds.push_back(preset.name);
  kinds.push_back("custom");
  if (colon == std::string_view::npos ||
      std::find(kinds.begin(), kinds.end(), kind) == kinds.end()) {
    const bool known = std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
    const std::string hint = known ? "" : did_you_mean(kind, kinds);
    throw std::invalid_argument(
        fmt::format("{} layout '{}'; {}layouts are classic:W, standard:W, circle:W, custom:ROWS",
                    known ? "unfinished" : "unknown", name, hint.empty() ? "" : hint + " "));
  }
  const std::string_view rest = name.substr(colon + 1);
  if (kind == "custom") return Layout(rest);
  int width = 0;
  const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), width);
  if (error != std::errc() || end != rest.data() + rest.size()) {
    throw std::invalid_argument(fmt::format(
        "layout '{}' needs a whole number of cells after the colon, like {}:10", name, kind));
  }
  const auto preset = std::find_if(presets().begin(), presets().end(),
                                   [&](const Preset& p) { return p.name == kind; });
  try {
    return preset->make(width);
  } catch (const std::invalid_argument& error_of_cells) {
    throw std::invalid_argument(fmt::format("layout '{}': {}", name, error_of_cells.what()));
  }
}

std::string layout_name(const Layout& layout) {
  if (const Preset* preset = find_preset(layout)) {
    return fmt::format("{}:{}", preset->name, layout.width());
  }
  return fmt::format("custom:{}", fmt::join(layout.rows(), "/"));
}

std::string layout_family_prefix(const Layout& layout) {
  const Preset* preset = find_preset(layout);
  return preset ? preset->family_prefix : "Custom";
}

}  // namespace tagmint::codec
