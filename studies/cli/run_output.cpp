#include "studies/cli/run_output.h"

#include <fmt/chrono.h>
#include <unistd.h>

#include <chrono>

#include "engine/base/parallel.h"
#include "engine/base/printable.h"
#include "engine/base/shell_word.h"
#include "engine/run/run.h"
#include "studies/build_info/build_info.h"
#include "studies/cli/print.h"
#include "studies/cli/signals.h"
#include "studies/figures/run_figure.h"
#include "studies/report/run_report.h"
#include "studies/results/output_files.h"
#include "studies/results/results_file.h"

namespace gurney::cli {
namespace {

namespace fs = std::filesystem;

/// What differs between two equal runs stands here and not in the results file.
std::string log_text(const std::string& job, const Response& response, double seconds) {
  char host[256] = "unknown";
  gethostname(host, sizeof host - 1);
  const build_info::BuildInfo build = build_info::build_info();
  const auto now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  return fmt::format(
      "finished        {:%Y-%m-%dT%H:%M:%SZ}\nhost            {}\njob             {}\n"
      "folder          {}\nprogram         gurney {}, commit {}\nCPU class       {}\n"
      "wall time       {:.3f} s\nsimulated time  {:.3f} s\n",
      fmt::gmtime(now), host, job, fs::current_path().string(), build.program_version,
      build.git_commit, build.cpu_class, seconds, response.end_time);
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
    files.stage(output.log().string(), log_text(output.job, response, seconds));
    files.commit();
  }
  if (!output.quiet) print(output, run, response, seconds);
  return std::move(response);
}

}  // namespace gurney::cli
