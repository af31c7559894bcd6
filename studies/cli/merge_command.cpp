#include <fmt/format.h>

#include <filesystem>
#include <string>

#include "engine/base/error.h"
#include "engine/base/files.h"
#include "engine/base/parallel.h"
#include "engine/base/shell_word.h"
#include "studies/cli/arguments.h"
#include "studies/cli/commands.h"
#include "studies/cli/process.h"
#include "studies/cli/repeated_run.h"
#include "studies/cli/study_output.h"
#include "studies/results/output_files.h"
#include "studies/run/shard_folders.h"
#include "studies/run/study_identity.h"

namespace gurney::cli {
namespace {

namespace fs = std::filesystem;

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
