#include "tests/studies/analysis/synthetic_runs.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "studies/results/columns.h"
#include "studies/results/growing_table.h"

namespace gurney::study {
namespace {

constexpr std::size_t kWidth = 60;

void add_texts(Hdf5Writer& file, const std::string& name,
               const std::map<std::string, std::vector<std::string>>& columns) {
  GrowingTable table(file, name);
  for (const auto& [column, values] : columns) table.add_text(column, column, kWidth);
  for (std::size_t row = 0; row < columns.begin()->second.size(); ++row) {
    for (const auto& [column, values] : columns) table.put(values[row]);
    table.end_row();
  }
  table.finish();
}

void add_half_steps(Hdf5Writer& file, const std::vector<SyntheticRun>& runs) {
  if (std::ranges::all_of(runs, [](const SyntheticRun& run) { return run.half_step < 0; })) return;
  GrowingTable table(file, "half_step");
  table.add_whole("run", "run");
  table.add_text("item", "item", 4);
  table.add(demand_columns());
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (runs[i].half_step < 0) continue;
    Demands demands;
    demands.peak_displacement = runs[i].half_step;
    table.put(double(i)).put("cart").put(demand_columns(), demands).end_row();
  }
  table.finish();
}

void add_points(Hdf5Writer& file, const std::string& name, const std::vector<SyntheticRun>& runs,
                std::optional<double> SyntheticRun::*acceleration) {
  const auto has = [&](const SyntheticRun& run) { return (run.*acceleration).has_value(); };
  if (std::ranges::none_of(runs, has)) return;
  GrowingTable table(file, name);
  table.add_whole("run", "run");
  table.add_text("item", "item", 4);
  table.add_text("point", "point", 4);
  table.add(point_demand_columns());
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (!has(runs[i])) continue;
    PointDemands demands;
    demands.peak_absolute_acceleration = *(runs[i].*acceleration);
    table.put(double(i)).put("cart").put("top").put(point_demand_columns(), demands).end_row();
  }
  table.finish();
}

void add_drawn(Hdf5Writer& file, const std::vector<SyntheticRun>& runs) {
  if (runs.empty() || runs.front().draw < 0) return;
  GrowingTable drawn(file, "drawn");
  drawn.add_whole("configuration", "configuration");
  drawn.add_whole("draw", "draw");
  drawn.add_text("variable", "variable", kWidth);
  drawn.add_number("value", "1", "value");
  std::set<std::pair<std::size_t, int>> written;
  for (const SyntheticRun& run : runs) {
    if (!written.insert({run.configuration, run.draw}).second) continue;
    for (const auto& [variable, value] : run.drawn)
      drawn.put(double(run.configuration)).put(double(run.draw)).put(variable).put(value).end_row();
  }
  drawn.finish();
}

}  // namespace

void SyntheticRuns::write(const std::string& path) const {
  Hdf5Writer file(path);
  for (const auto& [name, text] :
       std::map<std::string, std::string>{{"filetype", "gurney-study"},
                                          {"job_text", job},
                                          {"git_commit", commit},
                                          {"intensity_measure", measure},
                                          {"intensity_units", measure.empty() ? "1" : "m/s2"}})
    file.set_attribute("/", name, text);
  file.set_attribute("/", "format_version", std::int64_t{format_version});
  add_texts(file, "configurations", {{"name", configurations}, {"brakes", configurations}});
  std::map<std::string, std::vector<std::string>> of_records{
      {"set", std::vector<std::string>(records.size(), "0")},
      {"name", records},
      {"files", files.empty() ? records : files},
      {"processing", std::vector<std::string>(records.size())},
      {"warnings", std::vector<std::string>(records.size())}};
  if (!scales.empty()) of_records.emplace("scale", scales);
  add_texts(file, "records", of_records);
  add_texts(file, "data_files", {{"name", {"casters/a.toml"}}, {"sha256", {caster_sha256}}});
  std::vector<std::string> numbers, keys, values;
  for (std::size_t i = 0; i < configurations.size(); ++i) {
    numbers.push_back(std::to_string(i));
    keys.push_back("torque");
    values.push_back(configurations[i] == "true" ? "10 N m" : "0 N m");
  }
  add_texts(file, "assumptions",
            {{"configuration", numbers},
             {"key", keys},
             {"value", values},
             {"range", keys},
             {"drawn", std::vector<std::string>(keys.size(), "yes")},
             {"reason", keys},
             {"file", keys}});
  GrowingTable failures(file, "failures");
  failures.add_whole("run", "run");
  failures.add_text("cause", "cause", kWidth);
  failures.finish();

  if (!design.empty()) add_texts(file, "design", {{"input", design}});
  GrowingTable motions(file, "motions"), table(file, "runs"), items(file, "items");
  motions.add_whole("set", "set");
  motions.put(0.0).end_row();
  for (const char* name :
       {"run", "analysis_case", "configuration", "record", "motion", "draw", "replica"})
    table.add_whole(name, name);
  for (const char* name : {"angle", "scale", "intensity", "pfa", "pfv", "energy_closure"})
    table.add_number(name, "1", name);
  const bool magnitudes =
      std::ranges::any_of(runs, [](const SyntheticRun& run) { return run.magnitude.has_value(); });
  if (magnitudes) table.add_number("magnitude", "1", "magnitude");
  table.add_text("outcome", "outcome", 10);
  items.add_whole("run", "run");
  items.add_text("item", "item", 4);
  items.add(demand_columns());
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const SyntheticRun& run = runs[i];
    table.put(double(i))
        .put(double(run.record))
        .put(double(run.configuration))
        .put(double(run.record))
        .put(0.0);
    table.put(double(run.draw))
        .put(double(run.replica))
        .put(run.angle)
        .put(run.level)
        .put(run.level)
        .put(run.level);
    table.put(run.pfv).put(1e-6);
    if (magnitudes) table.put(run.magnitude.value_or(std::nan("")));
    table.put(std::string(run.failed ? "diverged" : run.fell ? "overturned" : "rested")).end_row();
    if (run.failed) continue;
    Demands demands;
    demands.peak_displacement = run.displacement;
    if (run.fell) demands.time_of_overturning = 1;
    items.put(double(i)).put("cart").put(demand_columns(), demands).end_row();
  }
  for (GrowingTable* each : {&motions, &table, &items}) each->finish();
  add_drawn(file, runs);
  add_half_steps(file, runs);
  add_points(file, "points", runs, &SyntheticRun::acceleration);
  add_points(file, "half_step_points", runs, &SyntheticRun::half_step_acceleration);
  file.finish();
}

SyntheticRuns study_of_records(std::size_t records, const std::vector<SyntheticRun>& runs) {
  SyntheticRuns study{.job = synthetic_job(), .records = {}, .files = {}, .runs = runs};
  for (std::size_t i = 0; i < records; ++i) study.records.push_back("r" + std::to_string(i));
  return study;
}

std::string synthetic_job(const std::string& in_study, const std::string& after) {
  return "schema = \"gurney-job/1\"\n[item]\nequipment = \"cart\"\n[study]\nmeasures = \"PGV "
         "h1\"\n" +
         in_study +
         "[study.intensity]\nmeasure = \"PGA\"\ncomponent = \"h1\"\nunit = \"m/s2\"\nlevels = [1, "
         "2]\n"
         "[[study.limit_state]]\nname = \"moved\"\ndemand = \"peak_displacement\"\nabove = 0.1\n"
         "[[study.limit_state]]\nname = \"fell\"\nevent = \"overturned\"\n" +
         after;
}

}  // namespace gurney::study
