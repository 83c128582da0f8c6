#include <fmt/format.h>

#include <charconv>
#include <stdexcept>
#include <system_error>

#include "io/family_kinds/data_square.h"
#include "io/family_kinds/flat_keys.h"
#include "io/family_kinds/imported_family.h"
#include "io/family_kinds/opencv.h"
#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/rotation.h"

namespace tagmint::io {
namespace {

using codec::Codeword;

constexpr int kMostSide = 8;  // 64 bits

class DictionaryReader {
 public:
  DictionaryReader(const FamilySource& source, const FamilyReadOptions& options)
      : source_(source), options_(options), keys_(read_flat_keys(source)) {}

  ReadFamily read() {
    const codec::Layout layout =
        square_layout(static_cast<int>(number("markersize", 1, kMostSide)));
    if (options_.layout && *options_.layout != layout) {
      throw std::invalid_argument("an OpenCV dictionary says its layout; leave --layout out");
    }
    ImportedFamily imported{
        .name = keys_.title, .layout = layout, .codewords = {}, .lines = {}, .kind = "opencv"};
    read_markers(imported);
    std::vector<std::string> notes;
    turn(imported, notes);
    if (const auto note = keys_.values.find(kOpenCvNoteKey); note != keys_.values.end()) {
      imported.note = note->second.text;
    }
    ReadFamily result = make_imported(std::move(imported), source_, options_);
    result.notes.insert(result.notes.begin(), notes.begin(), notes.end());
    return result;
  }

 private:
  [[noreturn]] void fail(int line, std::string_view what, std::string_view mend) const {
    fail_in_source(what, source_, line, mend);
  }

  std::uint64_t number(const std::string& key, std::uint64_t least, std::uint64_t most) const {
    const auto place = keys_.values.find(key);
    if (place == keys_.values.end()) {
      fail(0, fmt::format("the key '{}' is missing", key), "get the file anew");
    }
    const auto& [text, line] = place->second;
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || value < least || value > most) {
      fail(line, fmt::format("'{}' is {}", key, text),
           fmt::format("it is a whole number from {} to {}", least, most));
    }
    return value;
  }

  /// marker_0, marker_1, ... of which there are as many as the file says.
  void read_markers(ImportedFamily& imported) const {
    constexpr std::uint64_t kMostIds = 0xffff'ffff;
    const std::uint64_t markers = number("nmarkers", 1, kMostIds);
    const DataSquare square(imported.layout);
    for (std::uint64_t id = 0; id < markers; ++id) {
      const auto place = keys_.values.find(fmt::format("marker_{}", id));
      if (place == keys_.values.end()) {
        fail(keys_.values.at("nmarkers").line,
             fmt::format("'nmarkers' is {}, but 'marker_{}' is missing", markers, id),
             "get the file anew");
      }
      const auto& [text, line] = place->second;
      if (text.size() != static_cast<std::size_t>(square.cells()) ||
          text.find_first_not_of("01") != std::string::npos) {
        fail(line, fmt::format("'marker_{}' is not {} characters 0 and 1", id, square.cells()),
             "correct it; between quotes, lest zeros in front be lost");
      }
      imported.codewords.push_back(square.codeword(text));
      imported.lines.push_back(line);
    }
    const auto more = keys_.values.find(fmt::format("marker_{}", markers));
    if (more != keys_.values.end()) {
      fail(more->second.line, fmt::format("'nmarkers' is {0}, but there is 'marker_{0}'", markers),
           "correct the number");
    }
  }

  /// Turns markers upright that are turned by 180 degrees.
  void turn(ImportedFamily& imported, std::vector<std::string>& notes) const {
    const int bits = imported.layout.bits();
    const auto turn_all = [&] {
      for (Codeword& word : imported.codewords) word = codec::rotate(word, bits, 2);
    };
    if (options_.opencv) {
      if (*options_.opencv == OpenCvTurn::HalfTurned) turn_all();
    } else if (keys_.values.contains(kOpenCvTurnKey)) {
      if (number(kOpenCvTurnKey, 4, 5) == 4) turn_all();
    } else {
      turn_all();
      if (const auto name = published_name(imported)) {
        notes.push_back(fmt::format(
            "this is {} as OpenCV 4 has it, turned by 180 degrees; turned upright", *name));
        if (codec::find_family(*name)->size() == imported.codewords.size()) imported.name = *name;
      } else {
        turn_all();
        notes.emplace_back(
            "markers taken as upright; --opencv 4 turns those of OpenCV 4's AprilTag dictionaries");
      }
    }
  }

  /// The bundled family whose first tags these are.
  static std::optional<std::string> published_name(const ImportedFamily& imported) {
    for (const std::string& name : codec::family_names()) {
      const codec::SharedFamily family = codec::find_family(name);
      if (family->layout() != imported.layout || family->size() < imported.codewords.size())
        continue;
      codec::TagId id = 0;
      while (id < imported.codewords.size() && family->codeword(id) == imported.codewords[id]) ++id;
      if (id == imported.codewords.size()) return name;
    }
    return std::nullopt;
  }

  const FamilySource& source_;
  const FamilyReadOptions& options_;
  FlatKeys keys_;
};

}  // namespace

ReadFamily read_opencv(const FamilySource& source, const FamilyReadOptions& options) {
  return DictionaryReader(source, options).read();
}

}  // namespace tagmint::io
