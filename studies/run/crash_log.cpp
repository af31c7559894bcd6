#include "studies/run/crash_log.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <sstream>
#include <string_view>

#include "engine/base/error.h"

namespace gurney::study {
namespace {

constexpr std::array kSignals = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};
constexpr int kTries = 2;

int log_file = -1;  ///< of the one CrashLog there is
thread_local std::size_t task_of_thread = 0, run_of_thread = 0;
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
    line << task_of_thread << " " << run_of_thread << " " << number << "\n";
    line.write_to(log_file);
    ::fsync(log_file);
    Line word;
    word << "\ngurney: crashed (signal " << number << ") in run " << run_of_thread
         << " of analysis case " << task_of_thread
         << "; finished runs are kept, --resume goes on with the others\n";
    word.write_to(STDERR_FILENO);
  }
  ::raise(signal_number);  // SA_RESETHAND: this time it ends the process
}

std::string contents_of(int file) {
  std::string text;
  std::array<char, 4096> bytes{};
  for (ssize_t size; (size = ::read(file, bytes.data(), bytes.size())) > 0;)
    text.append(bytes.data(), static_cast<std::size_t>(size));
  return text;
}

}  // namespace

CrashLog::CrashLog(const std::filesystem::path& file) {
  const int descriptor =
      ::open(file.c_str(), O_RDWR | O_CREAT | O_APPEND | O_NOFOLLOW | O_CLOEXEC, 0644);
  require(descriptor >= 0,
          fmt::format("{}: cannot be written: {}", file.string(), strerror(errno)));
  const std::string text = contents_of(descriptor);
  // A power cut may have torn the last line: it is cut off, so that the next one stands alone.
  const std::size_t whole = text.rfind('\n') + 1;
  if (whole < text.size() && ::ftruncate(descriptor, static_cast<off_t>(whole)) != 0)
    warnings_.push_back(file.string() + ": its torn last line cannot be cut off");
  read(file, text.substr(0, whole));
  log_file = descriptor;
  struct sigaction action {};
  action.sa_handler = crashed;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  for (const int each : kSignals) sigaction(each, &action, nullptr);
}

void CrashLog::read(const std::filesystem::path& file, const std::string& text) {
  std::map<std::pair<std::size_t, std::size_t>, int> times;
  std::istringstream lines(text);
  int number = 0;
  for (std::string each; std::getline(lines, each);) {
    ++number;
    std::istringstream line(each);
    std::size_t task = 0, run = 0;
    int signal_number = 0;
    std::string rest;
    if (!(line >> task >> run >> signal_number) || line >> rest)
      warnings_.push_back(
          fmt::format("{}:{}: is not a line `case run signal` and was ignored: '{}'", file.string(),
                      number, each));
    else if (++times[{task, run}] == kTries)
      given_up_[{task, run}] =
          fmt::format("crashed the program {} times: {}", kTries, strsignal(signal_number));
  }
}

CrashLog::~CrashLog() {
  for (const int each : kSignals) signal(each, SIG_DFL);
  ::close(log_file);
  log_file = -1;
}

RunMark::RunMark(std::size_t task, std::size_t run) {
  task_of_thread = task;
  run_of_thread = run;
  in_a_run = 1;
}

RunMark::~RunMark() { in_a_run = 0; }

}  // namespace gurney::study
