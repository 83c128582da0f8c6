// Folders of pictures of tags, one pixel a cell.
#include "io/family_kinds/png_folder.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <png.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "io/atomic_folder.h"
#include "io/family_kinds/cell_png.h"
#include "io/family_kinds/family_changes.h"
#include "io/images.h"
#include "support/image_files.h"
#include "support/scratch_folder.h"
#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/errors.h"
#include "tagmint/codec/tag_cells.h"

namespace tagmint::io {
namespace {

namespace fs = std::filesystem;

/// The pictures of a family's first tags in a folder of its own.
class PngFolder : public testing::Test {
 protected:
  PngFolder() : family_(first_tags(*codec::find_family("tagCircle21h7"), 12)) {
    const std::string target = path();
    write_family_files(png_folder_kind(), target, png_folder_kind().make(family_, target, {}));
  }

  std::string path() const { return folder_.file("tags"); }
  std::string tag(int id) const { return path() + fmt::format("/tag21_07_{:05}.png", id); }
  ReadFamily read() const { return png_folder_kind().read(read_family_source(path()), {}); }
  std::string fault() const {
    try {
      read();
      return "no fault";
    } catch (const codec::InputError& error) {
      return error.what();
    }
  }
  const codec::Family& family() const { return family_; }

 private:
  const test::ScratchFolder folder_;
  const codec::Family family_;
};

TEST_F(PngFolder, HasOnePixelACellAndIsTransparentWhereThereIsNone) {
  const test::ScratchFolder folder;
  const std::string bytes = test::read_file(tag(3));
  EXPECT_EQ(decode_cell_png(bytes, "x"), codec::tag_cells(family().layout(), family().codeword(3)));
  // Seen over white.
  const detect::Image picture = decode_gray_image(bytes, "x");
  ASSERT_EQ(picture.width(), 9);
  ASSERT_EQ(picture.height(), 9);
  EXPECT_EQ(picture.row(0)[0], 255);
  EXPECT_EQ(picture.row(1)[1], 0);
  EXPECT_EQ(picture.row(2)[2], 255);
}

TEST_F(PngFolder, MosaicShowsAllTagsRowByRow) {
  const detect::Image mosaic = read_gray_image(path() + "/mosaic.png");
  ASSERT_EQ(mosaic.width(), 4 * 10 + 1);
  ASSERT_EQ(mosaic.height(), 3 * 10 + 1);
  for (int id = 0; id < 12; ++id) {
    const codec::TagCells cells =
        codec::tag_cells(family().layout(), family().codeword(static_cast<codec::TagId>(id)));
    for (int y = 0; y < 9; ++y) {
      for (int x = 0; x < 9; ++x) {
        const int seen = mosaic.row(id / 4 * 10 + 1 + y)[id % 4 * 10 + 1 + x];
        EXPECT_EQ(seen, cells.at(x, y) == codec::Cell::Black ? 0 : 255);
      }
    }
  }
}

TEST_F(PngFolder, OtherFilesAreLeftAlone) {
  test::write_file(path() + "/README.txt", "x");
  test::write_file(path() + "/preview.png", "x");
  EXPECT_TRUE(std::ranges::equal(read().family.codewords(), family().codewords()));
}

TEST_F(PngFolder, PicturesOfOtherProgramsMayBeInColour) {
  // Red, green, blue and opacity, as the collection itself has them.
  const codec::TagCells cells = codec::tag_cells(family().layout(), family().codeword(0));
  test::PngParts parts{.width = 9, .height = 9, .colour_type = PNG_COLOR_TYPE_RGB_ALPHA};
  for (int y = 0; y < 9; ++y) {
    std::vector<std::uint8_t> row;
    for (int x = 0; x < 9; ++x) {
      const std::uint8_t gray = cells.at(x, y) == codec::Cell::White ? 255 : 0;
      row.insert(row.end(),
                 {gray, gray, gray, std::uint8_t(cells.at(x, y) == codec::Cell::None ? 0 : 255)});
    }
    parts.rows.push_back(row);
  }
  test::write_file(tag(0), test::make_png(parts));
  EXPECT_TRUE(std::ranges::equal(read().family.codewords(), family().codewords()));
}

TEST_F(PngFolder, FaultsAreToldWithTheirFile) {
  const std::string good = test::read_file(tag(5));
  const auto fault_with = [&](const std::string& content) {
    test::write_file(tag(5), content);
    return fault();
  };
  const std::string mend = " (" + tag(5) + "); a tag is a PNG picture with one pixel a cell";
  EXPECT_EQ(fault_with(encode_png(detect::Image(9, 9, 128))),
            "the pixel (0, 0) is neither black nor white nor transparent" + mend);
  EXPECT_EQ(fault_with(encode_png(detect::Image(90, 90, 0))),
            "90 x 90 pixels are no square of up to 64 cells" + mend);
  EXPECT_EQ(fault_with(encode_png(detect::Image(9, 8, 0))),
            "9 x 8 pixels are no square of up to 64 cells" + mend);
  EXPECT_EQ(fault_with(encode_png(detect::Image(10, 10, 0))),
            "10 cells wide where tag 0 is 9 (" + tag(5) + "); give a folder with one family");
  EXPECT_TRUE(fault_with("x").starts_with("no PNG image: ")) << fault();
  EXPECT_TRUE(fault_with(good.substr(0, good.size() / 2)).ends_with(mend)) << fault();
}

TEST_F(PngFolder, MissingAndDoubleTagsAreTold) {
  fs::remove(tag(4));
  EXPECT_EQ(fault(),
            "the picture of tag 4 is missing (" + path() + "); ids run from 0 without gaps");
  test::write_file(path() + "/tag36_11_00004.png", test::read_file(tag(5)));
  EXPECT_EQ(fault(), "tags of two families, tag21_07_... and tag36_11_... (" + path() +
                         "); give a folder with one family");
  fs::rename(path() + "/tag36_11_00004.png", tag(4));
  EXPECT_EQ(fault(), "codeword 5 repeats codeword 4 (" + path() +
                         "); a family holds each once; remove one of them");
}

TEST(AtomicFolder, IsAbsentUntilItIsFinished) {
  const test::ScratchFolder folder;
  const std::string target = folder.file("new");
  {
    AtomicFolder files(target);
    files.write("a", "1");
    EXPECT_FALSE(fs::exists(target));
  }
  EXPECT_TRUE(folder.names().empty());
  AtomicFolder files(target);
  files.write("a", "1");
  EXPECT_THROW(files.write("a", "2"), codec::OutputError);
  EXPECT_THROW(files.write("no/a", "2"), codec::OutputError);
  files.finish();
  EXPECT_EQ(folder.names(), std::vector<std::string>{"new"});
  EXPECT_EQ(test::read_file(target + "/a"), "1");
  EXPECT_THROW(AtomicFolder{target}, codec::OutputError);
}

}  // namespace
}  // namespace tagmint::io
