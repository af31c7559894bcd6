#include "studies/cli/study_progress.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>

#include "studies/cli/standard_error.h"
#include "studies/cli/study_size.h"
#include "studies/report/failed_runs.h"

namespace gurney::cli {
namespace {

/// A longer line would not be written over but scroll.
std::size_t terminal_width() {
  winsize window{};
  const bool known = ioctl(STDERR_FILENO, TIOCGWINSZ, &window) == 0 && window.ws_col > 1;
  return known ? window.ws_col : 100;
}

}  // namespace

StudyProgress::StudyProgress(bool quiet) : quiet_(quiet), terminal_(isatty(STDERR_FILENO) == 1) {}

void StudyProgress::operator()(const study::BatchProgress& now) {
  if (quiet_ || complete_ || now.tasks_now == 0) return;
  const bool last = complete_ = now.done == now.tasks;
  if (!terminal_ && !last && now.seconds - shown_ < 10) return;
  shown_ = now.seconds;
  const double seconds = std::max(now.seconds, 1e-9);
  const double to_go =
      static_cast<double>(now.tasks - now.done) * seconds / static_cast<double>(now.tasks_now);
  std::string text =
      fmt::format("{:3.0f} %  {} runs, {:.1f} runs/s, {} overturned, {}{}",
                  100.0 * static_cast<double>(now.done) / static_cast<double>(now.tasks), now.runs,
                  static_cast<double>(now.runs_now) / seconds, now.overturned,
                  report::failed_runs(now.failed, now.untrusted),
                  last ? std::string()
                       : fmt::format(", {} elapsed, {} to go", duration_text(now.seconds),
                                     duration_text(to_go)));
  if (terminal_ && !last) text.resize(std::min(text.size(), terminal_width() - 1));
  write_error((terminal_ ? "\r" : "") + text + (terminal_ && !last ? "\x1b[K" : "\n"));
}

}  // namespace gurney::cli
