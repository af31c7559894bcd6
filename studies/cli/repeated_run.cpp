#include "studies/cli/repeated_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <map>
#include <memory>

#include "engine/base/error.h"
#include "engine/base/files.h"
#include "engine/base/hash/sha256.h"
#include "engine/base/input_file.h"
#include "engine/base/parallel.h"
#include "engine/config/unit_limit.h"
#include "engine/run/run.h"
#include "studies/analysis/study_data.h"
#include "studies/build_info/build_info.h"
#include "studies/explanation/explain.h"
#include "studies/plan/study_job.h"
#include "studies/report/run_report.h"
#include "studies/results/columns.h"
#include "studies/results/hdf5_reader.h"
#include "studies/results/names.h"
#include "studies/results/stored_predictability.h"
#include "studies/run/part_folder.h"
#include "studies/run/run_task.h"
#include "studies/run/study_identity.h"

namespace gurney::cli {
namespace {

/// Text behind the last `word` at the start of a line; empty where there is none.
std::string value_of(const std::string& text, const std::string& word) {
  const auto place = text.rfind('\n' + word + ' ');
  if (place == std::string::npos) return {};
  const auto start = text.find_first_not_of(' ', place + 1 + word.size());
  return text.substr(start, text.find('\n', start) - start);
}

namespace fs = std::filesystem;

std::string text_of(const fs::path& path) {
  return is_there(path) ? read_input_file(path.string()) : std::string();
}

/// The job of a results file: as named, or else where the log beside the file says it was.
std::string existing_job(const std::string& results, const std::string& named) {
  const std::string job = named.empty() ? job_of_log(results) : named;
  require(!job.empty() && is_there(job),
          fmt::format("{}: the job's file {}; name it with --job", results,
                      job.empty() ? "is not known" : job + " " + why_not_there(job)));
  return job;
}

/// @throws Error with the keys that differ between a job and that of a study
[[noreturn]] void refuse_job(const std::string& job, const std::string& text,
                             const std::string& study, const std::string& theirs) {
  const std::string keys = study::job_difference(theirs, text);
  throw Error(fmt::format(
      "{}: is not the job of {}: {}", job, study,
      keys.empty() ? fmt::format("there job_sha256 {}, here {}", sha256(theirs), sha256(text))
                   : keys));
}

std::string job_of(const study::StudyReader& file, const std::string& named) {
  const std::string job = existing_job(file.path(), named);
  const std::string theirs = file.text_attribute("job_sha256"), text = text_of(job);
  if (theirs != sha256(text)) refuse_job(job, text, file.path(), file.job_text());
  return job;
}

std::size_t whole(const study::StudyReader& file, const std::string& column, std::size_t run) {
  return static_cast<std::size_t>(file.numbers("runs/" + column)[run]);
}

/// The demands of one run as its file has them: a column, a number for each item.
using StoredDemands =
    std::vector<std::pair<const study::TableColumn<Demands>*, std::vector<double>>>;

/// The first demand of a run that is not as stored; empty: all are.
std::string difference_to(const StoredDemands& stored, const Response& response) {
  for (const auto& [column, theirs] : stored)
    for (std::size_t i = 0; i < response.items.size(); ++i) {
      const double ours = column->value(response.items[i].demands);
      if (i < theirs.size() && (ours == theirs[i] || (std::isnan(ours) && std::isnan(theirs[i]))))
        continue;
      return fmt::format("{} is {:.17g}, there {:.17g}", column->name, ours,
                         i < theirs.size() ? theirs[i] : 0);
    }
  return {};
}

std::string demand_difference(const study::StudyReader& file, std::size_t run,
                              const Response& response) {
  const auto [first, last] = file.rows_of_runs("items")[run];
  if (last - first != (is_failure(response.outcome) ? 0 : response.items.size()))
    return "the outcome";
  if (last == first) return {};
  StoredDemands stored;
  for (const study::TableColumn<Demands>& column : study::demand_columns()) {
    const std::string path = std::string("items/") + column.name;
    if (!file.has_column(path)) continue;
    const std::vector<double> all = file.numbers(path);
    stored.emplace_back(&column, std::vector(all.begin() + static_cast<std::ptrdiff_t>(first),
                                             all.begin() + static_cast<std::ptrdiff_t>(last)));
  }
  return difference_to(stored, response);
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

std::string type_of(const study::Hdf5Reader& file) {
  const auto attributes = file.attributes();
  if (std::ranges::find(attributes, "filetype") == attributes.end()) return {};
  return file.text_attribute("filetype");
}

StoredDemands demands_of(const study::Hdf5Reader& file) {
  StoredDemands demands;
  const std::vector<study::Hdf5Dataset> known = file.datasets();
  for (const study::TableColumn<Demands>& column : study::demand_columns()) {
    const std::string path = std::string("/items/") + column.name;
    if (std::ranges::find(known, path, &study::Hdf5Dataset::path) != known.end())
      demands.emplace_back(&column, file.numbers(path));
  }
  return demands;
}

/// The log beside a results file, after a line end; empty: there is none.
std::string log_beside(const std::string& results) {
  const fs::path log = fs::path(results).replace_extension(".log");
  return is_there(log) ? '\n' + read_input_file(log.string()) : std::string();
}

/// The file that a line of a log names, from the folder where it was written unless it is found from
/// here; empty: there is no such line.
std::string file_of_log(const std::string& log, const std::string& word) {
  const std::string file = value_of(log, word);
  if (file.empty()) return file;
  const fs::path from_its_folder = fs::path(value_of(log, "folder")) / file;
  return is_there(file) || !is_there(from_its_folder) ? file : from_its_folder.string();
}

/// The run that made a results file: of its job or, for one of `gurney replay`, of its study.
study::PreparedRun source_of(const std::string& path, const std::string& job) {
  const std::string log = log_beside(path), made = file_of_log(log, "study"),
                    word = value_of(log, "run");
  std::size_t run = 0;
  const auto read = std::from_chars(word.data(), word.data() + word.size(), run);
  if (made.empty() || read.ec != std::errc() || read.ptr != word.data() + word.size()) {
    require(!study::has_study(job),
            path +
                ": is one run of a study, and its log does not name which: gurney explain "
                "STUDY.h5 --run N, or repeat it with gurney replay");
    return study::prepare_run(job);
  }
  require(is_there(made), fmt::format("{}: is run {} of the study {}, which {}", path, run, made,
                                      why_not_there(made)));
  return StudyCase(made, run, job).prepared();
}

RepeatedRun single_run(const std::string& path, const std::string& named) {
  const study::Hdf5Reader file(path);
  require(type_of(file) == "gurney-results", path + ": is not a results file");
  const std::string job = existing_job(path, named);
  RepeatedRun result{source_of(path, job), {}, study::stored_predictability(file)};
  const std::string& text = result.run.facts.job_text;
  if (result.run.facts.job_sha256 != file.text_attribute("job_sha256"))
    throw Error(fmt::format("{}: is not the job of {}: {}", job, path,
                            study::job_difference(file.text_attribute("job_text"), text)));
  result.difference = [path, stored = demands_of(file)](const Response& response) {
    const std::string differs = difference_to(stored, response);
    if (differs.empty()) return differs;
    return fmt::format(
        "{}: its job gives other results now: {}; a record, an item, the program or the machine "
        "has changed",
        path, differs);
  };
  return result;
}

}  // namespace

std::string job_of_log(const std::string& results) {
  return file_of_log(log_beside(results), "job");
}

std::string results_of_folder(const std::string& folder) {
  const fs::path path = folder, name = path.has_filename() ? path : path.parent_path();
  return (name.parent_path() / name.stem()).string();
}

std::string job_of_shards(const fs::path& folder) {
  if (!is_there(folder / "job")) return {};
  std::string path = study::file_bytes(folder / "job");
  while (path.ends_with('\n')) path.pop_back();
  return path;
}

std::string job_of_unfinished(const study::FinishedCases& cases, const std::string& folder,
                              const std::string& named) {
  if (!named.empty()) {
    const std::string text = read_input_file(named), theirs = study::job_text_in(cases.identity());
    if (text != theirs) refuse_job(named, text, folder, theirs);
    return named;
  }
  const std::string job = job_of_shards(folder), results = results_of_folder(folder);
  return job.empty() ? study::place_of_job(job_of_log(results), results) : job;
}

std::string why_not_there(const std::string& path) {
  std::error_code problem;
  const bool there = std::filesystem::exists(path, problem);
  const bool gone = there || !problem || problem == std::errc::no_such_file_or_directory ||
                    problem == std::errc::not_a_directory;
  return gone ? "does not exist any more" : "cannot be read: " + problem.message();
}

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

bool is_study(const std::string& path) {
  return type_of(study::Hdf5Reader(path)) == "gurney-study";
}

RepeatedRun repeated_run(const std::string& file, std::optional<std::size_t> index,
                         const std::string& job) {
  if (!is_study(file)) {
    require(index.value_or(0) == 0, file + ": is a single run, which has no --run but 0");
    return single_run(file, job);
  }
  require(index.has_value(), file + ": is a study; choose one of its runs with --run N");
  const auto of_study = std::make_shared<StudyCase>(file, *index, job);
  return {of_study->prepared(),
          [of_study](const Response& response) { return of_study->difference(response); }};
}

namespace {

/// Puts what the file states in place of the same from other samples.
void keep(const std::vector<std::pair<std::string, Predictability>>& stored, const Scene& scene,
          Response& response) {
  const std::vector<std::string> names = study::item_names(scene);
  for (std::size_t i = 0; i < names.size(); ++i) {
    auto& found = response.items[i].predictability;
    const auto row =
        std::ranges::find(stored, names[i], [](const auto& each) { return each.first; });
    if (!found || row == stored.end()) continue;
    Predictability kept = row->second;
    kept.twin = std::move(found->twin);
    kept.half_step = std::move(found->half_step);
    found = std::move(kept);
  }
}

}  // namespace

Explained explained(const RepeatedRun& again, const study::UnitSystem& units) {
  const study::RunFacts& facts = again.run.facts;
  const auto settings =
      explanation::finely_stored(facts.settings, facts.floor, facts.scene.items.size());
  Response response = run_judged(facts.scene, facts.floor, settings, threads_or_all()).response;
  const std::string differs = again.difference(response);
  require(differs.empty(), differs);
  keep(again.predictability, facts.scene, response);
  explanation::Explanation found = explanation::explain(facts, response);
  found.units = units;
  return {std::move(found), report::narrative(facts, response, units)};
}

}  // namespace gurney::cli
