#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "engine/base/error.h"
#include "engine/base/files.h"
#include "studies/cli/commands.h"
#include "studies/cli/output.h"
#include "studies/cli/process.h"
#include "studies/cli/repeated_run.h"
#include "studies/cli/shared_options.h"
#include "studies/page/page.h"
#include "studies/results/output_files.h"
#include "studies/run/shard_status.h"

namespace gurney::cli {
namespace {

struct ReportOptions {
  page::PageRequest request;
  std::string output;
  bool overwrite = false, watch = false;
};

using Clock = std::chrono::steady_clock;

/// Explains one run, where its job can be run again and gives the same demands.
void add_explanation(page::PageRequest& request) {
  try {
    if (is_study(request.file)) return;
    Explained found = explained(repeated_run(request.file, {}, request.job), request.units);
    request.explanation = std::move(found.explanation);
    request.narrative = std::move(found.narrative);
  } catch (const Error& error) {
    request.no_explanation = error.what();
  }
}

/// The page of a results file.
std::string page_of(page::PageRequest request) {
  if (request.job.empty()) request.job = job_of_log(request.file);
  add_explanation(request);
  return page::results_page(request);
}

/// The page of what a study has finished so far.
std::string page_of(const page::PageRequest& options, const study::FinishedCases& cases) {
  const ScratchFolder scratch;
  page::PageRequest request = options;
  request.file = scratch.file("unfinished.h5");
  request.job = job_of_unfinished(cases, options.file, options.job);
  request.unfinished = fmt::format("{} of {} analysis cases of {}", cases.finished(), cases.tasks(),
                                   results_of_folder(options.file));
  cases.write(request.file, request.job);
  return page::results_page(request);
}

/// Whether a process works on the study, or on one of its shards.
bool is_running(const std::string& folder) {
  return std::ranges::any_of(study::study_status(folder).shards,
                             [](const study::ShardStatus& each) { return !each.process.empty(); });
}

/// Sleeps, unless an interruption ends it. @return whether there was none
bool pause(Clock::duration time) {
  for (const auto end = Clock::now() + time; Clock::now() < end && interruption() == 0;)
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  return interruption() == 0;
}

/// Writes the page of the results, once they are there; while the study runs, that of finished cases.
/// @return exit code
int watch(const ReportOptions& options) {
  constexpr std::chrono::seconds kLeast{1};
  constexpr int kMostFailures = 3;  // one after the other
  int failures = 0;
  const std::string& folder = options.request.file;
  page::PageRequest whole = options.request;
  whole.file = results_of_folder(folder);
  require(is_folder(folder) || is_there(whole.file),
          folder + ": no such folder; --watch is for FILE.h5.parts or FILE.h5.shards of a study");
  note_interruptions();
  bool written = false;
  const auto write = [&](const std::string& page) {
    write_output(options.output, page, options.overwrite || written, written);
    written = true;
  };
  for (std::size_t seen = 0;;) {
    const Clock::time_point start = Clock::now();
    bool running = is_folder(folder);
    std::size_t finished = seen;
    try {
      if (running) {
        running = is_running(folder);
        const study::FinishedCases cases(folder);
        finished = cases.finished();
        if (finished > seen) write(page_of(options.request, cases));
      }
      failures = 0;
    } catch (const Error&) {  // parts go while they are read, where the study ends
      if (is_folder(folder) && ++failures > kMostFailures) throw;
    }
    seen = finished;
    if (!is_folder(folder) && is_there(whole.file)) break;
    if (!running) {
      print_error("gurney: no process works on {}; {} analysis cases are finished\n", folder, seen);
      return 0;
    }
    // The study keeps at least three quarters of the time.
    if (!pause(std::max<Clock::duration>(kLeast, 3 * (Clock::now() - start)))) {
      print_error("\ngurney: interrupted; the page stays as it is\n");
      return 128 + interruption();
    }
  }
  write(page_of(whole));
  return 0;
}

int report(const ReportOptions& options) {
  require_usage(options.output.ends_with(".html"),
                options.output + ": the report must end in .html (-o REPORT.html)");
  study::OutputFiles(options.overwrite).check(options.output);
  if (options.watch) return watch(options);
  if (!is_folder(options.request.file)) {
    write_output(options.output, page_of(options.request), options.overwrite);
    return 0;
  }
  const study::FinishedCases cases(options.request.file);
  require(cases.finished() > 0, options.request.file + ": no analysis case is finished yet");
  write_output(options.output, page_of(options.request, cases), options.overwrite);
  return 0;
}

}  // namespace

void add_report(Commands& commands) {
  commands.add<ReportOptions>(
      {"report", "Write a run, a study, a calibration or a verification as one HTML page",
       "gurney report ventilator.h5 -o ventilator.html\n"
       "gurney report ventilator.h5 --limit-state \"peak_displacement > 0.2 m\" -o far.html"},
      report, [](Options& add, ReportOptions& options) {
        add.required("FILE", options.request.file,
                     "The results file of a study or of one run; JSON of gurney calibrate or "
                     "gurney verify; the folder "
                     "FILE.h5.parts or FILE.h5.shards of a study that is still running");
        add.required("-o,--output FILE", options.output, "The page (.html)");
        add_limit_state_options(add, options.request.assessed_by);
        add_hazard_option(add, options.request.assessed_by);
        add("--consequences FILE", options.request.consequences,
            "State what the runs of a study cost: prices and what follows from each limit state");
        add("--job FILE", options.request.job,
            "The job file, for drawings of its items (default: the path in the log)");
        add_units_option(add, options.request.units);
        add("--watch", options.watch,
            "Write the page of a running study again as its runs finish, until it ends");
        add("--overwrite", options.overwrite, "Replace a page that exists");
      });
}

}  // namespace gurney::cli
