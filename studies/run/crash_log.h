#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace gurney::study {

/// Runs that must not be tried again, by task and index in it: why.
using CrashedRuns = std::map<std::pair<std::size_t, std::size_t>, std::string>;

/// Remembers the runs in which a process crashed: a line `task run signal` for each thread that was
/// in a run when a signal such as a segmentation fault ended the process. A process that is killed
/// from outside leaves no line.
///
/// One at a time: it takes over the signals SIGSEGV, SIGBUS, SIGFPE, SIGILL and SIGABRT until it is
/// destroyed.
class CrashLog {
 public:
  /// @param file  made where it is missing
  /// @throws Error where it cannot be written
  explicit CrashLog(const std::filesystem::path& file);
  ~CrashLog();
  CrashLog(const CrashLog&) = delete;
  CrashLog& operator=(const CrashLog&) = delete;

  /// Runs that crashed a process twice.
  const CrashedRuns& given_up() const { return given_up_; }

  /// Lines that are none of its own; they are ignored.
  const std::vector<std::string>& warnings() const { return warnings_; }

 private:
  void read(const std::filesystem::path& file, const std::string& text);

  CrashedRuns given_up_;
  std::vector<std::string> warnings_;
};

/// While one exists, this thread is in a run.
class RunMark {
 public:
  RunMark(std::size_t task, std::size_t run);
  ~RunMark();
  RunMark(const RunMark&) = delete;
  RunMark& operator=(const RunMark&) = delete;
};

}  // namespace gurney::study
