// `tagmint sheet` from outside: kinds of files, reading back, trial runs, bad places.
#include <gtest/gtest.h>
#include <sys/mount.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <string>
#include <vector>

#include "draw/read_back.h"
#include "support/scratch_folder.h"
#include "support/tagmint_program.h"

namespace tagmint {
namespace {

using test::ProgramResult;
using test::read_file;
using test::ScratchFolder;

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// `tagmint sheet` into a folder of its own.
class SheetKinds : public testing::Test {
 protected:
  ProgramResult sheet(std::vector<std::string> arguments, const std::string& output) const {
    arguments.insert(arguments.begin(), "sheet");
    arguments.insert(arguments.end(), {"-o", folder_.file(output)});
    return test::tagmint(arguments);
  }
  /// Expects one line on stderr, that exit code, and an empty folder.
  void refused(const std::vector<std::string>& arguments, const std::string& output, int code,
               const std::string& part) const {
    const ProgramResult result = sheet(arguments, output);
    EXPECT_EQ(result.exit_code, code) << result.err;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    EXPECT_TRUE(has(result.err, part)) << result.err;
    EXPECT_TRUE(folder_.names().empty()) << folder_.names()[0];
  }

  ScratchFolder folder_;
};

TEST_F(SheetKinds, TheExtensionTellsTheKind) {
  const std::vector<std::pair<std::string, std::string>> starts = {{"a.pdf", "%PDF-1.7"},
                                                                   {"a.svg", "<?xml"},
                                                                   {"a.png", "\x89PNG"},
                                                                   {"a.tif", "II*"},
                                                                   {"a.tiff", "II*"},
                                                                   {"a.ps", "%!PS-Adobe-3.0\n"},
                                                                   {"a.eps", "%!PS-Adobe-3.0 EPSF"},
                                                                   {"a.dxf", "0\nSECTION"}};
  for (const auto& [name, start] : starts) {
    const ProgramResult result = sheet({"tag16h5:20mm:0-3", "--quiet"}, name);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.err, "") << name;
    EXPECT_TRUE(read_file(folder_.file(name)).starts_with(start)) << name;
  }
}

TEST_F(SheetKinds, StdoutHoldsWhatTheFileWouldHold) {
  EXPECT_EQ(sheet({"tag16h5:20mm:0-3"}, "a.pdf").exit_code, 0);
  const ProgramResult result =
      test::tagmint({"sheet", "tag16h5:20mm:0-3", "--format", "pdf", "-o", "-"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_TRUE(result.out == read_file(folder_.file("a.pdf")));
}

TEST_F(SheetKinds, ADryRunTellsPagesAndWritesNothing) {
  const ProgramResult result =
      sheet({"tag36h11:40mm:0-14", "tag16h5:20mm:3", "--dry-run"}, "a.pdf");
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.err, "");
  EXPECT_EQ(result.out, folder_.file("a.pdf") +
                            ": 16 tags on 2 pages of 210 mm x 297 mm\n"
                            "  tag36h11: 15 tags, edge 40 mm, outer 50 mm; a page takes 3 x 4\n"
                            "  tag16h5: 1 tag, edge 20 mm, outer 26.667 mm; a page takes 6 x 7\n"
                            "  page 1: tag36h11 0-11\n"
                            "  page 2: tag36h11 12-14; tag16h5 3\n");
  const ProgramResult files = sheet({"tag36h11:40mm:0-14", "--dry-run"}, "{id}.svg");
  EXPECT_EQ(files.out, folder_.file("{id}.svg") +
                           ": 15 files of one tag each\n"
                           "  tag36h11: 15 tags, edge 40 mm, outer 50 mm\n");
  EXPECT_TRUE(folder_.names().empty());
}

TEST_F(SheetKinds, PicturesHaveWholeDotsACellAndSaySo) {
  const ProgramResult result = sheet({"tag36h11:40mm:0", "--dpi", "300"}, "a.png");
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_TRUE(has(result.err,
                  "edge 39.963 mm, outer 49.953 mm (59 dots a cell; edge 40 mm asked, "
                  "-0.09 %)"))
      << result.err;
  EXPECT_FALSE(has(result.err, "warning"));
  const ProgramResult far = sheet({"tag36h11:12mm:0", "--dpi", "300"}, "b.png");
  EXPECT_TRUE(has(far.err,
                  "warning: tag36h11: whole dots a cell at 300 dpi make the edge 12.192 mm "
                  "instead of 12 mm, +1.6 %"))
      << far.err;
  const ProgramResult exact = sheet({"tag36h11:40mm:0", "--dpi", "300", "--exact"}, "c.png");
  EXPECT_TRUE(has(exact.err, "a cell of 5 mm is 59.055 dots at 300 dpi")) << exact.err;
  EXPECT_TRUE(has(exact.err, "edge 40 mm, outer 50 mm;")) << exact.err;
}

TEST_F(SheetKinds, NarrowQuietZonesAreWarnedOf) {
  EXPECT_TRUE(has(sheet({"tagStandard41h12:40mm:0", "--quiet-zone", "0.5"}, "a.pdf").err,
                  "warning: tagStandard41h12: a quiet zone of 0.5 cells is less than one"));
  EXPECT_FALSE(has(sheet({"tag36h11:40mm:0", "--quiet-zone", "0.5"}, "b.pdf").err, "warning"));
  EXPECT_FALSE(
      has(sheet({"tagStandard41h12:40mm:0", "--quiet-zone", "2"}, "c.pdf").err, "warning"));
}

TEST_F(SheetKinds, TheRulerGoesWhereThePageHasNoRoom) {
  const std::vector<std::string> small = {"tag36h11:40mm:0", "--paper", "60x70mm", "--margin",
                                          "3mm"};
  const ProgramResult result = sheet(small, "a.pdf");
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(has(result.err, "no room for a ruler")) << result.err;
  std::vector<std::string> asked = small;
  asked.emplace_back("--ruler");
  EXPECT_EQ(sheet(asked, "b.pdf").exit_code, 2);
}

TEST_F(SheetKinds, LandscapeIsWide) {
  for (const char* paper : {"a5", "148x210mm", "210x148mm"}) {
    EXPECT_TRUE(has(sheet({"tag36h11:40mm:0", "--paper", paper, "--landscape"}, "a.pdf").err,
                    "of 210 mm x 148 mm"))
        << paper;
  }
  EXPECT_TRUE(
      has(sheet({"tag36h11:40mm:0", "--paper", "tabloid"}, "a.pdf").err, "of 279.4 mm x 431.8 mm"));
}

TEST_F(SheetKinds, ReadsBackWhatItWrote) {
  std::vector<std::vector<std::string>> runs = {
      {"a.png", "tag36h11:14mm:0-9"},
      {"b.tif", "tagCircle21h7:2mm:0-30", "--dpi", "600", "--depth", "1", "--label", "none"},
      {"i.png", "tag16h5:7.7mm:0-9", "--dpi", "200", "--depth", "1", "--exact"},
      {"c.png", "tagCustom48h12:8mm:42200-42210", "--ground", "none"},
      {"d.png", "rot48:8mm:4000000-4000003", "--invert"},
      {"{id}.png", "tagStandard52h13:20mm:48700-48713"}};
  if (draw::can_read_back(draw::FileKind::Pdf)) {
    runs.push_back({"e.pdf", "tag36h11:14mm:0-30", "tagCircle49h12:12mm:5", "--color", "k"});
    runs.push_back({"f.pdf", "tagStandard41h12:15mm:0-3", "--invert", "--cut-lines", "square"});
  }
  if (draw::can_read_back(draw::FileKind::Svg)) {
    runs.push_back({"g{page}.svg", "tag25h9:30mm:0-7", "--cut-lines", "rounded"});
    runs.push_back({"h.svg", "tagCircle49h12:12mm:0-3", "--cut-lines", "circle"});
  }
  for (std::vector<std::string>& words : runs) {
    const std::string output = words.front();
    words.erase(words.begin());
    words.emplace_back("--verify");
    if (!output.starts_with("{")) words.insert(words.end(), {"--paper", "a6"});
    const ProgramResult result = sheet(words, output);
    EXPECT_EQ(result.exit_code, 0) << output << ": " << result.err;
    EXPECT_TRUE(has(result.err, "read back: all ")) << result.err;
  }
}

TEST_F(SheetKinds, WhatDoesNotReadBackIsNotLeftThere) {
  // Five dots an inch: less than one a cell.
  const std::string path = folder_.file("a.png");
  const ProgramResult result = sheet(
      {"tagStandard41h12:20mm:4-6", "--dpi", "5", "--exact", "--verify", "--no-ruler"}, "a.png");
  EXPECT_EQ(result.exit_code, 4);
  EXPECT_TRUE(has(result.err, "tagStandard41h12 id 4 on page 1 is not found (" + path + ")"))
      << result.err;
  EXPECT_TRUE(folder_.names().empty());
}

TEST_F(SheetKinds, WhatCannotBeReadBackIsRefused) {
  refused({"tag36h11:40mm:0", "--verify"}, "a.ps", 2, "a ps file cannot be read back");
  refused({"tag36h11:40mm:0", "--verify"}, "a.dxf", 2, "a dxf file cannot be read back");
  refused({"tag36h11:40mm:0", "--verify", "--outline"}, "a.svg", 2, "outlines are no picture");
}

TEST_F(SheetKinds, OptionsWithoutMeaningAreRefused) {
  refused({"tag36h11:40mm:0", "--dpi", "600"}, "a.pdf", 2, "--dpi has no meaning for a pdf file");
  refused({"tag36h11:40mm:0", "--color", "k"}, "a.svg", 2, "--color has no meaning");
  refused({"tag36h11:40mm:0", "--outline"}, "a.png", 2, "--outline has no meaning");
  refused({"tag36h11:40mm:0", "--ground", "white"}, "a.dxf", 2, "--ground has no meaning");
  refused({"tag36h11:40mm:0", "--depth", "1", "--ground", "none"}, "a.tif", 2, "no transparency");
  refused({"tag36h11:40mm:0", "--cut-lines", "square", "--gap", "0mm"}, "a.pdf", 2,
          "cut lines stand in");
  refused({"tag36h11:40mm:0-99"}, "a.eps", 2, "9 pages do not go into one eps file");
  refused({"tag36h11:40mm:0", "--cut-lines", "oval"}, "a.pdf", 2, "square, rounded, circle");
  refused({"tag36h11:40mm:0", "--quiet-zone", "-1"}, "a.pdf", 2, "from 0 to 100");
  refused({"tag36h11:40mm:0", "--gap", "-5mm"}, "a.pdf", 2, "is negative (--gap)");
  refused({"tag36h11:400mm:0"}, "a.pdf", 2, "not one tag fits on the page");
  refused({"tag36h11:40mm:587"}, "a.pdf", 2, "587");
  refused({"tag36h11:40mm:0"}, "no/a.pdf", 4, "there is no folder");
}

TEST_F(SheetKinds, AnInterruptedRunLeavesNothing) {
  test::RunningProgram program(test::tagmint_words(
      {"sheet", "rot48:20mm:0-99999", "--progress", "json", "-o", folder_.file("many.pdf")}));
  ASSERT_TRUE(program.wait_for_stderr("\"unit\":\"pages\""));
  program.send_signal(SIGINT);
  const ProgramResult result = program.finish();
  EXPECT_EQ(result.exit_code, 130);
  EXPECT_TRUE(has(result.err, "tagmint: error: interrupted; nothing was written")) << result.err;
  EXPECT_TRUE(folder_.names().empty());
}

TEST_F(SheetKinds, AFullDeviceIsToldInOneLine) {
  for (const char* kind : {"pdf", "svg", "png", "tiff", "ps", "dxf"}) {
    const ProgramResult result =
        test::tagmint({"sheet", "tag36h11:40mm:0", "--format", kind, "-o", "/dev/full"});
    EXPECT_EQ(result.exit_code, 4) << kind;
    EXPECT_TRUE(has(result.err, "No space left on device (/dev/full)")) << result.err;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
  }
}

TEST_F(SheetKinds, AFullDiskLeavesNothingHalfWritten) {
  const std::string disk = folder_.file("disk");
  std::filesystem::create_directory(disk);
  // Only root may mount; elsewhere the test of a full device stands alone.
  if (::mount("tmpfs", disk.c_str(), "tmpfs", 0, "size=128k") != 0) return;
  const ProgramResult one = sheet({"tagStandard41h12:20mm"}, "disk/a.ps");
  const ProgramResult many = sheet({"tagStandard41h12:20mm"}, "disk/{id}.svg");
  std::vector<std::string> left;
  for (const auto& entry : std::filesystem::directory_iterator(disk)) {
    left.push_back(entry.path().filename().string());
  }
  ::umount(disk.c_str());
  for (const ProgramResult& result : {one, many}) {
    EXPECT_EQ(result.exit_code, 4);
    EXPECT_TRUE(has(result.err, "No space left on device")) << result.err;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
  }
  EXPECT_TRUE(left.empty()) << left[0];
}

}  // namespace
}  // namespace tagmint
