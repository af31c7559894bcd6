#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/error.h"
#include "engine/base/files.h"
#include "engine/base/parallel.h"
#include "engine/base/printable.h"
#include "engine/base/shell_word.h"
#include "studies/cli/commands.h"
#include "studies/cli/output.h"
#include "studies/cli/process.h"
#include "studies/cli/repeated_run.h"
#include "studies/cli/shared_options.h"
#include "studies/cli/study_output.h"
#include "studies/plan/plan.h"
#include "studies/report/formats.h"
#include "studies/report/study_report.h"
#include "studies/results/output_files.h"
#include "studies/run/shard_folders.h"
#include "studies/run/shard_status.h"
#include "studies/run/study_identity.h"

namespace gurney::cli {
namespace {

namespace fs = std::filesystem;

struct SubmitOptions {
  std::string job, output, script, mode = "array", time = "01:00:00", program = "gurney";
  std::vector<std::string> site;  ///< options of the scheduler, such as --partition=short
  int shards = 0, threads = 1;
  int at_most = 0;  ///< shards that run at the same time; 0: as many as there is room for
  bool slurm = false, pbs = false, lsf = false, overwrite = false;
  std::size_t stages = 1;  ///< of the study
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

/// A stage needs all shards of the one before: each time all of them finish one more at least.
constexpr const char* kStages = R"(code=0
for stage in $(seq {}); do
  {}  code=$?
  [ "$code" -eq 0 ] || [ "$code" -eq 3 ] || break
done
(exit "$code")
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
  const std::string all = run + " --shard auto\n";
  text += options.stages == 1 ? all : fmt::format(fmt::runtime(kStages), options.stages, all);
  return text + fmt::format(fmt::runtime(kAgain), "$SLURM_JOB_ID") +
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
  require_usage(options.slurm + options.pbs + options.lsf == 1,
                "gurney submit needs one scheduler: --slurm, --pbs or --lsf");
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

int submit_command(const SubmitOptions& asked) {
  SubmitOptions options = asked;
  for (const std::string& line : options.site)
    require_usage(line.starts_with(options.slurm ? "--" : "-"),
                  fmt::format("--directive {}: must be one option of the scheduler, such as {}",
                              line, options.slurm ? "--partition=short" : "-q short"));
  require_usage(
      !options.time.empty() &&
          options.time.find_first_not_of("0123456789:-") == std::string::npos &&
          is_digit(options.time.front()) && is_digit(options.time.back()),
      "--time " + options.time + ": must be as sbatch takes it, such as 90, 02:00:00 or 1-12:00");
  const Scheduler& scheduler = scheduler_of(options);
  require_usage(options.slurm || options.time.find('-') == std::string::npos,
                fmt::format("--time {}: must be hours:minutes{}", options.time,
                            options.pbs ? ":seconds" : ""));
  require_usage(options.slurm || options.mode == "array",
                fmt::format("--mode allocation is for --slurm; {} has arrays", scheduler.option));
  const study::StudyJob job(options.job);
  const study::StudyMotions motions(job);
  const study::Plan plan(job, motions);
  const auto tasks = plan.tasks();
  const std::size_t at_once = plan.tasks_of_stage();
  require(
      static_cast<std::size_t>(options.shards) <= at_once,
      fmt::format("--shards {}: the study has {} analysis cases{}, and no more shards are of use",
                  options.shards, at_once, plan.stages() > 1 ? " in a stage" : ""));
  options.stages = plan.stages();
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
  if (options.mode == "array" && options.stages > 1)
    fmt::print("again    {}, in all {} times, each after all shards of the stage before\n",
               options.slurm ? fmt::format("sbatch --dependency=singleton {}", shell_word(script))
                             : scheduler.submit + shell_word(script),
               options.stages);
  if (options.mode == "array")
    fmt::print("at last  gurney merge {}\n", shell_word(study::shards_path(results).string()));
  return 0;
}

using study::RecordTime;
using study::ShardStatus;

struct StatusOptions {
  std::string folder;
  bool json = false;
};

std::string state_of(const ShardStatus& shard) {
  if (!shard.started) return "not started";
  if (shard.other_study) return "of another study: not counted, and refused by merge";
  if (shard.done == shard.tasks) return "finished";
  if (!shard.process.empty()) return "running: " + shard.process;
  if (shard.stage == 0 || shard.shard.count == 1) return "stopped";
  return fmt::format("stage {} of {} finished, goes on with --resume", shard.stage, shard.stages);
}

/// Time that a shard still takes [s]; none: unknown, or it does not run.
std::optional<double> to_go(const ShardStatus& shard) {
  if (shard.done >= shard.tasks) return 0;
  if (shard.process.empty() || !(shard.seconds_per_task > 0)) return {};
  return shard.seconds_per_task * static_cast<double>(shard.tasks - shard.done);
}

findings::Table table_of(const std::vector<ShardStatus>& shards) {
  findings::Table table{"shards", "", {}};
  for (const ShardStatus& s : shards) {
    const std::optional<double> time = to_go(s);
    report::add_row(
        table, {{{"shard", "shard"}, fmt::format("{}/{}", s.shard.number, s.shard.count)},
                {{"", "cases"}, fmt::format("{} of {}", s.done, s.tasks)},
                {"analysis_cases", s.tasks},
                {"finished", s.done},
                {{"runs", "runs"}, s.counts.runs},
                {{"overturned", "overturned"}, s.counts.overturned},
                {{"", "failed"}, report::failed_runs(s.counts.failed, s.counts.untrusted)},
                {"failed", s.counts.failed},
                {"untrusted", s.counts.untrusted},
                {{"runs_per_second", "runs/s", {".1f"}}, s.runs_per_second},
                {{"", "to go"}, time.value_or(0) > 0 ? duration_text(*time) : std::string("-")},
                {"seconds_to_go", time ? findings::Value(*time) : findings::Value()},
                {{"state", "state"}, state_of(s)}});
  }
  return table;
}

struct Total {
  std::size_t finished = 0, running = 0, damaged = 0, foreign = 0;
  double rate = 0;                  ///< of those that run
  std::optional<double> to_go = 0;  ///< the longest; none: of one it is unknown, or it does not run
  double running_to_go = 0;         ///< the longest of those that run
};

Total total_of(const study::StudyStatus& study) {
  Total all;
  for (const ShardStatus& s : study.shards) {
    all.damaged += s.damaged;
    all.foreign += s.foreign;
    all.finished += s.done == s.tasks;
    const std::optional<double> time = to_go(s);
    all.to_go = time && all.to_go ? std::optional(std::max(*all.to_go, *time)) : std::nullopt;
    if (s.process.empty()) continue;
    ++all.running;
    all.rate += s.runs_per_second;
    all.running_to_go = std::max(all.running_to_go, time.value_or(0));
  }
  if (study.done < study.tasks && all.to_go == 0) all.to_go.reset();  // a shard is not there
  return all;
}

/// Records of all shards, those with the slowest runs first.
std::vector<std::pair<std::string, RecordTime>> slowest_records(
    const std::vector<ShardStatus>& shards) {
  constexpr std::size_t kMost = 5;
  std::map<std::string, RecordTime> all;
  for (const ShardStatus& shard : shards)
    for (const auto& [name, time] : shard.records) {
      all[name].runs += time.runs;
      all[name].seconds += time.seconds;
    }
  std::vector<std::pair<std::string, RecordTime>> sorted(all.begin(), all.end());
  std::ranges::stable_sort(sorted, std::greater<>(),
                           [](const auto& each) { return each.second.mean(); });
  if (sorted.size() > kMost) sorted.resize(kMost);
  return sorted;
}

findings::Table table_of(const std::vector<std::pair<std::string, RecordTime>>& records) {
  findings::Table table{"slowest_records", "", {}};
  for (const auto& [name, time] : records)
    report::add_row(
        table, {{{"record", "slowest records"}, name.empty() ? "floor at rest" : printable(name)},
                {{"runs", "runs"}, time.runs},
                {{"cpu_seconds_per_run", "CPU time of a run", {".3g", "s"}}, time.mean()}});
  return table;
}

int status_command(const StatusOptions& options) {
  const study::StudyStatus study = study::study_status(options.folder);
  const std::vector<ShardStatus>& shards = study.shards;
  const Total all = total_of(study);
  findings::Section known;
  known.add(table_of(shards));
  known.json("analysis_cases", study.tasks).json("finished", study.done);
  known.json("runs", study.counts.runs)
      .json("failed", study.counts.failed)
      .json("damaged_parts", all.damaged);
  known.json("foreign_analysis_cases", all.foreign).json("runs_per_second", all.rate);
  known.json("seconds_to_go", all.to_go ? findings::Value(*all.to_go) : findings::Value());
  known.say(fmt::format(
      "{} of {} analysis cases, {} runs, {} failed; {} of {} shards finished, {} "
      "running{}{}",
      study.done, study.tasks, study.counts.runs, study.counts.failed, all.finished, shards.size(),
      all.running, all.rate > 0 ? fmt::format(", {:.1f} runs/s", all.rate) : "",
      all.running_to_go > 0 ? fmt::format(", {} to go", duration_text(all.running_to_go)) : ""));
  if (study.done < study.tasks && all.finished == shards.size())
    known.say(fmt::format("{} analysis cases are in no shard; these are of several counts",
                          study.tasks - study.done));
  if (all.damaged > 0)
    known.say(fmt::format("{} damaged part{}, whose runs will be repeated", all.damaged,
                          all.damaged == 1 ? "" : "s"));
  if (all.foreign > 0)
    known.say(fmt::format(
        "{} analysis cases stand in the folder of another shard and are not counted", all.foreign));
  const auto records = slowest_records(shards);
  if (records.size() > 1 || options.json) known.add(table_of(records));
  print_findings(known, options.json);
  return 0;
}

constexpr const char* kSuffix = ".shards";

struct MergeOptions {
  std::string folder, output, job;
  bool overwrite = false, json = false;
};

fs::path results_of(const MergeOptions& options, const fs::path& folder) {
  const bool named = folder.extension() == kSuffix;
  require(!options.output.empty() || named,
          fmt::format("{}: is not named as gurney run names a folder of shards, FILE.h5{}; give "
                      "the results file with -o",
                      folder.string(), kSuffix));
  return results_file(options.output.empty() ? folder.parent_path() / folder.stem()
                                             : fs::path(options.output));
}

std::string job_of(const MergeOptions& options, const fs::path& folder) {
  if (!options.job.empty()) return options.job;
  const std::string path = job_of_shards(folder);
  require(!path.empty(), folder.string() + ": holds no path of the job; give it with --job");
  require(is_there(path), fmt::format("{}: the job {} {}; give its new path with --job",
                                      folder.string(), path, why_not_there(path)));
  return path;
}

/// The commands that complete the shards; empty if these are of several counts.
std::string repair(const std::vector<study::ShardFolders::Incomplete>& shards,
                   const std::string& job, const fs::path& results) {
  constexpr std::size_t kShown = 3;
  std::size_t listed = 0;
  std::string text, numbers;
  for (const auto& [shard, missing] : shards) {
    if (!numbers.empty()) numbers += ",";
    numbers += std::to_string(shard.number);
    if (++listed <= kShown)
      text += fmt::format("\n  gurney run {} -o {} --resume --shard {}/{}", shell_word(job),
                          shell_word(results.string()), shard.number, shard.count);
  }
  if (text.empty()) return text;
  const std::string script = shell_word(fs::path(job).stem().string() + ".sbatch");
  return "\ncomplete them with:" + text +
         fmt::format("\nor all on Slurm, with the script of gurney submit:\n  sbatch --array={} {}",
                     numbers, script);
}

int merge_command(const MergeOptions& options) {
  fs::path folder = fs::path(options.folder).lexically_normal();
  if (!folder.has_filename()) folder = folder.parent_path();  // it ended in a slash
  study::shards_in(folder);                                   // or there are none
  const fs::path results = results_of(options, folder);
  study::OutputFiles(options.overwrite).check(results.string());
  const std::string path = job_of(options, folder);
  const study::StudyJob job(path);
  const study::StudyMotions motions(job);
  const study::Plan plan(job, motions);
  const study::Batch batch{job, motions, plan};
  motions.read_all(threads_or_all());
  for (const char* ending : {".h5", ".log"})
    study::refuse_input(fs::path(results).replace_extension(ending).string());

  study::ShardFolders shards(folder, study::identity_of(batch), plan.tasks());
  for (const std::string& warning : shards.warnings()) print_error("{}\n", warning);
  const std::string missing = shards.missing();
  require(missing.empty(), missing + repair(shards.incomplete(), path, results));
  const StudySummary summary = write_results(
      batch, folder, [&](std::size_t task) { return shards.read(task); }, results,
      options.overwrite);
  append_log(
      fs::path(results).replace_extension(".log"),
      shards.logs() + log_entry(path, "merged", fmt::format("{} runs", summary.counts.runs)));
  shards.remove();
  print_study(batch, results, summary, 0, options.json);
  return summary.counts.failed > 0 ? 3 : 0;
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
            ->check(Options::one_of({"array", "allocation"}));
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

void add_status(Commands& commands) {
  commands.add<StatusOptions>(
      {"status", "Report the progress of shards, also while they run",
       "gurney status ventilator.h5.shards"},
      status_command, [](Options& add, StatusOptions& options) {
        add.required("FOLDER", options.folder,
                     "The folder of the shards, FILE.h5.shards, or of one study, FILE.h5.parts");
        add("--json", options.json, "Print it as JSON");
      });
}

void add_merge(Commands& commands) {
  commands.add<MergeOptions>(
      {"merge", "Merge the shards of a study into its results file",
       "gurney merge ventilator.h5.shards\n"
       "gurney merge ventilator.h5.shards --job ventilator.toml -o all.h5"},
      merge_command, [](Options& add, MergeOptions& options) {
        add.required("FOLDER", options.folder, "The folder of the shards: FILE.h5.shards");
        add("-o,--output FILE", options.output,
            "The results file (default: FILE.h5 of the folder's name)");
        add("--job FILE", options.job, "The job file (default: where the shards found it)");
        add("--overwrite", options.overwrite, "Replace files that exist");
        add("--json", options.json, "Print the summary as JSON");
      });
}

}  // namespace gurney::cli
