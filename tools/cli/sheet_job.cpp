#include "cli/sheet_job.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "cli/length.h"
#include "cli/options.h"
#include "cli/paper.h"
#include "cli/tag_request.h"
#include "draw/cut_outline.h"
#include "draw/units.h"

namespace tagmint::cli {
namespace {

/// A size that was rounded by more than this share is warned of.
constexpr double kWarnedShare = 0.01;

/// Titles and labels are one line of text; a line break or a tab would be drawn as an empty box.
void require_one_line(const std::string& text, const char* option) {
  const bool control =
      std::any_of(text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; });
  if (control) {
    throw UsageError("the text holds a line break or another control character", option,
                     "write one line of plain text");
  }
}

/// Refuses options that a kind of file, or one file a tag, does not know.
void require_meaning(const SheetArguments& arguments, draw::FileKind kind, bool file_a_tag) {
  const auto refuse = [&](std::initializer_list<const char*> names, const std::string& where,
                          const std::string& mend) {
    for (const char* name : names) {
      if (!arguments.is_given(name)) continue;
      throw UsageError(fmt::format("{} has no meaning for {}", name, where), arguments.output,
                       mend);
    }
  };
  if (file_a_tag) {
    refuse({"--paper", "--landscape", "--gap", "--columns", "--rows", "--cut-marks", "--cut-lines",
            "--ruler", "--title"},
           "one file a tag",
           "leave it out, or write to a name without {id} for sheets of many tags");
  }
  const std::string file = fmt::format("a {} file", draw::name_of(kind));
  using draw::FileKind;
  if (!draw::is_raster(kind)) {
    refuse({"--dpi", "--exact", "--depth"}, file, "leave it out, or write a PNG or TIFF");
  } else {
    refuse({"--outline"}, file, "leave it out, or write a PDF, SVG, PS, EPS or DXF");
  }
  if (kind != FileKind::Pdf && kind != FileKind::Ps && kind != FileKind::Eps) {
    refuse({"--color"}, file, "leave it out, or write a PDF, PS or EPS");
  }
  if (kind == FileKind::Dxf) refuse({"--ground"}, file, "leave it out");
  if (arguments.outline) refuse({"--ground"}, "outlines", "leave it out");
  if (kind == FileKind::Tiff && arguments.depth == "1" && arguments.ground == "none") {
    throw UsageError("a TIFF of 1 bit a pixel has no transparency", "--ground none",
                     "take --depth 8, or write a PNG");
  }
}

std::vector<draw::TagGroup> tag_groups(const SheetArguments& arguments) {
  TagDefaults defaults{.edge_mm = {}, .outer_mm = {}, .ids = arguments.ids};
  if (!arguments.edge.empty()) defaults.edge_mm = parse_length_mm(arguments.edge, "--edge");
  if (!arguments.outer.empty()) defaults.outer_mm = parse_length_mm(arguments.outer, "--outer");
  std::vector<draw::TagGroup> groups;
  for (const std::string& tag : arguments.tags) {
    groups.push_back(resolve_tag_request(tag, defaults));
  }
  return groups;
}

/// The label's format; nothing for "none". Pages of one tag, and files for cutters, have a label
/// only when asked.
std::optional<draw::TextFormat> label_format(const SheetArguments& arguments, bool by_default) {
  if (arguments.label == "none" || (arguments.label.empty() && !by_default)) return std::nullopt;
  return parse_option(
      [](std::string_view text) { return draw::TextFormat(text, draw::label_fields()); },
      arguments.label.empty() ? kDefaultSheetLabel : arguments.label, "--label");
}

draw::CutShape cut_shape_of(const std::string& word) {
  if (word == "rounded") return draw::CutShape::Rounded;
  return word == "circle" ? draw::CutShape::Circle : draw::CutShape::Square;
}

draw::SheetOptions page_options(const SheetArguments& arguments, bool file_a_tag) {
  PaperSize paper = parse_paper(arguments.paper);
  if (arguments.landscape) {
    paper = {std::max(paper.width_mm, paper.height_mm), std::min(paper.width_mm, paper.height_mm)};
  }
  const std::string margin =
      arguments.margin.empty() ? (file_a_tag ? "0mm" : kDefaultSheetMargin) : arguments.margin;
  return {.page_width_mm = paper.width_mm,
          .page_height_mm = paper.height_mm,
          .margin_mm = parse_length_mm(margin, "--margin"),
          .gap_mm = parse_length_mm(arguments.gap, "--gap"),
          .columns = arguments.columns,
          .rows = arguments.rows,
          .quiet_zone_cells = arguments.quiet_zone_cells,
          .cut_shape = cut_shape_of(arguments.cut_lines)};
}

draw::FileOptions file_options(const SheetArguments& arguments) {
  draw::FileOptions file;
  file.ink_model = arguments.color == "k" ? draw::InkModel::Key : draw::InkModel::Gray;
  if (!arguments.ground.empty()) file.white_ground = arguments.ground == "white";
  file.dpi = arguments.dpi;
  file.bits = arguments.depth == "1" ? 1 : 8;
  file.outline = arguments.outline;
  return file;
}

/// Makes the cells of all tags whole dots, unless the exact size was asked for; warns of what is
/// far off, or not whole.
void fit_to_dots(SheetJob& job, const SheetArguments& arguments) {
  const double dot_mm = draw::kMmAnInch / arguments.dpi;
  for (draw::TagGroup& group : job.groups) {
    const codec::Layout& layout = group.family->layout();
    const double whole = draw::whole_dot_edge(layout, group.edge_mm, arguments.dpi);
    const double cell_dots = group.edge_mm / layout.width_at_border() / dot_mm;
    const RoundedSize size{
        group.family->name(), group.edge_mm, whole,
        static_cast<int>(std::lround(whole / layout.width_at_border() / dot_mm))};
    constexpr double kSame = 1e-9;
    if (std::abs(size.error()) < kSame) continue;
    if (arguments.exact) {
      job.warnings.push_back(fmt::format(
          "{}: a cell of {} is {:.3f} dots at {:g} dpi, so its edges are not sharp; an edge of {} "
          "has {} dots a cell",
          size.family, draw::format_mm(group.edge_mm / layout.width_at_border()), cell_dots,
          arguments.dpi, draw::format_mm(whole), size.dots_a_cell));
      continue;
    }
    if (std::abs(size.error()) > kWarnedShare) {
      job.warnings.push_back(fmt::format(
          "{}: whole dots a cell at {:g} dpi make the edge {} instead of {}, {:+.1f} %; more dots "
          "per inch come nearer, --exact keeps the size",
          size.family, arguments.dpi, draw::format_mm(whole), draw::format_mm(group.edge_mm),
          100 * size.error()));
    }
    job.rounded.push_back(size);
    group.edge_mm = whole;
  }
  if (!arguments.exact) job.page.dot_mm = dot_mm;
}

void warn_of_narrow_quiet_zones(SheetJob& job) {
  if (job.page.quiet_zone_cells >= 1) return;
  for (const draw::TagGroup& group : job.groups) {
    if (draw::quiet_cells(group.family->layout()) == 0) continue;  // has a white ring of its own
    job.warnings.push_back(
        fmt::format("{}: a quiet zone of {:g} cells is less than one; detectors may miss such tags",
                    group.family->name(), job.page.quiet_zone_cells));
  }
}

/// What a file calls itself: the title, or the families in it.
std::string file_title(const SheetArguments& arguments, const std::vector<draw::TagGroup>& groups) {
  if (!arguments.title.empty()) return arguments.title;
  std::vector<std::string> names;
  for (const draw::TagGroup& group : groups) {
    const std::string& name = group.family->name();
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

/// The heights and widths that the decor takes from the page.
void reserve_for_decor(SheetJob& job) {
  job.page.label_mm = draw::label_height_mm(job.decor, job.groups);
  job.page.header_mm = draw::header_height_mm(job.decor);
  job.page.footer_mm = draw::footer_height_mm(job.decor, job.groups.size());
  job.page.side_mm = draw::side_width_mm(job.decor);
}

/// Where a ruler goes on a page with the job's title and notes.
draw::RulerPlace ruler_place_of(const SheetJob& job) {
  draw::SheetDecor bare = job.decor;
  bare.ruler = draw::RulerPlace::None;
  const double used =
      draw::header_height_mm(bare) + draw::footer_height_mm(bare, job.groups.size());
  const double margins = 2 * job.page.margin_mm;
  return draw::ruler_place({job.page.margin_mm, job.page.margin_mm,
                            job.page.page_width_mm - margins,
                            job.page.page_height_mm - margins - used});
}

}  // namespace

SheetJob sheet_job(const SheetArguments& arguments, draw::FileKind kind, bool file_a_tag) {
  require_one_line(arguments.title, "--title");
  require_one_line(arguments.label, "--label");
  require_meaning(arguments, kind, file_a_tag);
  // What a laser cutter is given holds nothing that it should not cut or engrave.
  const bool for_cutters = arguments.outline || kind == draw::FileKind::Dxf;
  SheetJob job;
  job.groups = tag_groups(arguments);
  job.page = page_options(arguments, file_a_tag);
  job.decor = {.label = label_format(arguments, !file_a_tag && !for_cutters),
               .title = arguments.title,
               .notes = !file_a_tag && !for_cutters,
               .ruler = draw::RulerPlace::None,
               .cut_marks = arguments.cut_marks,
               .cut_lines = !arguments.cut_lines.empty(),
               .inverted = arguments.invert};
  job.file = file_options(arguments);
  job.file.title = file_title(arguments, job.groups);
  if (draw::is_raster(kind)) fit_to_dots(job, arguments);
  warn_of_narrow_quiet_zones(job);
  if ((job.decor.cut_marks || job.decor.cut_lines) && job.page.gap_mm < draw::kCutGapMm) {
    throw UsageError(fmt::format("{} stand in the gap between tags, which is {}",
                                 arguments.cut_marks ? "cut marks" : "cut lines",
                                 draw::format_mm(job.page.gap_mm)),
                     arguments.cut_marks ? "--cut-marks" : "--cut-lines",
                     "give a gap, for example --gap 5mm");
  }
  if (!file_a_tag && (arguments.ruler || (!arguments.no_ruler && !for_cutters))) {
    job.decor.ruler = ruler_place_of(job);
  }
  reserve_for_decor(job);
  return job;
}

draw::SheetPlan plan_job(SheetJob& job, const SheetArguments& arguments) {
  try {
    return draw::plan_sheet(job.groups, job.page);
  } catch (const draw::DoesNotFit&) {
    if (arguments.ruler || job.decor.ruler == draw::RulerPlace::None) throw;
  }
  job.decor.ruler = draw::RulerPlace::None;
  reserve_for_decor(job);
  draw::SheetPlan plan = draw::plan_sheet(job.groups, job.page);
  job.warnings.push_back("the page has no room for a ruler beside the tags; it is left out");
  return plan;
}

}  // namespace tagmint::cli
