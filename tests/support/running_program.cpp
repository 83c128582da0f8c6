#include "support/running_program.h"

#include <fcntl.h>
#include <poll.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <stdexcept>

namespace tagmint::test {
namespace {

struct Ends {
  int ours = -1;
  int theirs = -1;
};

Ends make_pipe() {
  std::array<int, 2> ends = {};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
  return {ends[0], ends[1]};
}

Ends make_terminal() {
  Ends ends;
  if (openpty(&ends.ours, &ends.theirs, nullptr, nullptr, nullptr) != 0) {
    throw std::runtime_error("no terminal");
  }
  fcntl(ends.ours, F_SETFD, FD_CLOEXEC);
  fcntl(ends.theirs, F_SETFD, FD_CLOEXEC);
  return ends;
}

/// Appends what can be read; closes the descriptor at its end.
void read_into(std::string& text, int& descriptor) {
  std::array<char, 4096> buffer;
  const ssize_t count = read(descriptor, buffer.data(), buffer.size());
  if (count > 0) {
    text.append(buffer.data(), static_cast<std::size_t>(count));
  } else if (count == 0 || errno != EINTR) {  // a terminal whose program ended gives EIO
    close(descriptor);
    descriptor = -1;
  }
}

}  // namespace

RunningProgram::RunningProgram(const std::vector<std::string>& words, Stderr stderr_kind,
                               const std::vector<std::string>& environment) {
  const Ends out = make_pipe();
  const Ends err = stderr_kind == Stderr::Terminal ? make_terminal() : make_pipe();
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  pid_ = fork();
  if (pid_ < 0) throw std::runtime_error("cannot fork");
  if (pid_ == 0) {
    const int nothing = open("/dev/null", O_RDONLY);
    dup2(nothing, STDIN_FILENO);
    dup2(out.theirs, STDOUT_FILENO);
    dup2(err.theirs, STDERR_FILENO);
    for (const std::string& entry : environment) putenv(const_cast<char*>(entry.c_str()));
    execv(arguments[0], arguments.data());
    _exit(127);
  }
  close(out.theirs);
  close(err.theirs);
  out_ = out.ours;
  err_ = err.ours;
}

RunningProgram::~RunningProgram() {
  if (pid_ > 0) {
    kill(pid_, SIGKILL);
    finish();
  }
}

bool RunningProgram::wait_for_stderr(const std::string& text) {
  while (result_.err.find(text) == std::string::npos) {
    if (!read_some()) return false;
  }
  return true;
}

void RunningProgram::send_signal(int signal) { kill(pid_, signal); }

ProgramResult RunningProgram::finish() {
  while (read_some()) {
  }
  int status = 0;
  while (waitpid(pid_, &status, 0) == -1 && errno == EINTR) {
  }
  pid_ = -1;
  result_.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return result_;
}

bool RunningProgram::read_some() {
  std::array<pollfd, 2> ends = {{{out_, POLLIN, 0}, {err_, POLLIN, 0}}};
  if (out_ < 0 && err_ < 0) return false;
  if (poll(ends.data(), ends.size(), -1) < 0) return errno == EINTR;
  if (ends[0].revents != 0) read_into(result_.out, out_);
  if (ends[1].revents != 0) read_into(result_.err, err_);
  return true;
}

ProgramResult run(const std::vector<std::string>& words) { return RunningProgram(words).finish(); }

}  // namespace tagmint::test
