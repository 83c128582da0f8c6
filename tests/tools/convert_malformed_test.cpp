// Malformed inputs of `tagmint convert`: one line with the place, and nothing is written.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "support/scratch_folder.h"
#include "support/tagmint_program.h"

namespace tagmint::test {
namespace {

namespace fs = std::filesystem;

/// A file of some kind, one replacement that spoils it, and the fault.
struct Spoilt {
  const char* file;
  const char* old;
  const char* now;
  const char* fault;  ///< "{}" stands for the file
};

class ConvertMalformed : public testing::TestWithParam<Spoilt> {};

TEST_P(ConvertMalformed, IsToldInOneLineWithItsPlace) {
  const Spoilt& spoilt = GetParam();
  const ScratchFolder folder;
  const std::string file = folder.file(spoilt.file);
  ASSERT_EQ(tagmint({"convert", "tag16h5", "-o", file}).exit_code, 0);
  std::string text = read_file(file);
  const std::size_t at = text.find(spoilt.old);
  ASSERT_NE(at, std::string::npos) << spoilt.old;
  text.replace(at, std::string(spoilt.old).size(), spoilt.now);
  write_file(file, text);
  expect_fault({"convert", file, "-o", folder.file("back.json")}, 3,
               fmt::format(fmt::runtime(spoilt.fault), file));
  EXPECT_FALSE(fs::exists(folder.file("back.json")));
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, ConvertMalformed,
    testing::Values(
        Spoilt{"a.json", "\"bits\":16", "\"bits\":17",
               "\"bits\" is 17, but the layout has 16 data cells ({}:5); correct one of them"},
        Spoilt{"a.c", "0x00000000000031b6ULL,", "0x00000000000031b6ULL;",
               "';' stands in the list 'codedata' ({}:12); a list holds whole numbers with commas "
               "between them"},
        Spoilt{"a.yml", "markersize: 4", "markersize: 9",
               "'markersize' is 9 ({}:4); it is a whole number from 1 to 8"},
        Spoilt{"a.yml", "nmarkers: 30", "nmarkers: 31",
               "'nmarkers' is 31, but 'marker_30' is missing ({}:3); get the file anew"},
        Spoilt{"a.yml", "nmarkers: 30", "nmarkers: 29",
               "'nmarkers' is 29, but there is 'marker_29' ({}:37); correct the number"},
        Spoilt{"a.yml", "marker_3: ", "marker_3 ",
               "'marker_3 \"1001110110100010\"' is no key with a value ({}:11); an OpenCV "
               "dictionary is one map of keys with numbers and quoted texts"},
        Spoilt{"a.yml", "marker_3: ", "marker_2: ",
               "the key 'marker_2' comes twice, first in line 10 ({}:11); an OpenCV dictionary is "
               "one map of keys with numbers and quoted texts"},
        Spoilt{"b.json.gz", "\x1f\x8b", "\x1f\x8a",
               "no known kind of family file ({}); the kinds are png, tagmint, opencv, rmsalinas, "
               "csv, apriltag-c; name the right one with --from"},
        Spoilt{"a.txt", "nbits 16", "nbits 17",
               "'nbits' is '17' ({}:2); it is the number of cells of a square, up to 64"},
        Spoilt{"a.txt", "\n0", "\n",
               "codeword 0 is '010001100011011' ({}:3); it is 16 characters 0 and 1"},
        Spoilt{"a.csv", "3,0x", "4,0x",
               "id '4' where 3 is due ({}:5); list the tags in the order of their ids, from 0, "
               "without gaps"},
        Spoilt{"a.csv", "3,0x", "3,0y",
               "'0y000000000000569c' is no codeword ({}:5); write up to 16 hex digits, like "
               "0x0000000d7e00984b"},
        Spoilt{"a.csv", "0x00000000000031b6", "0x00000000000031b7",
               "tag 1 is 0x00000000000031b7, but its cells show 0x00000000000031b6 ({}:3); correct "
               "one of them, or give the layout with --layout"},
        Spoilt{"a.csv", "wwwwwwww/wb", "wwwwwww/wb",
               "'wwwwwww/wbbbbbbw/wbbbwbbw/wbbbwwbw/wbbbbwbw/wbwbwwbw/wbbbbbbw/wwwwwwww' are not "
               "the cells of such a tag ({}:2); write as many rows of b, w, x as each row has "
               "cells, with '/' between them"}));

}  // namespace
}  // namespace tagmint::test
