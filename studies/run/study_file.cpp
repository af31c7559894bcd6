#include "studies/run/study_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "engine/base/error.h"
#include "engine/base/hash/sha256.h"
#include "engine/base/names.h"
#include "studies/plan/study_job.h"
#include "studies/prepare/run_job.h"
#include "studies/results/growing_table.h"
#include "studies/results/names.h"
#include "studies/results/results_file.h"
#include "studies/results/study_reader.h"
#include "studies/run/declared_ranges.h"
#include "studies/run/run_task.h"
#include "studies/run/study_identity.h"

namespace gurney::study {
namespace {

/// Names of the parts of a configuration's runs.
struct ConfigurationNames {
  std::vector<std::string> items, zones, tethers, shapes;
  std::vector<std::vector<std::string>> wheels, points;  ///< of each item
  std::vector<std::string> variables;                    ///< that are drawn
};

std::vector<ConfigurationNames> names_of(const Batch& batch) {
  std::vector<ConfigurationNames> all;
  for (std::size_t i = 0; i < batch.job.configurations().size(); ++i) {
    const Scene scene = batch.job.job(i, {}).scene;
    ConfigurationNames& names = all.emplace_back();
    names.items = item_names(scene);
    names.zones = gurney::names_of(scene.zones);
    names.tethers = gurney::names_of(scene.tethers);
    names.shapes = gurney::names_of(scene.room);
    for (const PlacedItem& item : scene.items) {
      names.wheels.push_back(caster_names(item.model));
      names.points.push_back(point_names(item.model));
    }
    for (const equipment::Assumption& each : first_job(batch, i).job.assumptions)
      if (!each.distribution.empty()) names.variables.push_back(each.key);
  }
  return all;
}

/// The longest of some names of all configurations, at least 1.
template <class Names>
std::size_t widest(const std::vector<ConfigurationNames>& all, Names ConfigurationNames::*member) {
  std::size_t width = 1;
  const auto widen = [&](const std::string& name) { width = std::max(width, name.size()); };
  for (const ConfigurationNames& names : all)
    for (const auto& each : names.*member)
      if constexpr (std::is_same_v<Names, std::vector<std::string>>)
        widen(each);
      else
        std::ranges::for_each(each, widen);
  return width;
}

/// A row of /runs.
struct RunRow {
  long analysis_case, configuration, record, motion;
  double angle;
  long draw, replica;
  const StudyRun& run;
  const groundmotions::SourceFacts& source;
};

constexpr TableColumn<RunRow> kRunsColumns[] = {
    {"analysis_case", "1", "index of the analysis case, whose runs follow each other",
     &RunRow::analysis_case},
    {"configuration", "1", "row of /configurations", &RunRow::configuration},
    {"record", "1", "index of the record in its set", &RunRow::record},
    {"motion", "1", "row of /motions", &RunRow::motion},
    {"angle", "rad", "angle of the record's axes from the floor's", &RunRow::angle},
    {"draw", "1", "which draw of the uncertain parameters; -1: all have their values",
     &RunRow::draw},
    {"replica", "1",
     "which replica of its draw: the masses of all but 0 are times a factor within 1 +- 1e-6",
     &RunRow::replica},
    {"scale", "1", "factor on the ground motion", [](const RunRow& r) { return r.run.scale; }},
    {"intensity", "1", "the study's intensity measure, in its SI unit; 0: none",
     [](const RunRow& r) { return r.run.intensity; }},
    {"pfa", "m/s2", "largest horizontal acceleration of the floor",
     [](const RunRow& r) { return r.run.pfa; }},
    {"pfv", "m/s", "largest horizontal velocity of the floor",
     [](const RunRow& r) { return r.run.pfv; }},
    {"magnitude", "1", "of the earthquake, as the source of the record states it; NaN: it does not",
     [](const RunRow& r) { return r.source.magnitude; }},
    {"distance", "m", "of the site, of the kind in /records; NaN: not stated",
     [](const RunRow& r) { return r.source.distance; }},
    {"vs30", "m/s", "mean shear-wave velocity of the uppermost 30 m; NaN: not stated",
     [](const RunRow& r) { return r.source.vs30; }},
    {"end_time", "s", "end of the run", [](const RunRow& r) { return r.run.response.end_time; }},
    {"energy_closure", "1", "largest energy balance error over the energy in play",
     [](const RunRow& r) { return r.run.response.quality.energy_closure; }},
};

struct MotionRow {
  long set, record;
  double scale;
};

constexpr TableColumn<MotionRow> kMotionsColumns[] = {
    {"set", "1", "set of ground motions: configurations that shake alike share one",
     &MotionRow::set},
    {"record", "1", "index of the record in its set", &MotionRow::record},
    {"scale", "1", "factor on the record", &MotionRow::scale},
};

struct DrawnRow {
  long configuration, draw;
  double value;
};

constexpr TableColumn<DrawnRow> kDrawnColumns[] = {
    {"configuration", "1", "row of /configurations", &DrawnRow::configuration},
    {"draw", "1", "which draw", &DrawnRow::draw},
    {"value", "1", "its value, in the unit at the end of its name", &DrawnRow::value},
};

constexpr std::span<const TableColumn<RunRow>> kRuns = kRunsColumns;
constexpr std::span<const TableColumn<MotionRow>> kMotions = kMotionsColumns;
constexpr std::span<const TableColumn<DrawnRow>> kDrawn = kDrawnColumns;

struct SampleVector {
  const char *name, *units, *meaning;
  Vector3 Sample::*value;
};

/// Columns of /histories before those of sample_columns(): x, y and z of each.
constexpr SampleVector kSampleVectors[] = {
    {"displacement", "m", "displacement relative to the floor since the start",
     &Sample::displacement},
    {"velocity", "m/s", "velocity relative to the floor", &Sample::velocity},
    {"acceleration", "m/s2", "acceleration relative to the floor", &Sample::acceleration}};

void add_axes(GrowingTable& table, const std::string& name, const std::string& units,
              const std::string& meaning) {
  for (const char* axis : {"x", "y", "z"})
    table.add_number(name + "_" + axis, units, std::string(axis) + " of the " + meaning);
}

void put(GrowingTable& table, const Vector3& v) { table.put(v.x()).put(v.y()).put(v.z()); }

/// A column of texts that says what a row is of.
struct Label {
  const char *name, *meaning;
  std::size_t width;
};

std::string kept_name(const KeptMeasure& kept) {
  return name_of(kept.measure) + " " + name_of(kept.combination);
}

constexpr std::size_t kLongestOutcome = 12, kLongestCause = 512;

/// The first kLongestCause bytes of a text, less a character of UTF-8 that they would cut.
std::string shortened(const std::string& text) {
  std::size_t end = std::min(text.size(), kLongestCause);
  while (end < text.size() && (text[end] & 0xC0) == 0x80) --end;
  return text.substr(0, end);
}

/// The tables of a study's file that have rows for each run: in each the run, labels, and the
/// columns of one or several structs.
class RunTables {
 public:
  RunTables(Hdf5Writer& file, const Batch& batch);

