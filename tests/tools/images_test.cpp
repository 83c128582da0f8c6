#include "io/images.h"

#include <gtest/gtest.h>
#include <png.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <vector>

#include "support/image_files.h"
#include "tagmint/codec/errors.h"

namespace tagmint::io {
namespace {

using test::make_jpeg;
using test::make_png;
using test::make_tiff;
using test::PngParts;
using test::TiffParts;

std::vector<int> pixels_of(const detect::Image& image) {
  std::vector<int> out;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) out.push_back(image.at(x, y));
  }
  return out;
}

std::vector<int> decoded(const std::string& bytes) {
  return pixels_of(decode_gray_image(bytes, "test"));
}

std::string refusal(const std::string& bytes) {
  try {
    decode_gray_image(bytes, "a.img");
  } catch (const codec::InputError& error) {
    return error.what();
  }
  return "accepted";
}

detect::Image ramp(int width, int height) {
  detect::Image image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) image.at(x, y) = static_cast<std::uint8_t>(x * 37 + y * 91);
  }
  return image;
}

/// Whether no cut of `file` is accepted, except those that lose fewer than `spare` bytes.
void expect_every_cut_refused(const std::string& file, std::size_t spare = 0) {
  ASSERT_EQ(refusal(file), "accepted");
  for (std::size_t length = 0; length + spare < file.size(); ++length) {
    const std::string message = refusal(file.substr(0, length));
    EXPECT_NE(message, "accepted") << length << " of " << file.size() << " bytes";
    EXPECT_NE(message.find("(a.img); "), std::string::npos) << message;
  }
}

TEST(Images, PnmRoundTripKeepsEveryPixel) {
  const detect::Image image = ramp(7, 5);
  EXPECT_EQ(decode_gray_image(encode_pnm(image), "test"), image);
}

TEST(Images, PngRoundTripKeepsEveryPixel) {
  const detect::Image image = ramp(300, 41);
  EXPECT_EQ(decode_gray_image(encode_png(image), "test"), image);
  EXPECT_EQ(decode_gray_image(encode_png(image, 300.0), "test"), image);
}

TEST(Images, ViewsWithStridesAreWrittenRowByRow) {
  const detect::Image image = ramp(6, 4);
  const detect::ImageView upside_down{image.row(3) + 1, 3, 4, -6};
  const detect::Image back = decode_gray_image(encode_png(upside_down), "test");
  EXPECT_EQ(back, decode_gray_image(encode_pnm(upside_down), "test"));
  EXPECT_EQ(back.at(0, 0), image.at(1, 3));
  EXPECT_EQ(back.at(2, 3), image.at(3, 0));
}

TEST(Images, ColourBecomesRec601Luma) {
  RgbImage image(5, 1);
  image.rgb = {255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255, 100, 100, 100};
  const std::vector<int> expected = {76, 150, 29, 255, 100};
  EXPECT_EQ(decoded(encode_png(image)), expected);
  EXPECT_EQ(decoded(encode_pnm(image)), expected);
  EXPECT_EQ(decoded(make_tiff({.width = 5,
                               .height = 1,
                               .samples = 3,
                               .photometric = 2,
                               .pixels = std::string(image.rgb.begin(), image.rgb.end())})),
            expected);
}

TEST(Images, PngNotesItsResolution) {
  const std::string png = encode_png(ramp(2, 2), 254.0);
  // pHYs: 10000 = 0x2710 pixels a metre on both axes, unit 1.
  EXPECT_NE(png.find(std::string("pHYs\x00\x00\x27\x10\x00\x00\x27\x10\x01", 13)),
            std::string::npos);
  EXPECT_EQ(encode_png(ramp(2, 2)).find("pHYs"), std::string::npos);
}

TEST(Images, ImpossibleImagesAreNotWritten) {
  EXPECT_THROW(encode_png(detect::Image()), std::invalid_argument);
  EXPECT_THROW(encode_pnm(detect::Image()), std::invalid_argument);
  EXPECT_THROW(encode_png(ramp(2, 2), 0.0), std::invalid_argument);
}

