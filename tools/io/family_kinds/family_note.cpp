#include "io/family_kinds/family_note.h"

#include <fmt/format.h>

#include <iterator>
#include <nlohmann/json.hpp>
#include <span>

#include "tagmint/codec/errors.h"
#include "tagmint/codec/family_file.h"

namespace tagmint::io {

using Json = nlohmann::ordered_json;

std::string family_note(const codec::Family& family) {
  // The codewords are the last key of a family file.
  std::string text = codec::format_family(family);
  text.erase(text.rfind("\"codes\""));
  text.erase(text.rfind(','));
  constexpr bool kAsciiOnly = true;
  return Json::parse(text + "}").dump(-1, ' ', kAsciiOnly);
}

std::optional<codec::Family> family_of_note(std::string_view note,
                                            std::span<const codec::Codeword> codewords) {
  const std::size_t end = note.rfind('}');
  if (end == std::string_view::npos) return std::nullopt;
  std::string text = fmt::format("{},\"codes\":[", note.substr(0, end));
  for (std::size_t id = 0; id < codewords.size(); ++id) {
    fmt::format_to(std::back_inserter(text), "{}\"{}\"", id == 0 ? "" : ",",
                   codec::to_hex(codewords[id]));
  }
  try {
    return codec::parse_family(text + "]}", "note");
  } catch (const codec::InputError&) {
    return std::nullopt;
  }
}

}  // namespace tagmint::io
