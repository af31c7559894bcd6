#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <new>
#include <nlohmann/json.hpp>

#include "engine/base/error.h"
#include "engine/base/files.h"
#include "engine/base/parallel.h"
#include "engine/base/printable.h"
#include "engine/base/shell_word.h"
#include "studies/cli/process.h"
#include "studies/cli/run_command.h"
#include "studies/cli/study_output.h"
#include "studies/report/study_report.h"
#include "studies/results/output_files.h"
#include "studies/run/part_folder.h"
#include "studies/run/run_batch.h"
#include "studies/run/shard.h"
#include "studies/run/shard_folders.h"
#include "studies/run/study_file.h"
#include "studies/run/study_identity.h"

namespace gurney::cli {
namespace {

namespace fs = std::filesystem;

struct Paths {
  fs::path results, log, parts;
};

study::Shard shard_of(const RunOptions& options) {
  if (options.shard.empty()) return {};
  return study::shard_from(options.shard, [](const char* name) { return std::getenv(name); });
}

Paths paths_for(const RunOptions& options, const study::Shard& shard) {
  const fs::path results = results_of(options);
  if (options.shard.empty())
    return {results, fs::path(results).replace_extension(".log"), results.string() + ".parts"};
  const fs::path shards = study::shards_path(results);
  return {results, shards / (shard.folder() + ".log"), shards / shard.folder()};
}

std::string attempt(const study::BatchProgress& progress, int threads) {
  return fmt::format("{} runs ({} so far) in {:.1f} s with {} threads", progress.runs_now,
                     report::failed_runs(progress.failed, progress.untrusted), progress.seconds,
                     threads);
}

/// The results are there already and nothing is left to do.
bool is_complete(const RunOptions& options, const Paths& paths, const study::Batch& batch) {
  if (!options.resume || !is_there(paths.results)) return false;
  const bool has_parts = study::IdentityFile(paths.parts).exists();
  if (has_parts && options.overwrite) return false;
  const std::string difference = study::difference_to_results(paths.results.string(), batch);
  require(difference.empty(),
          fmt::format("{}: holds the results of another study: {}{}", paths.results.string(),
                      difference, has_parts ? "; --resume --overwrite replaces them" : ""));
  if (has_parts)
    study::PartFolder(paths.parts, study::identity_of(batch), batch.plan.tasks(),
                      study::PartFolder::Start::kResume)
        .remove();
  study::remove_abandoned(paths.parts);
  fmt::print("results  {} (already complete)\n", printable(paths.results.string()));
  return true;
}

/// The finished cases whose bytes are still what was written.
std::size_t sound_cases(const study::PartFolder& folder, std::size_t tasks) {
  std::size_t sound = 0;
  for (std::size_t task = 0; task < tasks; ++task) try {
      sound += folder.has(task) && !folder.read(task).empty();
    } catch (const Error&) {  // its part was damaged meanwhile
    }
  return sound;
}

/// @param kept  of the cases; @param tasks  of the shard
std::string resume_hint(const RunOptions& options, const Paths& paths,
                        const study::PartFolder& folder, std::size_t kept, std::size_t tasks) {
  if (!folder.holds())
    return fmt::format("{}: the finished runs are lost with it; start again", paths.parts.string());
  return fmt::format(
      "{} of {} analysis cases are finished and kept in {}\ncontinue with: gurney run {} -o {} "
      "--resume{}{}{}{}",
      kept, tasks, paths.parts.string(), shell_word(options.job),
      shell_word(paths.results.string()), options.overwrite ? " --overwrite" : "",
      options.shard.empty() ? "" : " --shard " + shell_word(options.shard),
      options.threads > 0 ? fmt::format(" -j {}", options.threads) : "",
      options.json ? " --json" : "");
}

study::PartFolder::Start start_of(const RunOptions& options) {
  if (options.resume) return study::PartFolder::Start::kResume;
  return options.overwrite ? study::PartFolder::Start::kReplace : study::PartFolder::Start::kNew;
}

/// The path of the job, for those who read the folder beside this process.
void keep_path_of_job(const RunOptions& options, const fs::path& folder) {
  const fs::path job = folder / "job";
  if (is_there(job)) return;
  study::OutputFiles files(true);  // another shard may write the same at the same time
  files.stage(job.string(), fs::absolute(options.job).lexically_normal().string() + "\n");
  files.commit();
}

/// The folder of all shards, with the path of the job for `gurney merge`.
void make_shards_folder(const RunOptions& options, const Paths& paths) {
  const fs::path folder = paths.parts.parent_path();
  std::error_code problem;
  fs::create_directory(folder, problem);
  require(!problem, folder.string() + ": cannot be created: " + problem.message());
  keep_path_of_job(options, folder);
}

int finish_shard(const RunOptions& options, const study::Shard& shard,
                 const study::BatchProgress& progress, const Paths& paths) {
  if (options.json)
    fmt::print("{}\n", nlohmann::ordered_json{{"shard", shard.number},
                                              {"shards", shard.count},
                                              {"folder", paths.parts.string()},
                                              {"analysis_cases", progress.tasks},
                                              {"runs", progress.runs},
                                              {"overturned", progress.overturned},
                                              {"failed", progress.failed},
                                              {"untrusted", progress.untrusted}}
                           .dump(2));
  else
    fmt::print(
        "shard    {} of {}: {} analysis cases, {} runs, {} overturned, {}\n"
        "when all shards are finished: gurney merge {}\n",
        shard.number, shard.count, progress.tasks, progress.runs, progress.overturned,
        report::failed_runs(progress.failed, progress.untrusted),
        shell_word(paths.parts.parent_path().string()));
  return progress.failed > 0 ? 3 : 0;
}

}  // namespace

int run_study(const RunOptions& options) {
  const study::Shard shard = shard_of(options);
  const Paths paths = paths_for(options, shard);
  const study::StudyJob job(options.job);
  const int threads = threads_or_all(options.threads);
  const study::StudyMotions motions(job);
  const study::Plan plan(job, motions);
  const study::Batch batch{job, motions, plan};
  refuse_oversized(batch);
  require(options.shard.empty() || plan.stages() == 1,
          fmt::format("{}: study.intensity.adaptive: a stage needs the runs of all shards of those "
                      "before it; run the study without --shard, or state the levels",
                      options.job));
  motions.read_all(threads);
  if (is_complete(options, paths, batch)) return 0;

  if (options.output.empty()) fs::create_directory("out");
  study::OutputFiles(options.overwrite).check(paths.results.string());
  study::refuse_input(paths.log.string());
  if (!options.shard.empty()) {
    make_shards_folder(options, paths);
    if (!options.overwrite)
      study::refuse_shards_of_another_study(paths.parts, study::identity_of(batch));
  }
  note_interruptions();  // from here on there is something to continue
  study::PartFolder folder(paths.parts, study::identity_of(batch), plan.tasks(), start_of(options),
                           shard);
  if (options.shard.empty()) keep_path_of_job(options, folder.path());
  const study::CrashLog crashes(folder.path() / "crashes");
  for (const std::string& warning : job_warnings(batch.job)) print_error("warning: {}\n", warning);
  for (const std::string& warning : scale_warnings(batch)) print_error("warning: {}\n", warning);
  for (const std::string& warning : folder.warnings()) print_error("{}\n", warning);
  for (const std::string& warning : crashes.warnings()) print_error("{}\n", warning);

  StudyProgress line(options.json || options.quiet);
  study::BatchProgress progress;
  StudySummary summary;
  const auto fail = [&](const std::string& reason) {
    throw Error(reason + '\n' +
                resume_hint(options, paths, folder, sound_cases(folder, plan.tasks()),
                            shard.tasks_of(plan.tasks())));
  };
  try {
    progress = study::run_batch(
        batch, folder, crashes, shard, threads, [] { return interruption() == 0; },
        [&](const study::BatchProgress& now) { line(now); });
    if (progress.done == progress.tasks && options.shard.empty())
      summary = write_results(
          batch, folder.path(), [&](std::size_t task) { return folder.read(task); }, paths.results,
          options.overwrite);
  } catch (const Error& error) {
    fail(error.what());
  } catch (const std::bad_alloc&) {
    fail("not enough memory");
  }
  const std::string what = attempt(progress, threads);
  if (progress.done < progress.tasks) {
    append_log(paths.log, log_entry(options.job, "interrupted", what));
    print_error("\ngurney: interrupted; {}\n",
                resume_hint(options, paths, folder, folder.size(), shard.tasks_of(plan.tasks())));
    return 128 + interruption();
  }
  append_log(paths.log, log_entry(options.job, "finished", what));
  if (!options.shard.empty()) return finish_shard(options, shard, progress, paths);
  folder.remove();
  const double rate =
      progress.runs_now > 0 ? static_cast<double>(progress.runs_now) / progress.seconds : 0;
  if (!options.quiet) print_study(batch, paths.results, summary, rate, options.json, options.units);
  return summary.counts.failed > 0 ? 3 : 0;
}

}  // namespace gurney::cli
