#include "studies/run/run_tables.h"

#include <algorithm>
#include <cmath>

#include "engine/base/error.h"
#include "studies/results/names.h"

namespace gurney::study {
namespace {

std::size_t width(std::size_t least, const std::vector<std::string>& names) {
  for (const std::string& name : names) least = std::max(least, name.size());
  return least;
}

template <class Take>
std::size_t widest(const std::vector<ConfigurationNames>& all, Take take) {
  std::size_t result = 1;
  for (const ConfigurationNames& names : all) result = width(result, take(names));
  return result;
}

std::vector<std::string> flat(const std::vector<std::vector<std::string>>& lists) {
  std::vector<std::string> all;
  for (const auto& list : lists) all.insert(all.end(), list.begin(), list.end());
  return all;
}

template <class Named>
std::vector<std::string> names_in(const std::vector<Named>& list) {
  std::vector<std::string> names;
  for (const Named& each : list) names.push_back(each.name);
  return names;
}

std::string kept_name(const KeptMeasure& kept) {
  return name_of(kept.measure) + " " + name_of(kept.combination);
}

void add_axes(GrowingTable& table, const std::string& name, const std::string& units,
              const std::string& meaning) {
  for (const char* axis : {"x", "y", "z"})
    table.add_number(name + "_" + axis, units, std::string(axis) + " of the " + meaning);
}

void put(GrowingTable& table, const Vector3& v) { table.put(v.x()).put(v.y()).put(v.z()); }

constexpr std::size_t kLongestOutcome = 12, kLongestCause = 512;

/// Names of the numbers that are drawn, from the first draw that makes a job; none does: empty.
std::vector<std::string> variables_of(const Batch& batch, std::size_t configuration) {
  if (batch.job.study().draws == 0) return {};
  for (std::size_t draw = 0; draw < batch.plan.draws(configuration); ++draw) {
    const Task task{.configuration = configuration, .draw = draw};
    try {
      std::vector<std::string> names;
      for (const equipment::Assumption& each :
           batch.job.job(configuration, batch.plan.draw(task)).assumptions)
        if (!each.distribution.empty()) names.push_back(each.key);
      return names;
    } catch (const Error&) {
      continue;
    }
  }
  return {};
}

}  // namespace

std::vector<ConfigurationNames> names_of(const Batch& batch) {
  std::vector<ConfigurationNames> all;
  for (std::size_t i = 0; i < batch.job.configurations().size(); ++i) {
    const Job job = batch.job.job(i, {});
    ConfigurationNames names{item_names(job.scene),
                             names_in(job.scene.zones),
                             names_in(job.scene.tethers),
                             names_in(job.scene.room),
                             {},
                             {},
                             {}};
    for (const PlacedItem& item : job.scene.items) {
      names.wheels.push_back(caster_names(item.model));
      names.points.push_back(point_names(item.model));
    }
    names.variables = variables_of(batch, i);
    all.push_back(std::move(names));
  }
  return all;
}

GrowingTable& RunTables::make(const std::string& name) {
  GrowingTable& made = *(tables_[name] = std::make_unique<GrowingTable>(file_, name));
  if (name != "motions" && name != "drawn") made.add_whole("run", "index of the run");
  return made;
}

RunTables::RunTables(Hdf5Writer& file, const Batch& batch)
    : file_(file), batch_(batch), names_(names_of(batch)) {
  const Study& study = batch.job.study();
  const OutputOptions& keep = study.keep;
  const std::size_t item = widest(names_, [](auto& n) { return n.items; });
  const std::size_t wheel = widest(names_, [](auto& n) { return flat(n.wheels); });
  const std::size_t point = widest(names_, [](auto& n) { return flat(n.points); });
  const std::size_t other =
      std::max<std::size_t>(5, widest(names_, [](auto& n) { return n.shapes; }));
  const auto item_table = [&](const std::string& name) -> GrowingTable& {
    GrowingTable& table = make(name);
    table.add_text("item", "name of the item", item);
    return table;
  };

  GrowingTable& runs = make("runs");
  runs.add_whole("analysis_case", "index of the analysis case, whose runs follow each other");
  runs.add_whole("configuration", "row of /configurations");
  runs.add_whole("record", "index of the record in its set");
  runs.add_whole("motion", "row of /motions");
  runs.add_number("angle", "rad", "angle of the record's axes from the floor's");
  runs.add_whole("draw", "which draw of the uncertain parameters; -1: all have their values");
  runs.add_whole(
      "replica",
      "which replica of its draw: the masses of all but 0 are times a factor within 1 +- 1e-6");
  runs.add_number("scale", "1", "factor on the ground motion");
  runs.add_number("intensity", "1", "the study's intensity measure, in its SI unit; 0: none");
  runs.add_number("pfa", "m/s2", "largest horizontal acceleration of the floor");
  runs.add_number("pfv", "m/s", "largest horizontal velocity of the floor");
  runs.add_number("magnitude", "1",
                  "of the earthquake, as the source of the record states it; NaN: it does not");
  runs.add_number("distance", "m", "of the site, of the kind in /records; NaN: not stated");
  runs.add_number("vs30", "m/s", "mean shear-wave velocity of the uppermost 30 m; NaN: not stated");
  runs.add_text("outcome", "how the run ended", kLongestOutcome);
  runs.add_number("end_time", "s", "end of the run");
  runs.add_number("energy_closure", "1", "largest energy balance error over the energy in play");

  GrowingTable& motions = make("motions");
  motions.add_whole("set", "set of ground motions: configurations that shake alike share one");
  motions.add_whole("record", "index of the record in its set");
  motions.add_number("scale", "1", "factor on the record");
  for (const KeptMeasure& kept : study.measures)
    motions.add_number(kept_name(kept), groundmotions::si_unit_of(kept.measure),
                       groundmotions::definition_of(kept.measure));

  item_table("items").add(demand_columns());
  const auto point_table = [&](const std::string& name) {
    GrowingTable& points = item_table(name);
    points.add_text("point", "name of the marked point", point);
    points.add(point_demand_columns());
  };
  point_table("points");
  if (keep.wheels) {
    GrowingTable& wheels = item_table("wheels");
    wheels.add_text("wheel", "name of the caster", wheel);
    wheels.add(wheel_demand_columns());
  }
  if (keep.energy) item_table("energy").add(energy_columns());
  if (keep.events) {
    GrowingTable& events = item_table("events");
    events.add_text("body", "its part: chassis, or the name of a caster",
                    std::max<std::size_t>(wheel, 7));
    events.add_text("other", "what it hit: floor, or the name of a shape of the room or of an item",
                    std::max(other, item));
    events.add_text("other_body", "part of the other item; empty: it hit no item",
                    std::max<std::size_t>(wheel, 7));
    events.add(impact_columns());
  }
  if (keep.zones) {
    GrowingTable& zones = make("zones");
    zones.add_text("zone", "name of the zone", widest(names_, [](auto& n) { return n.zones; }));
    zones.add(zone_columns());
  }
  if (keep.tethers) {
    GrowingTable& tethers = make("tethers");
    tethers.add_text("tether", "name of the tether",
                     widest(names_, [](auto& n) { return n.tethers; }));
    tethers.add(tether_columns());
  }
  if (keep.histories != Histories::kNone) {
    GrowingTable& histories = item_table("histories");
    histories.add_number("time", "s", "time");
    add_axes(histories, "displacement", "m", "displacement relative to the floor since the start");
    add_axes(histories, "velocity", "m/s", "velocity relative to the floor");
    add_axes(histories, "acceleration", "m/s2", "acceleration relative to the floor");
    histories.add(sample_columns());
    if (keep.energy) histories.add(energy_columns());
    GrowingTable& point_histories = item_table("point_histories");
    point_histories.add_text("point", "name of the marked point", point);
    point_histories.add_number("time", "s", "time");
    add_axes(point_histories, "absolute_acceleration", "m/s2",
             "absolute acceleration of the point, without gravity, as an accelerometer has it");
  }
  if (study.step_check > 0) {
    item_table("half_step").add(demand_columns());
    point_table("half_step_points");
  }
  if (study.draws > 0) {
    GrowingTable& drawn = make("drawn");
    drawn.add_whole("configuration", "row of /configurations");
    drawn.add_whole("draw", "which draw");
    drawn.add_text("variable", "the parameter that was drawn",
                   widest(names_, [](auto& n) { return n.variables; }));
    drawn.add_number("value", "1", "its value, in the unit at the end of its name");
  }
  make("failures").add_text("cause", "why the run failed", kLongestCause);
  make("warnings")
      .add_text(
          "warning",
          "what the building under this motion, or the repetition with half the step, warned of",
          kLongestCause);
}

void RunTables::add(const TaskResult& result) {
  const Task task = batch_.plan.task(result.task);
  const auto draw = batch_.plan.draw(task);
  if (draw && task.angle == 0 && task.replica == 0) {
    const std::vector<std::string>& variables = names_[task.configuration].variables;
    for (std::size_t i = 0; i < std::min(variables.size(), result.drawn.size()); ++i) {
      table("drawn").put(double(task.configuration)).put(double(draw->run()));
      table("drawn").put(variables[i]).put(result.drawn[i]).end_row();
    }
  }
  for (const StudyRun& run : result.runs) add_run(result, task, run);
}

std::int64_t RunTables::motion_of(const Task& task, double scale) {
  const std::size_t set = batch_.motions.index_of(task.configuration);
  GrowingTable& motions = table("motions");
  const auto [place, fresh] = motions_.try_emplace({set, task.record, scale}, motions.rows());
  if (!fresh) return place->second;
  motions.put(double(set)).put(double(task.record)).put(scale);
  const std::vector<KeptMeasure>& kept = batch_.job.study().measures;
  const std::vector<double>& values = batch_.motions.set(set).ground(task.record).measures;
  for (std::size_t i = 0; i < kept.size(); ++i)
    motions.put(values[i] * std::pow(scale, groundmotions::scaling_power(kept[i].measure)));
  motions.end_row();
  return place->second;
}

void RunTables::add_run(const TaskResult& result, const Task& task, const StudyRun& run) {
  const auto draw = batch_.plan.draw(task);
  GrowingTable& runs = table("runs");
  runs.put(double(runs_)).put(double(result.task)).put(double(task.configuration));
  runs.put(double(task.record)).put(double(motion_of(task, run.scale)));
  runs.put(batch_.job.study().angles[task.angle]).put(draw ? double(draw->run()) : -1.0);
  runs.put(double(task.replica)).put(run.scale).put(run.intensity).put(run.pfa).put(run.pfv);
  const auto& source = batch_.motions.set_of(task.configuration).ground(task.record).source;
  runs.put(source.magnitude).put(source.distance).put(source.vs30);
  runs.put(std::string(name_of(run.response.outcome))).put(run.response.end_time);
  runs.put(run.response.quality.energy_closure).end_row();
  for (const std::string& warning : run.warnings)
    table("warnings").put(double(runs_)).put(warning.substr(0, kLongestCause)).end_row();
  const ConfigurationNames& names = names_[task.configuration];
  if (is_failure(run.response.outcome)) {
    table("failures").put(double(runs_)).put(run.response.cause.substr(0, kLongestCause)).end_row();
  } else {
    add_items(run, names);
    add_events(run, names);
  }
  if (tables_.contains("histories")) add_histories(run, names);
  ++runs_;
}

void RunTables::add_items(const StudyRun& run, const ConfigurationNames& names) {
  const auto row = [&](const std::string& name, const std::string& item) -> GrowingTable& {
    return table(name).put(double(runs_)).put(item);
  };
  for (std::size_t i = 0; i < run.response.items.size(); ++i) {
    const ItemResponse& item = run.response.items[i];
    row("items", names.items[i]).put(demand_columns(), item.demands).end_row();
    if (tables_.contains("energy"))
      row("energy", names.items[i]).put(energy_columns(), item.energy).end_row();
    add_points("points", i, item.demands, names);
    if (!tables_.contains("wheels")) continue;
    for (std::size_t k = 0; k < item.demands.wheels.size(); ++k)
      row("wheels", names.items[i])
          .put(names.wheels[i][k])
          .put(wheel_demand_columns(), item.demands.wheels[k])
          .end_row();
  }
  for (std::size_t i = 0; i < run.at_half_step.size(); ++i) {
    row("half_step", names.items[i]).put(demand_columns(), run.at_half_step[i]).end_row();
    add_points("half_step_points", i, run.at_half_step[i], names);
  }
}

void RunTables::add_points(const std::string& to, std::size_t item, const Demands& demands,
                           const ConfigurationNames& names) {
  for (std::size_t k = 0; k < demands.points.size(); ++k)
    table(to)
        .put(double(runs_))
        .put(names.items[item])
        .put(names.points[item][k])
        .put(point_demand_columns(), demands.points[k])
        .end_row();
}

void RunTables::add_events(const StudyRun& run, const ConfigurationNames& names) {
  const Response& response = run.response;
  if (tables_.contains("events"))
    for (const Impact& impact : response.impacts)
      table("events")
          .put(double(runs_))
          .put(names.items[impact.item])
          .put(impact.body)
          .put(impact.other)
          .put(impact.other_body)
          .put(impact_columns(), impact)
          .end_row();
  if (tables_.contains("zones"))
    for (std::size_t i = 0; i < response.zones.size(); ++i)
      table("zones")
          .put(double(runs_))
          .put(names.zones[i])
          .put(zone_columns(), response.zones[i])
          .end_row();
  if (tables_.contains("tethers"))
    for (std::size_t i = 0; i < response.tethers.size(); ++i)
      table("tethers")
          .put(double(runs_))
          .put(names.tethers[i])
          .put(tether_columns(), response.tethers[i])
          .end_row();
}

void RunTables::add_histories(const StudyRun& run, const ConfigurationNames& names) {
  GrowingTable& histories = table("histories");
  for (std::size_t i = 0; i < run.response.items.size(); ++i)
    for (const Sample& sample : run.response.items[i].history) {
      histories.put(double(runs_)).put(names.items.at(i)).put(sample.time);
      put(histories, sample.displacement);
      put(histories, sample.velocity);
      put(histories, sample.acceleration);
      histories.put(sample_columns(), sample);
      if (tables_.contains("energy")) histories.put(energy_columns(), sample.energy);
      histories.end_row();
      for (std::size_t k = 0; k < sample.points.size(); ++k) {
        GrowingTable& points = table("point_histories");
        points.put(double(runs_)).put(names.items.at(i)).put(names.points.at(i).at(k));
        put(points.put(sample.time), sample.points[k].absolute_acceleration);
        points.end_row();
      }
    }
}

void RunTables::finish() {
  for (auto& [name, table] : tables_) table->finish();
}

}  // namespace gurney::study
