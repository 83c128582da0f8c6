#pragma once

#include <optional>
#include <string>
#include <vector>

#include "draw/canvas.h"
#include "draw/colour_model.h"
#include "draw/pdf_file.h"
#include "draw/pdf_font.h"

namespace tagmint::draw {

/// A PDF file of any number of pages, written page by page. It asks viewers to print at actual size
/// (PrintScaling None), shows its title, and has page labels, bookmarks and searchable text. The
/// same drawing is the same file. Lengths are exact to 0.01 um, and along the grid of a tag all
/// edges share the same numbers.
class PdfCanvas final : public Canvas {
 public:
  ///   title   noted in the file, UTF-8; may be empty
  PdfCanvas(ByteSink sink, const std::string& title, InkModel ink_model = InkModel::Gray);

  void begin_page(const PageSetup& page) override;
  void paint_ground(const Path& area) override;
  void fill(const Path& path, const Placement& place, const Ink& ink) override;
  void stroke(const Path& path, const Placement& place, const Pen& pen) override;
  void show_text(const TextLine& line) override;
  void end_page() override;
  void finish() override;

 private:
  /// A bookmark and the page it leads to.
  struct Entry {
    Bookmark bookmark;
    int page = 0;  // object number
  };
  void set_fill_gray(double gray);
  void append_colour(double gray, bool for_lines);
  int write_outline();
  std::string page_labels() const;

  PdfFile file_;
  InkModel ink_model_;
  int info_;
  int page_tree_;  // object numbers
  int resources_;
  PdfFonts fonts_;
  std::vector<int> pages_;           // object numbers
  std::vector<std::string> labels_;  // of the pages
  std::vector<Entry> entries_;
  PageSetup page_;
  std::string content_;              // of the page being drawn
  std::optional<double> fill_gray_;  // set in the content so far
};

}  // namespace tagmint::draw
