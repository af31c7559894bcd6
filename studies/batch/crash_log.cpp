#include "studies/batch/crash_log.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <fstream>
#include <sstream>
#include <string_view>

#include "engine/base/error.h"

namespace gurney {
namespace {

constexpr std::array kSignals = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};
constexpr int kTries = 2;

int log_file = -1;  ///< of the one CrashLog there is
thread_local std::size_t unit_of_thread = 0, run_of_thread = 0;
thread_local volatile sig_atomic_t in_a_run = 0;

/// Text in a buffer: what a signal handler may use.
class Line {
 public:
  Line& operator<<(std::string_view text) {
    const std::size_t size = std::min(text.size(), bytes_.size() - size_);
    std::memcpy(bytes_.data() + size_, text.data(), size);
    size_ += size;
    return *this;
  }
  Line& operator<<(std::size_t number) {
    const auto end = std::to_chars(bytes_.data() + size_, bytes_.data() + bytes_.size(), number);
    size_ = static_cast<std::size_t>(end.ptr - bytes_.data());
    return *this;
  }
  void write_to(int file) const {
    [[maybe_unused]] const auto ignored = ::write(file, bytes_.data(), size_);
  }

 private:
  std::array<char, 256> bytes_{};
  std::size_t size_ = 0;
};

extern "C" void crashed(int signal_number) {
  if (in_a_run != 0) {
    const auto number = static_cast<std::size_t>(signal_number);
    Line line;
    line << unit_of_thread << " " << run_of_thread << " " << number << "\n";
    line.write_to(log_file);
    ::fsync(log_file);
    Line word;
    word << "\ngurney: crashed (signal " << number << ") in run " << run_of_thread << " of unit "
         << unit_of_thread << "; finished runs are kept, --resume goes on with the others\n";
    word.write_to(STDERR_FILENO);
  }
  ::raise(signal_number);  // SA_RESETHAND: this time it ends the process
}

CrashedRuns read(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::map<std::pair<std::size_t, std::size_t>, int> times;
  CrashedRuns given_up;
  std::string text;
  for (int number = 1; std::getline(stream, text); ++number) {
    std::istringstream line(text);
    std::size_t unit = 0, run = 0;
    int signal_number = 0;
    require(bool(line >> unit >> run >> signal_number),
            fmt::format("{}:{}: is no line `unit run signal`: '{}'", file.string(), number, text));
    if (++times[{unit, run}] == kTries)
      given_up[{unit, run}] =
          fmt::format("crashed the program {} times: {}", kTries, strsignal(signal_number));
  }
  return given_up;
}

}  // namespace

CrashLog::CrashLog(const std::filesystem::path& file) : given_up_(read(file)) {
  log_file = ::open(file.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
  require(log_file >= 0, fmt::format("{}: cannot be written: {}", file.string(), strerror(errno)));
  struct sigaction action {};
  action.sa_handler = crashed;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  for (const int each : kSignals) sigaction(each, &action, nullptr);
}

CrashLog::~CrashLog() {
  for (const int each : kSignals) signal(each, SIG_DFL);
  ::close(log_file);
  log_file = -1;
}

RunMark::RunMark(std::size_t unit, std::size_t run) {
  unit_of_thread = unit;
  run_of_thread = run;
  in_a_run = 1;
}

RunMark::~RunMark() { in_a_run = 0; }

}  // namespace gurney