TEST(Images, PlainPnmMayHoldCommentsAndAnyMaximum) {
  EXPECT_EQ(decoded("P2 # gray\n2 2\n#size above\n15\n0 15\n5 10\n"),
            (std::vector<int>{0, 255, 85, 170}));
  EXPECT_EQ(decoded("P3\n1 2 1023 1023 0 0 511 511 511"), (std::vector<int>{76, 127}));
  EXPECT_EQ(decoded("P5 1 1 100\n\x32"), (std::vector<int>{128}));
}

TEST(Images, SixteenBitsAreRoundedToEight) {
  // 0, 128 (rounds to 0), 129 (rounds to 1), 0x7fff, 0xffff
  const std::string high_first("\x00\x00\x00\x80\x00\x81\x7f\xff\xff\xff", 10);
  const std::vector<int> expected = {0, 0, 1, 127, 255};
  EXPECT_EQ(decoded("P5 5 1 65535\n" + high_first), expected);
  EXPECT_EQ(decoded(make_png({.width = 5,
                              .height = 1,
                              .bit_depth = 16,
                              .rows = {{high_first.begin(), high_first.end()}}})),
            expected);
  EXPECT_EQ(decoded(make_tiff(
                {.width = 5, .height = 1, .bits = 16, .big_endian = true, .pixels = high_first})),
            expected);
}

TEST(Images, PngOfFewBitsAndPalettesIsExpanded) {
  EXPECT_EQ(decoded(make_png({.width = 5, .height = 1, .bit_depth = 1, .rows = {{0b10110000}}})),
            (std::vector<int>{255, 0, 255, 255, 0}));
  EXPECT_EQ(decoded(make_png({.width = 4, .height = 1, .bit_depth = 2, .rows = {{0b00011011}}})),
            (std::vector<int>{0, 85, 170, 255}));
  EXPECT_EQ(decoded(make_png({.width = 4,
                              .height = 1,
                              .bit_depth = 4,
                              .colour_type = PNG_COLOR_TYPE_PALETTE,
                              .palette = {0, 0, 0, 255, 0, 0, 255, 255, 255},
                              .palette_alpha = {255, 255, 0},
                              .rows = {{0x01, 0x20}}})),
            (std::vector<int>{0, 76, 255, 0}));
}

TEST(Images, AlphaIsSeenOverWhite) {
  const std::vector<std::uint8_t> gray_alpha = {0, 0, 0, 255, 0, 51, 200, 255};
  const std::vector<int> expected = {255, 0, 204, 200};
  EXPECT_EQ(decoded(make_png({.width = 4,
                              .height = 1,
                              .colour_type = PNG_COLOR_TYPE_GRAY_ALPHA,
                              .rows = {gray_alpha}})),
            expected);
  std::vector<std::uint8_t> rgba;
  for (std::size_t i = 0; i < gray_alpha.size(); i += 2) {
    rgba.insert(rgba.end(), {gray_alpha[i], gray_alpha[i], gray_alpha[i], gray_alpha[i + 1]});
  }
  EXPECT_EQ(
      decoded(make_png(
          {.width = 4, .height = 1, .colour_type = PNG_COLOR_TYPE_RGB_ALPHA, .rows = {rgba}})),
      expected);
  EXPECT_EQ(decoded(make_tiff({.width = 4,
                               .height = 1,
                               .samples = 4,
                               .photometric = 2,
                               .extra_samples = 2,
                               .pixels = std::string(rgba.begin(), rgba.end())})),
            expected);
}

TEST(Images, InterlacedPngIsReadLikeAnyOther) {
  PngParts parts{.width = 13, .height = 11, .interlaced = true};
  const detect::Image image = ramp(13, 11);
  for (int y = 0; y < 11; ++y) parts.rows.emplace_back(image.row(y), image.row(y) + 13);
  EXPECT_EQ(decode_gray_image(make_png(parts), "test"), image);
}

