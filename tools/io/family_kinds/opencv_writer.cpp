#include <fmt/format.h>

#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "io/family_kinds/data_square.h"
#include "io/family_kinds/family_note.h"
#include "io/family_kinds/gzip.h"
#include "io/family_kinds/opencv.h"
#include "tagmint/codec/rotation.h"

namespace tagmint::io {
namespace {

/// OpenCV 4 reads texts of up to 4095 characters.
constexpr std::size_t kLongestText = 4000;

/// Writes keys and values as YAML or as JSON.
class KeyWriter {
 public:
  explicit KeyWriter(bool json) : json_(json), text_(json ? "{\n" : "%YAML:1.0\n---\n") {}

  void number(std::string_view key, std::size_t value) { add(key, fmt::format("{}", value)); }
  /// `value` holds nothing that must be escaped.
  void plain_text(std::string_view key, std::string_view value) {
    add(key, fmt::format("\"{}\"", value));
  }
  void text(std::string_view key, const std::string& value) {
    add(key, nlohmann::json(value).dump());
  }
  std::string finish() { return text_ + (json_ ? "\n}\n" : ""); }

 private:
  void add(std::string_view key, std::string_view value) {
    if (json_) {
      fmt::format_to(std::back_inserter(text_), "{}    \"{}\": {}", first_ ? "" : ",\n", key,
                     value);
    } else {
      fmt::format_to(std::back_inserter(text_), "{}: {}\n", key, value);
    }
    first_ = false;
  }

  bool json_;
  bool first_ = true;
  std::string text_;
};

/// The part of the name that tells the format: ".json" of "a.json.gz".
bool is_json(std::string_view target) {
  if (target.ends_with(".gz")) target.remove_suffix(3);
  return target.ends_with(".json");
}

bool recognises_opencv(const FamilySource& source) {
  return source.content.find("markersize") != std::string::npos ||
         source.content.find("nmarkers") != std::string::npos ||
         source.content.find("marker_0") != std::string::npos;
}

}  // namespace

std::vector<FamilyFile> make_opencv(const codec::Family& family, const std::string& target,
                                    const FamilyWriteOptions& options) {
  require_square(family, "an OpenCV dictionary");
  const DataSquare square(family.layout());
  KeyWriter writer(is_json(target));
  writer.number("nmarkers", family.size());
  writer.number("markersize", static_cast<std::size_t>(square.side()));
  // A reader's own default is 0.
  writer.number("maxCorrectionBits", static_cast<std::size_t>(family.max_safe_errors()));
  writer.number(kOpenCvTurnKey, static_cast<std::size_t>(options.opencv));
  const std::string note = family_note(family);
  if (note.size() <= kLongestText / 2) writer.text(kOpenCvNoteKey, note);  // escapes at most double
  const int turns = options.opencv == OpenCvTurn::HalfTurned ? 2 : 0;
  for (codec::TagId id = 0; id < family.size(); ++id) {
    writer.plain_text(fmt::format("marker_{}", id),
                      square.characters(codec::rotate(family.codeword(id), family.bits(), turns)));
  }
  std::string content = writer.finish();
  return {{target, target.ends_with(".gz") ? gzip(content) : std::move(content)}};
}

FamilyKind opencv_kind() {
  return {.name = "opencv",
          .summary = "OpenCV ArUco dictionary, YAML or JSON, also packed by gzip",
          .extensions = {".yaml", ".yml", ".yaml.gz", ".yml.gz", ".json.gz"},
          .recognises = recognises_opencv,
          .read = read_opencv,
          .make = make_opencv};
}

}  // namespace tagmint::io