  void add(const TaskResult& result);
  void finish() {
    for (auto& [name, table] : tables_) table->finish();
  }

 private:
  using Labels = std::vector<std::string>;

  void add_run(const TaskResult& result, const Task& task, const StudyRun& run);
  void add_items(const StudyRun& run, const ConfigurationNames& names);
  void add_events(const Response& response, const ConfigurationNames& names);
  void add_histories(const Response& response, const ConfigurationNames& names);
  long motion_of(const Task& task, double scale);

  template <class... Row>
  GrowingTable& define(const std::string& name, const std::vector<Label>& labels,
                       std::span<const TableColumn<Row>>... columns) {
    GrowingTable& made = *(tables_[name] = std::make_unique<GrowingTable>(file_, name));
    if (name != "motions" && name != "drawn") made.add_whole("run", "index of the run");
    for (const Label& label : labels) made.add_text(label.name, label.meaning, label.width);
    (made.add(columns), ...);
    return made;
  }

  /// Begins a row of a table; null: the study does not keep it.
  GrowingTable* begin(const std::string& name, const Labels& labels) {
    const auto found = tables_.find(name);
    if (found == tables_.end()) return nullptr;
    found->second->put(static_cast<double>(runs_));
    for (const std::string& label : labels) found->second->put(label);
    return found->second.get();
  }

  template <class Row>
  void row(const std::string& name, const Labels& labels, std::span<const TableColumn<Row>> columns,
           const Row& values) {
    if (GrowingTable* const table = begin(name, labels)) table->put(columns, values).end_row();
  }

