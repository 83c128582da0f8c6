#include "io/family_kinds/imported_family.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <unordered_map>
#include <utility>

#include "io/family_kinds/family_changes.h"
#include "io/family_kinds/family_note.h"
#include "tagmint/codec/family_stats.h"
#include "tagmint/codec/version.h"

namespace tagmint::io {
namespace {

/// Comparing all pairs of so many codewords takes half a minute on one core.
constexpr std::size_t kMostCompared = 250'000;

int line_of(const ImportedFamily& parts, std::size_t id) {
  return id < parts.lines.size() ? parts.lines[id] : 0;
}

/// Each codeword fits the layout and comes once.
void check_codewords(const ImportedFamily& parts, const FamilySource& source) {
  if (parts.codewords.empty()) {
    fail_in_source("there is no codeword", source, 0, "give a file that lists at least one");
  }
  const codec::Codeword mask = codec::low_mask(parts.layout.bits());
  std::unordered_map<codec::Codeword, std::size_t> ids;
  ids.reserve(parts.codewords.size());
  for (std::size_t id = 0; id < parts.codewords.size(); ++id) {
    const codec::Codeword word = parts.codewords[id];
    if ((word & ~mask) != 0) {
      fail_in_source(fmt::format("codeword {} has more than {} bits", id, parts.layout.bits()),
                     source, line_of(parts, id), "correct it");
    }
    const auto [earlier, is_new] = ids.emplace(word, id);
    if (!is_new) {
      fail_in_source(fmt::format("codeword {} repeats codeword {}", id, earlier->second), source,
                     line_of(parts, id), "a family holds each once; remove one of them");
    }
  }
}

codec::FamilyParts parts_of(ImportedFamily imported, int min_hamming) {
  return {.name = std::move(imported.name),
          .layout = std::move(imported.layout),
          .min_hamming = min_hamming,
          .codewords = std::move(imported.codewords),
          .complexity = {},
          .origin = {.method = fmt::format("converted from {}", imported.kind),
                     .order = {},
                     .seed = {},
                     .searched = {},
                     .program = fmt::format("tagmint {}", codec::kVersion)},
          .levels = {}};
}

/// The true distance of codewords that came without one. A family file declares at least 1.
int computed_distance(const ImportedFamily& imported, const FamilySource& source, int threads,
                      std::vector<std::string>& notes) {
  const std::size_t codes = imported.codewords.size();
  if (codes > kMostCompared) {
    fail_in_source(
        fmt::format("the distance of {} codewords is not declared and takes long to compute",
                    codes),
        source, 0, "declare it with --min-hamming");
  }
  const codec::Family undeclared(parts_of(imported, 1));
  const int distance = codec::family_stats(undeclared, threads).min_hamming;
  if (distance > 0) {
    notes.push_back(fmt::format("the distance is {}, computed from the codewords", distance));
  } else {
    notes.emplace_back(
        "some tag is equal to a turn of itself or of another, so its id or its corners are "
        "ambiguous: 'tagmint check' names it");
  }
  return std::max(distance, 1);
}

/// The family that the note describes, if it belongs to what the source lists.
std::optional<codec::Family> noted_family(const ImportedFamily& imported,
                                          const FamilyReadOptions& options,
                                          std::vector<std::string>& notes) {
  // A user who says otherwise knows better than the note.
  if (!imported.note || options.min_hamming || options.layout) return std::nullopt;
  std::optional<codec::Family> noted = family_of_note(*imported.note, imported.codewords);
  if (noted && std::ranges::equal(noted->layout().data_cells(), imported.layout.data_cells()) &&
      (!imported.min_hamming || *imported.min_hamming == noted->min_hamming())) {
    return noted;
  }
  notes.emplace_back("the note that tagmint left in the file does not belong to it; passed over");
  return std::nullopt;
}

}  // namespace

ReadFamily make_imported(ImportedFamily imported, const FamilySource& source,
                         const FamilyReadOptions& options) {
  check_codewords(imported, source);
  std::vector<std::string> notes;
  const std::string written = std::exchange(imported.name, possible_name(imported.name));
  if (written != imported.name && options.name.empty()) {
    notes.emplace_back("the file has another name, which cannot be that of a family; see --name");
  }
  if (!options.name.empty()) imported.name = options.name;
  if (std::optional<codec::Family> noted = noted_family(imported, options, notes)) {
    if (imported.name.empty() || imported.name == noted->name()) return {std::move(*noted), notes};
    return {renamed(*noted, imported.name), notes};
  }
  if (imported.name.empty()) imported.name = name_from_path(source);
  if (options.min_hamming) imported.min_hamming = options.min_hamming;
  if (!imported.min_hamming) {
    imported.min_hamming = computed_distance(imported, source, options.threads, notes);
  }
  const int min_hamming = *imported.min_hamming;
  return {codec::Family(parts_of(std::move(imported), min_hamming)), notes};
}

}  // namespace tagmint::io
