#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "engine/base/error.h"
#include "engine/base/shell_word.h"
#include "studies/cli/commands.h"
#include "studies/study/plan/plan.h"
#include "studies/study/results/output_files.h"
#include "studies/study/run/shard_folders.h"

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

std::string head(const SubmitOptions& options) {
  const bool array = options.mode == "array";
  std::string text = fmt::format(
      "#!/bin/bash\n"
      "#SBATCH --job-name={}\n"
      "#SBATCH --{}\n"
      "#SBATCH --cpus-per-task={}\n"
      "#SBATCH --time={}\n"
      "#SBATCH --output={}\n"
      "#SBATCH --open-mode=append\n"
      "#SBATCH --requeue\n"
      "#SBATCH --signal=TERM@{}\n",
      shell_word(fs::path(options.job).stem().string()),
      array ? fmt::format("array=1-{}", options.shards) : fmt::format("ntasks={}", options.shards),
      options.threads, options.time, array ? "%x-%A_%a.out" : "%x-%j.out", kGrace);
  for (const std::string& line : options.site) text += fmt::format("#SBATCH {}\n", line);
  return text;
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

int submit_command(const SubmitOptions& options) {
  for (const std::string& line : options.site)
    require(line.starts_with("--") && line.find('\n') == std::string::npos,
            "--sbatch " + line + ": must be one option of sbatch, such as --partition=short");
  require(
      options.time.find_first_not_of("0123456789:-") == std::string::npos,
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
  const std::string stem = fs::path(options.job).stem().string();
  const std::string results = options.output.empty() ? stem + ".h5" : options.output;
  require(fs::path(results).extension() == ".h5",
          results + ": the results file must end in .h5 (-o FILE.h5)");
  const std::string script = options.script.empty() ? stem + ".sbatch" : options.script;
  study::OutputFiles files(options.overwrite);
  files.check(script);
  files.stage(script, script_of(options, results));
  files.commit();
  fmt::print("{}: {} analysis cases in {} shards\nsubmit   sbatch {}\nwatch    gurney status {}\n",
             script, tasks, options.shards, shell_word(script),
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