TEST(Images, JpegKeepsFlatColoursToALevel) {
  const auto flat = [](std::vector<std::uint8_t> colour, bool progressive) {
    std::vector<std::uint8_t> samples;
    for (int i = 0; i < 16 * 16; ++i) samples.insert(samples.end(), colour.begin(), colour.end());
    const auto image = decode_gray_image(
        make_jpeg(16, 16, static_cast<int>(colour.size()), samples, progressive), "test");
    EXPECT_EQ(image.width(), 16);
    return int{image.at(8, 8)};
  };
  EXPECT_NEAR(flat({90}, false), 90, 1);
  EXPECT_NEAR(flat({90}, true), 90, 1);
  EXPECT_NEAR(flat({255, 0, 0}, false), 76, 1);
  EXPECT_NEAR(flat({0, 255, 0}, true), 150, 1);
  // Adobe's inks are inverted: 255 is no ink.
  EXPECT_NEAR(flat({255, 255, 255, 255}, false), 255, 1);
  EXPECT_NEAR(flat({255, 0, 0, 255}, false), 76, 1);
  EXPECT_NEAR(flat({255, 255, 255, 0}, false), 0, 1);
}

TEST(Images, JpegLosesMoreAtLowerQuality) {
  detect::Image image(161, 117);
  for (int y = 0; y < 117; ++y) {
    for (int x = 0; x < 161; ++x) {
      image.at(x, y) = static_cast<std::uint8_t>(((x / 7 + y / 5) % 2 == 0 ? 40 : 210) + x % 3);
    }
  }
  double last = 0;
  for (const int quality : {100, 75, 30, 5}) {
    const detect::Image kept = decode_gray_image(encode_jpeg(image.view(), quality), "memory");
    ASSERT_EQ(kept.width(), 161);
    ASSERT_EQ(kept.height(), 117);
    double squares = 0;
    for (int y = 0; y < 117; ++y) {
      for (int x = 0; x < 161; ++x) squares += std::pow(kept.at(x, y) - image.at(x, y), 2);
    }
    if (quality == 100) {
      EXPECT_LT(squares / (161 * 117), 1);  // levels squared
    }
    EXPECT_GT(squares, last) << quality;
    last = squares;
  }
}

TEST(Images, ImpossibleJpegsAreNotWritten) {
  const detect::Image image(8, 8, 100);
  EXPECT_THROW(encode_jpeg(image.view(), 0), std::invalid_argument);
  EXPECT_THROW(encode_jpeg(image.view(), 101), std::invalid_argument);
  EXPECT_THROW(encode_jpeg(detect::ImageView{}, 80), std::invalid_argument);
  EXPECT_THROW(encode_jpeg(detect::Image(65501, 1).view(), 80), std::invalid_argument);
}

TEST(Images, TiffOfEachKindIsRead) {
  EXPECT_EQ(decoded(make_tiff({.width = 3, .height = 1, .pixels = "\x0a\x14\x1e"})),
            (std::vector<int>{10, 20, 30}));
  EXPECT_EQ(
      decoded(make_tiff({.width = 3, .height = 1, .photometric = 0, .pixels = "\x0a\x14\x1e"})),
      (std::vector<int>{245, 235, 225}));
  EXPECT_EQ(decoded(make_tiff({.width = 9, .height = 1, .bits = 1, .pixels = "\xb1\x80"})),
            (std::vector<int>{255, 0, 255, 255, 0, 0, 0, 255, 255}));
  TiffParts palette{.width = 2, .height = 1, .bits = 4, .photometric = 3, .pixels = "\x12"};
  palette.palette.assign(48, 0);
  palette.palette[1] = palette.palette[16 + 1] = palette.palette[32 + 1] = 65535;
  palette.palette[2] = 65535;
  EXPECT_EQ(decoded(make_tiff(palette)), (std::vector<int>{255, 76}));
}

TEST(Images, EveryCutFileIsRefused) {
  const detect::Image image = ramp(9, 8);
  std::vector<std::uint8_t> samples(image.row(0), image.row(0) + 72);
  expect_every_cut_refused(encode_png(image, 100.0));
  expect_every_cut_refused(encode_pnm(image));
  // The last digits of a text file may be a number as well.
  expect_every_cut_refused("P2\n2 2\n255\n0 1\n2 255", 3);
  expect_every_cut_refused(make_jpeg(9, 8, 1, samples));
  expect_every_cut_refused(make_jpeg(9, 8, 1, samples, true));
  // The end mark of the directory, zero, is 4 bytes that nobody needs.
  expect_every_cut_refused(
      make_tiff({.width = 9, .height = 8, .pixels = std::string(samples.begin(), samples.end())}),
      5);
}

