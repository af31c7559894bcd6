#include "studies/cli/study_case.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <map>

#include "engine/base/error.h"
#include "engine/base/files.h"
#include "engine/base/hash/sha256.h"
#include "engine/base/input_file.h"
#include "engine/config/unit_limit.h"
#include "studies/build_info/build_info.h"
#include "studies/cli/job_of_log.h"
#include "studies/plan/data_files.h"
#include "studies/results/columns.h"
#include "studies/run/run_task.h"
#include "studies/run/study_identity.h"

namespace gurney::cli {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& path) {
  return is_there(path) ? read_input_file(path.string()) : std::string();
}

std::string job_of(const study::StudyReader& file, const std::string& named) {
  const std::string job = named.empty() ? job_of_log(file.path()) : named;
  require(!job.empty() && is_there(job),
          fmt::format("{}: the job's file {}; name it with --job", file.path(),
                      job.empty() ? "is not known" : job + " " + why_not_there(job)));
  const std::string theirs = file.text_attribute("job_sha256"), text = text_of(job);
  if (theirs == sha256(text)) return job;
  const std::string keys = study::job_difference(file.job_text(), text);
  throw Error(fmt::format(
      "{}: is not the job of {}: {}", job, file.path(),
      keys.empty() ? fmt::format("there job_sha256 {}, here {}", theirs, sha256(text)) : keys));
}

std::size_t whole(const study::StudyReader& file, const std::string& column, std::size_t run) {
  return static_cast<std::size_t>(file.numbers("runs/" + column)[run]);
}

/// A demand that is not the same as in the study; empty: all are.
std::string demand_difference(const study::StudyReader& file, std::size_t run,
                              const Response& response) {
  const auto [first, last] = file.rows_of_runs("items")[run];
  if (last - first != (is_failure(response.outcome) ? 0 : response.items.size()))
    return "the outcome";
  for (const study::TableColumn<Demands>& column : study::demand_columns()) {
    if (!file.has_column(std::string("items/") + column.name)) continue;
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

const study::StudyReader& with_run(const study::StudyReader& file, std::size_t run) {
  require(run < file.runs(), fmt::format("{}: has no run {}; it has runs 0 to {}", file.path(), run,
                                         static_cast<long>(file.runs()) - 1));
  return file;
}

}  // namespace

StudyCase::StudyCase(const std::string& path, std::size_t run, const std::string& job)
    : file_(path), run_(run), job_(job_of(with_run(file_, run), job)), study_(job_) {}

study::PreparedRun StudyCase::prepared() const {
  const study::StudyMotions motions(study_);
  const study::Plan plan(study_, motions);
  const study::Task task = plan.task(whole(file_, "analysis_case", run_));
  const study::Job job = study_.job(task.configuration, plan.draw(task), task.replica);
  const double scale = file_.numbers("runs/scale")[run_];
  const double largest = config::unit_limit("scale").largest;  // of a job too
  require(std::abs(scale) <= largest,
          fmt::format("{}: /runs/scale[{}] = {:g}: must be at most {:g}", file_.path(), run_, scale,
                      largest));
  return study::prepare_run(job,
                            motions.set_of(task.configuration)
                                .motion(task.record, scale, study_.study().angles[task.angle]));
}

std::string StudyCase::difference(const Response& response) const {
  const std::string differs = demand_difference(file_, run_, response);
  if (differs.empty()) return {};
  const std::string changed = changed_files(file_, study_);
  const build_info::BuildInfo build = build_info::build_info();
  return fmt::format(
      "{}: run {} gives other results now: {}\nit was computed by gurney {} {} on CPU class {}, "
      "this is {} {} on {}; {}",
      file_.path(), run_, differs, file_.text_attribute("program_version"),
      file_.text_attribute("git_commit"), file_.text_attribute("cpu_class"), build.program_version,
      build.git_commit, build.cpu_class,
      changed.empty() ? "a record may have changed, too" : "changed since: " + changed);
}

}  // namespace gurney::cli
