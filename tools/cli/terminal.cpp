#include "cli/terminal.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace tagmint::cli {
namespace {

void write_stderr(std::string_view text) {
  // A message that cannot be shown has nowhere to be complained about.
  std::fwrite(text.data(), 1, text.size(), stderr);
  std::fflush(stderr);
}

}  // namespace

bool is_terminal(int descriptor) {
  const char* term = std::getenv("TERM");
  const bool dumb = term != nullptr && std::string_view(term) == "dumb";
  return !dumb && isatty(descriptor) == 1;
}

bool wants_colour(int descriptor) {
  const char* no_color = std::getenv("NO_COLOR");
  return is_terminal(descriptor) && (no_color == nullptr || *no_color == '\0');
}

int terminal_columns(int descriptor) {
  winsize size = {};
  if (ioctl(descriptor, TIOCGWINSZ, &size) == 0 && size.ws_col > 0) return size.ws_col;
  return 80;
}

void say(const Common& common, std::string_view line) {
  if (!common.quiet) write_stderr("tagmint: " + std::string(line) + "\n");
}

void print_error(std::string_view line) {
  std::string text(line);
  std::replace(text.begin(), text.end(), '\n', ' ');
  const bool colour = wants_colour(STDERR_FILENO);
  const std::string_view red = colour ? "\033[1;31m" : "";
  const std::string_view plain = colour ? "\033[0m" : "";
  write_stderr("tagmint: " + std::string(red) + "error:" + std::string(plain) + " " + text + "\n");
}

}  // namespace tagmint::cli
