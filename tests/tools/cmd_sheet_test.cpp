#include "cli/cmd_sheet.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "cli/program.h"
#include "io/images.h"
#include "io/streams.h"

namespace tagmint::cli {
namespace {

namespace fs = std::filesystem;

/// What a call of the program left.
struct Outcome {
  int code = 0;
  std::string messages;  // stderr
};

/// Calls `tagmint sheet` with a folder of its own, which is removed afterwards.
class SheetCommand : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(::testing::TempDir()) / (std::string("tagmint_sheet_") + test->name());
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string file(const std::string& name) const { return (folder_ / name).string(); }

  /// `output` is a name in the folder.
  Outcome run(std::vector<std::string> arguments, const std::string& output) {
    arguments.insert(arguments.end(), {"-o", file(output)});
    std::vector<const char*> argv = {"tagmint", "sheet"};
    for (const std::string& argument : arguments) argv.push_back(argument.c_str());
    ::testing::internal::CaptureStderr();
    const int code = run_program(static_cast<int>(argv.size()), argv.data());
    return {code, ::testing::internal::GetCapturedStderr()};
  }

  std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_)) {
      names.push_back(entry.path().filename().string());
    }
    std::sort(names.begin(), names.end());
    return names;
  }

  fs::path folder_;
};

TEST_F(SheetCommand, PrintsBothSizesAndWhatFits) {
  const Outcome outcome = run({"tag36h11", "--edge", "40mm", "--ids", "0-14"}, "a.pdf");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.messages,
            file("a.pdf") +
                ": 15 tags on 2 pages of 210 mm x 297 mm\n"
                "  tag36h11: 15 tags, edge 40 mm, outer 50 mm; a page takes 3 x 4\n");
  EXPECT_EQ(io::read_input(file("a.pdf")).substr(0, 5), "%PDF-");
}

TEST_F(SheetCommand, QuietSaysNothing) {
  EXPECT_EQ(run({"tag36h11:4cm:0", "--quiet"}, "a.svg").messages, "");
  EXPECT_EQ(files(), (std::vector<std::string>{"a.svg"}));
}

TEST_F(SheetCommand, OneFileATagHasTheTagsSize) {
  const Outcome outcome = run({"tag16h5:20cm:7,3,20-21", "--dpi", "25.4"}, "{family}-{id:05}.png");
  EXPECT_EQ(outcome.code, 0) << outcome.messages;
  EXPECT_EQ(files(), (std::vector<std::string>{"tag16h5-00003.png", "tag16h5-00007.png",
                                               "tag16h5-00020.png", "tag16h5-00021.png"}));
  // Eight cells in all for six in the edge; 33.3 mm a cell become 33 dots of a mm.
  const detect::Image image = io::read_gray_image(file("tag16h5-00003.png"));
  EXPECT_EQ(image.width(), 264);
  EXPECT_EQ(image.height(), 264);
}

TEST_F(SheetCommand, OneFileAPageIsNumbered) {
  const Outcome outcome = run({"tag36h11:60mm:0-6", "--paper", "a5"}, "s{page}.svg");
  EXPECT_EQ(outcome.code, 0) << outcome.messages;
  EXPECT_EQ(files(), (std::vector<std::string>{"s1.svg", "s2.svg", "s3.svg", "s4.svg"}));
}

TEST_F(SheetCommand, LandscapePaperMarginAndGapAreKept) {
  const Outcome outcome = run({"tag36h11:40mm:0-3", "--paper", "120x60mm", "--margin", "5mm",
                               "--gap", "0mm", "--label", "none", "--dpi", "254"},
                              "a.png");
  EXPECT_EQ(outcome.code, 2);  // the notes need 6.8 mm of the 50 mm
  EXPECT_NE(outcome.messages.find("it needs 50 mm of height"), std::string::npos);
  const Outcome turned = run({"tag36h11:40mm:0-3", "--paper", "60x120mm", "--landscape", "--margin",
                              "1mm", "--gap", "0mm", "--label", "none", "--dpi", "254"},
                             "b{page}.png");
  EXPECT_EQ(turned.code, 0) << turned.messages;
  EXPECT_EQ(io::read_gray_image(file("b1.png")).width(), 1200);
  EXPECT_EQ(files(), (std::vector<std::string>{"b1.png", "b2.png"}));
}