  Hdf5Writer& file_;
  const Batch& batch_;
  std::vector<ConfigurationNames> names_;
  std::map<std::string, std::unique_ptr<GrowingTable>> tables_;
  std::map<std::tuple<std::size_t, std::size_t, double>, long> motions_;
  std::int64_t runs_ = 0;
};

RunTables::RunTables(Hdf5Writer& file, const Batch& batch)
    : file_(file), batch_(batch), names_(names_of(batch)) {
  const Study& study = batch.job.study();
  const OutputOptions& keep = study.keep;
  const Label item{"item", "name of the item", widest(names_, &ConfigurationNames::items)};
  const Label wheel{"wheel", "name of the caster", widest(names_, &ConfigurationNames::wheels)};
  const Label point{"point", "name of the marked point",
                    widest(names_, &ConfigurationNames::points)};
  define("runs", {{"outcome", "how the run ended", kLongestOutcome}}, kRuns);
  GrowingTable& motions = define("motions", {}, kMotions);
  for (const KeptMeasure& kept : study.measures)
    motions.add_number(kept_name(kept), groundmotions::si_unit_of(kept.measure),
                       groundmotions::definition_of(kept.measure));
  define("items", {item}, demand_columns());
  define("points", {item, point}, point_demand_columns());
  if (keep.wheels) define("wheels", {item, wheel}, wheel_demand_columns());
  if (keep.energy) define("energy", {item}, energy_columns());
  const std::size_t body = std::max(wheel.width, std::string_view("chassis").size());
  if (keep.events)
    define("events",
           {item,
            {"body", "its part: chassis, or the name of a caster", body},
            {"other", "what it hit: floor, or the name of a shape of the room or of an item",
             std::max({std::string_view("floor").size(), item.width,
                       widest(names_, &ConfigurationNames::shapes)})},
            {"other_body", "part of the other item; empty: it hit no item", body}},
           impact_columns());
  if (keep.zones)
    define("zones", {{"zone", "name of the zone", widest(names_, &ConfigurationNames::zones)}},
           zone_columns());
  if (keep.tethers)
    define("tethers",
           {{"tether", "name of the tether", widest(names_, &ConfigurationNames::tethers)}},
           tether_columns());
  if (keep.histories != Histories::kNone) {
    GrowingTable& histories = define("histories", {item});
    histories.add_number("time", "s", "time");
    for (const SampleVector& each : kSampleVectors)
      add_axes(histories, each.name, each.units, each.meaning);
    histories.add(sample_columns());
    if (keep.energy) histories.add(energy_columns());
    GrowingTable& point_histories = define("point_histories", {item, point});
    point_histories.add_number("time", "s", "time");
    add_axes(point_histories, "absolute_acceleration", "m/s2",
             "absolute acceleration of the point, without gravity, as an accelerometer has it");
  }
  if (study.step_check > 0) {
    define("half_step", {item}, demand_columns());
    define("half_step_points", {item, point}, point_demand_columns());
  }
  if (study.draws > 0)
    define("drawn",
           {{"variable", "the parameter that was drawn",
             widest(names_, &ConfigurationNames::variables)}},
           kDrawn);
  define("failures", {{"cause", "why the run failed", kLongestCause}});
  define("warnings", {{"warning",
                       "what is to be known of the run: of the building under this motion, of the "
                       "repetition with half "
                       "the step, of an item whose run ends where it overturned",
                       kLongestCause}});
}

void RunTables::add(const TaskResult& result) {
  const Task task = batch_.plan.task(result.task);
  const auto draw = batch_.plan.draw(task);
  if (draw && task.angle == 0 && task.replica == 0) {
    const std::vector<std::string>& variables = names_[task.configuration].variables;
    for (std::size_t i = 0; i < std::min(variables.size(), result.drawn.size()); ++i)
      tables_.at("drawn")
          ->put(variables[i])
          .put(kDrawn, DrawnRow{static_cast<long>(task.configuration),
                                static_cast<long>(draw->run()), result.drawn[i]})
          .end_row();
  }
  for (const StudyRun& run : result.runs) add_run(result, task, run);
}

long RunTables::motion_of(const Task& task, double scale) {
  const std::size_t set = batch_.motions.index_of(task.configuration);
  GrowingTable& motions = *tables_.at("motions");
  const auto [place, fresh] =
      motions_.try_emplace({set, task.record, scale}, static_cast<long>(motions.rows()));
  if (!fresh) return place->second;
  motions.put(kMotions, MotionRow{static_cast<long>(set), static_cast<long>(task.record), scale});
  const std::vector<KeptMeasure>& kept = batch_.job.study().measures;
  const std::vector<double>& values = batch_.motions.set(set).ground(task.record).measures;
  for (std::size_t i = 0; i < kept.size(); ++i)
    motions.put(values[i] * std::pow(scale, groundmotions::scaling_power(kept[i].measure)));
  motions.end_row();
  return place->second;
}

void RunTables::add_run(const TaskResult& result, const Task& task, const StudyRun& run) {
  const auto draw = batch_.plan.draw(task);
  row("runs", {name_of(run.response.outcome)}, kRuns,
      RunRow{static_cast<long>(result.task), static_cast<long>(task.configuration),
             static_cast<long>(task.record), motion_of(task, run.scale),
             batch_.job.study().angles[task.angle], draw ? static_cast<long>(draw->run()) : -1,
             static_cast<long>(task.replica), run,
             batch_.motions.set_of(task.configuration).ground(task.record).source});
  for (const std::string& warning : run.warnings)
    begin("warnings", {shortened(warning)})->end_row();
  const ConfigurationNames& names = names_[task.configuration];
  if (is_failure(run.response.outcome)) {
    begin("failures", {shortened(run.response.cause)})->end_row();
  } else {
    if (!run.response.cause.empty()) begin("warnings", {shortened(run.response.cause)})->end_row();
    add_items(run, names);
    add_events(run.response, names);
  }
  add_histories(run.response, names);
  ++runs_;
}

void RunTables::add_items(const StudyRun& run, const ConfigurationNames& names) {
  const auto add_demands = [&](const std::string& items, const std::string& points, std::size_t i,
                               const Demands& demands) {
    row(items, {names.items[i]}, demand_columns(), demands);
    for (std::size_t k = 0; k < demands.points.size(); ++k)
      row(points, {names.items[i], names.points[i][k]}, point_demand_columns(), demands.points[k]);
  };
  for (std::size_t i = 0; i < run.response.items.size(); ++i) {
    const ItemResponse& item = run.response.items[i];
    add_demands("items", "points", i, item.demands);
    row("energy", {names.items[i]}, energy_columns(), item.energy);
    for (std::size_t k = 0; k < item.demands.wheels.size(); ++k)
      row("wheels", {names.items[i], names.wheels[i][k]}, wheel_demand_columns(),
          item.demands.wheels[k]);
  }
  for (std::size_t i = 0; i < run.at_half_step.size(); ++i)
    add_demands("half_step", "half_step_points", i, run.at_half_step[i]);
}

void RunTables::add_events(const Response& response, const ConfigurationNames& names) {
  for (const Impact& impact : response.impacts)
    row("events", {names.items[impact.item], impact.body, impact.other, impact.other_body},
        impact_columns(), impact);
  for (std::size_t i = 0; i < response.zones.size(); ++i)
    row("zones", {names.zones[i]}, zone_columns(), response.zones[i]);
  for (std::size_t i = 0; i < response.tethers.size(); ++i)
    row("tethers", {names.tethers[i]}, tether_columns(), response.tethers[i]);
}

void RunTables::add_histories(const Response& response, const ConfigurationNames& names) {
  for (std::size_t i = 0; i < response.items.size(); ++i)
    for (const Sample& sample : response.items[i].history) {
      GrowingTable* const histories = begin("histories", {names.items.at(i)});
      if (histories == nullptr) return;
      histories->put(sample.time);
      for (const SampleVector& each : kSampleVectors) put(*histories, sample.*each.value);
      histories->put(sample_columns(), sample);
      if (batch_.job.study().keep.energy) histories->put(energy_columns(), sample.energy);
      histories->end_row();
      for (std::size_t k = 0; k < sample.points.size(); ++k) {
        GrowingTable& points =
            *begin("point_histories", {names.items.at(i), names.points.at(i).at(k)});
        put(points.put(sample.time), sample.points[k].absolute_acceleration);
        points.end_row();
      }
    }
}

/// A column of a table of texts, which are all known before the first is written.
template <class Row>
struct TextColumn {
  std::string name, meaning;
  std::function<std::string(const Row&)> text;
};

template <class Row>
void add_texts(Hdf5Writer& file, const std::string& name, const std::vector<Row>& rows,
               const std::vector<TextColumn<Row>>& columns) {
  GrowingTable table(file, name);
  for (const TextColumn<Row>& column : columns) {
    std::size_t width = 1;
    for (const Row& row : rows) width = std::max(width, column.text(row).size());
    table.add_text(column.name, column.meaning, width);
  }
  for (const Row& row : rows) {
    for (const TextColumn<Row>& column : columns) table.put(column.text(row));
    table.end_row();
  }
  table.finish();
}

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
  std::vector<TextColumn<Configuration>> columns{
      {"name", "levels of all factors",
       [](const auto& each) { return fmt::format("{}", fmt::join(each.levels, ", ")); }}};
  const std::vector<Factor>& factors = batch.job.study().factors;
  for (std::size_t i = 0; i < factors.size(); ++i)
    columns.push_back({factors[i].name, "level of this factor",
                       [i](const Configuration& each) { return each.levels[i]; }});
  add_texts(file, "configurations", batch.job.configurations(), columns);
}

void add_records(Hdf5Writer& file, const Batch& batch) {
  struct RecordRow {
    std::size_t set;
    std::string name;
    double scale;
    const GroundMotion* motion;
  };
  std::vector<RecordRow> rows;
  for (std::size_t set = 0; set < batch.motions.sets(); ++set) {
    const MotionSet& of_set = batch.motions.set(set);
    for (std::size_t i = 0; i < of_set.size(); ++i)
      rows.push_back({set, of_set.name(i), of_set.stated_scale(i), &of_set.ground(i)});
  }
  const auto lines = [](const std::vector<std::string>& list) {
    return fmt::format("{}", fmt::join(list, "\n"));
  };
  add_texts<RecordRow>(
      file, "records", rows,
      {{"set", "set of ground motions", [](auto& r) { return std::to_string(r.set); }},
       {"name", "name of the record; empty: the floor is at rest", &RecordRow::name},
       {"files", "SHA-256 and name of each of its files", [](auto& r) { return r.motion->files; }},
       {"scale", "factor that the job or its list states; that of runs is on the product",
        [](auto& r) { return fmt::format("{}", r.scale); }},
       {"processing", "what was done to it, step by step",
        [&](auto& r) { return lines(r.motion->processing); }},
       {"warnings", "what its reading warned of",
        [&](auto& r) { return lines(r.motion->warnings); }},
       {"distance_kind", "kind of runs/distance: Rrup, Rjb, epicentral, not stated; empty: none",
        [](auto& r) { return r.motion->source.distance_kind; }}});
}

void add_data_files(Hdf5Writer& file, const Batch& batch) {
  using File = std::pair<std::string, std::string>;
  const std::map<std::string, std::string> files = data_files(batch.job);
  add_texts<File>(file, "data_files", {files.begin(), files.end()},
                  {{"name", "of the catalogue, or relative to the job's folder", &File::first},
                   {"sha256", "SHA-256 of the file", &File::second}});
}

/// Nothing unless the draws are those of a Saltelli design.
void add_design(Hdf5Writer& file, const Batch& batch) {
  const std::vector<std::string> inputs = batch.plan.inputs();
  if (!inputs.empty())
    add_texts<std::string>(
        file, "design", inputs,
        {{"input", "input of the design, in the order of its matrices", std::identity()}});
}

void add_assumptions(Hdf5Writer& file, const Batch& batch) {
  struct AssumptionRow {
    AssumptionFacts facts;
    std::size_t configuration;
    bool drawn;
  };
  std::vector<AssumptionRow> rows;
  for (const StatedAssumption& each : stated_assumptions(batch))
    rows.push_back({facts_of(each.assumption), each.configuration, each.drawn});
  add_texts<AssumptionRow>(
      file, "assumptions", rows,
      {{"configuration", "row of /configurations",
        [](auto& r) { return std::to_string(r.configuration); }},
       {"key", "the number that has no source", [](auto& r) { return r.facts.key; }},
       {"value", "its value where it is not drawn", [](auto& r) { return r.facts.value; }},
       {"range", "how far it may be off", [](auto& r) { return r.facts.range; }},
       {"drawn", "yes: drawn by the study; no: always its value",
        [](auto& r) { return r.drawn ? "yes" : "no"; }},
       {"reason", "why this value", [](auto& r) { return r.facts.reason; }},
       {"file", "data file that states it", [](auto& r) { return r.facts.file; }}});
}

std::string inputs_in(const StudyReader& file) {
  std::string lines;
  const auto sets = file.strings("records/set"), records = file.strings("records/name"),
             of_record = file.strings("records/files");
  for (std::size_t row = 0; row < records.size(); ++row)
    lines += record_line(sets.at(row), records[row], of_record.at(row));
  const auto names = file.strings("data_files/name"), hashes = file.strings("data_files/sha256");
  for (std::size_t row = 0; row < names.size(); ++row)
    lines += data_file_line(names[row], hashes.at(row));
  return inputs_from(lines, file.job_text());
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

std::string difference_to_results(const std::string& path, const Batch& batch) {
  const std::string theirs = inputs_in(StudyReader(path)), ours = inputs_of(batch);
  return theirs == ours ? std::string() : difference(theirs, ours);
}

}  // namespace gurney::study