TEST(Images, DamagedFilesAreRefusedOrRead) {
  // Whatever byte changes: an image or an InputError, nothing else.
  const detect::Image image = ramp(9, 8);
  const std::vector<std::uint8_t> samples(image.row(0), image.row(0) + 72);
  const std::vector<std::string> files = {
      encode_png(image),
      encode_pnm(image),
      make_jpeg(9, 8, 1, samples),
      make_jpeg(8, 3, 3, samples, true),
      make_tiff({.width = 9, .height = 8, .pixels = std::string(samples.begin(), samples.end())}),
      make_tiff({.width = 4,
                 .height = 9,
                 .bits = 16,
                 .pixels = std::string(samples.begin(), samples.end())})};
  for (const std::string& file : files) {
    for (std::size_t i = 0; i < file.size(); ++i) {
      for (const char flip : {'\x01', '\x80', '\xff'}) {
        std::string damaged = file;
        damaged[i] = static_cast<char>(damaged[i] ^ flip);
        EXPECT_NO_FATAL_FAILURE(refusal(damaged)) << i;
      }
    }
  }
}

TEST(Images, FaultsAreNamed) {
  EXPECT_EQ(refusal(""), "the image is empty (a.img); give a PNG, JPEG, PNM or TIFF file");
  EXPECT_EQ(refusal("GIF89a"),
            "not an image of a known kind (a.img); give a PNG, JPEG, PNM or TIFF file");
  EXPECT_NE(refusal("P4 8 1 \xff").find("PNM images of kind P4 are not read (a.img)"),
            std::string::npos);
  EXPECT_NE(refusal("P5 70000 70000 255\nx").find("claims 70000 x 70000 pixels, more than"),
            std::string::npos);
  EXPECT_NE(refusal("P5 0 4 255\nx").find("0 x 4 pixels"), std::string::npos);
  EXPECT_NE(refusal("P2 2 1 9\n3 10").find("a sample is larger than 9"), std::string::npos);
  EXPECT_NE(refusal("P5 2 1 70000\nxx").find("larger than 65535"), std::string::npos);
  EXPECT_NE(refusal("P5 2 1 0\nxx").find("largest sample value is 0"), std::string::npos);
  EXPECT_NE(refusal("P5 4 4 255\nxx").find("16 bytes of samples are needed at least and 2 are"),
            std::string::npos);
  EXPECT_NE(refusal("P2 1 1 255\n-3").find("a sample is not a number"), std::string::npos);
}

TEST(Images, HugeClaimsAreRefusedBeforeMemoryIsTaken) {
  std::string png = encode_png(ramp(4, 4));
  png.replace(16, 8, std::string("\x7f\xff\xff\xff\x7f\xff\xff\xff", 8));
  // The checksum of the header chunk is wrong now, so libpng may be the one to refuse.
  EXPECT_NE(refusal(png), "accepted");
  TiffParts tiff{.width = 60000, .height = 60000, .pixels = "x"};
  EXPECT_NE(refusal(make_tiff(tiff)).find("claims 60000 x 60000 pixels"), std::string::npos);
}

TEST(Images, MissingFilesAndFoldersAreNamed) {
  const auto refused = [](const std::string& path) -> std::string {
    try {
      read_gray_image(path);
    } catch (const codec::InputError& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_NE(refused("no/such.png").find("No such file"), std::string::npos);
  EXPECT_NE(refused("no/such.png").find("(no/such.png); "), std::string::npos);
  EXPECT_NE(refused(::testing::TempDir()).find("it is a folder"), std::string::npos);
}

TEST(Images, FilesAreWrittenAndReadBack) {
  const detect::Image image = ramp(20, 10);
  const std::string stem = ::testing::TempDir() + "tagmint_images_test";
  write_png(stem + ".png", image);
  write_pnm(stem + ".pgm", image);
  EXPECT_EQ(read_gray_image(stem + ".png"), image);
  EXPECT_EQ(read_gray_image(stem + ".pgm"), image);
  std::remove((stem + ".png").c_str());
  std::remove((stem + ".pgm").c_str());
}

}  // namespace
}  // namespace tagmint::io
