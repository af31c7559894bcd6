#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "engine/base/error.h"
#include "engine/base/printable.h"
#include "engine/base/shell_word.h"
#include "studies/cli/commands.h"
#include "studies/plan/plan.h"
#include "studies/results/output_files.h"
#include "studies/run/shard_folders.h"

namespace gurney::cli {
namespace {

namespace fs = std::filesystem;

struct SubmitOptions {
  std::string job, output, script, mode = "array", time = "01:00:00", program = "gurney";
  std::vector<std::string> site;  ///< options of sbatch, such as --partition=short
  int shards = 0, threads = 1;
  bool slurm = false, overwrite = false;
};

/// Before a shard: how many seconds of grace Slurm gives with SIGTERM, to write what is finished.
constexpr int kGrace = 60;

/// @param origin  that states the text, for the message
void check_one_line(const std::string& origin, const std::string& text) {
  const auto control =
      std::ranges::find_if(text, [](unsigned char c) { return c < 0x20 || c == 0x7f; });
  require(control == text.end(),
          fmt::format("{}: has the control character 0x{:02x}; a line of #SBATCH has none", origin,
                      control == text.end() ? 0 : static_cast<unsigned char>(*control)));
}

/// An option of sbatch as a comment of the script, which a line end would turn into a command.
std::string directive(const std::string& origin, const std::string& option) {
  check_one_line(origin, option);
  return fmt::format("#SBATCH {}\n", option);
}

std::string head(const SubmitOptions& options) {
  const bool array = options.mode == "array";
  std::string text = "#!/bin/bash\n";
  const std::string name = fs::path(options.job).stem().string();
  check_one_line("the name of the job file", name);
  text += directive("the name of the job file", "--job-name=" + shell_word(name));
  text += fmt::format("#SBATCH --{}={}\n", array ? "array" : "ntasks",
                      (array ? "1-" : "") + std::to_string(options.shards));
  text += fmt::format("#SBATCH --cpus-per-task={}\n", options.threads);
  text += directive("--time", "--time=" + options.time);
  text += fmt::format("#SBATCH --output={}\n", array ? "%x-%A_%a.out" : "%x-%j.out");
  text += "#SBATCH --open-mode=append\n#SBATCH --requeue\n";
  text += fmt::format("#SBATCH --signal=TERM@{}\n", kGrace);
  for (const std::string& option : options.site) text += directive("--sbatch", option);
  return text;
}

/// A path that no program takes for an option.
std::string no_option(const std::string& path) {
  return path.starts_with('-') ? "./" + path : path;
}

/// Of an array a task ends with SIGTERM before its time is over: it is put into the queue again.
constexpr const char* kAgain = R"(code=$?
if [ "$code" -eq 143 ]; then  # the time is over: go on in another allocation
  scontrol requeue "{}"
  exit 0
fi
[ "$code" -eq 3 ] && code=0  # some runs failed: they are rows of the results
)";

std::string script_of(const SubmitOptions& options, const std::string& results) {
  const std::string program = shell_word(options.program);
  const std::string run = fmt::format("srun {} run {} -o {} --resume -j \"$SLURM_CPUS_PER_TASK\"",
                                      program, shell_word(options.job), shell_word(results));
  const std::string merge =
      fmt::format("{} merge {}", program, shell_word(study::shards_path(results).string()));
  std::string text = head(options) + "\nset -u\n";
  if (options.mode == "array")
    return text + fmt::format("{} --shard \"$SLURM_ARRAY_TASK_ID/{}\"\n", run, options.shards) +
           fmt::format(fmt::runtime(kAgain), "${SLURM_ARRAY_JOB_ID}_${SLURM_ARRAY_TASK_ID}") +
           "exit \"$code\"\n";
  return text + fmt::format("{} --shard auto\n", run) +
         fmt::format(fmt::runtime(kAgain), "$SLURM_JOB_ID") +
         fmt::format("[ \"$code\" -eq 0 ] && exec {}\nexit \"$code\"\n", merge);
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

int submit_command(const SubmitOptions& options) {
  for (const std::string& line : options.site)
    require(line.starts_with("--"),
            "--sbatch " + line + ": must be one option of sbatch, such as --partition=short");
  require(
      !options.time.empty() &&
          options.time.find_first_not_of("0123456789:-") == std::string::npos &&
          is_digit(options.time.front()) && is_digit(options.time.back()),
      "--time " + options.time + ": must be as sbatch takes it, such as 90, 02:00:00 or 1-12:00");
  require(options.slurm, "gurney submit needs --slurm, the only scheduler whose scripts it writes");
  const study::StudyJob job(options.job);
  const study::StudyMotions motions(job);
  const study::Plan plan(job, motions);
  const auto tasks = plan.tasks();
  require(plan.stages() == 1,
          options.job +
              ": study.intensity.adaptive: a study in stages cannot be divided into "
              "shards; run it on one node, or state the levels");
  require(static_cast<std::size_t>(options.shards) <= tasks,
          fmt::format("--shards {}: the study has {} analysis cases, and no more shards are of use",
                      options.shards, tasks));
  motions.read_all(1);  // what is wrong with a record is said here and not by every shard
  const std::string stem = fs::path(options.job).stem().string();
  const std::string results = no_option(options.output.empty() ? stem + ".h5" : options.output);
  require(fs::path(results).extension() == ".h5",
          results + ": the results file must end in .h5 (-o FILE.h5)");
  const std::string script = no_option(options.script.empty() ? stem + ".sbatch" : options.script);
  study::OutputFiles files(options.overwrite);
  files.check(script);
  files.stage(script, script_of(options, results));
  files.commit();
  fmt::print("{}: {} analysis cases in {} shards\nsubmit   sbatch {}\nwatch    gurney status {}\n",
             printable(script), tasks, options.shards, shell_word(script),
             shell_word(study::shards_path(results).string()));
  if (options.mode == "array")
    fmt::print("at last  gurney merge {}\n", shell_word(study::shards_path(results).string()));
  return 0;
}

}  // namespace

void add_submit(CLI::App& app, std::function<int()>& action) {
  auto shared = std::make_shared<SubmitOptions>();
  SubmitOptions& options = *shared;
  CLI::App* const submit = app.add_subcommand("submit", "");
  submit->add_option("JOB", options.job, "The job file of a study")->required();
  submit->add_flag("--slurm", options.slurm, "Write a script for Slurm's sbatch");
  submit->add_option("--shards", options.shards, "Number of shards")
      ->required()
      ->check(CLI::Range(1, static_cast<int>(study::kMaxShards)));
  submit
      ->add_option("--mode", options.mode,
                   "array: a job of an array for each shard; allocation: all in one job")
      ->check(CLI::IsMember({"array", "allocation"}))
      ->capture_default_str();
  submit->add_option("-j,--threads", options.threads, "Threads of each shard")
      ->check(CLI::Range(1, 4096))
      ->capture_default_str();
  submit->add_option("--time", options.time, "Time limit, as sbatch takes it")
      ->capture_default_str();
  submit->add_option("--sbatch", options.site,
                     "A further line for sbatch, such as --sbatch=--partition=short");
  submit->add_option("--program", options.program, "The program on the nodes")
      ->capture_default_str();
  submit->add_option("-o,--output", options.output,
                     "The results file (default: <name of the job>.h5)");
  submit->add_option("--script", options.script, "The script (default: <name of the job>.sbatch)");
  submit->add_flag("--overwrite", options.overwrite, "Replace files that exist");
  submit->callback([shared, &action] { action = [shared] { return submit_command(*shared); }; });
}

}  // namespace gurney::cli
