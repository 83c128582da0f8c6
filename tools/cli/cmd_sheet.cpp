#include "cli/cmd_sheet.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <string>

#include "cli/options.h"
#include "cli/sheet_files.h"
#include "cli/sheet_job.h"
#include "cli/sheet_options.h"
#include "cli/sheet_report.h"
#include "cli/standard_output.h"
#include "cli/terminal.h"
#include "draw/units.h"

namespace tagmint::cli {
namespace {

void say_warnings(const SheetJob& job, const Common& common) {
  for (const std::string& warning : job.warnings) say(common, "warning: " + warning);
}

void report(const std::string& text, const SheetFiles& files, bool verified, const Common& common) {
  if (common.quiet) return;
  fmt::print(stderr, "{}", text);
  if (!verified) return;
  fmt::print(stderr, "  read back: all {} at their places, corners within {}\n",
             fmt::format("{} tag{}", files.verified().tags, files.verified().tags == 1 ? "" : "s"),
             draw::format_mm(files.verified().largest_error_mm));
}

int run_file_a_tag(const SheetArguments& arguments, const SheetTarget& target, const SheetJob& job,
                   const Common& common) {
  if (arguments.dry_run) {
    write_stdout(tag_files_report(job, count_tag_files(target, job), target.shown()));
    return kDone;
  }
  SheetFiles files(target, job, arguments.verify, common);
  const std::size_t written = files.write_tags();
  report(tag_files_report(job, written, target.shown()), files, arguments.verify, common);
  return kDone;
}

int run_sheet(const SheetArguments& arguments, const SheetTarget& target, const SheetJob& job,
              const draw::SheetPlan& plan, const Common& common) {
  if (arguments.dry_run) {
    require_room_for_pages(target, plan.pages.size());
    write_stdout(sheet_report(job, plan, target.shown()) + page_list(plan));
    return kDone;
  }
  SheetFiles files(target, job, arguments.verify, common);
  files.write_pages(plan);
  report(sheet_report(job, plan, target.shown()), files, arguments.verify, common);
  return kDone;
}

int run(const SheetArguments& arguments, const Common& common) try {
  const SheetTarget target(arguments.output, arguments.format);
  if (arguments.verify) require_verifiable(target, arguments);
  SheetJob job = sheet_job(arguments, target.kind(), target.is_file_a_tag());
  if (target.is_file_a_tag()) {
    say_warnings(job, common);
    return run_file_a_tag(arguments, target, job, common);
  }
  const draw::SheetPlan plan = plan_job(job, arguments);
  say_warnings(job, common);
  return run_sheet(arguments, target, job, plan, common);
} catch (const draw::DoesNotFit& fault) {
  throw UsageError(fault.what(), "", "");
} catch (const std::invalid_argument& fault) {
  throw usage_error(fault, "sheet");
}

Runner set_up(CLI::App& app, const Common& common) {
  auto arguments = std::make_shared<SheetArguments>();
  const auto note_given = add_sheet_options(app, arguments);
  return [arguments, note_given, &common] {
    note_given();
    return run(*arguments, common);
  };
}

}  // namespace

Command sheet_command() {
  return {.name = "sheet",
          .summary = "print tags at exact physical size: PDF, SVG, PNG and others",
          .examples = {"tagmint sheet tag36h11 --edge 40mm --ids 0-11 --cut-marks -o tags.pdf",
                       "tagmint sheet tag25h9 --outer 50mm -o 'tags/{family}-{id:05}.svg'"},
          .set_up = set_up};
}

}  // namespace tagmint::cli
