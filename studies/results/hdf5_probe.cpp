#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <filesystem>
#include <new>

#include "engine/base/error.h"
#include "studies/results/hdf5_checks.h"

namespace gurney::hdf5 {
namespace {

enum Exit { kRead = 0, kRefused = 1, kTooLarge = 2 };

double largest_data(double file_size) { return 2e9 + 20 * file_size; }

/// Whether this process may take less than its child did.
bool is_limited(double file_size) {
  for (const int what : {RLIMIT_AS, RLIMIT_DATA}) {
    rlimit limits;
    if (::getrlimit(static_cast<__rlimit_resource>(what), &limits) == 0 &&
        static_cast<double>(limits.rlim_cur) < largest_data(file_size))
      return true;
  }
  return false;
}

void limit(int what, double most) {
  rlimit limits;
  if (::getrlimit(static_cast<__rlimit_resource>(what), &limits) != 0) return;
  limits.rlim_cur = std::min(limits.rlim_max, static_cast<rlim_t>(most));
  ::setrlimit(static_cast<__rlimit_resource>(what), &limits);
}

/// A crash of the child is no news for the terminal, and leaves no core.
void prepare_child(double file_size) {
  for (const int signal : {SIGINT, SIGTERM, SIGALRM}) std::signal(signal, SIG_DFL);
  if (const int null = ::open("/dev/null", O_RDWR); null >= 0)
    for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) ::dup2(null, stream);
  limit(RLIMIT_CORE, 0);
  // Some hundred times what a file of this program takes, for emulators and debugging allocators.
  const double seconds = 30 + file_size / 2e5;
  limit(RLIMIT_CPU, seconds);
  ::alarm(static_cast<unsigned>(std::min(20 * seconds, 1e6)));
  limit(RLIMIT_DATA, largest_data(file_size));
}

/// @param out  takes the error
[[noreturn]] void run_child(double file_size, const std::function<void()>& read, int out) {
  int code = kRead;
  try {
    prepare_child(file_size);
    read();
  } catch (const std::bad_alloc&) {
    code = kTooLarge;
  } catch (const std::exception& error) {
    code = kRefused;
    const std::string text = error.what();
    if (::write(out, text.data(), text.size()) < 0) code = kTooLarge;
  }
  ::_exit(code);
}

std::string all_of(int in) {
  std::string text;
  char some[512];
  for (ssize_t got = 0; (got = ::read(in, some, sizeof some)) != 0;) {
    if (got > 0) text.append(some, static_cast<std::size_t>(got));
    if (got < 0 && errno != EINTR) break;
  }
  return text;
}

}  // namespace

void probe(const std::string& path, const std::function<void()>& read) {
  std::error_code ignored;
  const auto size = static_cast<double>(std::filesystem::file_size(path, ignored));
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) return;  // no process to spare: as without a probe
  const pid_t child = ::fork();
  if (child == 0) run_child(size, read, ends[1]);
  ::close(ends[1]);
  const std::string error = child < 0 ? "" : all_of(ends[0]);
  ::close(ends[0]);
  if (child < 0) return;
  int status = 0;
  while (::waitpid(child, &status, 0) < 0)
    if (errno != EINTR) return;
  const int code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  require(code != kRefused, error);
  if (code == kTooLarge && is_limited(size)) throw std::bad_alloc();
  const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  require(signal != SIGXCPU && signal != SIGALRM,
          path + ": took too long to read for a file of its size");
  require(code != kTooLarge,
          path + ": is damaged: to read it takes more memory than its size can ask for");
  require(code == kRead, path + ": is damaged: the HDF5 library crashes over it");
}

}  // namespace gurney::hdf5
