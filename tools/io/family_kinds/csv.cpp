#include "io/family_kinds/csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <system_error>

#include "io/family_kinds/imported_family.h"
#include "io/family_kinds/layout_of_tags.h"
#include "io/family_kinds/text_lines.h"
#include "tagmint/codec/tag_cells.h"

namespace tagmint::io {
namespace {

using codec::Codeword;
using codec::TagCells;

constexpr std::string_view kSeparators = ",;\t";

std::string_view unquoted(std::string_view field) {
  const std::size_t begin = field.find_first_not_of(" \"");
  if (begin == std::string_view::npos) return {};
  return field.substr(begin, field.find_last_not_of(" \"") + 1 - begin);
}

std::vector<std::string_view> fields_of(std::string_view line, char separator) {
  std::vector<std::string_view> fields;
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min(line.find(separator, begin), line.size());
    fields.push_back(unquoted(line.substr(begin, end - begin)));
    begin = end + 1;
  }
  return fields;
}

std::string_view without_mark(std::string_view content) {
  constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";  // as spreadsheets write it
  if (content.starts_with(kByteOrderMark)) content.remove_prefix(kByteOrderMark.size());
  return content;
}

bool recognises(const FamilySource& source) {
  const std::string_view line = without_mark(source.content).substr(0, 200);
  const std::size_t separator = line.find_first_of(kSeparators);
  return separator != std::string_view::npos && unquoted(line.substr(0, separator)) == "id";
}

/// Reads the table line by line.
class TableReader {
 public:
  TableReader(const FamilySource& source, const FamilyReadOptions& options)
      : source_(source), options_(options), lines_(text_lines(without_mark(source.content))) {}

  ReadFamily read() {
    read_head();
    for (std::size_t i = 1; i < lines_.size(); ++i) read_row(lines_[i]);
    if (words_.empty()) fail(lines_[0].number, "the table has no rows", "list at least one tag");
    ImportedFamily imported{
        .name = {}, .layout = layout(), .codewords = words_, .lines = row_lines_, .kind = "csv"};
    if (!tags_.empty()) compare_with_cells(imported.layout);
    return make_imported(std::move(imported), source_, options_);
  }

 private:
  [[noreturn]] void fail(int line, std::string_view what, std::string_view mend) const {
    fail_in_source(what, source_, line, mend);
  }

  std::optional<std::size_t> column(std::string_view name) const {
    const auto place = std::find(head_.begin(), head_.end(), name);
    if (place == head_.end()) return std::nullopt;
    return static_cast<std::size_t>(place - head_.begin());
  }

  void read_head() {
    if (lines_.empty()) fail(0, "the table is empty", "its first line is id,codeword,cells");
    const std::size_t at = lines_[0].text.find_first_of(kSeparators);
    separator_ = at == std::string_view::npos ? ',' : lines_[0].text[at];
    head_ = fields_of(lines_[0].text, separator_);
    id_ = column("id");
    word_ = column("codeword");
    cells_ = column("cells");
    if (!id_ || !word_) {
      fail(lines_[0].number, "the table has no columns 'id' and 'codeword'",
           "name them in its first line: id,codeword,cells");
    }
    if (!cells_ && !options_.layout) {
      fail(lines_[0].number, "the table has no column 'cells', so the layout is unknown",
           "give it with --layout");
    }
  }

  void read_row(const TextLine& line) {
    const std::vector<std::string_view> fields = fields_of(line.text, separator_);
    if (fields.size() != head_.size()) {
      fail(line.number, fmt::format("{} fields in a table of {}", fields.size(), head_.size()),
           "complete the row");
    }
    if (fields[*id_] != fmt::format("{}", words_.size())) {
      fail(line.number, fmt::format("id '{}' where {} is due", fields[*id_], words_.size()),
           "list the tags in the order of their ids, from 0, without gaps");
    }
    words_.push_back(codeword(fields[*word_], line.number));
    row_lines_.push_back(line.number);
    if (cells_) tags_.push_back(cells(fields[*cells_], line.number));
  }

