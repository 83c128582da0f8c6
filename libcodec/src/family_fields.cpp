#include "family_fields.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <system_error>

namespace tagmint::codec {
namespace {

using Kind = FamilyField::Kind;

constexpr std::array kFields = {
    FamilyField{"", Kind::Group},
    FamilyField{"format", Kind::Text},
    FamilyField{"version", Kind::WholeNumber},
    FamilyField{"name", Kind::Text},
    FamilyField{"bits", Kind::WholeNumber},
    FamilyField{"min_hamming", Kind::WholeNumber},
    FamilyField{"layout", Kind::List},
    FamilyField{"layout[]", Kind::Text},
    FamilyField{"complexity", Kind::Group},
    FamilyField{"complexity.rule", Kind::Text},
    FamilyField{"complexity.threshold", Kind::Number},
    FamilyField{"origin", Kind::Group},
    FamilyField{"origin.method", Kind::Text},
    FamilyField{"origin.order", Kind::Text},
    FamilyField{"origin.seed", Kind::Text},
    FamilyField{"origin.searched", Kind::Text},
    FamilyField{"origin.program", Kind::Text},
    FamilyField{"sha256", Kind::Text},
    FamilyField{"codes", Kind::List},
    FamilyField{"codes[]", Kind::Code},
    FamilyField{"levels", Kind::List},
    FamilyField{"levels[]", Kind::Group},
    FamilyField{"levels[].codes", Kind::WholeNumber},
    FamilyField{"levels[].min_hamming", Kind::WholeNumber},
    FamilyField{"levels[].plain", Kind::WholeNumber},
    FamilyField{"generator", Kind::Group},
    FamilyField{"generator.basis", Kind::List},
    FamilyField{"generator.basis[]", Kind::Code},
    FamilyField{"generator.translation", Kind::Code},
    FamilyField{"generator.cosets", Kind::List},
    FamilyField{"generator.cosets[]", Kind::Code},
    FamilyField{"generator.levels", Kind::List},
    FamilyField{"generator.levels[]", Kind::Group},
    FamilyField{"generator.levels[].dimension", Kind::WholeNumber},
    FamilyField{"generator.levels[].cosets", Kind::WholeNumber},
};

}  // namespace

const FamilyField* find_family_field(std::string_view path) {
  const auto field = std::find_if(kFields.begin(), kFields.end(),
                                  [&](const FamilyField& f) { return f.path == path; });
  return field == kFields.end() ? nullptr : &*field;
}

std::string_view kind_name(FamilyField::Kind kind) {
  switch (kind) {
    case Kind::Text:
      return "a string";
    case Kind::WholeNumber:
      return "a whole number of at least 0";
    case Kind::Number:
      return "a number";
    case Kind::Code:
      return "a string of 0x and 16 hex digits";
    case Kind::List:
      return "a list";
    case Kind::Group:
      break;
  }
  return "an object";
}

std::optional<Codeword> parse_code(std::string_view text) {
  constexpr std::size_t kDigits = 16;
  if (text.size() != 2 + kDigits || !text.starts_with("0x")) return std::nullopt;
  Codeword word = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data() + 2, end, word, 16);
  if (error != std::errc() || stop != end) return std::nullopt;
  return word;
}

}  // namespace tagmint::codec
