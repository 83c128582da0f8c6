#include "family_document.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "counting_iterator.h"
#include "family_fields.h"
#include "tagmint/codec/errors.h"

namespace tagmint::codec {
namespace {

using Json = nlohmann::json;
using Kind = FamilyField::Kind;

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
    const FamilyField* const field = value_field();
    if (field == nullptr) return true;
    if (field->kind != Kind::Number) fail_kind(*field, fmt::format("{}", value));
    set_number(*field, static_cast<double>(value));
    return true;
  }
  bool number_unsigned(Json::number_unsigned_t value) {
    const FamilyField* const field = value_field();
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
    const FamilyField* const field = value_field();
    if (field == nullptr) return true;
    if (field->kind != Kind::Number) fail_kind(*field, text);
    set_number(*field, value);
    return true;
  }
  bool string(std::string& value) {
    const FamilyField* const field = value_field();
    if (field == nullptr) return true;
    if (field->kind == Kind::Code) {
      add_code(*field, value);
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
    frame.value = plain ? find_family_field(path) : nullptr;
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
    fail(fmt::format("this is not JSON: {}", reason),
         "a family file is one JSON object; `tagmint convert` makes one of other programs' files");
  }

 private:
  /// An open object or list.
  struct Frame {
    bool is_list = false;
    bool known = false;                  // a field of ours, not something inside an unknown key
    std::string path;                    // its own
    const FamilyField* value = nullptr;  // the field that the next value fills; null = unknown
    std::set<std::string, std::less<>> seen;  // the known keys so far
  };

  [[noreturn]] void fail(std::string_view what, std::string_view mend) const {
    fail_in_line(what, source_, count_.line, mend);
  }

  [[noreturn]] void fail_kind(const FamilyField& field, std::string_view found) const {
    if (field.path.empty()) {
      fail(fmt::format("a family file is one JSON object, this is {}", found),
           "see docs/family-format.md");
    }
    fail(fmt::format("\"{}\" holds {}", field.path, found),
         fmt::format("it must be {}", kind_name(field.kind)));
  }

  const FamilyField* value_field() const {
    return frames_.empty() ? find_family_field("") : frames_.back().value;
  }

  bool refuse_unless_unknown(std::string_view found) const {
    if (const FamilyField* const field = value_field()) fail_kind(*field, found);
    return true;
  }

  void open(Kind kind) {
    const FamilyField* const field = value_field();
    Frame frame;
    frame.is_list = kind == Kind::List;
    if (field != nullptr) {
      if (field->kind != kind) fail_kind(*field, kind_name(kind));
      frame.known = true;
      frame.path = std::string(field->path);
      if (frame.is_list) frame.value = find_family_field(frame.path + "[]");
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
    if (path == "generator") document_.generator = {{}, line};
    if (path == "generator.basis") document_.generator->value.basis.emplace();
    if (path == "generator.cosets") document_.generator->value.cosets.emplace();
    if (path == "generator.levels") document_.generator->value.levels.emplace();
    if (path == "generator.levels[]") document_.generator->value.levels->emplace_back();
  }

  void set_text(const FamilyField& field, const std::string& text) {
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

  void set_whole_number(const FamilyField& field, std::uint64_t number) {
    const Placed<std::uint64_t> placed{number, count_.line};
    if (field.path == "version") document_.version = placed;
    if (field.path == "bits") document_.bits = placed;
    if (field.path == "min_hamming") document_.min_hamming = placed;
    if (field.path == "levels[].codes") document_.levels->value.back().codes = placed;
    if (field.path == "levels[].min_hamming") document_.levels->value.back().min_hamming = placed;
    if (field.path == "levels[].plain") document_.levels->value.back().plain = placed;
    if (field.path == "generator.levels[].dimension") {
      document_.generator->value.levels->back().dimension = placed;
    }
    if (field.path == "generator.levels[].cosets") {
      document_.generator->value.levels->back().cosets = placed;
    }
  }

  void set_number(const FamilyField& field, double number) {
    if (field.path == "complexity.threshold") {
      document_.complexity_threshold = {number, count_.line};
    }
  }

  void add_code(const FamilyField& field, const std::string& text) {
    const std::optional<Codeword> code = parse_code(text);
    const bool listed = field.path == "codes[]";
    if (!code) {
      const std::string place = listed ? fmt::format("codeword {}", document_.code_lines.size())
                                       : fmt::format("\"{}\"", field.path);
      fail(fmt::format("{} is \"{}\"", place, text.substr(0, 40)),
           "a codeword is 0x and 16 hex digits");
    }
    if (listed) {
      document_.codes->value.push_back(*code);
      document_.code_lines.push_back(count_.line);
    }
    if (field.path == "generator.basis[]") document_.generator->value.basis->push_back(*code);
    if (field.path == "generator.translation") document_.generator->value.translation = *code;
    if (field.path == "generator.cosets[]") document_.generator->value.cosets->push_back(*code);
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
