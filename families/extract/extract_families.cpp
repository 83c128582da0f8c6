// Writes the published families that the installed libapriltag carries as tagmint family files.
// Codewords and the places of their bits are read through libapriltag's C functions; the layouts
// are tagmint's own, and each is checked cell by cell against the places that libapriltag gives.
// Usage: extract_families FOLDER

#include <apriltag/apriltag.h>
#include <apriltag/tag16h5.h>
#include <apriltag/tag25h9.h>
#include <apriltag/tag36h10.h>
#include <apriltag/tag36h11.h>
#include <apriltag/tagCircle21h7.h>
#include <apriltag/tagCircle49h12.h>
#include <apriltag/tagCustom48h12.h>
#include <apriltag/tagStandard41h12.h>
#include <apriltag/tagStandard52h13.h>
#include <fmt/format.h>

#include <cstdint>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "tagmint/codec/family.h"
#include "tagmint/codec/family_file.h"
#include "tagmint/codec/layout_presets.h"

namespace {

using namespace tagmint::codec;

/// A published family: how libapriltag makes it, and what was published about it.
struct Published {
  std::string name;
  apriltag_family_t* (*create)();
  void (*destroy)(apriltag_family_t*);
  std::string layout;
  std::string complexity;
  std::string order;
  int seed_constant;  // seed of the walk = bits * 10000 + distance * 100 + this
  std::string searched;
};

const std::vector<Published>& published_families() {
  static const std::string custom48 =
      "custom:dddddddddd/dbbbbbbbbd/dbwwwwwwbd/dbwddddwbd/dbwdxxdwbd/"
      "dbwdxxdwbd/dbwddddwbd/dbwwwwwwbd/dbbbbbbbbd/dddddddddd";
  static const std::string energy = "energy:0.3333";
  // clang-format off
  static const std::vector<Published> all = {
      {"tag16h5", tag16h5_create, tag16h5_destroy, "classic:8", "rectangles:5", "apriltag2", 5, "complete"},
      {"tag25h9", tag25h9_create, tag25h9_destroy, "classic:9", "rectangles:8", "apriltag2", 8, "complete"},
      {"tag36h11", tag36h11_create, tag36h11_destroy, "classic:10", "rectangles:10", "apriltag2", 10, "complete"},
      {"tag36h10", tag36h10_create, tag36h10_destroy, "classic:10", "rectangles:10", "apriltag2", 10, "complete"},
      {"tagCircle21h7", tagCircle21h7_create, tagCircle21h7_destroy, "circle:9", energy, "apriltag3", 10, "complete"},
      {"tagStandard41h12", tagStandard41h12_create, tagStandard41h12_destroy, "standard:9", energy, "apriltag3", 10,
       "stopped at 10.7 % of all words"},
      {"tagCustom48h12", tagCustom48h12_create, tagCustom48h12_destroy, custom48, energy, "apriltag3", 12,
       "stopped after about 3.43e9 words, 0.0012 %"},
      {"tagCircle49h12", tagCircle49h12_create, tagCircle49h12_destroy, "circle:11", energy, "apriltag3", 15,
       "stopped after about 3.19e9 words; the first 65,535 of 65,698 codewords found"},
      {"tagStandard52h13", tagStandard52h13_create, tagStandard52h13_destroy, "standard:10", energy, "apriltag3", 12,
       "stopped after about 2.81e9 words"},
  };
  // clang-format on
  return all;
}

template <typename A, typename B>
void require_equal(const std::string& name, const std::string& what, A theirs, B ours) {
  if (static_cast<long long>(theirs) != static_cast<long long>(ours)) {
    throw std::runtime_error(
        fmt::format("{}: libapriltag has {} = {}, our layout {}", name, what, theirs, ours));
  }
}

void check_layout(const apriltag_family_t& theirs, const std::string& name, const Layout& layout) {
  require_equal(name, "nbits", theirs.nbits, layout.bits());
  require_equal(name, "total_width", theirs.total_width, layout.width());
  require_equal(name, "width_at_border", theirs.width_at_border, layout.width_at_border());
  require_equal(name, "reversed_border", int{theirs.reversed_border},
                int{layout.reversed_border()});
  for (int i = 0; i < layout.bits(); ++i) {
    // Theirs count from the border square; outside of it they are negative, kept in unsigned.
    const CellPosition cell = layout.data_cells()[static_cast<std::size_t>(i)];
    const int offset = layout.border_offset();
    require_equal(name, fmt::format("bit_x[{}]", i), static_cast<std::int32_t>(theirs.bit_x[i]),
                  cell.x - offset);
    require_equal(name, fmt::format("bit_y[{}]", i), static_cast<std::int32_t>(theirs.bit_y[i]),
                  cell.y - offset);
  }
}

Family read(const Published& published) {
  const std::unique_ptr<apriltag_family_t, decltype(published.destroy)> theirs(published.create(),
                                                                               published.destroy);
  if (!theirs || theirs->name != published.name) {
    throw std::runtime_error(published.name + ": libapriltag gives another family");
  }
  const Layout layout = parse_layout(published.layout);
  check_layout(*theirs, published.name, layout);
  const int min_hamming = static_cast<int>(theirs->h);
  const int seed = layout.bits() * 10000 + min_hamming * 100 + published.seed_constant;
  return Family({.name = published.name,
                 .layout = layout,
                 .min_hamming = min_hamming,
                 .codewords = {theirs->codes, theirs->codes + theirs->ncodes},
                 .complexity = parse_complexity(published.complexity),
                 .origin = {.method = "lexicode",
                            .order = published.order,
                            .seed = std::to_string(seed),
                            .searched = published.searched,
                            .program = "april.tag.TagFamilyGenerator; read from libapriltag 3.3"},
                 .levels = {}});
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    fmt::print(stderr, "usage: extract_families FOLDER\n");
    return 2;
  }
  try {
    for (const Published& published : published_families()) {
      const Family family = read(published);
      const auto path = std::filesystem::path(argv[1]) / (published.name + ".json");
      write_family(family, path);
      fmt::print("{}: {} codewords, {}\n", path.string(), family.size(), family_digest(family));
    }
  } catch (const std::exception& error) {
    fmt::print(stderr, "extract_families: {}\n", error.what());
    return 1;
  }
  return 0;
}
