#include "io/family_kinds/rmsalinas.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <system_error>

#include "io/family_kinds/data_square.h"
#include "io/family_kinds/imported_family.h"
#include "io/family_kinds/text_lines.h"

namespace tagmint::io {
namespace {

bool recognises(const FamilySource& source) {
  const std::vector<TextLine> lines = text_lines(std::string_view(source.content).substr(0, 4096));
  return lines.size() >= 2 && lines[0].text.starts_with("name ") &&
         lines[1].text.starts_with("nbits");
}

/// What follows `key` in a line "key VALUE".
std::string_view value_of(const TextLine& line, std::string_view key, const FamilySource& source) {
  const std::size_t begin = line.text.find_first_not_of(" \t:", key.size());
  if (!line.text.starts_with(key) || begin == key.size() || begin == std::string_view::npos) {
    fail_in_source(
        fmt::format("'{}' stands where '{}' and its value are due", line.text.substr(0, 60), key),
        source, line.number, "the file begins with the lines 'name X' and 'nbits N'");
  }
  return line.text.substr(begin);
}

int side_of(const TextLine& line, const FamilySource& source) {
  const std::string_view text = value_of(line, "nbits", source);
  int bits = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), bits);
  const int side = bits > 0 && bits <= codec::kMaxBits ? int(std::lround(std::sqrt(bits))) : 0;
  if (error != std::errc() || end != text.data() + text.size() || side == 0 ||
      side * side != bits) {
    fail_in_source(fmt::format("'nbits' is '{}'", text), source, line.number,
                   "it is the number of cells of a square, up to 64");
  }
  return side;
}

ReadFamily read(const FamilySource& source, const FamilyReadOptions& options) {
  const std::vector<TextLine> lines = text_lines(source.content);
  if (lines.size() < 3) {
    fail_in_source("the file ends too early", source, lines.empty() ? 1 : lines.back().number,
                   "it needs 'name X', 'nbits N' and one line a tag");
  }
  const std::string name(value_of(lines[0], "name", source));
  const codec::Layout layout = square_layout(side_of(lines[1], source));
  if (options.layout && *options.layout != layout) {
    throw std::invalid_argument("a rmsalinas dictionary says its layout; leave --layout out");
  }
  ImportedFamily imported{
      .name = name, .layout = layout, .codewords = {}, .lines = {}, .kind = "rmsalinas"};
  const DataSquare square(layout);
  for (std::size_t i = 2; i < lines.size(); ++i) {
    const std::string_view bits = lines[i].text;
    if (bits.size() != static_cast<std::size_t>(square.cells()) ||
        bits.find_first_not_of("01") != std::string_view::npos) {
      fail_in_source(fmt::format("codeword {} is '{}'", i - 2, bits.substr(0, 80)), source,
                     lines[i].number, fmt::format("it is {} characters 0 and 1", square.cells()));
    }
    imported.codewords.push_back(square.codeword(bits));
    imported.lines.push_back(lines[i].number);
  }
  return make_imported(std::move(imported), source, options);
}

std::vector<FamilyFile> make(const codec::Family& family, const std::string& target,
                             const FamilyWriteOptions&) {
  require_square(family, "a rmsalinas dictionary");
  const DataSquare square(family.layout());
  std::string content = fmt::format("name {}\nnbits {}\n", family.name(), family.bits());
  content.reserve(content.size() + family.size() * (static_cast<std::size_t>(family.bits()) + 1));
  for (const codec::Codeword word : family.codewords()) {
    content += square.characters(word);
    content += '\n';
  }
  return {{target, std::move(content)}};
}

}  // namespace

FamilyKind rmsalinas_kind() {
  return {.name = "rmsalinas",
          .summary = "dictionary of the ArUco library of R. Munoz-Salinas",
          .extensions = {".txt", ".dict"},
          .recognises = recognises,
          .read = read,
          .make = make};
}

}  // namespace tagmint::io
