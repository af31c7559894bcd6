#include "studies/cli/replay_command.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <map>

#include "engine/base/error.h"
#include "engine/base/hash/sha256.h"
#include "engine/base/input_file.h"
#include "studies/build_info/build_info.h"
#include "studies/cli/job_of_log.h"
#include "studies/cli/run_output.h"
#include "studies/cli/standard_error.h"
#include "studies/study/analysis/replica_spread.h"
#include "studies/study/plan/data_files.h"
#include "studies/study/results/columns.h"
#include "studies/study/results/study_reader.h"
#include "studies/study/run/run_task.h"
#include "studies/study/run/study_identity.h"

namespace gurney::cli {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& path) {
  return fs::exists(path) ? read_input_file(path.string()) : std::string();
}

std::string job_of(const ReplayOptions& options, const study::StudyReader& file) {
  const std::string job = options.job.empty() ? job_of_log(options.file) : options.job;
  require(!job.empty() && fs::exists(job),
          fmt::format("{}: the job's file {}; name it with --job", options.file,
                      job.empty() ? "is not known" : job + " no longer exists"));
  const std::string theirs = file.text_attribute("job_sha256"), text = text_of(job);
  if (theirs == sha256(text)) return job;
  const std::string keys = study::job_difference(file.job_text(), text);
  throw Error(fmt::format(
      "{}: is not the job of {}: {}", job, options.file,
      keys.empty() ? fmt::format("there job_sha256 {}, here {}", theirs, sha256(text)) : keys));
}

std::size_t whole(const study::StudyReader& file, const std::string& column, std::size_t run) {
  return static_cast<std::size_t>(file.numbers("runs/" + column)[run]);
}

/// A demand that is not the same as in the study; empty: all are.
std::string difference(const study::StudyReader& file, std::size_t run, const Response& response) {
  const auto [first, last] = file.rows_of_runs("items")[run];
  if (last - first != (is_failure(response.outcome) ? 0 : response.items.size()))
    return "the outcome";
  for (const study::TableColumn<Demands>& column : study::demand_columns()) {
    const std::vector<double> theirs = file.numbers(std::string("items/") + column.name);
    for (std::size_t row = first; row < last; ++row) {
      const double ours = column.value(response.items[row - first].demands);
      const bool same = ours == theirs[row] || (std::isnan(ours) && std::isnan(theirs[row]));
      if (!same) return fmt::format("{} is {:.17g}, there {:.17g}", column.name, ours, theirs[row]);
    }
  }
  return {};
}

/// Names of data files that are not what the study was run with.
std::string changed_files(const study::StudyReader& file, const study::StudyJob& job) {
  std::map<std::string, std::string> now = study::data_files(job);
  const auto names = file.strings("data_files/name"), hashes = file.strings("data_files/sha256");
  std::string changed;
  for (std::size_t row = 0; row < names.size(); ++row)
    if (now[names[row]] != hashes[row]) changed += (changed.empty() ? "" : ", ") + names[row];
  return changed;
}

std::string spread_text(const std::optional<study::ReplicaSpread>& spread) {
  if (!spread) return {};
  return fmt::format(
      "replicas {} of this case: peak displacement {:.3g} to {:.3g} m, median {:.3g} m; {} "
      "overturned, {} failed\n",
      spread->runs, spread->lowest, spread->highest, spread->median, spread->overturned,
      spread->failed);
}

fs::path results_of(const ReplayOptions& options) {
  if (!options.output.empty()) {
    require(fs::path(options.output).extension() == ".h5",
            options.output + ": the results file must end in .h5 (-o FILE.h5)");
    return options.output;
  }
  const fs::path file = options.file;
  return file.parent_path() / fmt::format("{}_run_{}.h5", file.stem().string(), options.run);
}

}  // namespace

int replay_command(const ReplayOptions& options) {
  options.figures.check();
  const study::StudyReader file(options.file);
  require(options.run < file.runs(),
          fmt::format("{}: has no run {}; it has runs 0 to {}", options.file, options.run,
                      static_cast<long>(file.runs()) - 1));
  const RunOutput output{results_of(options), job_of(options, file), options.overwrite,
                         options.json,        options.no_figure,     options.figures};
  check_output(output);

  const study::StudyJob study(output.job);
  const study::StudyMotions motions(study);
  const study::Plan plan(study, motions);
  const study::Task task = plan.task(whole(file, "analysis_case", options.run));
  const study::Job job = study.job(task.configuration, plan.draw(task), task.replica);
  const double scale = file.numbers("runs/scale")[options.run];
  const study::PreparedRun run =
      study::prepare_run(job, motions.set_of(task.configuration)
                                  .motion(task.record, scale, study.study().angles[task.angle]));
  const Response response = run_and_write(run, output);
  const std::string differs = difference(file, options.run, response);
  if (!differs.empty()) {
    const std::string changed = changed_files(file, study);
    print_error(
        "{}: run {} gives other results now: {}\nit was computed by gurney {} {} on CPU class {}, "
        "this is {} {} on {}; {}\n",
        options.file, options.run, differs, file.text_attribute("program_version"),
        file.text_attribute("git_commit"), file.text_attribute("cpu_class"),
        build_info::build_info().program_version, build_info::build_info().git_commit,
        build_info::build_info().cpu_class,
        changed.empty() ? "a record may have changed, too" : "changed since: " + changed);
    return 1;
  }
  if (!options.json)
    fmt::print("replay   the same results as in {}\n{}", options.file,
               spread_text(study::replica_spread(file, options.run)));
  return is_failure(response.outcome) ? 3 : 0;
}

}  // namespace gurney::cli
