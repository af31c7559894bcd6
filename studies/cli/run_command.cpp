#include "studies/cli/run_command.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>

#include "engine/base/error.h"
#include "engine/base/parallel.h"
#include "engine/base/printable.h"
#include "engine/base/shell_word.h"
#include "engine/run/run.h"
#include "studies/build_info/build_info.h"
#include "studies/cli/arguments.h"
#include "studies/cli/output.h"
#include "studies/cli/process.h"
#include "studies/figures/run_figure.h"
#include "studies/plan/study_job.h"
#include "studies/report/run_report.h"
#include "studies/results/output_files.h"
#include "studies/results/results_file.h"

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

namespace fs = std::filesystem;

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
            "merge");
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

Response run_and_write(const study::PreparedRun& run, const RunOutput& output) {
  auto [response, seconds] =
      run_judged(run.facts.scene, run.facts.floor, run.facts.settings, threads_or_all());
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

}  // namespace gurney::cli
