#include "studies/cli/run_study.h"

#include <fmt/chrono.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <thread>

#include "engine/base/error.h"
#include "engine/base/hash/sha256.h"
#include "studies/batch/declared_ranges.h"
#include "studies/batch/run_batch.h"
#include "studies/build_info/build_info.h"
#include "studies/cli/signals.h"
#include "studies/report/wrapped.h"
#include "studies/results/hdf5_reader.h"
#include "studies/results/output_files.h"
#include "studies/study/data_files.h"
#include "studies/study_results/study_file.h"

namespace gurney {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

struct Paths {
  fs::path results, log, parts;
};

Paths paths_for(const RunOptions& options) {
  fs::path results = options.output;
  if (results.empty())
    results = fs::path("out") / fs::path(options.job).stem().replace_extension(".h5");
  require(results.extension() == ".h5",
          options.output + ": the results file must end in .h5 (-o FILE.h5)");
  return {results, fs::path(results).replace_extension(".log"), results.string() + ".parts"};
}

std::string records_hash(const StudyMotions& motions) {
  std::string text;
  for (std::size_t set = 0; set < motions.sets(); ++set)
    for (std::size_t i = 0; i < motions.set(set).size(); ++i) {
      const Record& record = motions.set(set).ground(i).record;
      text += record.name + '\n';
      for (const auto& component : record.components)
        if (component) text += component->sha256 + '\n';
    }
  return sha256(text);
}

/// What must be equal for runs to belong together: lines `key value`.
std::string identity(const Batch& batch) {
  const BuildInfo build = build_info();
  std::string text =
      fmt::format("job_sha256 {}\nrecords_sha256 {}\nunits {}\nprogram {} {}\ncpu_class {}\n",
                  sha256(batch.job.text()), records_hash(batch.motions), batch.plan.units(),
                  build.program_version, build.git_commit, build.cpu_class);
  for (const auto& [name, hash] : data_files(batch.job)) text += fmt::format("{} {}\n", name, hash);
  return text;
}

std::string duration_text(double seconds) {
  if (seconds < 90) return fmt::format("{:.0f} s", seconds);
  if (seconds < 5400) return fmt::format("{:.0f} min", seconds / 60);
  return fmt::format("{:.1f} h", seconds / 3600);
}

/// One line that is written over on a terminal; elsewhere a line every ten seconds.
class ProgressLine {
 public:
  explicit ProgressLine(bool quiet) : quiet_(quiet), terminal_(isatty(STDERR_FILENO) == 1) {}

  void operator()(const BatchProgress& now) {
    if (quiet_ || now.units_now == 0) return;
    const bool last = now.done == now.units;
    if (!terminal_ && !last && now.seconds - shown_ < 10) return;
    shown_ = now.seconds;
    const double rate = static_cast<double>(now.units_now) / std::max(now.seconds, 1e-9);
    fmt::print(
        stderr, "{}{:3.0f} %  {} runs, {:.1f} runs/s, {} overturned, {} failed{}{}",
        terminal_ ? "\r" : "",
        100.0 * static_cast<double>(now.done) / static_cast<double>(now.units), now.runs,
        static_cast<double>(now.runs) / std::max(now.seconds, 1e-9), now.overturned, now.failed,
        last ? std::string()
             : ", " + duration_text(static_cast<double>(now.units - now.done) / rate) + " to go",
        terminal_ && !last ? "\x1b[K" : "\n");
    std::fflush(stderr);
  }

