#include <fmt/format.h>

#include <filesystem>
#include <iterator>

#include "io/family_kinds/apriltag_c.h"
#include "io/family_kinds/family_note.h"
#include "tagmint/codec/layout_presets.h"
#include "tagmint/codec/version.h"

namespace tagmint::io {
namespace {

using codec::Family;

/// The text as a name of C: letters, digits and '_', not a digit first.
std::string identifier(const std::string& text) {
  std::string name = text[0] >= '0' && text[0] <= '9' ? "tag" + text : text;
  for (char& c : name) {
    if (c == '-' || c == '.') c = '_';
  }
  return name;
}

std::string guard(const std::string& function) {
  std::string name = "TAGMINT_" + function + "_H";
  for (char& c : name) {
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  }
  return name;
}

/// "587 tags of 36 bits, at least 11 bits apart, layout classic:10; the first 587 of 600"
std::string description(const Family& family, const FamilyWriteOptions& options) {
  std::string text =
      fmt::format("{} tags of {} bits, at least {} bits apart, layout {}", family.size(),
                  family.bits(), family.min_hamming(), codec::layout_name(family.layout()));
  if (options.codes_before_cut > 0) {
    text += fmt::format("; the first {} of {} tags", family.size(), options.codes_before_cut);
  }
  return text;
}

std::string header(const Family& family, const FamilyWriteOptions& options) {
  const std::string function = identifier(family.name());
  return fmt::format(
      "// The tag family {name} for libapriltag: {description}.\n"
      "// Written by tagmint {version}.\n"
      "#ifndef {guard}\n"
      "#define {guard}\n"
      "\n"
      "// Beside libapriltag's own files, or with its headers installed in a folder apriltag.\n"
      "#if defined(__has_include)\n"
      "#if __has_include(\"apriltag.h\")\n"
      "#include \"apriltag.h\"\n"
      "#else\n"
      "#include <apriltag/apriltag.h>\n"
      "#endif\n"
      "#else\n"
      "#include \"apriltag.h\"\n"
      "#endif\n"
      "\n"
      "#ifdef __cplusplus\n"
      "extern \"C\" {{\n"
      "#endif\n"
      "\n"
      "apriltag_family_t *{function}_create(void);\n"
      "void {function}_destroy(apriltag_family_t *tf);\n"
      "\n"
      "#ifdef __cplusplus\n"
      "}}\n"
      "#endif\n"
      "\n"
      "#endif\n",
      fmt::arg("name", family.name()), fmt::arg("description", description(family, options)),
      fmt::arg("version", codec::kVersion), fmt::arg("guard", guard(function)),
      fmt::arg("function", function));
}

std::string code_table(const Family& family) {
  std::string table = fmt::format("static uint64_t codedata[{}] = {{\n", family.size());
  table.reserve(table.size() + family.size() * 25);
  for (const codec::Codeword word : family.codewords()) {
    fmt::format_to(std::back_inserter(table), "   0x{:016x}ULL,\n", word);
  }
  return table + "};\n";
}

/// Where each bit is, from the most significant: cells from the border square's top left corner.
std::string bit_places(const Family& family) {
  std::string lines;
  const int offset = family.layout().border_offset();
  int bit = 0;
  for (const codec::CellPosition cell : family.layout().data_cells()) {
    fmt::format_to(std::back_inserter(lines),
                   "   tf->bit_x[{0}] = {1};\n   tf->bit_y[{0}] = {2};\n", bit++, cell.x - offset,
                   cell.y - offset);
  }
  return lines;
}

std::string source(const Family& family, const std::string& header_name,
                   const FamilyWriteOptions& options) {
  return fmt::format(
      "// The tag family {name} for libapriltag: {description}.\n"
      "// Written by tagmint {version}. The next line lets tagmint read all of it back.\n"
      "// {mark}{note}\n"
      "#include \"{header}\"\n"
      "\n"
      "#include <stdint.h>\n"
      "#include <stdlib.h>\n"
      "#include <string.h>\n"
      "\n"
      "{codes}"
      "\n"
      "apriltag_family_t *{function}_create(void)\n"
      "{{\n"
      "   apriltag_family_t *tf = (apriltag_family_t *)calloc(1, sizeof(apriltag_family_t));\n"
      "   tf->name = strdup(\"{name}\");\n"
      "   tf->h = {distance};\n"
      "   tf->ncodes = {size};\n"
      "   tf->codes = codedata;\n"
      "   tf->nbits = {bits};\n"
      "   tf->bit_x = (uint32_t *)calloc({bits}, sizeof(uint32_t));\n"
      "   tf->bit_y = (uint32_t *)calloc({bits}, sizeof(uint32_t));\n"
      "{places}"
      "   tf->width_at_border = {at_border};\n"
      "   tf->total_width = {total};\n"
      "   tf->reversed_border = {reversed};\n"
      "   return tf;\n"
      "}}\n"
      "\n"
      "void {function}_destroy(apriltag_family_t *tf)\n"
      "{{\n"
      "   free(tf->bit_x);\n"
      "   free(tf->bit_y);\n"
      "   free(tf->name);\n"
      "   free(tf);\n"
      "}}\n",
      fmt::arg("name", family.name()), fmt::arg("description", description(family, options)),
      fmt::arg("version", codec::kVersion), fmt::arg("mark", kNoteMark),
      fmt::arg("note", family_note(family)), fmt::arg("header", header_name),
      fmt::arg("codes", code_table(family)), fmt::arg("function", identifier(family.name())),
      fmt::arg("distance", family.min_hamming()), fmt::arg("size", family.size()),
      fmt::arg("bits", family.bits()), fmt::arg("places", bit_places(family)),
      fmt::arg("at_border", family.layout().width_at_border()),
      fmt::arg("total", family.layout().width()),
      fmt::arg("reversed", family.layout().reversed_border()));
}

bool recognises_apriltag_c(const FamilySource& source) {
  if (source.is_folder) return false;
  for (const char* mark : {"apriltag_family_t", "codedata", "TagCodes", "TagFamily"}) {
    if (source.content.find(mark) != std::string::npos) return true;
  }
  return false;
}

}  // namespace

std::vector<FamilyFile> make_apriltag_c(const Family& family, const std::string& target,
                                        const FamilyWriteOptions& options) {
  // The header first: a source whose header is missing does not compile.
  std::filesystem::path path = target;
  const std::filesystem::path header_path = path.replace_extension(".h");
  const std::filesystem::path source_path = path.replace_extension(".c");
  return {{header_path.string(), header(family, options)},
          {source_path.string(), source(family, header_path.filename().string(), options)}};
}

FamilyKind apriltag_c_kind() {
  return {.name = "apriltag-c",
          .summary = "C source for libapriltag, NAME.c and NAME.h",
          .extensions = {".c", ".h"},
          .one_file = false,
          .most_codes = kMostLibapriltagCodes,
          .limit_reason = "libapriltag holds no more",
          .recognises = recognises_apriltag_c,
          .read = read_apriltag_c,
          .make = make_apriltag_c};
}

}  // namespace tagmint::io
