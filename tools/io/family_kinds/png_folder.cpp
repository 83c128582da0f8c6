#include "io/family_kinds/png_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <system_error>

#include "io/family_kinds/cell_png.h"
#include "io/family_kinds/imported_family.h"
#include "io/family_kinds/layout_of_tags.h"
#include "io/streams.h"
#include "tagmint/codec/errors.h"
#include "tagmint/codec/tag_cells.h"

namespace tagmint::io {
namespace {

namespace fs = std::filesystem;
using codec::Cell;
using codec::TagCells;

constexpr std::size_t kMostFiles = 100'000;  // ids of five digits

/// "tag36_11_": bits and distance, as the collection names its files.
std::string file_prefix(const codec::Family& family) {
  return fmt::format("tag{:02}_{:02}_", family.bits(), family.min_hamming());
}

CellPicture picture_of(const TagCells& tag) {
  CellPicture picture{tag.width(), tag.width(), {}};
  for (int y = 0; y < tag.width(); ++y) {
    for (int x = 0; x < tag.width(); ++x) picture.cells.push_back(tag.at(x, y));
  }
  return picture;
}

/// All tags row by row in about a square, with a cell of nothing between them.
CellPicture mosaic(const codec::Family& family) {
  const int count = static_cast<int>(family.size());
  const int columns = static_cast<int>(std::ceil(std::sqrt(count)));
  const int rows = (count + columns - 1) / columns;
  const int pitch = family.layout().width() + 1;
  CellPicture picture{columns * pitch + 1, rows * pitch + 1, {}};
  picture.cells.assign(static_cast<std::size_t>(picture.width) * picture.height, Cell::None);
  for (int id = 0; id < count; ++id) {
    const TagCells tag =
        codec::tag_cells(family.layout(), family.codeword(static_cast<codec::TagId>(id)));
    const int left = id % columns * pitch + 1;
    const int top = id / columns * pitch + 1;
    for (int y = 0; y < tag.width(); ++y) {
      for (int x = 0; x < tag.width(); ++x) {
        picture.cells[static_cast<std::size_t>(top + y) * picture.width + left + x] = tag.at(x, y);
      }
    }
  }
  return picture;
}

std::vector<FamilyFile> make(const codec::Family& family, const std::string& target,
                             const FamilyWriteOptions&) {
  const fs::path folder = target;
  const std::string prefix = file_prefix(family);
  std::vector<FamilyFile> files;
  for (codec::TagId id = 0; id < family.size(); ++id) {
    const TagCells tag = codec::tag_cells(family.layout(), family.codeword(id));
    files.push_back({(folder / fmt::format("{}{:05}.png", prefix, id)).string(),
                     encode_cell_png(picture_of(tag))});
  }
  files.push_back({(folder / "mosaic.png").string(), encode_cell_png(mosaic(family))});
  return files;
}

/// The pictures of a folder by their ids, and what their names have in common.
struct TagFiles {
  std::string prefix;
  std::map<std::uint64_t, fs::path> by_id;
};

/// The number at the end of a name like "tag36_11_00012"; nothing where there is none.
std::optional<std::pair<std::string, std::uint64_t>> split_name(const std::string& stem) {
  const std::size_t begin = stem.find_last_not_of("0123456789") + 1;
  if (begin == stem.size() || begin == 0 || stem[begin - 1] != '_') return std::nullopt;
  std::uint64_t id = 0;
  const auto [end, error] = std::from_chars(stem.data() + begin, stem.data() + stem.size(), id);
  if (error != std::errc()) return std::nullopt;
  return std::pair{stem.substr(0, begin), id};
}

TagFiles find_files(const FamilySource& source) {
  TagFiles files;
  for (const fs::directory_entry& entry : fs::directory_iterator(source.path)) {
    const fs::path& path = entry.path();
    if (path.extension() != ".png") continue;
    const auto name = split_name(path.stem().string());
    if (!name) continue;
    if (files.by_id.empty()) files.prefix = name->first;
    if (name->first != files.prefix) {
      fail_in_source(
          fmt::format("tags of two families, {}... and {}...", std::min(files.prefix, name->first),
                      std::max(files.prefix, name->first)),
          source, 0, "give a folder with one family");
    }
    const auto [earlier, is_new] = files.by_id.emplace(name->second, path);
    if (!is_new) {
      fail_in_source(fmt::format("two files of tag {}, {} and {}", name->second,
                                 earlier->second.filename().string(), path.filename().string()),
                     source, 0, "remove one of them");
    }
  }
  if (files.by_id.empty()) {
    fail_in_source("no picture of a tag is in this folder", source, 0,
                   "they are called like tag36_11_00000.png");
  }
  std::uint64_t due = 0;
  for (const auto& [id, path] : files.by_id) {
    if (id != due++) {
      fail_in_source(fmt::format("the picture of tag {} is missing", due - 1), source, 0,
                     "ids run from 0 without gaps");
    }
  }
  return files;
}

/// What a prefix "tag36_11_" tells.
struct PrefixFigures {
  int bits = 0;
  int distance = 0;
};

std::optional<PrefixFigures> figures_of(const std::string& prefix) {
  constexpr std::string_view kBegin = "tag";
  if (!prefix.starts_with(kBegin)) return std::nullopt;
  PrefixFigures figures;
  const char* const end = prefix.data() + prefix.size();
  const auto bits = std::from_chars(prefix.data() + kBegin.size(), end, figures.bits);
  if (bits.ec != std::errc() || bits.ptr == end || *bits.ptr != '_') return std::nullopt;
  const auto distance = std::from_chars(bits.ptr + 1, end, figures.distance);
  if (distance.ec != std::errc() || std::string_view(distance.ptr, end) != "_") return std::nullopt;
  if (figures.distance < 1 || figures.distance > figures.bits) return std::nullopt;
  return figures;
}

/// The layout that the user names, or the first possible one that has as many bits as the files'
/// names say, or the first one.
codec::Layout layout_of(const std::vector<TagCells>& tags,
                        const std::optional<PrefixFigures>& figures, const FamilySource& source,
                        const FamilyReadOptions& options) {
  if (options.layout) return *options.layout;
  try {
    const std::vector<codec::Layout> layouts = possible_layouts(tags);
    const auto named = std::find_if(layouts.begin(), layouts.end(), [&](const auto& layout) {
      return figures && layout.bits() == figures->bits;
    });
    return named == layouts.end() ? layouts.front() : *named;
  } catch (const std::invalid_argument& fault) {
    fail_in_source(fmt::format("the pictures show no layout: {}", fault.what()), source, 0,
                   "give it with --layout");
  }
}

ReadFamily read(const FamilySource& source, const FamilyReadOptions& options) {
  const TagFiles files = find_files(source);
  std::vector<TagCells> tags;
  for (const auto& [id, path] : files.by_id) {
    tags.push_back(decode_cell_png(read_input(path.string()), path.string()));
    if (tags.back().width() != tags.front().width()) {
      throw codec::InputError(
          fmt::format("{} cells wide where tag 0 is {}", tags.back().width(), tags.front().width()),
          path.string(), "give a folder with one family");
    }
  }
  const std::optional<PrefixFigures> figures = figures_of(files.prefix);
  const codec::Layout layout = layout_of(tags, figures, source, options);
  const std::size_t misfit = first_misfit(layout, tags);
  if (misfit < tags.size()) {
    throw codec::InputError("the tag has other cells than the layout",
                            files.by_id.at(misfit).string(),
                            "correct the picture, or give the layout with --layout");
  }
  ImportedFamily imported{
      .name = {}, .layout = layout, .codewords = {}, .lines = {}, .kind = "png"};
  if (figures && figures->bits == layout.bits()) imported.min_hamming = figures->distance;
  for (const TagCells& tag : tags) imported.codewords.push_back(codec::codeword_of(layout, tag));
  return make_imported(std::move(imported), source, options);
}

}  // namespace

FamilyKind png_folder_kind() {
  return {.name = "png",
          .summary = "folder of pictures as in apriltag-imgs, one pixel a cell",
          .is_folder = true,
          .one_file = false,
          .most_codes = kMostFiles,
          .limit_reason = "its file names have ids of five digits",
          .recognises = [](const FamilySource& source) { return source.is_folder; },
          .read = read,
          .make = make};
}

}  // namespace tagmint::io