 private:
  bool quiet_, terminal_;
  double shown_ = -10;
};

void append_log(const Paths& paths, const RunOptions& options, int threads,
                const BatchProgress& progress, const std::string& how) {
  char host[256] = "unknown";
  gethostname(host, sizeof host - 1);
  const BuildInfo build = build_info();
  const auto now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  std::FILE* const log = std::fopen(paths.log.c_str(), "a");
  require(log != nullptr, paths.log.string() + ": cannot be written");
  fmt::print(log,
             "{:%Y-%m-%dT%H:%M:%SZ} {} on {}: {} runs in {:.1f} s with {} threads, gurney {} {}, "
             "CPU class {}\njob {}\n",
             fmt::gmtime(now), how, host, progress.runs, progress.seconds, threads,
             build.program_version, build.git_commit, build.cpu_class,
             fs::absolute(options.job).lexically_normal().string());
  std::fclose(log);
}

/// The results are there already and nothing is left to do.
bool complete_already(const RunOptions& options, const Paths& paths, const StudyJob& job) {
  if (!options.resume || !fs::exists(paths.results) || fs::exists(paths.parts)) return false;
  const std::string theirs = Hdf5Reader(paths.results.string()).text_attribute("job_sha256");
  const std::string ours = sha256(job.text());
  require(theirs == ours, fmt::format("{}: holds the results of another job: there job_sha256 {}, "
                                      "here {}",
                                      paths.results.string(), theirs, ours));
  fmt::print("results  {} (complete already)\n", paths.results.string());
  return true;
}

void print_counts(const RunOptions& options, const Paths& paths, const StudyCounts& counts,
                  const BatchProgress& progress, const std::vector<std::string>& undrawn) {
  if (options.json) {
    fmt::print("{}\n", nlohmann::ordered_json{{"results", paths.results.string()},
                                              {"runs", counts.runs},
                                              {"overturned", counts.overturned},
                                              {"failed", counts.failed},
                                              {"ranges_not_drawn", undrawn}}
                           .dump(2));
    return;
  }
  fmt::print("runs     {}, {} overturned, {} failed\n", counts.runs, counts.overturned,
             counts.failed);
  if (progress.runs > 0)
    fmt::print("speed    {:.1f} runs per second\n",
               static_cast<double>(progress.runs) / progress.seconds);
  fmt::print("declared ranges not drawn:\n");
  for (const std::string& line : undrawn) fmt::print("  {}\n", wrapped(line, 4, 2));
  fmt::print("results  {}\n", paths.results.string());
}

std::string how_to_go_on(const RunOptions& options, const Paths& paths, std::size_t done,
                         std::size_t units) {
  return fmt::format(
      "{} of {} records' runs are kept in {}\ngo on with: gurney run {} -o {} --resume", done,
      units, paths.parts.string(), options.job, paths.results.string());
}

/// Writes the results file from the parts.
StudyCounts merge(const Batch& batch, const PartFolder& folder, const Paths& paths) {
  const fs::path made = paths.results.string() + ".part";
  try {
    const StudyCounts counts = write_study_file(
        made.string(), batch, [&](std::size_t unit) { return unit_from_bytes(folder.read(unit)); });
    put_in_place(made.string(), paths.results.string());
    return counts;
  } catch (...) {
    std::error_code ignored;
    fs::remove(made, ignored);
    throw;
  }
}

}  // namespace

int run_study(const RunOptions& options) {
  const Paths paths = paths_for(options);
  const StudyJob job(options.job);
  if (complete_already(options, paths, job)) return 0;
  const int threads = options.threads > 0
                          ? options.threads
                          : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  const StudyMotions motions(job);
  motions.read_all(threads);
  const Plan plan(job, motions);
  const Batch batch{job, motions, plan};

  if (options.output.empty()) fs::create_directory("out");
  OutputFiles(options.overwrite || options.resume).check(paths.results.string());
  if (options.overwrite && !options.resume) fs::remove_all(paths.parts);
  const std::string inputs = identity(batch);
  PartFolder folder(paths.parts, inputs, options.resume);
  for (const std::string& warning : folder.warnings()) fmt::print(stderr, "{}\n", warning);

  note_interruptions();
  ProgressLine line(options.json);
  BatchProgress progress;
  StudyCounts counts;
  try {
    progress = run_batch(
        batch, folder, threads, [] { return interruption() == 0; },
        [&](const BatchProgress& now) { line(now); });
    if (progress.done == progress.units) {
      require(identity(batch) == inputs, paths.parts.string() +
                                             ": a data file was edited while the study ran: " +
                                             first_difference(inputs, identity(batch)));
      counts = merge(batch, folder, paths);
    }
  } catch (const Error& error) {
    throw Error(std::string(error.what()) + '\n' +
                how_to_go_on(options, paths, folder.size(), plan.units()));
  }
  if (progress.done < progress.units) {
    append_log(paths, options, threads, progress, "interrupted");
    fmt::print(stderr, "\ngurney: interrupted; {}\n",
               how_to_go_on(options, paths, progress.done, progress.units));
    return 128 + interruption();
  }
  append_log(paths, options, threads, progress, "finished");
  folder.remove();
  print_counts(options, paths, counts, progress, undrawn_ranges(batch).lines());
  return counts.failed > 0 ? 3 : 0;
}

}  // namespace gurney
