#include "cli/process.h"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <stdexcept>
#include <system_error>

#include "cli/command.h"

namespace tagmint::cli {
namespace {

// A signal handler may touch lock-free atomics and call write() and _exit() only, so it wakes the
// guard's watcher thread through a pipe; that thread may then do what it likes.
std::atomic<int> g_wake_descriptor = -1;
std::atomic<bool> g_stop_asked = false;
static_assert(std::atomic<int>::is_always_lock_free && std::atomic<bool>::is_always_lock_free);

constexpr char kStop = 's';
constexpr char kQuit = 'q';

void on_signal(int) {
  const int saved_errno = errno;
  const int descriptor = g_wake_descriptor.load();
  if (descriptor < 0 || g_stop_asked.exchange(true)) _exit(kInterrupted);
  if (write(descriptor, &kStop, 1) != 1) _exit(kInterrupted);
  errno = saved_errno;
}

/// A closed standard stream is opened the wrong way round, so that using it fails but no other file
/// gets its number.
void hold_descriptor(int descriptor, int flags) {
  if (fcntl(descriptor, F_GETFD) != -1 || errno != EBADF) return;
  const int opened = open("/dev/null", flags);
  if (opened >= 0 && opened != descriptor) {
    dup2(opened, descriptor);
    close(opened);
  }
}

}  // namespace

void prepare_process() {
  hold_descriptor(STDIN_FILENO, O_WRONLY);
  hold_descriptor(STDOUT_FILENO, O_RDONLY);
  hold_descriptor(STDERR_FILENO, O_RDONLY);
  std::signal(SIGPIPE, SIG_IGN);
  struct sigaction action = {};
  action.sa_handler = on_signal;
  action.sa_flags = SA_RESTART;
  sigemptyset(&action.sa_mask);
  for (const int signal : {SIGINT, SIGTERM}) sigaction(signal, &action, nullptr);
}

InterruptGuard::InterruptGuard() {
  if (g_wake_descriptor.load() >= 0) throw std::logic_error("two InterruptGuards at once");
  if (pipe2(pipe_, O_CLOEXEC) != 0) {
    throw std::system_error(errno, std::generic_category(), "cannot open a pipe");
  }
  watcher_ = std::thread([this] {
    char message = kQuit;
    while (read(pipe_[0], &message, 1) == -1 && errno == EINTR) {
    }
    if (message == kStop) source_.request_stop();
  });
  g_stop_asked = false;
  g_wake_descriptor = pipe_[1];
}

InterruptGuard::~InterruptGuard() {
  g_wake_descriptor = -1;
  while (write(pipe_[1], &kQuit, 1) == -1 && errno == EINTR) {
  }
  watcher_.join();
  close(pipe_[0]);
  close(pipe_[1]);
}

void InterruptGuard::throw_if_interrupted(std::string_view left_undone) const {
  if (source_.stop_requested()) throw Interrupted("interrupted", "", left_undone);
}

}  // namespace tagmint::cli
