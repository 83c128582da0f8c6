#include "io/family_kinds/family_note.h"

#include <nlohmann/json.hpp>
#include <span>

#include "tagmint/codec/errors.h"
#include "tagmint/codec/family_file.h"

namespace tagmint::io {

using Json = nlohmann::ordered_json;

std::string family_note(const codec::Family& family) {
  Json note = Json::parse(codec::format_family(family));
  note.erase("codes");
  constexpr bool kAsciiOnly = true;
  return note.dump(-1, ' ', kAsciiOnly);
}

std::optional<codec::Family> family_of_note(std::string_view note,
                                            std::span<const codec::Codeword> codewords) {
  Json json = Json::parse(note, nullptr, false);
  if (!json.is_object()) return std::nullopt;
  Json& codes = json["codes"] = Json::array();
  for (const codec::Codeword word : codewords) codes.push_back(codec::to_hex(word));
  try {
    return codec::parse_family(json.dump(), "note");
  } catch (const codec::InputError&) {
    return std::nullopt;
  } catch (const Json::exception&) {  // a text of the note that is no UTF-8
    return std::nullopt;
  }
}

}  // namespace tagmint::io
