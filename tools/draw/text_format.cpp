#include "draw/text_format.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "tagmint/codec/suggest.h"

namespace tagmint::draw {

TextFormat::TextFormat(std::string_view text, std::span<const std::string_view> fields) {
  const auto literal = [&](char c) {
    if (pieces_.empty() || !pieces_.back().name.empty()) pieces_.emplace_back();
    pieces_.back().literal.push_back(c);
  };
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    const bool doubled = i + 1 < text.size() && text[i + 1] == c;
    if ((c == '{' || c == '}') && doubled) {
      literal(c);
      ++i;
    } else if (c == '}') {
      throw std::invalid_argument(
          fmt::format("'}}' without '{{' in '{}'; write '}}}}' for a brace", text));
    } else if (c == '{') {
      const std::size_t end = text.find('}', i);
      if (end == std::string_view::npos) {
        throw std::invalid_argument(
            fmt::format("'{{' without '}}' in '{}'; write '{{{{' for a brace", text));
      }
      pieces_.push_back(parse_field(text.substr(i + 1, end - i - 1), fields));
      i = end;
    } else {
      literal(c);
    }
  }
}

TextFormat::Piece TextFormat::parse_field(std::string_view inside,
                                          std::span<const std::string_view> fields) {
  const std::size_t colon = inside.find(':');
  Piece piece;
  piece.name = inside.substr(0, colon);
  if (std::find(fields.begin(), fields.end(), piece.name) == fields.end()) {
    const std::vector<std::string> names(fields.begin(), fields.end());
    const std::string hint = codec::did_you_mean(piece.name, names);
    throw std::invalid_argument(fmt::format("unknown field {{{}}}; {}the fields are {{{}}}",
                                            piece.name, hint.empty() ? "" : hint + " ",
                                            fmt::join(fields, "}, {")));
  }
  if (colon == std::string_view::npos) return piece;
  const std::string_view width = inside.substr(colon + 1);
  constexpr std::size_t kLongestWidth = 3;  // "020"
  constexpr int kLargestWidth = 20;         // digits of the largest number
  const bool digits = !width.empty() && width.size() <= kLongestWidth &&
                      width.find_first_not_of("0123456789") == std::string_view::npos;
  for (const char c : width) piece.width = digits ? piece.width * 10 + (c - '0') : 0;
  piece.zeros = digits && width[0] == '0';
  if (piece.width < 1 || piece.width > kLargestWidth) {
    throw std::invalid_argument(
        fmt::format("'{}' is no width of the field {{{}}}; write {{{}:5}} or {{{}:05}}, up to {}",
                    width, piece.name, piece.name, piece.name, kLargestWidth));
  }
  return piece;
}

bool TextFormat::uses(std::string_view field) const {
  return std::any_of(pieces_.begin(), pieces_.end(),
                     [&](const Piece& piece) { return piece.name == field; });
}

bool TextFormat::has_fields() const {
  return std::any_of(pieces_.begin(), pieces_.end(),
                     [](const Piece& piece) { return !piece.name.empty(); });
}

std::string TextFormat::expand(std::span<const FieldValue> values) const {
  std::string out;
  for (const Piece& piece : pieces_) {
    if (piece.name.empty()) {
      out += piece.literal;
      continue;
    }
    const auto field = std::find_if(values.begin(), values.end(), [&](const FieldValue& value) {
      return value.name == piece.name;
    });
    if (field == values.end()) {
      throw std::invalid_argument(fmt::format("the field {{{}}} has no value here", piece.name));
    }
    if (const auto* number = std::get_if<std::uint64_t>(&field->value)) {
      out += piece.zeros ? fmt::format("{:0{}}", *number, piece.width)
                         : fmt::format("{:{}}", *number, piece.width);
    } else if (piece.width > 0) {
      throw std::invalid_argument(
          fmt::format("the field {{{}}} is no number and takes no width", piece.name));
    } else {
      out += std::get<std::string>(field->value);
    }
  }
  return out;
}

}  // namespace tagmint::draw
