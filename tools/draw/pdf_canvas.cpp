#include "draw/pdf_canvas.h"

#include <fmt/format.h>

#include <algorithm>

#include "draw/numbers.h"
#include "draw/path_operators.h"
#include "draw/units.h"
#include "tagmint/codec/version.h"

namespace tagmint::draw {
namespace {

constexpr int kDigits = 5;  // of a mm

}  // namespace

PdfCanvas::PdfCanvas(ByteSink sink, const std::string& title, InkModel ink_model)
    : file_(std::move(sink)),
      ink_model_(ink_model),
      info_(file_.reserve()),
      page_tree_(file_.reserve()),
      resources_(file_.reserve()) {
  // No date, so that the same drawing is the same file.
  const std::string shown = title.empty() ? "" : "/Title " + pdf_text(title);
  file_.write(info_, fmt::format("<<{}/Producer(tagmint {})>>", shown, codec::kVersion));
}

void PdfCanvas::begin_page(const PageSetup& page) {
  page_ = page;
  fill_gray_.reset();
  // From here on the unit is the mm, and y runs down from the top.
  content_ = fmt::format("{0} 0 0 -{0} 0 {1} cm\n", number_text(kPointsAMm, 9),
                         number_text(kPointsAMm * page.height_mm, 6));
}

void PdfCanvas::append_colour(double gray, bool for_lines) {
  if (ink_model_ == InkModel::Gray) {
    append_number(content_, gray, 4);
    content_ += for_lines ? " G\n" : " g\n";
  } else {
    content_ += "0 0 0 ";
    append_number(content_, 1 - gray, 4);
    content_ += for_lines ? " K\n" : " k\n";
  }
}

void PdfCanvas::set_fill_gray(double gray) {
  if (fill_gray_ == gray) return;
  fill_gray_ = gray;
  append_colour(gray, false);
}

void PdfCanvas::paint_ground(const Path& area) { fill(area, {}, {.gray = 1.0}); }

void PdfCanvas::fill(const Path& path, const Placement& place, const Ink& ink) {
  set_fill_gray(ink.gray);
  // The path keeps its own unit: the grid lines of a tag are whole numbers there.
  content_ += fmt::format("q {0} 0 0 {0} {1} {2} cm\n", number_text(place.unit_mm, 8),
                          number_text(place.x_mm, kDigits), number_text(place.y_mm, kDigits));
  append_path_operators(content_, path, kDigits);
  content_ += "f Q\n";
}

void PdfCanvas::stroke(const Path& path, const Placement& place, const Pen& pen) {
  content_ += "q ";
  append_colour(pen.ink.gray, true);
  content_ += fmt::format("{0} 0 0 {0} {1} {2} cm {3} w\n", number_text(place.unit_mm, 8),
                          number_text(place.x_mm, kDigits), number_text(place.y_mm, kDigits),
                          number_text(pen.width_mm / place.unit_mm, kDigits));
  append_path_operators(content_, path, kDigits);
  content_ += "S Q\n";
}

void PdfCanvas::show_text(const TextLine& line) {
  set_fill_gray(line.ink.gray);
  content_ += fmt::format("BT 1 0 0 -1 {} {} Tm\n", number_text(line.x_mm, kDigits),
                          number_text(line.baseline_mm, kDigits));
  std::optional<std::size_t> font;
  for (const Glyph* glyph : line.glyphs) {
    const GlyphCode code = fonts_.code_of(*glyph);
    if (font != code.font) {
      if (font) content_ += ">Tj\n";
      font = code.font;
      content_ += fmt::format("/F{} {} Tf <", code.font, number_text(line.size_mm, kDigits));
    }
    content_ += fmt::format("{:02X}", code.code);
  }
  content_ += font ? ">Tj ET\n" : "ET\n";
}

void PdfCanvas::end_page() {
  const int content = file_.add_stream("", content_);
  const int page =
      file_.add(fmt::format("<</Type/Page/Parent {}/MediaBox[0 0 {} {}]/Resources {}/Contents {}>>",
                            pdf_reference(page_tree_), number_text(kPointsAMm * page_.width_mm, 6),
                            number_text(kPointsAMm * page_.height_mm, 6), pdf_reference(resources_),
                            pdf_reference(content)));
  pages_.push_back(page);
  labels_.push_back(page_.label);
  for (Bookmark& bookmark : page_.bookmarks) entries_.push_back({std::move(bookmark), page});
}

/// Number ranges for pages that are called by their number, and each other label by itself
/// (ISO 32000-1, 12.4.2).
std::string PdfCanvas::page_labels() const {
  std::string ranges;
  bool in_numbers = false;
  for (std::size_t i = 0; i < labels_.size(); ++i) {
    if (!labels_[i].empty()) {
      ranges += fmt::format("{}<</P {}>>", i, pdf_text(labels_[i]));
    } else if (!in_numbers) {
      ranges += fmt::format("{}<</S/D/St {}>>", i, i + 1);
    }
    in_numbers = labels_[i].empty();
  }
  return ranges;
}

/// The outline as a tree of entries with links to parent, neighbours and children (ISO 32000-1,
/// 12.3.3); all closed but the topmost level. Returns the number of its root, 0 for none.
int PdfCanvas::write_outline() {
  if (entries_.empty()) return 0;
  struct Links {
    int number = 0;
    int parent = 0;  // object number
    int previous = 0, next = 0, first = 0, last = 0;
    int children = 0;
  };
  const int root = file_.reserve();
  std::vector<Links> all(entries_.size() + 1);  // the last one is the root
  Links& top = all.back();
  top.number = root;
  std::vector<std::size_t> open = {entries_.size()};  // the entry's ancestors, topmost first
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    all[i].number = file_.reserve();
    const auto level = static_cast<std::size_t>(std::max(entries_[i].bookmark.level, 0));
    open.resize(std::min(open.size(), level + 1));
    Links& parent = all[open.back()];
    all[i].parent = parent.number;
    all[i].previous = parent.last;
    if (parent.first == 0) parent.first = all[i].number;
    if (parent.last != 0) {
      // Its elder sibling is the last one with that number; numbers were given in order.
      all[static_cast<std::size_t>(parent.last - root - 1)].next = all[i].number;
    }
    parent.last = all[i].number;
    ++parent.children;
    open.push_back(i);
  }
  const auto link = [](const char* name, int number) {
    return number == 0 ? std::string() : fmt::format("/{} {}", name, pdf_reference(number));
  };
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const Links& links = all[i];
    const std::string count = links.children > 0 ? fmt::format("/Count {}", -links.children) : "";
    file_.write(
        links.number,
        fmt::format("<</Title {}/Dest[{}/Fit]{}{}{}{}{}{}>>", pdf_text(entries_[i].bookmark.title),
                    pdf_reference(entries_[i].page), link("Parent", links.parent),
                    link("Prev", links.previous), link("Next", links.next),
                    link("First", links.first), link("Last", links.last), count));
  }
  file_.write(root, fmt::format("<</Type/Outlines{}{}/Count {}>>", link("First", top.first),
                                link("Last", top.last), top.children));
  return root;
}

void PdfCanvas::finish() {
  std::string kids;
  for (const int page : pages_) kids += pdf_reference(page) + " ";
  file_.write(page_tree_, fmt::format("<</Type/Pages/Count {}/Kids[{}]>>", pages_.size(), kids));
  const std::string fonts = fonts_.write(file_);
  file_.write(resources_, fonts.empty() ? "<<>>" : fmt::format("<</Font<<{}>>>>", fonts));
  const int outline = write_outline();
  const std::string outlines =
      outline == 0 ? "" : fmt::format("/Outlines {}/PageMode/UseOutlines", pdf_reference(outline));
  const int catalog = file_.add(fmt::format(
      "<</Type/Catalog/Pages {}/ViewerPreferences<</PrintScaling/None/DisplayDocTitle true>>"
      "/PageLabels<</Nums[{}]>>{}>>",
      pdf_reference(page_tree_), page_labels(), outlines));
  file_.finish(catalog, info_);
}

}  // namespace tagmint::draw