TEST_F(SheetCommand, UsageFaultsAreNamed) {
  const auto refused = [&](std::vector<std::string> arguments, const std::string& output) {
    const Outcome outcome = run(std::move(arguments), output);
    EXPECT_EQ(outcome.code, 2) << outcome.messages;
    EXPECT_EQ(std::count(outcome.messages.begin(), outcome.messages.end(), '\n'), 1);
    return outcome.messages;
  };
  const auto has = [](const std::string& text, const char* part) {
    return text.find(part) != std::string::npos;
  };
  EXPECT_PRED2(has, refused({"tag36h11"}, "a.pdf"), "the size of the tags is missing");
  EXPECT_PRED2(has, refused({"tag36h11", "--edge", "40"}, "a.pdf"), "no unit");
  EXPECT_PRED2(has, refused({"tag36h11", "--edge", "4cm", "--outer", "5cm"}, "a.pdf"), "--outer");
  EXPECT_PRED2(has, refused({"tag36h11:40mm:587"}, "a.pdf"), "587");
  EXPECT_PRED2(has, refused({"tag36h11:40cm:0"}, "a.pdf"), "not one tag fits on the page");
  EXPECT_PRED2(has, refused({"tag36h11:4cm"}, "a.svg"), "49 pages do not go into one svg file");
  EXPECT_PRED2(has, refused({"tag36h11:4cm"}, "a.xyz"), "names no format");
  EXPECT_PRED2(has, refused({"tag36h11:4cm"}, "a"), "--format");
  EXPECT_PRED2(has, refused({"tag36h11:4cm"}, "{ids}.svg"), "did you mean 'id'?");
  EXPECT_PRED2(has, refused({"tag36h11:4cm"}, "{family}.svg"), "two tags would be written to");
  EXPECT_PRED2(has, refused({"tag36h11:4cm"}, "{id}{page}.svg"), "one or the other");
  EXPECT_PRED2(has, refused({"tag36h11:4cm"}, "{page}.pdf"), "a PDF holds all pages");
  EXPECT_PRED2(has, refused({"tag36h11:4cm", "--ruler"}, "{id}.svg"), "--ruler has no meaning");
  EXPECT_PRED2(has, refused({"tag36h11:4cm", "--cut-marks", "--gap", "0mm"}, "a.pdf"),
               "cut marks stand in the gap");
  EXPECT_PRED2(has, refused({"tag36h11:4cm", "--label", "{nr}"}, "a.pdf"), "unknown field {nr}");
  EXPECT_PRED2(has, refused({"tag36h11:4cm", "--label", "{family:3}"}, "a.pdf"), "takes no width");
  EXPECT_PRED2(has, refused({"tag36h11:4cm", "--paper", "a7"}, "a.pdf"), "unknown paper");
  EXPECT_PRED2(has, refused({"tag36h11:4cm", "--title", "\xff"}, "a.pdf"), "UTF-8");
  EXPECT_PRED2(has, refused({"tag36h11:4cm", "--title", "two\nlines"}, "a.pdf"), "(--title)");
  EXPECT_PRED2(has, refused({"tag36h11:4cm", "--label", "two\nlines"}, "a.pdf"), "(--label)");
  EXPECT_PRED2(has, refused({"tag36h11:4cm:0", "--dpi", "nan"}, "a.png"),
               "'nan' is not a number from 1 to 100000 (--dpi)");
  EXPECT_TRUE(files().empty());
}

TEST_F(SheetCommand, FoldersThatAreNotThereAreNamed) {
  const Outcome outcome = run({"tag36h11:4cm:0"}, "no/such/{id}.svg");
  EXPECT_EQ(outcome.code, 4);
  EXPECT_NE(outcome.messages.find("there is no folder"), std::string::npos) << outcome.messages;
}

TEST_F(SheetCommand, UnknownFamiliesAreNamed) {
  const Outcome outcome = run({"tag36h12:4cm:0"}, "a.pdf");
  EXPECT_NE(outcome.code, 0);
  EXPECT_NE(outcome.messages.find("tag36h11"), std::string::npos) << outcome.messages;
}

}  // namespace
}  // namespace tagmint::cli
