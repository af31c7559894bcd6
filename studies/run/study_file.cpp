#include "studies/run/study_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "engine/base/error.h"
#include "engine/base/hash/sha256.h"
#include "studies/plan/data_files.h"
#include "studies/prepare/run_job.h"
#include "studies/results/results_file.h"
#include "studies/results/study_reader.h"
#include "studies/run/declared_ranges.h"
#include "studies/run/run_tables.h"
#include "studies/run/study_identity.h"

namespace gurney::study {
namespace {

/// Rows of texts, all known before the first is written.
struct TextTable {
  struct TextColumn {
    std::string name, meaning;
    std::vector<std::string> values;
  };
  std::vector<TextColumn> columns;

  void write(GrowingTable& table) const {
    for (const TextColumn& column : columns) {
      std::size_t width = 1;
      for (const std::string& value : column.values) width = std::max(width, value.size());
      table.add_text(column.name, column.meaning, width);
    }
    for (std::size_t row = 0; row < columns.front().values.size(); ++row) {
      for (const TextColumn& column : columns) table.put(column.values[row]);
      table.end_row();
    }
    table.finish();
  }
};

void add_root(Hdf5Writer& file, const Batch& batch) {
  add_program(file, "gurney-study", kStudyFormatVersion);
  const auto text = [&](const char* name, const std::string& value) {
    file.set_attribute("/", name, value);
  };
  text("job_name", std::filesystem::path(batch.job.file()).stem().string());
  text("job_text", batch.job.text());
  text("job_sha256", sha256(batch.job.text()));
  text("title", batch.job.job(0, {}).title);
  text("seed", std::to_string(batch.job.study().seed));
  const IntensityPlan& intensity = batch.job.study().intensity;
  const bool by_measure = intensity.kind != IntensityPlan::Kind::kScales;
  text("intensity_measure",
       by_measure ? name_of(intensity.measure) + " " + name_of(intensity.combination) : "");
  text("intensity_units", by_measure ? groundmotions::si_unit_of(intensity.measure) : "1");
}

void add_configurations(Hdf5Writer& file, const Batch& batch) {
  const std::vector<Factor>& factors = batch.job.study().factors;
  TextTable texts;
  texts.columns.push_back({"name", "levels of all factors", {}});
  for (const Factor& factor : factors)
    texts.columns.push_back({factor.name, "level of this factor", {}});
  for (const Configuration& each : batch.job.configurations()) {
    texts.columns[0].values.push_back(fmt::format("{}", fmt::join(each.levels, ", ")));
    for (std::size_t i = 0; i < factors.size(); ++i)
      texts.columns[i + 1].values.push_back(each.levels[i]);
  }
  GrowingTable table(file, "configurations");
  texts.write(table);
}

void add_records(Hdf5Writer& file, const Batch& batch) {
  std::vector<std::string> sets, names, files, processing, warnings, distances;
  for (std::size_t set = 0; set < batch.motions.sets(); ++set)
    for (std::size_t i = 0; i < batch.motions.set(set).size(); ++i) {
      const GroundMotion& motion = batch.motions.set(set).ground(i);
      sets.push_back(std::to_string(set));
      names.push_back(batch.motions.set(set).name(i));
      files.push_back(motion.files);
      processing.push_back(fmt::format("{}", fmt::join(motion.processing, "\n")));
      warnings.push_back(fmt::format("{}", fmt::join(motion.warnings, "\n")));
      distances.push_back(motion.source.distance_kind);
    }
  GrowingTable table(file, "records");
  TextTable{{{"set", "set of ground motions", sets},
             {"name", "name of the record; empty: the floor is at rest", names},
             {"files", "SHA-256 and name of each of its files", files},
             {"processing", "what was done to it, step by step", processing},
             {"warnings", "what its reading warned of", warnings},
             {"distance_kind",
              "kind of runs/distance: Rrup, Rjb, epicentral, not stated; empty: none", distances}}}
      .write(table);
}

void add_data_files(Hdf5Writer& file, const Batch& batch) {
  std::vector<std::string> names, hashes;
  for (const auto& [name, hash] : data_files(batch.job)) {
    names.push_back(name);
    hashes.push_back(hash);
  }
  GrowingTable table(file, "data_files");
  TextTable{{{"name", "of the catalogue, or relative to the job's folder", names},
             {"sha256", "SHA-256 of the file", hashes}}}
      .write(table);
}

/// Nothing unless the draws are those of a Saltelli design.
void add_design(Hdf5Writer& file, const Batch& batch) {
  const std::vector<std::string> inputs = batch.plan.inputs();
  if (inputs.empty()) return;
  GrowingTable table(file, "design");
  TextTable{{{"input", "input of the design, in the order of its matrices", inputs}}}.write(table);
}

void add_assumptions(Hdf5Writer& file, const Batch& batch) {
  std::vector<std::string> configurations, keys, values, ranges, drawn, reasons, files;
  for (const StatedAssumption& each : stated_assumptions(batch)) {
    const AssumptionFacts facts = facts_of(each.assumption);
    configurations.push_back(std::to_string(each.configuration));
    keys.push_back(facts.key);
    values.push_back(facts.value);
    ranges.push_back(facts.range);
    drawn.push_back(each.drawn ? "yes" : "no");
    reasons.push_back(facts.reason);
    files.push_back(facts.file);
  }
  GrowingTable table(file, "assumptions");
  TextTable{{{"configuration", "row of /configurations", configurations},
             {"key", "the number that has no source", keys},
             {"value", "its value where it is not drawn", values},
             {"range", "how far it may be off", ranges},
             {"drawn", "yes: drawn by the study; no: always its value", drawn},
             {"reason", "why this value", reasons},
             {"file", "data file that states it", files}}}
      .write(table);
}

}  // namespace

RunCounts write_study_file(const std::string& path, const Batch& batch,
                           const std::function<TaskResult(std::size_t)>& read,
                           const std::function<bool(std::size_t)>& has) {
  Hdf5Writer file(path);
  add_root(file, batch);
  add_configurations(file, batch);
  add_records(file, batch);
  add_data_files(file, batch);
  add_assumptions(file, batch);
  add_design(file, batch);
  RunCounts counts;
  RunTables tables(file, batch);
  for (std::size_t task = 0; task < batch.plan.tasks(); ++task) {
    if (has && !has(task)) continue;
    const TaskResult result = read(task);
    require(result.task == task,
            fmt::format("the results of analysis case {} stand where those of case {} must be",
                        result.task, task));
    counts.add(result);
    tables.add(result);
  }
  tables.finish();
  file.finish();
  return counts;
}

}  // namespace gurney::study
