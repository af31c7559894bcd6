#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "engine/base/error.h"
#include "engine/base/printable.h"
#include "engine/base/shell_word.h"
#include "studies/cli/arguments.h"
#include "studies/cli/commands.h"
#include "studies/plan/plan.h"
#include "studies/results/output_files.h"
#include "studies/run/shard_folders.h"

namespace gurney::cli {
namespace {

namespace fs = std::filesystem;

struct SubmitOptions {
  std::string job, output, script, mode = "array", time = "01:00:00", program = "gurney";
  std::vector<std::string> site;  ///< options of the scheduler, such as --partition=short
  int shards = 0, threads = 1;
  int at_most = 0;  ///< shards that run at the same time; 0: as many as there is room for
  bool slurm = false, pbs = false, lsf = false, overwrite = false;
};

/// Slurm refuses array indices from MaxArraySize on, which is 1001 unless a site sets another.
constexpr int kLargestIndex = 1000;

/// Before a shard: how many seconds of grace Slurm gives with SIGTERM, to write what is finished.
constexpr int kGrace = 60;

/// @param origin  that states the text, for the message
void check_one_line(const std::string& origin, const std::string& text) {
  const auto control =
      std::ranges::find_if(text, [](unsigned char c) { return c < 0x20 || c == 0x7f; });
  require(control == text.end(),
          fmt::format("{}: has the control character 0x{:02x}; a line of a scheduler has none",
                      origin, control == text.end() ? 0 : static_cast<unsigned char>(*control)));
}

/// An option of a scheduler as a comment of the script, which a line end would turn into a command.
std::string directive(const std::string& origin, const std::string& option,
                      const char* scheduler = "SBATCH") {
  check_one_line(origin, option);
  return fmt::format("#{} {}\n", scheduler, option);
}

std::string job_name(const SubmitOptions& options) {
  const std::string name = fs::path(options.job).stem().string();
  check_one_line("the name of the job file", name);
  return name;
}

/// How many tasks of an array run at the same time, as Slurm, PBS and LSF take it; empty: all.
std::string at_most(const SubmitOptions& options) {
  return options.at_most > 0 ? fmt::format("%{}", options.at_most) : "";
}

/// The indices of an array.
std::string array_of(const SubmitOptions& options, int size) {
  return fmt::format("1-{}{}", size, at_most(options));
}

std::string head(const SubmitOptions& options) {
  const bool array = options.mode == "array";
  std::string text = "#!/bin/bash\n";
  text += directive("the name of the job file", "--job-name=" + shell_word(job_name(options)));
  text += array ? fmt::format("#SBATCH --array={}\n",
                              array_of(options, std::min(options.shards, kLargestIndex)))
                : fmt::format("#SBATCH --ntasks={}\n", options.shards);
  text += fmt::format("#SBATCH --cpus-per-task={}\n", options.threads);
  text += directive("--time", "--time=" + options.time);
  text += fmt::format("#SBATCH --output={}\n", array ? "%x-%A_%a.out" : "%x-%j.out");
  text += "#SBATCH --open-mode=append\n#SBATCH --requeue\n";
  text += fmt::format("#SBATCH --signal=TERM@{}\n", kGrace);
  for (const std::string& option : options.site) text += directive("--directive", option);
  return text;
}

/// A path that no program takes for an option.
std::string no_option(const std::string& path) {
  return path.starts_with('-') ? "./" + path : path;
}

/// A task of an array ends with SIGTERM before its time is over: it is put into the queue again.
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
    return text +
           fmt::format("{} --shard \"{}/{}\"\n", run,
                       options.shards > kLargestIndex
                           ? "$((SLURM_ARRAY_TASK_ID + ${GURNEY_SHARDS_BEFORE:-0}))"
                           : "$SLURM_ARRAY_TASK_ID",
                       options.shards) +
           fmt::format(fmt::runtime(kAgain), "${SLURM_ARRAY_JOB_ID}_${SLURM_ARRAY_TASK_ID}") +
           "exit \"$code\"\n";
  return text + fmt::format("{} --shard auto\n", run) +
         fmt::format(fmt::runtime(kAgain), "$SLURM_JOB_ID") +
         fmt::format("[ \"$code\" -eq 0 ] && exec {}\nexit \"$code\"\n", merge);
}

/// A shard as a task of an array of PBS or LSF. These put no task into the queue again whose time is
/// over: it is submitted again, and goes on.
std::string task_of(const SubmitOptions& options, const std::string& results, const char* index) {
  return fmt::format(
      "set -u\n{} run {} -o {} --resume -j {} --shard \"{}/{}\"\ncode=$?\n"
      "[ \"$code\" -eq 3 ] && code=0  # some runs failed: they are rows of the results\n"
      "exit \"$code\"\n",
      shell_word(options.program), shell_word(options.job), shell_word(results), options.threads,
      index, options.shards);
}

std::string pbs_script_of(const SubmitOptions& options, const std::string& results) {
  std::string text = "#!/bin/bash\n";
  text += directive("the name of the job file", "-N " + shell_word(job_name(options)), "PBS");
  if (options.shards > 1)  // it refuses an array of one
    text += fmt::format("#PBS -J {}\n", array_of(options, options.shards));
  text += fmt::format("#PBS -l select=1:ncpus={}\n", options.threads);
  text += directive("--time", "-l walltime=" + options.time, "PBS") + "#PBS -j oe\n#PBS -r y\n";
  for (const std::string& option : options.site) text += directive("--directive", option, "PBS");
  return text + "\ncd \"$PBS_O_WORKDIR\" || exit 1\n" +
         task_of(options, results, "${PBS_ARRAY_INDEX:-1}");
}

std::string lsf_script_of(const SubmitOptions& options, const std::string& results) {
  std::string text = "#!/bin/bash\n";
  text += directive("the name of the job file",
                    fmt::format("-J {}", shell_word(fmt::format("{}[1-{}]{}", job_name(options),
                                                                options.shards, at_most(options)))),
                    "BSUB");
  text += fmt::format("#BSUB -n {}\n#BSUB -R \"span[hosts=1]\"\n", options.threads);
  text += directive("--time", "-W " + options.time, "BSUB");
  text += "#BSUB -o %J_%I.out\n#BSUB -r\n#BSUB -Q \"143\"\n#BSUB -wa TERM -wt 1\n";
  for (const std::string& option : options.site) text += directive("--directive", option, "BSUB");
  return text + "\n" + task_of(options, results, "$LSB_JOBINDEX");
}

struct Scheduler {
  const char *option, *suffix, *submit;  ///< submit: the command before the script
  std::string (*script)(const SubmitOptions&, const std::string& results);
};

constexpr Scheduler kSlurm{"--slurm", ".sbatch", "sbatch ", script_of},
    kPbs{"--pbs", ".pbs", "qsub ", pbs_script_of}, kLsf{"--lsf", ".bsub", "bsub < ", lsf_script_of};

const Scheduler& scheduler_of(const SubmitOptions& options) {
  require(options.slurm + options.pbs + options.lsf == 1,
          "gurney submit needs the scheduler: --slurm, --pbs or --lsf");
  return options.slurm ? kSlurm : options.pbs ? kPbs : kLsf;
}

/// Arrays of shards beyond the largest index, each submitted with the number of those before it.
std::string further_arrays(const SubmitOptions& options, const std::string& script) {
  std::string text;
  if (!options.slurm || options.mode != "array") return text;
  for (int before = kLargestIndex; before < options.shards; before += kLargestIndex)
    text +=
        fmt::format("         GURNEY_SHARDS_BEFORE={} sbatch --array={} {}\n", before,
                    array_of(options, std::min(options.shards - before, kLargestIndex)), script);
  return text;
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

int submit_command(const SubmitOptions& options) {
  for (const std::string& line : options.site)
    require(line.starts_with(options.slurm ? "--" : "-"),
            fmt::format("--directive {}: must be one option of the scheduler, such as {}", line,
                        options.slurm ? "--partition=short" : "-q short"));
  require(
      !options.time.empty() &&
          options.time.find_first_not_of("0123456789:-") == std::string::npos &&
          is_digit(options.time.front()) && is_digit(options.time.back()),
      "--time " + options.time + ": must be as sbatch takes it, such as 90, 02:00:00 or 1-12:00");
  const Scheduler& scheduler = scheduler_of(options);
  require(options.slurm || options.time.find('-') == std::string::npos,
          fmt::format("--time {}: must be hours:minutes{}", options.time,
                      options.pbs ? ":seconds" : ""));
  require(options.slurm || options.mode == "array",
          fmt::format("--mode allocation is for --slurm; {} has arrays", scheduler.option));
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
  results_file(results);
  const std::string script =
      no_option(options.script.empty() ? stem + scheduler.suffix : options.script);
  study::OutputFiles files(options.overwrite);
  files.check(script);
  files.stage(script, scheduler.script(options, results));
  files.commit();
  fmt::print("{}: {} analysis cases in {} shards\nsubmit   {}{}\n{}watch    gurney status {}\n",
             printable(script), tasks, options.shards, scheduler.submit, shell_word(script),
             further_arrays(options, shell_word(script)),
             shell_word(study::shards_path(results).string()));
  if (options.mode == "array")
    fmt::print("at last  gurney merge {}\n", shell_word(study::shards_path(results).string()));
  return 0;
}

}  // namespace

void add_submit(Commands& commands) {
  commands.add<SubmitOptions>(
      {"submit", "Write a batch script that runs a study in shards on a cluster",
       "gurney submit ventilator.toml --slurm --shards 16 -j 4 --time 02:00:00\n"
       "gurney submit ventilator.toml --slurm --shards 16 --mode allocation"},
      submit_command, [](Options& add, SubmitOptions& options) {
        add.required("JOB", options.job, "The job file of a study");
        add("--slurm", options.slurm, "Write a script for Slurm's sbatch");
        add("--pbs", options.pbs, "Write a script for qsub of PBS Pro or OpenPBS");
        add("--lsf", options.lsf, "Write a script for LSF's bsub");
        add.required("--shards", options.shards, "Number of shards")
            ->check(CLI::Range(1, static_cast<int>(study::kMaxShards)));
        add("--mode", options.mode,
            "array: a job of an array for each shard; allocation: all in one job of Slurm")
            ->check(CLI::IsMember({"array", "allocation"}));
        add.threads(options.threads, "Threads of each shard");
        add("--at-most", options.at_most, "Shards of an array that run at the same time")
            ->check(CLI::Range(1, static_cast<int>(study::kMaxShards)));
        add("--time TIME", options.time, "Time limit, as the scheduler takes it");
        add("--directive,--sbatch", options.site,
            "A further option for the scheduler, such as --directive=--partition=short");
        add("--program FILE", options.program, "The program on the nodes");
        add("-o,--output FILE", options.output, "The results file (default: <name of the job>.h5)");
        add("--script FILE", options.script,
            "The script (default: <name of the job>.sbatch, .pbs or .bsub)");
        add("--overwrite", options.overwrite, "Replace files that exist");
      });
}

}  // namespace gurney::cli
