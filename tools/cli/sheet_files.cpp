#include "cli/sheet_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include "cli/options.h"
#include "cli/output.h"
#include "draw/read_back.h"
#include "draw/sheet_writer.h"
#include "draw/units.h"

namespace tagmint::cli {
namespace {

constexpr std::array<std::string_view, 5> kNameFields = {"family", "id", "edge", "outer", "page"};

draw::FileKind kind_of(const std::string& option, const std::string& pattern) {
  std::vector<std::string> words(draw::file_kind_names().begin(), draw::file_kind_names().end());
  words.emplace_back("tif");
  const std::string word = choose_format(option, pattern, words, "");
  if (const auto kind = draw::file_kind_of(word)) return *kind;
  throw UsageError("the name of the output has no extension that tells its format", pattern,
                   "name it .pdf, .svg or .png, or give --format");
}

/// Hands bytes on in larger pieces.
class Buffer {
 public:
  explicit Buffer(draw::ByteSink sink) : sink_(std::move(sink)) {}
  void add(std::string_view bytes) {
    held_ += bytes;
    constexpr std::size_t kPiece = 1 << 18;
    if (held_.size() >= kPiece) flush();
  }
  void flush() {
    sink_(held_);
    held_.clear();
  }

 private:
  draw::ByteSink sink_;
  std::string held_;
};

}  // namespace

SheetTarget::SheetTarget(const std::string& pattern, const std::string& format)
    : pattern_(pattern),
      name_(parse_option([](std::string_view text) { return draw::TextFormat(text, kNameFields); },
                         pattern, "-o")),
      kind_(kind_of(format, pattern)) {
  if (name_.uses("page") && is_file_a_tag()) {
    throw UsageError("a name with {page} is one file a page, with other fields one file a tag",
                     pattern, "use one or the other");
  }
  if (name_.uses("page") && kind_ == draw::FileKind::Pdf) {
    throw UsageError("a PDF holds all pages", pattern, "leave {page} out of its name");
  }
}

bool SheetTarget::is_file_a_tag() const {
  const auto tag_fields = draw::label_fields();
  return std::any_of(tag_fields.begin(), tag_fields.end(),
                     [&](std::string_view field) { return name_.uses(field); });
}

std::string SheetTarget::page_file(std::size_t page) const {
  const std::vector<draw::FieldValue> values = {{"page", std::uint64_t{page + 1}}};
  return name_.expand(values);
}

std::string SheetTarget::tag_file(const draw::TagGroup& group, codec::TagId id) const {
  return name_.expand(draw::tag_fields(group, id, ""));
}

SheetFiles::SheetFiles(const SheetTarget& target, const SheetJob& job, bool verify,
                       const Common& common)
    : target_(target),
      job_(job),
      progress_(common, "sheet", target.is_file_a_tag() ? "files" : "pages") {
  if (verify) checker_ = std::make_unique<draw::SheetChecker>(job.groups, job.decor.inverted);
}

/// Counts a page as drawn, or as read back.
void SheetFiles::advance() {
  guard_.throw_if_interrupted("nothing was written");
  // A page that is verified counts twice: drawing it and reading it take their time each.
  steps_ += checker_ ? 0.5 : 1.0;
  progress_.update(steps_, all_steps_);
}

void SheetFiles::write_file(const std::string& name, const draw::SheetPlan& plan, std::size_t first,
                            std::size_t last, const draw::FileOptions& options) {
  const auto draw_to = [&](draw::ByteSink sink) {
    Buffer buffer(std::move(sink));
    draw::write_sheet(
        plan, job_.decor, first, last, target_.kind(), options,
        [&](std::string_view bytes) { buffer.add(bytes); }, [this](std::size_t) { advance(); });
    buffer.flush();
  };
  if (is_stdout(name)) return draw_to([](std::string_view bytes) { write_stdout(bytes); });
  codec::AtomicFile file(name);
  draw_to([&](std::string_view bytes) { file.write(bytes); });
  file.close();
  if (checker_) verify_file(file, plan, first, last);
  finished_.push_back(std::move(file));
}

void SheetFiles::verify_file(const codec::AtomicFile& file, const draw::SheetPlan& plan,
                             std::size_t first, std::size_t last) {
  const auto written = draw::open_written(file.written_path(), target_.kind(), job_.file.dpi);
  // In a picture of one bit, edges that are not on a dot's side move there: by half a dot at most
  // along each axis, unless all cells are whole dots.
  const bool rounds =
      draw::is_raster(target_.kind()) && job_.file.bits == 1 && job_.page.dot_mm == 0;
  const double slack_mm = rounds ? 0.71 * draw::kMmAnInch / job_.file.dpi : 0.0;
  for (std::size_t page = first; page < last; ++page) {
    const double dpi = draw::SheetChecker::reading_dpi(plan, page);
    const draw::PageCheck result =
        checker_->check(written->page(page - first, dpi), plan, page, slack_mm);
    if (result.fault) {
      throw codec::OutputError(
          fmt::format("reading back what was written, {} id {} on page {} {}", result.fault->family,
                      result.fault->id, page + 1, result.fault->what),
          file.path().string(),
          "nothing was written; a larger edge, a wider quiet zone or more dots per inch help");
    }
    verified_.tags += result.tags;
    verified_.largest_error_mm = std::max(verified_.largest_error_mm, result.largest_error_mm);
    advance();
  }
}

/// Gives all files their names.
void SheetFiles::publish() {
  progress_.clear();
  for (codec::AtomicFile& file : finished_) file.publish();
  finished_.clear();
}

void SheetFiles::write_pages(const draw::SheetPlan& plan) {
  require_room_for_pages(target_, plan.pages.size());
  require_writable(target_.page_file(0));
  all_steps_ = static_cast<double>(plan.pages.size());
  if (!target_.is_file_a_page()) {
    write_file(target_.page_file(0), plan, 0, plan.pages.size(), job_.file);
  } else {
    for (std::size_t page = 0; page < plan.pages.size(); ++page) {
      write_file(target_.page_file(page), plan, page, page + 1, job_.file);
    }
  }
  publish();
}

std::size_t SheetFiles::write_tags() {
  const std::size_t files = count_tag_files(target_, job_);
  require_writable(target_.tag_file(job_.groups[0], job_.groups[0].ids[0]));
  all_steps_ = static_cast<double>(files);
  for (const draw::TagGroup& group : job_.groups) {
    for (const codec::TagId id : group.ids) {
      draw::FileOptions options = job_.file;
      options.title = fmt::format("{} {}", group.family->name(), id);
      const draw::SheetPlan plan = draw::plan_single(group.family, group.edge_mm, id, job_.page);
      write_file(target_.tag_file(group, id), plan, 0, 1, options);
    }
  }
  publish();
  return files;
}

void require_verifiable(const SheetTarget& target, const SheetArguments& arguments) {
  const std::string kind(draw::name_of(target.kind()));
  if (arguments.outline) {
    throw UsageError("outlines are no picture that could be read back", "--verify",
                     "verify the sheet without --outline, or leave --verify out");
  }
  if (!draw::can_read_back(target.kind())) {
    throw UsageError(fmt::format("a {} file cannot be read back by this program", kind), "--verify",
                     "verify a PDF of the same sheet, or leave --verify out");
  }
  if (is_stdout(target.pattern())) {
    throw UsageError("what goes to stdout cannot be read back", "--verify",
                     "write to a file, or leave --verify out");
  }
}

std::size_t count_tag_files(const SheetTarget& target, const SheetJob& job) {
  std::set<std::string> names;
  for (const draw::TagGroup& group : job.groups) {
    for (const codec::TagId id : group.ids) {
      const std::string name = target.tag_file(group, id);
      if (!names.insert(name).second) {
        throw UsageError(fmt::format("two tags would be written to '{}'", name), target.pattern(),
                         "put {family}, {id} and, for several sizes, {edge} into the name");
      }
    }
  }
  return names.size();
}

void require_room_for_pages(const SheetTarget& target, std::size_t pages) {
  if (pages < 2 || target.is_file_a_page() || draw::holds_pages(target.kind())) return;
  throw UsageError(
      fmt::format("{} pages do not go into one {} file", pages, draw::name_of(target.kind())),
      target.pattern(),
      fmt::format("put {{page}} into its name, like sheet-{{page}}.{}, or write a PDF",
                  draw::name_of(target.kind())));
}

}  // namespace tagmint::cli
