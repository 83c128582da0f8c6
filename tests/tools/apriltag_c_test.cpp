// C source of tag families: as tagmint writes it, and as users have it.
#include "io/family_kinds/apriltag_c.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "io/family_kinds/data_square.h"
#include "io/family_kinds/family_changes.h"
#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/errors.h"
#include "tagmint/codec/layout_presets.h"

namespace tagmint::io {
namespace {

using codec::Family;

FamilySource source_of(const std::string& content) {
  return {.path = "my.c", .name = "my.c", .content = content};
}

ReadFamily read(const std::string& content, const FamilyReadOptions& options = {}) {
  return read_apriltag_c(source_of(content), options);
}

std::string fault_of(const std::string& content, const FamilyReadOptions& options = {}) {
  try {
    read(content, options);
    return "no fault";
  } catch (const codec::InputError& fault) {
    return fault.what();
  }
}

std::string replaced(std::string text, std::string_view old, std::string_view now) {
  for (std::size_t at = 0; (at = text.find(old, at)) != std::string::npos; at += now.size()) {
    text.replace(at, old.size(), now);
  }
  return text;
}

void expect_same_tags(const Family& read, const Family& expected) {
  EXPECT_EQ(read.layout(), expected.layout());
  EXPECT_EQ(read.min_hamming(), expected.min_hamming());
  EXPECT_TRUE(std::ranges::equal(read.codewords(), expected.codewords()));
}

/// The source that tagmint writes, without its note: as if libapriltag's own authors had.
std::string plain_source(const Family& family) {
  std::string source = make_apriltag_c(family, "my.c", {}).back().content;
  source.erase(0, source.find("#include"));
  return source;
}

TEST(AprilTagC, FieldsAreThoseOfTheDetector) {
  const std::string source =
      make_apriltag_c(*codec::find_family("tagStandard41h12"), "dir/my.h", {}).back().content;
  for (const char* line :
       {"#include \"my.h\"\n", "static uint64_t codedata[2115] = {\n",
        "apriltag_family_t *tagStandard41h12_create(void)\n",
        "   tf->name = strdup(\"tagStandard41h12\");\n", "   tf->h = 12;\n",
        "   tf->ncodes = 2115;\n", "   tf->codes = codedata;\n", "   tf->nbits = 41;\n",
        "   tf->bit_x[0] = -2;\n   tf->bit_y[0] = -2;\n",
        "   tf->bit_x[40] = 2;\n   tf->bit_y[40] = 2;\n", "   tf->width_at_border = 5;\n",
        "   tf->total_width = 9;\n", "   tf->reversed_border = true;\n",
        "void tagStandard41h12_destroy(apriltag_family_t *tf)\n"}) {
    EXPECT_NE(source.find(line), std::string::npos) << line;
  }
}

TEST(AprilTagC, NamesThatAreNoNamesOfCAreMadeSome) {
  const Family family = renamed(*codec::find_family("tag16h5"), "3d-tags.v2");
  const std::string source = make_apriltag_c(family, "my.c", {}).back().content;
  EXPECT_NE(source.find("*tag3d_tags_v2_create(void)"), std::string::npos);
  EXPECT_NE(source.find("strdup(\"3d-tags.v2\")"), std::string::npos);
  EXPECT_EQ(read(source).family.name(), "3d-tags.v2");
}

TEST(AprilTagC, WithoutTheNoteLayoutAndTagsAreTheSame) {
  for (const std::string& name : codec::family_names()) {
    const codec::SharedFamily whole = codec::find_family(name);
    const Family family = first_tags(*whole, std::min<std::size_t>(whole->size(), 500));
    const ReadFamily back = read(plain_source(family));
    expect_same_tags(back.family, family);
    EXPECT_EQ(back.family.name(), name);
    EXPECT_TRUE(back.notes.empty());
  }
}

TEST(AprilTagC, NoteOfOtherCodewordsIsPassedOver) {
  const Family family = *codec::find_family("tag16h5");
  const std::string source = make_apriltag_c(family, "my.c", {}).back().content;
  const ReadFamily back = read(replaced(source, "0x00000000000027c8", "0x00000000000027c9"));
  EXPECT_EQ(back.family.codeword(0), 0x27c9U);
  EXPECT_EQ(back.family.complexity().rule, codec::ComplexityRule::None);
  ASSERT_EQ(back.notes.size(), 1U);
  EXPECT_EQ(back.notes[0],
            "the note that tagmint left in the file does not belong to it; passed over");
}

TEST(AprilTagC, FormattingMayVary) {
  const Family family = *codec::find_family("tag16h5");
  const std::string source = plain_source(family);
  const std::string one_line = replaced(source, "\n   0x", " 0x");
  const std::string decimal = [&] {
    std::string text = source;
    for (const codec::Codeword word : family.codewords()) {
      text = replaced(text, fmt::format("0x{:016x}ULL", word), fmt::format("{}", word));
    }
    return text;
  }();
  const std::vector<std::string> variants = {
      one_line,
      decimal,
      replaced(source, "ULL", ""),
      replaced(source, "ULL", "UL"),
      replaced(source, "ULL,\n", "u /* {1, 2} \" */, // };\n"),
      replaced(source, "ULL,", "ll, "),
      replaced(replaced(source, "0x", "UINT64_C(0x"), "ULL", ")"),
      replaced(source, "0x00000000000027c8", "0X27C8"),
      replaced(source, "codedata[30]", "codedata[]"),
      replaced(source, "codedata[30]", "codedata[NCODES]"),
      replaced(source, "static uint64_t", "static const uint64_t"),
      replaced(source, "\n", "\r\n"),
      replaced(source, "tf->", "tf -> "),
      replaced(source, "tf->bit_x", "fam.bit_x"),
      replaced(source, "(void)", "()"),
      replaced(source, "tf->ncodes = 30;", "tf->ncodes = sizeof(codedata) / sizeof(codedata[0]);"),
      replaced(source, "#include", "#define A { 7 } \\\n  { 8 }\n#include"),
      replaced(source, "reversed_border = false", "reversed_border = 0"),
  };
  for (std::size_t i = 0; i < variants.size(); ++i) {
    SCOPED_TRACE(i);
    expect_same_tags(read(variants[i]).family, family);
  }
}

TEST(AprilTagC, BitsInAnotherOrderAreMappedByTheirPlaces) {
  // The same tags, listed row by row with the places of each bit.
  const Family family = *codec::find_family("tag25h9");
  const DataSquare square(family.layout());
  std::string source = "static uint64_t codedata[] = {";
  for (const codec::Codeword word : family.codewords()) {
    source += fmt::format("{:#x},", square.rows_of(word));
  }
  source += "};\napriltag_family_t *tag25h9_create() {\n  tf->h = 9; tf->nbits = 25;\n";
  for (int bit = 0; bit < 25; ++bit) {
    source +=
        fmt::format("tf->bit_x[{0}] = {1}; tf->bit_y[{0}] = {2};\n", bit, bit % 5 + 1, bit / 5 + 1);
  }
  source += "tf->width_at_border = 7; tf->total_width = 9; tf->reversed_border = false; }\n";
  expect_same_tags(read(source).family, family);
}

/// tag36h11's table as AprilTag programs before version 3 had it.
std::vector<codec::Codeword> old_36h11() {
  const codec::SharedFamily family = codec::find_family("tag36h11");
  const DataSquare square(family->layout());
  std::vector<codec::Codeword> rows;
  for (const codec::Codeword word : family->codewords()) rows.push_back(square.rows_of(word));
  return rows;
}

TEST(AprilTagC, OldTablesAreRowByRow) {
  // The first and the last word of the table that was published with AprilTag.
  const std::vector<codec::Codeword> rows = old_36h11();
  EXPECT_EQ(rows.front(), 0xd5d628584U);
  EXPECT_EQ(rows.back(), 0xe83be4b73U);
  std::string c =
      "apriltag_family_t *tag36h11_create()\n{\n   tf->name = strdup(\"tag36h11\");\n"
      "   tf->black_border = 1;\n   tf->d = 6;\n   tf->h = 11;\n   tf->ncodes = 587;\n"
      "   tf->codes = calloc(587, sizeof(uint64_t));\n";
  std::string cxx = "const unsigned long long t36h11[] =\n  { ";
  std::string java =
      "public class Tag36h11 extends TagFamily { public Tag36h11() { super(36, 11, "
      "new long[] { ";
  for (std::size_t id = 0; id < rows.size(); ++id) {
    c += fmt::format("   tf->codes[{}] = 0x{:016x}UL;\n", id, rows[id]);
    cxx += fmt::format("{:#x}LL, ", rows[id]);
    java += fmt::format("{:#x}L, ", rows[id]);
  }
  c += "   return tf;\n}\n";
  cxx +=
      "};\nstatic const TagCodes tagCodes36h11 = TagCodes(36, 11, t36h11, sizeof(t36h11)/"
      "sizeof(t36h11[0]));\n";
  java += "}); } }\n";
  for (const std::string& source : {c, cxx, java}) {
    const ReadFamily back = read(source);
    expect_same_tags(back.family, *codec::find_family("tag36h11"));
    ASSERT_EQ(back.notes.size(), 1U);
    EXPECT_TRUE(
        back.notes[0].starts_with("no places of bits, so the codewords are read row by "
                                  "row"));
  }
}

TEST(AprilTagC, BitOrderOfABareTableCanBeGiven) {
  const codec::SharedFamily family = codec::find_family("tagCircle21h7");
  std::string source = "uint64_t codedata[] = {\n";
  for (const codec::Codeword word : family->codewords()) source += fmt::format("{:#x},\n", word);
  source += "};\n";
  const ReadFamily back =
      read(source, {.layout = family->layout(), .bit_order = BitOrder::QuarterBlocks});
  expect_same_tags(back.family, *family);
  EXPECT_EQ(fault_of(source, {.layout = family->layout()}),
            "the file does not say where the bits are (my.c:1); a table in the layout's own order "
            "is read with --bit-order quarter-blocks");
  EXPECT_EQ(fault_of(source),
            "the file does not say how many bits a codeword has (my.c:1); give the layout with "
            "--layout");
}

TEST(AprilTagC, TwoBlackCellsOfBorderAreKept) {
  const ReadFamily back = read(
      "tf->black_border = 2; tf->d = 3; tf->h = 1; static uint64_t codedata[] = {0x1, 0x7, 0x3};",
      {.name = "kalibr"});
  EXPECT_EQ(back.family.layout(),
            codec::parse_layout("custom:wwwwwwwww/wbbbbbbbw/wbbbbbbbw/wbbdddbbw/wbbdddbbw/"
                                "wbbdddbbw/wbbbbbbbw/wbbbbbbbw/wwwwwwwww"));
}

TEST(AprilTagC, FaultsAreToldWithTheirLine) {
  const std::string good = plain_source(*codec::find_family("tag16h5"));
  const auto bad = [&](std::string_view old, std::string_view now) {
    EXPECT_NE(good.find(old), std::string::npos) << old;
    return fault_of(replaced(good, old, now));
  };
  EXPECT_EQ(bad("0x00000000000027c8ULL", "0x127c8"),
            "codeword 0 is 0x127c8, which has more than 16 bits (my.c:8); correct it");
  EXPECT_EQ(bad("0x00000000000031b6ULL", "0x27c8"),
            "codeword 1 repeats codeword 0 (my.c:9); a family holds each once; remove one of them");
  EXPECT_EQ(bad("0x00000000000027c8ULL", "0x27g8"),
            "'0x27g8' is not a whole number (my.c:8); write it like 0x1d5c6");
  EXPECT_EQ(bad("0x00000000000027c8ULL", "0x100000000000027c8"),
            "0x100000000000027c8 has more than 64 bits (my.c:8); correct it");
  EXPECT_EQ(bad("0x00000000000027c8ULL", "\"0x27c8\""),
            "there is no list of codewords (my.c); "
            "give the file with the numbers: NAME.c, not NAME.h");
  EXPECT_EQ(bad("0x00000000000031b6ULL", "x"),
            "'x' stands in the list 'codedata' (my.c:9); a list holds whole numbers with commas "
            "between them");
  EXPECT_EQ(bad("tf->ncodes = 30;", "tf->ncodes = 31;"),
            "31 codewords are declared, 30 are listed (my.c:45); get the file anew");
  EXPECT_EQ(bad("codedata[30]", "codedata[29]"),
            "29 codewords are declared, 30 are listed (my.c:7); get the file anew");
  EXPECT_EQ(bad("   tf->bit_x[3] = 2;\n", ""),
            "bit_x[4] comes where bit_x[3] is due (my.c:57); list all items in their order, each "
            "once");
  EXPECT_EQ(bad("bit_x[3] = 2;", "bit_x[3] = 1;"),
            "two bits at (1, 2) (my.c:83); correct the file");
  EXPECT_EQ(bad("bit_x[3] = 2;", "bit_x[3] = 9;"),
            "the bit at (9, 2) lies outside of the tag (my.c:83); correct the file");
  EXPECT_EQ(bad("bit_x[0] = 1;", "bit_x[0] = 0;"),
            "a bit lies in the border of the tag (my.c:83); correct the file");
  EXPECT_EQ(bad("tf->total_width = 8;", "tf->total_width = 7;"),
            "a border square 6 cells wide in a tag 7 cells wide cannot be (my.c:83); correct the "
            "file");
  EXPECT_EQ(bad("tf->h = 5;", "tf->h = 0;"),
            "a distance of 0 cannot be (my.c:44); with 16 bits it is 1 to 16");
  EXPECT_EQ(bad("tf->nbits = 16;", "tf->nbits = 17;"),
            "17 bits, but 16 places bit_x and 16 places bit_y (my.c:51); give each bit its place");
  EXPECT_EQ(bad("   tf->total_width = 8;\n", ""),
            "'total_width' is not set (my.c); give a whole source file");
}

TEST(AprilTagC, SourceThatEndsTooEarlyOrHoldsTwoFamiliesIsRefused) {
  const std::string good = plain_source(*codec::find_family("tag16h5"));
  EXPECT_EQ(fault_of(good.substr(0, good.find("31b6"))),
            "the list 'codedata' has no end (my.c:9); a list holds whole numbers with commas "
            "between them");
  EXPECT_EQ(fault_of("/* " + good), "a comment begins here and does not end (my.c:1); complete it");
  EXPECT_EQ(fault_of(good + "char *x = \"abc\n"),
            "a text begins here and does not end (my.c:95); complete it");
  EXPECT_EQ(fault_of(good + good),
            "a second list 'codedata' of numbers (my.c:101); give a file with one family");
  EXPECT_EQ(fault_of("#include \"apriltag.h\"\napriltag_family_t *tag36h11_create();\n"),
            "there is no list of codewords (my.c); give the file with the numbers: NAME.c, not "
            "NAME.h");
}

}  // namespace
}  // namespace tagmint::io
