#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace tagmint::draw {

/// A named value that a TextFormat puts in.
struct FieldValue {
  std::string_view name;
  std::variant<std::string, std::uint64_t> value;
};

/// A text with fields, "{family} {id:05}", as labels and file names have them. A number may have a
/// width: {id:5} pads with blanks, {id:05} with zeros. {{ and }} stand for single braces.
class TextFormat {
 public:
  /// Throws std::invalid_argument naming the field or brace at fault.
  ///   fields   the names that may occur
  TextFormat(std::string_view text, std::span<const std::string_view> fields);

  bool uses(std::string_view field) const;
  /// Whether any field occurs.
  bool has_fields() const;
  /// The text with the values put in. Throws std::invalid_argument when a field has no value, or a
  /// width was given for one that is no number.
  std::string expand(std::span<const FieldValue> values) const;

 private:
  /// Either literal text or, with a name, a field.
  struct Piece {
    std::string literal;
    std::string name;
    int width = 0;  // 0 = as long as it is
    bool zeros = false;
  };
  static Piece parse_field(std::string_view inside, std::span<const std::string_view> fields);

  std::vector<Piece> pieces_;
};

}  // namespace tagmint::draw
