#include "studies/cli/run_command.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <new>

#include "engine/base/error.h"
#include "engine/base/files.h"
#include "engine/base/parallel.h"
#include "engine/base/printable.h"
#include "engine/base/shell_word.h"
#include "engine/run/run.h"
#include "studies/build_info/build_info.h"
#include "studies/cli/output.h"
#include "studies/cli/process.h"
#include "studies/cli/shared_options.h"
#include "studies/cli/study_output.h"
#include "studies/figures/run_figure.h"
#include "studies/plan/study_job.h"
#include "studies/report/run_report.h"
#include "studies/report/study_report.h"
#include "studies/results/output_files.h"
#include "studies/results/results_file.h"
#include "studies/run/part_folder.h"
#include "studies/run/run_batch.h"
#include "studies/run/shard.h"
#include "studies/run/shard_folders.h"
#include "studies/run/study_file.h"
#include "studies/run/study_identity.h"

namespace gurney::cli {
namespace {

namespace fs = std::filesystem;

/// The default folder is made when it is missing; a folder the user names must exist.
void make_default_folder(const RunOptions& options) {
  if (!options.output.empty()) return;
  std::error_code problem;
  fs::create_directory("out", problem);
  require(!problem, "out: the folder cannot be created: " + problem.message());
}

RunOutput output_of(const RunOptions& options) {
  const fs::path results = results_of(options);
  return {results,         options.job,   options.overwrite, options.json,   options.no_figure,
          options.figures, options.quiet, options.units,     options.verbose};
}

/// Facts that differ between two equal runs stand here and not in the results file.
std::string log_text(const RunOutput& output, const Response& response, double seconds) {
  char host[256] = "unknown";
  gethostname(host, sizeof host - 1);
  const build_info::BuildInfo build = build_info::build_info();
  const auto now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  return fmt::format(
      "finished        {:%Y-%m-%dT%H:%M:%SZ}\nhost            {}\njob             {}\n"
      "{}folder          {}\nprogram         gurney {}, commit {}\nCPU class       {}\n"
      "wall time       {:.3f} s\nsimulated time  {:.3f} s\n",
      fmt::gmtime(now), host, output.job, output.origin, fs::current_path().string(),
      build.program_version, build.git_commit, build.cpu_class, seconds, response.end_time);
}

void print(const RunOutput& output, const study::PreparedRun& run, const Response& response,
           double seconds) {
  findings::Section known = report::run_findings(run.facts, response, output.units);
  const std::size_t hidden = output.json || output.verbose ? 0 : findings::hide_zeros(known);
  print_findings(known, output.json);
  if (output.json) return;
  if (hidden > 0) fmt::print("\n{} numbers are zero and not shown (--verbose)\n", hidden);
  fmt::print("\n");
  if (seconds > 0) fmt::print("speed    {:.0f} x real time\n", response.end_time / seconds);
  fmt::print("results  {}\n", printable(output.results.string()));
  if (!output.no_figure) fmt::print("figure   {}\n", printable(output.figure().string()));
  if (is_failure(response.outcome)) return;
  const fs::path stem = fs::path(output.results).replace_extension();
  const std::string file = shell_word(output.results.string());
  fmt::print(
      "{}",
      next_steps(
          {"gurney explain " + file,
           fmt::format("gurney play {} -o {}", file, shell_word(stem.string() + "_play.html")),
           fmt::format("gurney report {} -o {}", file, shell_word(stem.string() + ".html"))}));
}

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
  return true;
}

/// Says what the complete results hold; @returns the exit code of the study that made them
int print_complete(const RunOptions& options, const fs::path& results, const study::Batch& batch) {
  const study::StudyOverview known = study::study_overview(results.string(), {}, options.units);
  if (options.json)
    print_study(
        batch, results,
        {{known.runs, known.failed, known.untrusted, known.overturned}, known.factors_on_records},
        0, true, options.units);
  else if (!options.quiet)
    fmt::print("results  {} (already complete)\n", printable(results.string()));
  return known.failed > 0 ? 3 : 0;
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
      "--resume{}{}{}{}{}",
      kept, tasks, paths.parts.string(), shell_word(options.job),
      shell_word(paths.results.string()), options.overwrite ? " --overwrite" : "",
      options.shard.empty() ? "" : " --shard " + shell_word(options.shard),
      options.threads > 0 ? fmt::format(" -j {}", options.threads) : "",
      options.json ? " --json" : "", options.no_figure ? " --no-figure" : "");
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
  if (options.json) {
    findings::Section facts;
    facts.json("shard", shard.number).json("shards", shard.count);
    facts.json("folder", paths.parts.string()).json("analysis_cases", progress.tasks);
    facts.json("finished", progress.done).json("runs", progress.runs);
    facts.json("overturned", progress.overturned).json("failed", progress.failed);
    facts.json("untrusted", progress.untrusted).json("stage", progress.stage + 1);
    print_findings(facts.json("awaited_analysis_cases", progress.awaited), true);
  } else if (!options.quiet)
    fmt::print(
        "shard    {} of {}: {} analysis cases, {} runs, {} overturned, {}\n{}", shard.number,
        shard.count, progress.done, progress.runs, progress.overturned,
        report::failed_runs(progress.failed, progress.untrusted),
        progress.awaited > 0
            ? fmt::format(
                  "stage    {} is finished here and lacks {} analysis cases of other shards\n"
                  "when these are finished: gurney run {} -o {} --resume --shard {}\n",
                  progress.stage + 1, progress.awaited, shell_word(options.job),
                  shell_word(paths.results.string()), shell_word(options.shard))
            : fmt::format("when all shards are finished: gurney merge {}\n",
                          shell_word(paths.parts.parent_path().string())));
  return progress.failed > 0 ? 3 : 0;
}

}  // namespace