  Codeword codeword(std::string_view text, int line) const {
    std::string_view digits = text;
    if (digits.starts_with("0x") || digits.starts_with("0X")) digits.remove_prefix(2);
    Codeword word = 0;
    const auto [end, error] =
        std::from_chars(digits.data(), digits.data() + digits.size(), word, 16);
    if (error != std::errc() || end != digits.data() + digits.size()) {
      fail(line, fmt::format("'{}' is no codeword", text),
           "write up to 16 hex digits, like 0x0000000d7e00984b");
    }
    return word;
  }

  TagCells cells(std::string_view text, int line) const {
    std::vector<codec::Cell> cells;
    const std::size_t width = std::min(text.find('/'), text.size());
    bool square = width > 0 && text.size() == width * width + width - 1;
    for (std::size_t i = 0; i < text.size() && square; ++i) {
      if (i % (width + 1) == width) {
        square = text[i] == '/';
      } else if (text[i] == 'b' || text[i] == 'w' || text[i] == 'x') {
        cells.push_back(static_cast<codec::Cell>(text[i]));
      } else {
        square = false;
      }
    }
    if (!square || (!tags_.empty() && tags_[0].width() != static_cast<int>(width))) {
      fail(line, fmt::format("'{}' are not the cells of such a tag", text.substr(0, 80)),
           "write as many rows of b, w, x as each row has cells, with '/' between them");
    }
    return TagCells(static_cast<int>(width), std::move(cells));
  }

  /// The layout that the user names, or the first possible one in which the codewords are those
  /// that the cells show, or the first one.
  codec::Layout layout() const {
    if (options_.layout) return *options_.layout;
    try {
      const std::vector<codec::Layout> layouts = possible_layouts(tags_);
      const auto agreeing = std::find_if(layouts.begin(), layouts.end(), [&](const auto& layout) {
        return first_disagreement(layout) == words_.size();
      });
      return agreeing == layouts.end() ? layouts.front() : *agreeing;
    } catch (const std::invalid_argument& fault) {
      fail(row_lines_[0], fmt::format("the cells show no layout: {}", fault.what()),
           "give it with --layout");
    }
  }

  /// The first tag whose codeword its cells do not show in that layout, which fits the cells; the
  /// number of tags when there is none.
  std::size_t first_disagreement(const codec::Layout& layout) const {
    std::size_t id = 0;
    while (id < words_.size() && codec::codeword_of(layout, tags_[id]) == words_[id]) ++id;
    return id;
  }

  void compare_with_cells(const codec::Layout& layout) const {
    const std::size_t misfit = first_misfit(layout, tags_);
    if (misfit < tags_.size()) {
      fail(row_lines_[misfit], fmt::format("tag {} has other cells than the layout", misfit),
           "correct the cells, or the layout of --layout");
    }
    const std::size_t id = first_disagreement(layout);
    if (id == words_.size()) return;
    fail(row_lines_[id],
         fmt::format("tag {} is {}, but its cells show {}", id, codec::to_hex(words_[id]),
                     codec::to_hex(codec::codeword_of(layout, tags_[id]))),
         "correct one of them, or give the layout with --layout");
  }

  const FamilySource& source_;
  const FamilyReadOptions& options_;
  std::vector<TextLine> lines_;
  char separator_ = ',';
  std::vector<std::string_view> head_;
  std::optional<std::size_t> id_, word_, cells_;
  std::vector<Codeword> words_;
  std::vector<int> row_lines_;
  std::vector<TagCells> tags_;
};

ReadFamily read(const FamilySource& source, const FamilyReadOptions& options) {
  return TableReader(source, options).read();
}

std::vector<FamilyFile> make(const codec::Family& family, const std::string& target,
                             const FamilyWriteOptions&) {
  std::string content = "id,codeword,cells\n";
  const auto width = static_cast<std::size_t>(family.layout().width());
  content.reserve(family.size() * (32 + width * (width + 1)));
  for (codec::TagId id = 0; id < family.size(); ++id) {
    const Codeword word = family.codeword(id);
    fmt::format_to(std::back_inserter(content), "{},{},{}\n", id, codec::to_hex(word),
                   fmt::join(codec::tag_cells(family.layout(), word).rows(), "/"));
  }
  return {{target, std::move(content)}};
}

}  // namespace

FamilyKind csv_kind() {
  return {.name = "csv",
          .summary = "table of id, codeword and cells",
          .extensions = {".csv"},
          .recognises = recognises,
          .read = read,
          .make = make};
}

}  // namespace tagmint::io
