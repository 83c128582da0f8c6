#include "support/chromium.h"

#include <sstream>
#include <stdexcept>
#include <vector>

#include "support/running_program.h"
#include "support/scratch_folder.h"

namespace tagmint::test {
namespace {

/// A page is there in a second; a browser that hangs is ended.
constexpr const char* kPatience = "60";

ProgramResult run_chromium(const ScratchFolder& profile, const std::vector<std::string>& options,
                           const std::string& address) {
  std::vector<std::string> words = {TAGMINT_TIMEOUT,
                                    "--kill-after=5",
                                    kPatience,
                                    TAGMINT_CHROMIUM,
                                    "--headless",
                                    "--no-sandbox",
                                    "--disable-gpu",
                                    "--disable-dev-shm-usage",
                                    "--disable-background-networking",
                                    "--disable-component-update",
                                    "--no-first-run",
                                    "--hide-scrollbars",
                                    "--enable-logging=stderr",
                                    "--user-data-dir=" + profile.file("profile")};
  words.insert(words.end(), options.begin(), options.end());
  words.push_back(address);
  ProgramResult result = run(words);
  if (result.exit_code != 0) {
    throw std::runtime_error("chromium ended with " + std::to_string(result.exit_code) + ": " +
                             result.err);
  }
  return result;
}

/// The lines of its log that a page's console wrote.
std::string console_of(const std::string& log) {
  std::istringstream stream(log);
  std::string console;
  for (std::string line; std::getline(stream, line);) {
    if (line.find("CONSOLE") != std::string::npos) console += line + "\n";
  }
  return console;
}

}  // namespace

LoadedPage load_page(const std::string& page, const std::string& fragment) {
  const ScratchFolder profile;
  const ProgramResult result = run_chromium(profile, {"--dump-dom"}, "file://" + page + fragment);
  return {result.out, console_of(result.err)};
}

void picture_page(const std::string& page, const std::string& fragment, int width, int height,
                  bool dark, const std::string& png) {
  const ScratchFolder profile;
  std::vector<std::string> options = {
      "--window-size=" + std::to_string(width) + "," + std::to_string(height),
      "--screenshot=" + png};
  if (dark) options.emplace_back("--blink-settings=preferredColorScheme=0");
  run_chromium(profile, options, "file://" + page + fragment);
}

}  // namespace tagmint::test
