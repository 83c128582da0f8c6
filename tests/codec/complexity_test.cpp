#include "tagmint/codec/complexity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "colour_changes.h"
#include "tagmint/codec/layout_presets.h"
#include "tagmint/codec/rotation.h"
#include "tagmint/codec/tag_cells.h"

namespace tagmint::codec {
namespace {

std::string message_of(const std::string& text) {
  try {
    parse_complexity(text);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

/// The word whose data square, drawn as the published generator saw it (turned by 180 degrees), has
/// '#' for 1 and '.' for 0.
Codeword word_of(const Layout& layout, const std::vector<std::string>& picture) {
  const int side = static_cast<int>(picture.size());
  const int offset = (layout.width() - side) / 2;
  std::vector<Cell> cells;
  for (int y = 0; y < layout.width(); ++y) {
    for (int x = 0; x < layout.width(); ++x) {
      const int gx = side - 1 - (x - offset);
      const int gy = side - 1 - (y - offset);
      const bool data = gx >= 0 && gx < side && gy >= 0 && gy < side;
      cells.push_back(data && picture[gy][gx] == '#' ? Cell::White : Cell::Black);
    }
  }
  return codeword_of(layout, TagCells(layout.width(), cells));
}

/// The greedy painter word for word as docs/lexicodes.md describes it, on the tag turned by 180
/// degrees.
int rectangles_as_described(const Layout& layout, Codeword word) {
  const TagCells tag = tag_cells(layout, word);
  const int width = layout.width();
  const auto is_data = [&](int x, int y) {
    return layout.cell(width - 1 - x, width - 1 - y) == Cell::Data;
  };
  const auto wanted = [&](int x, int y) {
    return tag.at(width - 1 - x, width - 1 - y) == Cell::White ? 1 : 0;
  };
  std::vector<int> canvas(static_cast<std::size_t>(width) * width, -1);
  const auto wrong_cells = [&](const std::vector<int>& on) {
    int wrong = 0;
    for (int y = 0; y < width; ++y) {
      for (int x = 0; x < width; ++x) wrong += is_data(x, y) && on[y * width + x] != wanted(x, y);
    }
    return wrong;
  };
  int rectangles = 0;
  for (int wrong = wrong_cells(canvas); wrong > 0; ++rectangles) {
    std::vector<int> best;
    for (int y0 = 0; y0 < width; ++y0) {
      for (int y1 = y0; y1 < width; ++y1) {
        for (int x0 = 0; x0 < width; ++x0) {
          for (int x1 = x0; x1 < width; ++x1) {
            for (const int colour : {0, 1}) {
              std::vector<int> painted = canvas;
              for (int y = y0; y <= y1; ++y) {
                std::fill(&painted[y * width + x0], &painted[y * width + x1] + 1, colour);
              }
              if (const int left = wrong_cells(painted); left < wrong) {
                wrong = left;
                best = painted;
              }
            }
          }
        }
      }
    }
    canvas = best;
  }
  return rectangles;
}

/// Colour changes counted on the picture itself.
int changes_in_picture(const TagCells& cells) {
  const auto differ = [&](int x0, int y0, int x1, int y1) {
    const Cell a = cells.at(x0, y0);
    const Cell b = cells.at(x1, y1);
    return a != Cell::None && b != Cell::None && a != b;
  };
  int changes = 0;
  for (int y = 0; y < cells.width(); ++y) {
    for (int x = 0; x < cells.width(); ++x) {
      if (x + 1 < cells.width()) changes += differ(x, y, x + 1, y);
      if (y + 1 < cells.width()) changes += differ(x, y, x, y + 1);
    }
  }
  return changes;
}

TEST(Complexity, TextFormsGoThereAndBack) {
  for (const char* text : {"rectangles:10", "energy:0.3333", "energy:1", "none"}) {
    EXPECT_EQ(to_string(parse_complexity(text)), text);
  }
  EXPECT_EQ(parse_complexity("rectangles:8"), (Complexity{ComplexityRule::Rectangles, 8}));
}

TEST(Complexity, MisspeltFormsAreNamed) {
  EXPECT_EQ(message_of("rectangle:10"),
            "unknown complexity rule 'rectangle'; did you mean 'rectangles'? rules are "
            "rectangles:N, energy:F and none");
  EXPECT_NE(message_of("rectangles").find("needs a whole number"), std::string::npos);
  EXPECT_NE(message_of("rectangles:0").find("at least 1"), std::string::npos);
  EXPECT_NE(message_of("rectangles:2.5").find("whole number"), std::string::npos);
  EXPECT_NE(message_of("rectangles:1e99").find("whole number"), std::string::npos);
  EXPECT_NE(message_of("energy:x").find("needs a share"), std::string::npos);
  EXPECT_NE(message_of("energy:1.5").find("needs a share"), std::string::npos);
  EXPECT_NE(message_of("energy:nan").find("needs a share"), std::string::npos);
  EXPECT_NE(message_of("none:3").find("takes nothing"), std::string::npos);
  EXPECT_NE(message_of("").find("rules are"), std::string::npos);
}

TEST(Rectangles, APlainSquareNeedsOneAndAFrameTwo) {
  const Layout layout = classic_layout(8);
  EXPECT_EQ(count_rectangles(layout, word_of(layout, {"####", "####", "####", "####"})), 1);
  EXPECT_EQ(count_rectangles(layout, word_of(layout, {"....", "....", "....", "...."})), 1);
  EXPECT_EQ(count_rectangles(layout, word_of(layout, {"####", "#..#", "#..#", "####"})), 2);
}

TEST(Rectangles, EqualThePainterAsItIsDescribed) {
  std::mt19937_64 random(9);
  for (const char* name : {"classic:8", "classic:9", "circle:9"}) {
    const Layout layout = parse_layout(name);
    for (int i = 0; i < 5; ++i) {
      const Codeword word = random() & low_mask(layout.bits());
      EXPECT_EQ(count_rectangles(layout, word), rectangles_as_described(layout, word)) << name;
    }
  }
}

TEST(Rectangles, TheGreedyPainterIsNotRotationInvariant) {
  const Layout layout = classic_layout(8);
  bool differs = false;
  for (Codeword word = 0; word < 2000 && !differs; ++word) {
    differs = count_rectangles(layout, word) !=
              count_rectangles(layout, rotate_quarter(word, layout.bits()));
  }
  EXPECT_TRUE(differs);
}

TEST(Rectangles, CellsWithoutDataNeverCount) {
  const Layout layout = circle_layout(9);
  EXPECT_EQ(count_rectangles(layout, 0), 1);
  EXPECT_EQ(count_rectangles(layout, low_mask(layout.bits())), 1);
}

TEST(ColourChanges, AreThoseOfThePicture) {
  std::mt19937_64 random(7);
  for (const char* text :
       {"classic:8", "classic:9", "circle:9", "standard:9", "circle:11", "standard:10",
        "classic:12", "custom:xxddxx/xbbbbx/dbwwbd/dbwwbd/xbbbbx/xxddxx"}) {
    const Layout layout = parse_layout(text);
    for (int i = 0; i < 50; ++i) {
      const Codeword word = random() & low_mask(layout.bits());
      EXPECT_EQ(count_colour_changes(layout, word), changes_in_picture(tag_cells(layout, word)))
          << text;
      EXPECT_EQ(count_colour_changes(layout, word),
                count_colour_changes(layout, rotate_quarter(word, layout.bits())))
          << text;
    }
  }
}

TEST(ColourChanges, AreBitsThatAddUpByExclusiveOr) {
  std::mt19937_64 random(4);
  for (const char* name : {"classic:8", "classic:9", "standard:9", "circle:11", "classic:12"}) {
    const Layout layout = parse_layout(name);
    const ColourChanges changes(layout);
    const Codeword mask = low_mask(layout.bits());
    for (int i = 0; i < 50; ++i) {
      const Codeword a = random() & mask;
      const Codeword b = random() & mask;
      int ones = changes.fixed_changes();
      for (std::size_t word = 0; word < 4; ++word) {
        const std::uint64_t own = changes.change_bits(a)[word];
        ones += std::popcount(own);
        EXPECT_EQ(changes.change_bits(a ^ b)[word],
                  own ^ changes.change_bits(b)[word] ^ changes.change_bits(0)[word]);
      }
      EXPECT_EQ(ones, changes.count(a)) << name;
    }
  }
}

TEST(ComplexityJudge, ComparesTheMeasureWithTheThreshold) {
  std::mt19937_64 random(8);
  for (const char* rule : {"rectangles:7", "energy:0.3333", "none"}) {
    const Layout layout = classic_layout(9);
    const Complexity complexity = parse_complexity(rule);
    const ComplexityJudge judge(layout, complexity);
    for (int i = 0; i < 300; ++i) {
      const Codeword word = random() & random() & low_mask(layout.bits());
      EXPECT_EQ(judge.accepts(word), judge.measure(word) >= complexity.threshold) << rule;
    }
  }
}

TEST(ComplexityJudge, MeasuresWhatTheCountersCount) {
  const Layout layout = standard_layout(9);
  const Codeword word = 0x1234567890au;
  EXPECT_EQ(ComplexityJudge(layout, parse_complexity("rectangles:1")).measure(word),
            count_rectangles(layout, word));
  EXPECT_DOUBLE_EQ(ComplexityJudge(layout, parse_complexity("energy:0.5")).measure(word),
                   count_colour_changes(layout, word) / (2.0 * 81));
  EXPECT_EQ(ComplexityJudge(layout, {}).measure(word), 0);
}

}  // namespace
}  // namespace tagmint::codec
