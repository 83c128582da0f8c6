#include "io/family_kinds/family_kind.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>

#include "io/atomic_folder.h"
#include "io/family_kinds/apriltag_c.h"
#include "io/family_kinds/csv.h"
#include "io/family_kinds/opencv.h"
#include "io/family_kinds/png_folder.h"
#include "io/family_kinds/rmsalinas.h"
#include "io/family_kinds/tagmint_json.h"
#include "tagmint/codec/atomic_file.h"
#include "tagmint/codec/errors.h"

namespace tagmint::io {

std::span<const FamilyKind> family_kinds() {
  // tagmint first: its files may hold any text. apriltag-c last: its marks are words of a source.
  static const std::array kinds = {png_folder_kind(), tagmint_json_kind(), opencv_kind(),
                                   rmsalinas_kind(),  csv_kind(),          apriltag_c_kind()};
  return kinds;
}

std::vector<std::string> family_kind_names() {
  std::vector<std::string> names;
  for (const FamilyKind& kind : family_kinds()) names.emplace_back(kind.name);
  return names;
}

const FamilyKind* find_family_kind(std::string_view name) {
  for (const FamilyKind& kind : family_kinds()) {
    if (kind.name == name) return &kind;
  }
  return nullptr;
}

const FamilyKind* family_kind_of_output(const std::string& target) {
  std::string name = std::filesystem::path(target).filename().string();
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const FamilyKind& kind : family_kinds()) {
    for (const std::string_view extension : kind.extensions) {
      if (name.size() > extension.size() && name.ends_with(extension)) return &kind;
    }
    if (kind.is_folder && name.find('.') == std::string::npos) return &kind;
  }
  return nullptr;
}

const FamilyKind& recognise_family_kind(const FamilySource& source) {
  for (const FamilyKind& kind : family_kinds()) {
    if (kind.recognises(source)) return kind;
  }
  std::string known;
  for (const FamilyKind& kind : family_kinds()) {
    known += (known.empty() ? "" : ", ") + std::string(kind.name);
  }
  fail_in_source(source.content.empty() ? "the file is empty" : "no known kind of family file",
                 source, 0, fmt::format("the kinds are {}; name the right one with --from", known));
}

void write_family_files(const FamilyKind& kind, const std::string& target,
                        const std::vector<FamilyFile>& files) {
  if (!kind.is_folder) {
    for (const FamilyFile& file : files) codec::write_file_atomically(file.path, file.content);
    return;
  }
  AtomicFolder folder(target);
  for (const FamilyFile& file : files) {
    folder.write(std::filesystem::path(file.path).filename().string(), file.content);
  }
  folder.finish();
}

}  // namespace tagmint::io
