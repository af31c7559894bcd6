#include "studies/cli/run_study.h"

#include <fmt/chrono.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <new>
#include <nlohmann/json.hpp>
#include <thread>

#include "engine/base/error.h"
#include "engine/base/shell_word.h"
#include "studies/build_info/build_info.h"
#include "studies/cli/signals.h"
#include "studies/cli/standard_error.h"
#include "studies/cli/study_progress.h"
#include "studies/cli/study_size.h"
#include "studies/report/failed_runs.h"
#include "studies/report/scale_factors_json.h"
#include "studies/report/wrapped.h"
#include "studies/study/results/output_files.h"
#include "studies/study/run/complete_study.h"
#include "studies/study/run/declared_ranges.h"
#include "studies/study/run/run_batch.h"
#include "studies/study/run/study_file.h"
#include "studies/study/run/study_identity.h"

namespace gurney::cli {
namespace {

namespace fs = std::filesystem;

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

std::string log_entry(const RunOptions& options, int threads, const study::BatchProgress& progress,
                      const std::string& how) {
  char host[256] = "unknown";
  gethostname(host, sizeof host - 1);
  const build_info::BuildInfo build = build_info::build_info();
  const auto now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  return fmt::format(
      "{:%Y-%m-%dT%H:%M:%SZ} {} on {}: {} runs ({} so far) in {:.1f} s with {} threads, gurney {} "
      "{}, "
      "CPU class {}\njob {}\n",
      fmt::gmtime(now), how, host, progress.runs_now,
      report::failed_runs(progress.failed, progress.untrusted), progress.seconds, threads,
      build.program_version, build.git_commit, build.cpu_class,
      fs::absolute(options.job).lexically_normal().string());
}

void append_log(const Paths& paths, const std::string& entry) {
  std::FILE* const log = std::fopen(paths.log.c_str(), "a");
  const bool written = log != nullptr && std::fputs(entry.c_str(), log) >= 0;
  const bool closed = log != nullptr && std::fclose(log) == 0;
  if (!written || !closed)
    print_error("warning: {}: the log cannot be written\n", paths.log.string());
}

/// The results are there already and nothing is left to do.
bool is_complete(const RunOptions& options, const Paths& paths, const study::Batch& batch) {
  if (!options.resume || !fs::exists(paths.results)) return false;
  const bool has_parts = !study::identity_in(paths.parts).empty();
  if (has_parts && options.overwrite) return false;
  const std::string difference = study::difference_to_results(paths.results.string(), batch);
  require(difference.empty(),
          fmt::format("{}: holds the results of another study: {}{}", paths.results.string(),
                      difference, has_parts ? "; --resume --overwrite replaces them" : ""));
  if (has_parts)
    study::PartFolder(paths.parts, study::identity_of(batch), batch.plan.tasks(),
                      study::PartFolder::Start::kResume)
        .remove();
  fmt::print("results  {} (already complete)\n", paths.results.string());
  return true;
}

void print_counts(const RunOptions& options, const Paths& paths, const study::StudyCounts& counts,
                  const study::BatchProgress& progress, const std::vector<std::string>& undrawn) {
  const study::ScaleFactors factors =
      study::scale_factors(study::StudyData(paths.results.string()));
  if (options.json) {
    nlohmann::ordered_json json{{"results", paths.results.string()}, {"runs", counts.runs},
                                {"overturned", counts.overturned},   {"failed", counts.failed},
                                {"untrusted", counts.untrusted},     {"ranges_not_drawn", undrawn}};
    if (factors.any()) json["scale_factors"] = report::scale_factors_json(factors);
    fmt::print("{}\n", json.dump(2));
    return;
  }
  fmt::print("runs     {}, {} overturned, {}\n", counts.runs, counts.overturned,
             report::failed_runs(counts.failed, counts.untrusted));
  if (progress.runs_now > 0)
    fmt::print("speed    {:.1f} runs per second\n",
               static_cast<double>(progress.runs_now) / progress.seconds);
  if (factors.any()) fmt::print("scaling  factors {}\n", factors.text());
  fmt::print("declared ranges not drawn:\n");
  for (const std::string& line : undrawn) fmt::print("  {}\n", report::wrapped(line, 4, 2));
  fmt::print("results  {}\n", paths.results.string());
}

std::string resume_hint(const RunOptions& options, const Paths& paths,
                        const study::PartFolder& folder, std::size_t tasks) {
  if (!folder.holds())
    return fmt::format("{}: the finished runs are lost with it; start again", paths.parts.string());
  return fmt::format(
      "{} of {} analysis cases are finished and kept in {}\ncontinue with: gurney run {} -o {} "
      "--resume{}{}{}",
      folder.size(), tasks, paths.parts.string(), shell_word(options.job),
      shell_word(paths.results.string()), options.overwrite ? " --overwrite" : "",
      options.threads > 0 ? fmt::format(" -j {}", options.threads) : "",
      options.json ? " --json" : "");
}

/// Writes the results file from the parts.
study::StudyCounts merge(const study::Batch& batch, const study::PartFolder& folder,
                         const Paths& paths, bool overwrite) {
  const fs::path made = folder.path() / "results.h5";
  study::StudyCounts counts;
  try {
    fs::remove(made);
    counts = study::write_study_file(made.string(), batch, [&](std::size_t task) {
      return study::task_from_bytes(folder.read(task));
    });
  } catch (...) {
    std::error_code ignored;
    fs::remove(made, ignored);
    throw;
  }
  try {
    study::put_in_place(made.string(), paths.results.string(), overwrite);
  } catch (const Error& error) {
    throw Error(fmt::format("{}; the finished results are in {}", error.what(), made.string()));
  }
  return counts;
}

study::PartFolder::Start start_of(const RunOptions& options) {
  if (options.resume) return study::PartFolder::Start::kResume;
  return options.overwrite ? study::PartFolder::Start::kReplace : study::PartFolder::Start::kNew;
}

}  // namespace

int run_study(const RunOptions& options) {
  const Paths paths = paths_for(options);
  const study::StudyJob job(options.job);
  const int threads = options.threads > 0
                          ? options.threads
                          : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  const study::StudyMotions motions(job);
  const study::Plan plan(job, motions);
  const study::Batch batch{job, motions, plan};
  refuse_oversized(batch);
  motions.read_all(threads);
  if (is_complete(options, paths, batch)) return 0;

  if (options.output.empty()) fs::create_directory("out");
  study::OutputFiles(options.overwrite).check(paths.results.string());
  study::PartFolder folder(paths.parts, study::identity_of(batch), plan.tasks(), start_of(options));
  const study::CrashLog crashes(folder.path() / "crashes");
  for (const std::string& note : batch.job.notes()) print_error("{}\n", note);
  for (const std::string& warning : folder.warnings()) print_error("{}\n", warning);
  for (const std::string& warning : crashes.warnings()) print_error("{}\n", warning);

  note_interruptions();
  StudyProgress line(options.json);
  study::BatchProgress progress;
  study::StudyCounts counts;
  const auto fail = [&](const std::string& reason) {
    throw Error(reason + '\n' + resume_hint(options, paths, folder, plan.tasks()));
  };
  try {
    progress = study::run_batch(
        batch, folder, crashes, threads, [] { return interruption() == 0; },
        [&](const study::BatchProgress& now) { line(now); });
    if (progress.done == progress.tasks) counts = merge(batch, folder, paths, options.overwrite);
  } catch (const Error& error) {
    fail(error.what());
  } catch (const std::bad_alloc&) {
    fail("not enough memory");
  }
  if (progress.done < progress.tasks) {
    append_log(paths, log_entry(options, threads, progress, "interrupted"));
    print_error("\ngurney: interrupted; {}\n", resume_hint(options, paths, folder, plan.tasks()));
    return 128 + interruption();
  }
  append_log(paths, log_entry(options, threads, progress, "finished"));
  folder.remove();
  print_counts(options, paths, counts, progress, study::undrawn_ranges(batch).lines());
  return counts.failed > 0 ? 3 : 0;
}

}  // namespace gurney::cli
