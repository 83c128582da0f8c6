#include "cli/standard_output.h"

#include <cerrno>
#include <cstdio>
#include <string>
#include <system_error>

namespace tagmint::cli {

void write_stdout(std::string_view text) {
  errno = 0;
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if (written && std::fflush(stdout) == 0) return;
  const int error = errno;
  const std::string reason = std::generic_category().message(error);
  if (error == EPIPE) throw BrokenPipe("cannot write: " + reason, "stdout", "");
  throw codec::OutputError("cannot write: " + reason, "stdout",
                           "give the result another place with -o FILE");
}

}  // namespace tagmint::cli