fs::path results_of(const RunOptions& options) {
  if (!options.output.empty()) return results_file(options.output);
  return fs::path("out") / fs::path(options.job).stem().replace_extension(".h5");
}

int run_command(const RunOptions& options) {
  options.figures.check();
  require_job(options.job, "run");
  if (study::has_study(options.job)) return run_study(options);
  std::string unused;
  const auto add = [&](bool given, const char* option) {
    if (given) unused += (unused.empty() ? "" : " and ") + std::string(option);
  };
  add(options.resume, "--resume");
  add(!options.shard.empty(), "--shard");
  require(unused.empty(), fmt::format("{}: is a single run, which has no use for {}; studies have "
                                      "a table [study]",
                                      options.job, unused));
  const RunOutput output = output_of(options);
  const study::PreparedRun run = study::prepare_run(options.job);
  make_default_folder(options);
  check_output(output);
  return is_failure(run_and_write(run, output).outcome) ? 3 : 0;
}

void add_run(Commands& commands) {
  commands.add<RunOptions>(
      {"run", "Run a job: a single run or a study",
       "gurney run studies/jobs/icu_ventilator_shake.toml -o shake.h5\n"
       "gurney run studies/jobs/icu_ventilator_fragility.toml -o ventilator.h5 --resume"},
      run_command, [](Options& add, RunOptions& options) {
        add.required("JOB", options.job,
                     "The job file, such as studies/jobs/icu_ventilator_shake.toml");
        add("-o,--output FILE", options.output,
            "The results file; the figure and the log are written beside it "
            "(default: out/<name of the job>.h5)");
        add("--overwrite", options.overwrite, "Replace files that exist");
        CLI::Option* const units = add_units_option(add, options.units);
        CLI::Option* const json =
            add("--json", options.json, "Print the summary as JSON, in SI units");
        json->excludes(units);
        add("-q,--quiet", options.quiet, "Print warnings and errors only")->excludes(json);
        add("--verbose", options.verbose, "Print what is zero too")->excludes(json);
        add("--no-figure", options.no_figure, "Draw no figure");
        add_figure_format(add, options.figures);
        add("--resume", options.resume, "Continue an interrupted study");
        add("--shard I/N", options.shard,
            "Run one share of a study: I/N, or auto to take it from Slurm or Open MPI; see "
            "merge")
            ->check(CLI::Validator(study::shard_problem, ""));
        add.threads(options.threads,
                    "Threads for a study (default: all hardware threads); a single run takes one");
      });
}

std::string next_steps(const std::vector<std::string>& commands) {
  return fmt::format("next:    {}\n", fmt::join(commands, "\n         "));
}

fs::path RunOutput::figure() const { return fs::path(results).replace_extension(style.suffix()); }
fs::path RunOutput::log() const { return fs::path(results).replace_extension(".log"); }

void check_output(const RunOutput& output) {
  const study::OutputFiles files(output.overwrite);
  files.check(output.results.string());
  output.style.check();
  if (!output.no_figure) files.check(output.figure().string());
  files.check(output.log().string());
}

/// The engine names items of this job in what it refuses.
auto simulated(const study::PreparedRun& run, const std::string& job) {
  try {
    return run_judged(run.facts.scene, run.facts.floor, run.facts.settings, threads_or_all());
  } catch (const Error& error) {
    throw Error(job + ": " + error.what());
  }
}

Response run_and_write(const study::PreparedRun& run, const RunOutput& output) {
  auto [response, seconds] = simulated(run, output.job);
  {
    const SignalsHeld until_written;
    study::OutputFiles files(output.overwrite);
    files.stage(output.results.string(), study::results_image(run.facts, response));
    if (!output.no_figure)
      files.stage(output.figure().string(),
                  output.style.bytes(figures::run_figure(run.facts, response, output.units)));
    files.stage(output.log().string(), log_text(output, response, seconds));
    files.commit();
  }
  if (!output.quiet) print(output, run, response, seconds);
  return std::move(response);
}

int run_study(const RunOptions& options) {
  const study::Shard shard = shard_of(options);
  const Paths paths = paths_for(options, shard);
  const study::StudyJob job(options.job);
  const int threads = threads_or_all(options.threads);
  const study::StudyMotions motions(job);
  const study::Plan plan(job, motions);
  const study::Batch batch{job, motions, plan};
  refuse_oversized(batch);
  motions.read_all(threads);
  if (is_complete(options, paths, batch)) return print_complete(options, paths.results, batch);

  make_default_folder(options);
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
  if (progress.done < progress.tasks && progress.awaited == 0) {
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
  if (!options.quiet)
    print_study(batch, paths.results, summary, rate, options.json, options.units);
  else if (summary.counts.failed > 0)
    print_error("{}: {} of {} runs failed\n", paths.results.string(), summary.counts.failed,
                summary.counts.runs);
  return summary.counts.failed > 0 ? 3 : 0;
}

}  // namespace gurney::cli
