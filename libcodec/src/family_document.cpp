#include "family_document.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <nlohmann/json.hpp>
#include <set>

#include "counting_iterator.h"
#include "tagmint/codec/errors.h"

namespace tagmint::codec {
namespace {

using Json = nlohmann::json;

enum class Kind { Text, WholeNumber, Number, Code, List, Group };

/// What a key must hold. List elements have the list's path and "[]".
struct Field {
  std::string_view path;
  Kind kind;
};

constexpr std::array kFields = {
    Field{"", Kind::Group},
    Field{"format", Kind::Text},
    Field{"version", Kind::WholeNumber},
    Field{"name", Kind::Text},
    Field{"bits", Kind::WholeNumber},
    Field{"min_hamming", Kind::WholeNumber},
    Field{"layout", Kind::List},
    Field{"layout[]", Kind::Text},
    Field{"complexity", Kind::Group},
    Field{"complexity.rule", Kind::Text},
    Field{"complexity.threshold", Kind::Number},
    Field{"origin", Kind::Group},
    Field{"origin.method", Kind::Text},
    Field{"origin.order", Kind::Text},
    Field{"origin.seed", Kind::Text},
    Field{"origin.searched", Kind::Text},
    Field{"origin.program", Kind::Text},
    Field{"sha256", Kind::Text},
    Field{"codes", Kind::List},
    Field{"codes[]", Kind::Code},
    Field{"levels", Kind::List},
    Field{"levels[]", Kind::Group},
    Field{"levels[].codes", Kind::WholeNumber},
    Field{"levels[].min_hamming", Kind::WholeNumber},
    Field{"generator", Kind::Group},
};

const Field* find_field(std::string_view path) {
  const auto field =
      std::find_if(kFields.begin(), kFields.end(), [&](const Field& f) { return f.path == path; });
  return field == kFields.end() ? nullptr : &*field;
}

std::string_view kind_name(Kind kind) {
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

/// Takes the parser's events and fills a FamilyDocument.
class DocumentReader {
 public:
  DocumentReader(const std::string& source, const LineCount& count)
      : source_(source), count_(count) {}

  FamilyDocument take_document() {
    document_.last_line = count_.line;
    return std::move(document_);
  }

  // The events, as nlohmann's SAX interface names them. Each returns true: go on.
  bool null() { return refuse_unless_unknown("null"); }
  bool boolean(bool) { return refuse_unless_unknown("true or false"); }
  bool number_integer(Json::number_integer_t value) {
    const Field* const field = value_field();
    if (field == nullptr) return true;
    if (field->kind != Kind::Number) fail_kind(*field, fmt::format("{}", value));
    set_number(*field, static_cast<double>(value));
    return true;
  }
  bool number_unsigned(Json::number_unsigned_t value) {
    const Field* const field = value_field();
    if (field == nullptr) return true;
    if (field->kind == Kind::WholeNumber) {
      set_whole_number(*field, value);
    } else if (field->kind == Kind::Number) {
      set_number(*field, static_cast<double>(value));
    } else {
      fail_kind(*field, "a number");
    }
    return true;
  }
  bool number_float(Json::number_float_t value, const std::string& text) {
    const Field* const field = value_field();
    if (field == nullptr) return true;
    if (field->kind != Kind::Number) fail_kind(*field, text);
    set_number(*field, value);
    return true;
  }
  bool string(std::string& value) {
    const Field* const field = value_field();
    if (field == nullptr) return true;
    if (field->kind == Kind::Code) {
      add_code(value);
    } else if (field->kind == Kind::Text) {
      set_text(*field, value);
    } else {
      fail_kind(*field, "a string");
    }
    return true;
  }
  bool binary(Json::binary_t&) { return true; }  // never comes from text
  bool start_object(std::size_t) {
    open(Kind::Group);
    return true;
  }
  bool start_array(std::size_t) {
    open(Kind::List);
    return true;
  }
  bool key(std::string& name) {
    Frame& frame = frames_.back();
    if (!frame.known) return true;
    // Names with a path's own signs are none of ours.
    const bool plain = !name.empty() && name.find_first_of(".[]") == std::string::npos;
    const std::string path = frame.path.empty() ? name : frame.path + "." + name;
    frame.value = plain ? find_field(path) : nullptr;
    if (frame.value != nullptr && !frame.seen.insert(name).second) {
      fail(fmt::format("the key \"{}\" comes twice", name), "keep one of them");
    }
    return true;
  }
  bool end_object() {
    frames_.pop_back();
    return true;
  }
  bool end_array() {
    frames_.pop_back();
    return true;
  }
  bool parse_error(std::size_t, const std::string&, const Json::exception& error) {
    // "[json.exception...] parse error at line 1, column 2: REASON; last read: 'TEXT'; expected X".
    // The reason alone is short and free of the file's bytes.
    std::string_view reason = error.what();
    for (const std::string_view lead : {"] ", ": "}) {
      const std::size_t at = reason.find(lead);
      if (at != std::string_view::npos) reason.remove_prefix(at + lead.size());
    }
    reason = reason.substr(0, reason.find("; last read"));
    fail(fmt::format("this is not JSON: {}", reason), "a family file is one JSON object");
  }

 private:
  /// An open object or list.
  struct Frame {
    bool is_list = false;
    bool known = false;            // a field of ours, not something inside an unknown key
    std::string path;              // its own
    const Field* value = nullptr;  // the field that the next value fills; null = unknown
    std::set<std::string, std::less<>> seen;  // the known keys so far
  };

  [[noreturn]] void fail(std::string_view what, std::string_view mend) const {
    fail_in_line(what, source_, count_.line, mend);
  }

  [[noreturn]] void fail_kind(const Field& field, std::string_view found) const {
    if (field.path.empty()) {
      fail(fmt::format("a family file is one JSON object, this is {}", found),
           "see docs/family-format.md");
    }
    fail(fmt::format("\"{}\" holds {}", field.path, found),
         fmt::format("it must be {}", kind_name(field.kind)));
  }

  const Field* value_field() const { return frames_.empty() ? &kFields[0] : frames_.back().value; }

  bool refuse_unless_unknown(std::string_view found) const {
    if (const Field* const field = value_field()) fail_kind(*field, found);
    return true;
  }

  void open(Kind kind) {
    const Field* const field = value_field();
    Frame frame;
    frame.is_list = kind == Kind::List;
    if (field != nullptr) {
      if (field->kind != kind) fail_kind(*field, kind_name(kind));
      frame.known = true;
      frame.path = std::string(field->path);
      if (frame.is_list) frame.value = find_field(frame.path + "[]");
      begin(frame.path);
    }
    frames_.push_back(std::move(frame));
  }

  /// A known list or group starts here.
  void begin(std::string_view path) {
    const int line = count_.line;
    if (path == "layout") document_.layout = {{}, line};
    if (path == "codes") document_.codes = {{}, line};
    if (path == "levels") document_.levels = {{}, line};
    if (path == "levels[]") document_.levels->value.emplace_back();
    if (path == "generator") document_.generator = {true, line};
  }

  void set_text(const Field& field, const std::string& text) {
    const Placed<std::string> placed{text, count_.line};
    if (field.path == "format") document_.format = placed;
    if (field.path == "name") document_.name = placed;
    if (field.path == "layout[]") document_.layout->value.push_back(text);
    if (field.path == "complexity.rule") document_.complexity_rule = placed;
    if (field.path == "origin.method") document_.origin_method = text;
    if (field.path == "origin.order") document_.origin_order = text;
    if (field.path == "origin.seed") document_.origin_seed = text;
    if (field.path == "origin.searched") document_.origin_searched = text;
    if (field.path == "origin.program") document_.origin_program = text;
    if (field.path == "sha256") document_.sha256 = placed;
  }

  void set_whole_number(const Field& field, std::uint64_t number) {
    const Placed<std::uint64_t> placed{number, count_.line};
    if (field.path == "version") document_.version = placed;
    if (field.path == "bits") document_.bits = placed;
    if (field.path == "min_hamming") document_.min_hamming = placed;
    if (field.path == "levels[].codes") document_.levels->value.back().codes = placed;
    if (field.path == "levels[].min_hamming") document_.levels->value.back().min_hamming = placed;
  }

  void set_number(const Field& field, double number) {
    if (field.path == "complexity.threshold") {
      document_.complexity_threshold = {number, count_.line};
    }
  }

  void add_code(const std::string& text) {
    const std::size_t id = document_.code_lines.size();
    const std::optional<Codeword> code = parse_code(text);
    if (!code) {
      fail(fmt::format("codeword {} is \"{}\"", id, text.substr(0, 40)),
           "a codeword is 0x and 16 hex digits");
    }
    document_.codes->value.push_back(*code);
    document_.code_lines.push_back(count_.line);
  }

  const std::string& source_;
  const LineCount& count_;
  std::vector<Frame> frames_;
  FamilyDocument document_;
};

/// The text as one line of reasonable length: faults may quote whatever a file holds.
std::string printable(std::string_view text) {
  constexpr std::size_t kLongest = 300;
  std::string line;
  for (const char c : text.substr(0, kLongest)) {
    const auto code = static_cast<unsigned char>(c);
    line += code < 0x20 || code >= 0x7f ? fmt::format("\\x{:02x}", code) : std::string(1, c);
  }
  if (text.size() > kLongest) line += "...";
  return line;
}

}  // namespace

void fail_in_line(std::string_view what, const std::string& source, int line,
                  std::string_view mend) {
  throw InputError(printable(what), fmt::format("{}:{}", source, line), mend);
}

FamilyDocument parse_family_document(std::string_view json, const std::string& source) {
  LineCount count;
  DocumentReader reader(source, count);
  Json::sax_parse(CountingIterator(json.data(), &count),
                  CountingIterator(json.data() + json.size(), &count), &reader);
  return reader.take_document();
}

}  // namespace tagmint::codec
