#include "cli/sheet_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include "cli/options.h"
#include "cli/output.h"
#include "cli/progress.h"

namespace tagmint::cli {
namespace {

constexpr std::array<std::string_view, 5> kNameFields = {"family", "id", "edge", "outer", "page"};

draw::FileKind format_of(const std::string& option, const std::string& pattern) {
  const std::vector<std::string> words = {"pdf", "svg", "png"};
  const std::string word = choose_format(option, pattern, words, "");
  if (word.empty()) {
    throw UsageError("the name of the output has no extension that tells its format", pattern,
                     "name it .pdf, .svg or .png, or give --format");
  }
  if (word == "pdf") return draw::FileKind::Pdf;
  return word == "svg" ? draw::FileKind::Svg : draw::FileKind::Png;
}

std::string render_page(draw::FileKind format, const draw::SheetPlan& plan, std::size_t page,
                        const draw::SheetDecor& decor, double dpi) {
  return format == draw::FileKind::Svg ? draw::sheet_svg(plan, page, decor)
                                          : draw::sheet_png(plan, page, decor, dpi);
}

/// What a PDF calls itself: the title, or the families in it.
std::string pdf_title(const draw::SheetPlan& plan, const draw::SheetDecor& decor) {
  if (!decor.title.empty()) return decor.title;
  std::string title;
  for (const draw::TagGroup& group : plan.groups) {
    const std::string& name = group.family->name();
    if (title.find(name) == std::string::npos) title += (title.empty() ? "" : ", ") + name;
  }
  return title;
}

}  // namespace

SheetTarget::SheetTarget(const std::string& pattern, const std::string& format)
    : pattern_(pattern),
      name_(parse_option([](std::string_view text) { return draw::TextFormat(text, kNameFields); },
                         pattern, "-o")),
      format_(format_of(format, pattern)) {
  if (name_.uses("page") && is_file_a_tag()) {
    throw UsageError("a name with {page} is one file a page, with other fields one file a tag",
                     pattern, "use one or the other");
  }
  if (name_.uses("page") && format_ == draw::FileKind::Pdf) {
    throw UsageError("a PDF holds all pages", pattern, "leave {page} out of its name");
  }
}

bool SheetTarget::is_file_a_tag() const {
  const auto tag_fields = draw::label_fields();
  return std::any_of(tag_fields.begin(), tag_fields.end(),
                     [&](std::string_view field) { return name_.uses(field); });
}

void SheetTarget::write_pages(const draw::SheetPlan& plan, const draw::SheetDecor& decor,
                              double dpi, const Common& common) const {
  const auto file = [&](std::size_t page) {
    const std::vector<draw::FieldValue> values = {{"page", std::uint64_t{page + 1}}};
    return name_.expand(values);
  };
  require_writable(file(0));
  if (format_ == draw::FileKind::Pdf) {
    write_output(file(0), draw::sheet_pdf(plan, decor, pdf_title(plan, decor)));
    return;
  }
  if (plan.pages.size() > 1 && !name_.uses("page")) {
    throw UsageError(fmt::format("{} pages do not go into one SVG or PNG file", plan.pages.size()),
                     pattern_, "put {page} into its name, like sheet-{page}.svg, or write a PDF");
  }
  Progress progress(common, "sheet", "pages");
  for (std::size_t page = 0; page < plan.pages.size(); ++page) {
    write_output(file(page), render_page(format_, plan, page, decor, dpi));
    progress.update(static_cast<double>(page + 1), static_cast<double>(plan.pages.size()));
  }
}

std::string SheetTarget::tag_file(const draw::TagGroup& group, codec::TagId id) const {
  return name_.expand(draw::tag_fields(group, id, ""));
}

std::size_t SheetTarget::write_tags(const std::vector<draw::TagGroup>& groups,
                                    const draw::SheetOptions& options,
                                    const draw::SheetDecor& decor, double dpi,
                                    const Common& common) const {
  std::set<std::string> names;
  for (const draw::TagGroup& group : groups) {
    for (const codec::TagId id : group.ids) {
      const std::string name = tag_file(group, id);
      if (!names.insert(name).second) {
        throw UsageError(fmt::format("two tags would be written to '{}'", name), pattern_,
                         "put {family}, {id} and, for several sizes, {edge} into the name");
      }
    }
  }
  require_writable(tag_file(groups[0], groups[0].ids[0]));
  Progress progress(common, "sheet", "files");
  std::size_t done = 0;
  for (const draw::TagGroup& group : groups) {
    for (const codec::TagId id : group.ids) {
      const draw::SheetPlan plan = draw::plan_single(group.family, group.edge_mm, id, options);
      write_output(
          tag_file(group, id),
          format_ == draw::FileKind::Pdf
              ? draw::sheet_pdf(plan, decor, fmt::format("{} {}", group.family->name(), id))
              : render_page(format_, plan, 0, decor, dpi));
      progress.update(static_cast<double>(++done), static_cast<double>(names.size()));
    }
  }
  return done;
}

}  // namespace tagmint::cli
