#include "cli/sheet_report.h"

#include <fmt/format.h>

#include <algorithm>

#include "draw/sheet_bookmarks.h"
#include "draw/units.h"

namespace tagmint::cli {
namespace {

std::string counted(std::size_t count, const char* word) {
  return fmt::format("{} {}{}", count, word, count == 1 ? "" : "s");
}

/// "tag36h11: 12 tags, edge 40 mm, outer 50 mm"
std::string describe(const SheetJob& job, const draw::TagGroup& group) {
  std::string line =
      fmt::format("{}: {}, edge {}, outer {}", group.family->name(),
                  counted(group.ids.size(), "tag"), draw::format_mm(group.edge_mm),
                  draw::format_mm(draw::outer_of_edge(group.family->layout(), group.edge_mm)));
  const auto rounded =
      std::find_if(job.rounded.begin(), job.rounded.end(), [&](const RoundedSize& size) {
        return size.family == group.family->name() && size.drawn_mm == group.edge_mm;
      });
  if (rounded != job.rounded.end()) {
    line += fmt::format(" ({} dots a cell; edge {} asked, {:+.2f} %)", rounded->dots_a_cell,
                        draw::format_mm(rounded->asked_mm), 100 * rounded->error());
  }
  return line;
}

}  // namespace

std::string sheet_report(const SheetJob& job, const draw::SheetPlan& plan,
                         const std::string& what) {
  std::string text =
      fmt::format("{}: {} on {} of {} x {}\n", what, counted(plan.tag_count(), "tag"),
                  counted(plan.pages.size(), "page"), draw::format_mm(plan.options.page_width_mm),
                  draw::format_mm(plan.options.page_height_mm));
  for (std::size_t i = 0; i < plan.groups.size(); ++i) {
    text += fmt::format("  {}; a page takes {} x {}\n", describe(job, plan.groups[i]),
                        plan.grids[i].columns, plan.grids[i].rows);
  }
  return text;
}

std::string tag_files_report(const SheetJob& job, std::size_t files, const std::string& what) {
  std::string text = fmt::format("{}: {} of one tag each\n", what, counted(files, "file"));
  for (const draw::TagGroup& group : job.groups) text += "  " + describe(job, group) + "\n";
  return text;
}

std::string page_list(const draw::SheetPlan& plan) {
  std::string text;
  for (std::size_t page = 0; page < plan.pages.size(); ++page) {
    text +=
        fmt::format("  page {}: {}\n", page + 1, fmt::join(draw::page_contents(plan, page), "; "));
  }
  return text;
}

}  // namespace tagmint::cli
