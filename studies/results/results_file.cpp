#include "studies/results/results_file.h"

#include <span>
#include <vector>

#include "studies/build_info/build_info.h"
#include "studies/results/columns.h"
#include "studies/results/hdf5_file.h"

namespace gurney {
namespace {

using Scales = std::vector<std::string>;

const Scales kRun{"/runs/run"};

template <class Row>
void add_column(Hdf5Writer& file, const std::string& group, const Column<Row>& column,
                const Scales& scales, const std::vector<double>& values) {
  const Hdf5Spec spec{group + column.name, column.units, column.meaning, scales};
  if (column.whole) {
    const std::vector<std::int64_t> whole(values.begin(), values.end());
    file.add(spec, whole);
  } else {
    file.add(spec, values);
  }
  if (column.missing != 0) file.set_attribute(spec.path, "_FillValue", column.missing);
}

/// One dataset for each column, one value for each row.
template <class Row>
void add_columns(Hdf5Writer& file, const std::string& group, std::span<const Column<Row>> columns,
                 const Scales& scales, const std::vector<Row>& rows) {
  for (const Column<Row>& column : columns) {
    std::vector<double> values;
    for (const Row& row : rows) values.push_back(column.value(row));
    add_column(file, group, column, scales, values);
  }
}

std::vector<std::string> caster_names(const RunFacts& facts) {
  std::vector<std::string> names;
  for (const Caster& caster : facts.scene.items[0].model.casters) names.push_back(caster.name);
  return names;
}

std::vector<std::string> point_names(const RunFacts& facts) {
  std::vector<std::string> names;
  for (const MarkedPoint& point : facts.scene.items[0].model.marked_points)
    names.push_back(point.name);
  return names;
}

void add_root(Hdf5Writer& file, const RunFacts& facts) {
  const auto text = [&](const std::string& name, const std::string& value) {
    file.set_attribute("/", name, value);
  };
  const BuildInfo build = build_info();
  text("filetype", "gurney-results");
  file.set_attribute("/", "format_version", std::int64_t{kResultsFormatVersion});
  text("program_version", build.program_version);
  text("git_commit", build.git_commit);
  text("compiler", build.compiler);
  text("bullet_precision", build.bullet_precision);
  text("cpu_class", build.cpu_class);
  text("job_name", facts.job_name);
  text("job_text", facts.job_text);
  text("job_sha256", facts.job_sha256);
  text("title", facts.title);
  if (facts.seed) text("seed", std::to_string(*facts.seed));
  if (facts.draw) {
    text("draw_seed", std::to_string(facts.draw->seed()));
    text("draw", std::to_string(facts.draw->run()));
  }
  std::vector<std::string> names, hashes;
  if (facts.record)
    for (const FileFacts& record_file : facts.record->files) {
      names.push_back(record_file.name);
      hashes.push_back(record_file.sha256);
    }
  file.set_attribute("/", "record_files", names);
  file.set_attribute("/", "record_sha256", hashes);
  file.set_attribute("/", "record_components",
                     facts.record ? facts.record->components : std::vector<std::string>{});
  file.set_attribute("/", "record_processing",
                     facts.record ? facts.record->processing : std::vector<std::string>{});
  file.set_attribute("/", "warnings", facts.warnings);
}

void add_record(Hdf5Writer& file, const RecordFacts& record) {
  const auto per_axis = [&](const char* name, const char* units, const char* meaning,
                            const Vector3& value) {
    file.add({std::string("/runs/record_") + name, units, meaning, {"/runs/run", "/runs/axis"}},
             std::span<const double>(value.data(), 3));
  };
  per_axis("pga", "m/s2", "largest |floor acceleration|", record.pga);
  per_axis("pgv", "m/s", "largest |floor velocity|", record.pgv);
  per_axis("pgd", "m", "largest |floor displacement|", record.pgd);
  per_axis("residual_velocity", "m/s", "floor velocity left at the end of the record",
           record.residual_velocity);
  per_axis("residual_displacement", "m", "floor displacement left at the end of the record",
           record.residual_displacement);
}

void add_runs(Hdf5Writer& file, const RunFacts& facts, const Response& response) {
  const auto one_text = [&](const char* name, const char* meaning, const std::string& value) {
    file.add({std::string("/runs/") + name, "1", meaning, kRun}, std::vector<std::string>{value});
  };
  file.add_group("/runs");
  file.add_scale({"/runs/run", "1", "index of the run", {}}, std::vector<std::int64_t>{0});
  file.add_scale({"/runs/wheel", "1", "name of the caster", {}}, caster_names(facts));
  file.add_scale({"/runs/point", "1", "name of the marked point", {}}, point_names(facts));
  file.add_scale({"/runs/axis", "1", "floor axis", {}}, std::vector<std::string>{"x", "y", "z"});
  one_text("item", "name of the item", facts.scene.items[0].model.name);
  one_text("record", "name of the floor motion; empty: the floor is at rest",
           facts.record ? facts.record->name : "");
  one_text("outcome", "how the run ended: rested, still_moving, stopped, overturned or diverged",
           name_of(response.outcome));
  one_text("cause", "why the run diverged; empty: it did not", response.cause);
  file.add({"/runs/end_time", "s", "end of the run", kRun}, std::vector<double>{response.end_time});
  add_columns(file, "/runs/", demand_columns(), kRun,
              std::vector<Demands>{response.items[0].demands});
  add_columns(file, "/runs/", wheel_demand_columns(), {"/runs/run", "/runs/wheel"},
              response.items[0].demands.wheels);
  add_columns(file, "/runs/", point_demand_columns(), {"/runs/run", "/runs/point"},
              response.items[0].demands.points);
  add_record(file, facts.record.value_or(RecordFacts{}));
}

void add_verification(Hdf5Writer& file, const Response& response) {
  file.add_group("/verification");
  file.add_scale({"/verification/run", "1", "index of the run", {}}, std::vector<std::int64_t>{0});
  const Scales run{"/verification/run"};
  add_columns(file, "/verification/", quality_columns(), run,
              std::vector<Quality>{response.quality});
  file.add({"/verification/stored_energy_at_start", "J", "energy stored at the start", run},
           std::vector<double>{response.items[0].stored_energy_at_start});
  add_columns(file, "/verification/", energy_columns(), run,
              std::vector<EnergyAccount>{response.items[0].energy});
}

/// `get` gives a Vector3 for each sample.
template <class Get>
void add_vectors(Hdf5Writer& file, const Hdf5Spec& spec, const std::vector<Sample>& history,
                 Get get) {
  std::vector<double> values;
  for (const Sample& sample : history) {
    const Vector3 vector = get(sample);
    values.insert(values.end(), vector.data(), vector.data() + 3);
  }
  file.add(spec, values);
}

void add_body_histories(Hdf5Writer& file, const std::vector<Sample>& history) {
  const Scales scales{"/histories/time", "/histories/axis"};
  add_vectors(file,
              {"/histories/displacement", "m",
               "displacement of the item's origin relative to the floor since the start", scales},
              history, [](const Sample& s) { return s.displacement; });
  add_vectors(
      file,
      {"/histories/velocity", "m/s", "velocity of the item's origin relative to the floor", scales},
      history, [](const Sample& s) { return s.velocity; });
  add_vectors(file,
              {"/histories/acceleration", "m/s2",
               "acceleration of the item's origin relative to the floor", scales},
              history, [](const Sample& s) { return s.acceleration; });
  add_columns(file, "/histories/", sample_columns(), {"/histories/time"}, history);
  std::vector<EnergyAccount> energy;
  for (const Sample& sample : history) energy.push_back(sample.energy);
  add_columns(file, "/histories/", energy_columns(), {"/histories/time"}, energy);
}

void add_wheel_histories(Hdf5Writer& file, const std::vector<Sample>& history, std::size_t wheels) {
  const Scales scales{"/histories/time", "/histories/wheel"};
  std::vector<WheelSample> samples;
  std::vector<std::uint8_t> modes;
  for (const Sample& sample : history)
    for (std::size_t i = 0; i < wheels; ++i) {
      samples.push_back(sample.wheels[i]);
      modes.push_back(static_cast<std::uint8_t>(sample.wheels[i].mode));
    }
  add_columns(file, "/histories/", wheel_sample_columns(), scales, samples);
  file.add({"/histories/mode", "1", "what the wheel does, coded as flag_meanings says", scales},
           modes);
  std::vector<std::uint8_t> codes;
  std::string meanings;
  for (const WheelMode mode : {WheelMode::kSticks, WheelMode::kRolls, WheelMode::kSkids,
                               WheelMode::kBraked, WheelMode::kLifted}) {
    codes.push_back(static_cast<std::uint8_t>(mode));
    meanings += (meanings.empty() ? "" : " ") + std::string(name_of(mode));
  }
  file.set_attribute("/histories/mode", "flag_values", codes);
  file.set_attribute("/histories/mode", "flag_meanings", meanings);
}

void add_point_histories(Hdf5Writer& file, const std::vector<Sample>& history, std::size_t points) {
  const Scales scales{"/histories/time", "/histories/point", "/histories/axis"};
  const auto add = [&](const char* name, const char* units, const char* meaning, auto member) {
    std::vector<double> values;
    for (const Sample& sample : history)
      for (std::size_t i = 0; i < points; ++i) {
        const Vector3& vector = sample.points.at(i).*member;
        values.insert(values.end(), vector.data(), vector.data() + 3);
      }
    file.add({std::string("/histories/point_") + name, units, meaning, scales}, values);
  };
  add("displacement", "m", "displacement of the point relative to the floor since the start",
      &PointSample::displacement);
  add("velocity", "m/s", "velocity of the point relative to the floor", &PointSample::velocity);
  add("absolute_acceleration", "m/s2", "absolute acceleration of the point, without gravity",
      &PointSample::absolute_acceleration);
}

void add_histories(Hdf5Writer& file, const RunFacts& facts, const std::vector<Sample>& history) {
  std::vector<double> time;
  for (const Sample& sample : history) time.push_back(sample.time);
  file.add_group("/histories");
  file.add_scale({"/histories/run", "1", "index of the run", {}}, std::vector<std::int64_t>{0});
  file.add_scale({"/histories/time", "s", "time, one run after the other", {}}, time);
  file.add_scale({"/histories/wheel", "1", "name of the caster", {}}, caster_names(facts));
  file.add_scale({"/histories/point", "1", "name of the marked point", {}}, point_names(facts));
  file.add_scale({"/histories/axis", "1", "floor axis", {}},
                 std::vector<std::string>{"x", "y", "z"});
  file.add({"/histories/offset", "1", "first sample of the run", {"/histories/run"}},
           std::vector<std::int64_t>{0});
  file.add({"/histories/count", "1", "number of samples of the run", {"/histories/run"}},
           std::vector<std::int64_t>{static_cast<std::int64_t>(history.size())});
  add_body_histories(file, history);
  add_wheel_histories(file, history, facts.scene.items[0].model.casters.size());
  add_point_histories(file, history, facts.scene.items[0].model.marked_points.size());
}

void add_assumptions(Hdf5Writer& file, const std::vector<AssumptionFacts>& assumptions) {
  file.add_group("/assumptions");
  const auto texts = [&](std::string AssumptionFacts::*member) {
    std::vector<std::string> values;
    for (const AssumptionFacts& assumption : assumptions) values.push_back(assumption.*member);
    return values;
  };
  const Scales scale{"/assumptions/key"};
  file.add_scale({"/assumptions/key", "1", "the number that has no source", {}},
                 texts(&AssumptionFacts::key));
  file.add({"/assumptions/value", "1", "its value in this run", scale},
           texts(&AssumptionFacts::value));
  file.add({"/assumptions/range", "1", "how far it may be off", scale},
           texts(&AssumptionFacts::range));
  file.add({"/assumptions/reason", "1", "why this value", scale}, texts(&AssumptionFacts::reason));
  file.add({"/assumptions/file", "1", "data file that states it", scale},
           texts(&AssumptionFacts::file));
}

void add_drawn(Hdf5Writer& file, const std::vector<DrawnFacts>& drawn) {
  file.add_group("/drawn");
  const auto texts = [&](std::string DrawnFacts::*member) {
    std::vector<std::string> values;
    for (const DrawnFacts& each : drawn) values.push_back(each.*member);
    return values;
  };
  std::vector<double> values;
  for (const DrawnFacts& each : drawn) values.push_back(each.value);
  const Scales scale{"/drawn/variable"};
  file.add_scale({"/drawn/variable", "1", "the number that was drawn", {}},
                 texts(&DrawnFacts::variable));
  file.add({"/drawn/value", "1", "its value in this run, in the unit given", scale}, values);
  file.add({"/drawn/unit", "1", "unit of its value", scale}, texts(&DrawnFacts::unit));
  file.add({"/drawn/distribution", "1", "what it was drawn from, in the unit given", scale},
           texts(&DrawnFacts::distribution));
  file.add({"/drawn/file", "1", "data file that states it", scale}, texts(&DrawnFacts::file));
}

}  // namespace

std::string results_image(const RunFacts& facts, const Response& response) {
  Hdf5Writer file;
  add_root(file, facts);
  add_runs(file, facts, response);
  add_histories(file, facts, response.items[0].history);
  add_assumptions(file, facts.assumptions);
  if (facts.draw) add_drawn(file, facts.drawn);
  add_verification(file, response);
  return file.image();
}

}  // namespace gurney
