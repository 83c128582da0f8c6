#pragma once

#include <string>

#include "draw/canvas.h"
#include "draw/colour_model.h"

namespace tagmint::draw {

/// A PostScript file (level 2) of any number of pages, or an EPS file of one. Text is outlines.
///   source   Adobe, PostScript Language Reference; Document Structuring Conventions 3.0; EPSF 3.0
class PsCanvas final : public Canvas {
 public:
  enum class Kind { Ps, Eps };

  ///   title   noted in the file; characters beyond ASCII become '?'
  PsCanvas(ByteSink sink, Kind kind, std::string title, InkModel ink_model = InkModel::Gray);

  /// Throws std::logic_error for a second page of an EPS file.
  void begin_page(const PageSetup& page) override;
  void paint_ground(const Path& area) override;
  void fill(const Path& path, const Placement& place, const Ink& ink) override;
  void stroke(const Path& path, const Placement& place, const Pen& pen) override;
  void show_text(const TextLine& line) override;
  void end_page() override;
  void finish() override;

 private:
  void put_header(const PageSetup& first_page);
  void put_if_large();

  ByteSink sink_;
  Kind kind_;
  std::string title_;
  InkModel ink_model_;
  int pages_ = 0;
  std::string text_;  // not yet handed to the sink
};

}  // namespace tagmint::draw
