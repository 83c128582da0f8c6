#include "cli/drawing_target.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <vector>

#include "cli/options.h"
#include "io/atomic_files.h"

namespace tagmint::cli {
namespace {

std::vector<std::string> kind_names() {
  const auto names = draw::file_kind_names();
  return {names.begin(), names.end()};
}

}  // namespace

void add_drawing_options(CLI::App& app, double& dpi, std::string& format) {
  app.add_option("--dpi", dpi, "pixels per inch of PNG and TIFF files")
      ->check(number_between(1, 100000))
      ->type_name("N")
      ->capture_default_str();
  const std::vector<std::string> names = kind_names();
  add_choice(app, "--format", format, names,
             fmt::format("{}; default: by the extension of -o", fmt::join(names, " ")))
      ->type_name("KIND");
}

draw::FileKind drawing_kind(const std::string& format, const std::string& output) {
  const std::vector<std::string> names = kind_names();
  const std::string word = choose_format(format, output, names, "");
  if (word.empty()) {
    throw UsageError("the name of the output has no extension that tells its format", output,
                     "name it .pdf, .svg or .png, or give --format");
  }
  return *draw::file_kind_of(word);
}

void require_writable(std::span<const Result> results) {
  const auto to_stdout = std::count_if(results.begin(), results.end(), [](const Result& result) {
    return is_stdout(result.target);
  });
  if (to_stdout > 1) {
    throw UsageError("two results would go to stdout", "-", "give all but one a file");
  }
  for (const Result& result : results) require_writable(result.target);
}

void write_results(std::span<const Result> results) {
  io::AtomicFiles files;
  for (const Result& result : results) {
    if (!is_stdout(result.target)) files.add(result.target, result.content);
  }
  for (const Result& result : results) {
    if (is_stdout(result.target)) write_stdout(result.content);
  }
  files.finish();
}

}  // namespace tagmint::cli
