#include "studies/results/results_file.h"

#include <span>
#include <vector>

#include "studies/build_info/build_info.h"
#include "studies/results/column_writer.h"
#include "studies/results/histories.h"
#include "studies/results/shapes.h"
#include "studies/results/tables.h"

namespace gurney::study {
namespace {

using Scales = std::vector<std::string>;

const Scales kRun{"/runs/run"};

void add_root(Hdf5Writer& file, const RunFacts& facts) {
  const auto text = [&](const std::string& name, const std::string& value) {
    file.set_attribute("/", name, value);
  };
  add_program(file, "gurney-results", kResultsFormatVersion);
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
  file.add_scale({"/runs/axis", "1", "floor axis", {}}, std::vector<std::string>{"x", "y", "z"});
  one_text("record", "name of the floor motion; empty: the floor is at rest",
           facts.record ? facts.record->name : "");
  one_text("outcome",
           "how the run ended: rested, still_moving, stopped, overturned, diverged or untrusted",
           name_of(response.outcome));
  one_text("cause", "why the run diverged or is untrusted; empty: neither", response.cause);
  file.add({"/runs/end_time", "s", "end of the run", kRun}, std::vector<double>{response.end_time});
  add_record(file, facts.record.value_or(RecordFacts{}));
}

void add_verification(Hdf5Writer& file, const Response& response) {
  file.add_group("/verification");
  file.add_scale({"/verification/run", "1", "index of the run", {}}, std::vector<std::int64_t>{0});
  const Scales run{"/verification/run"};
  add_columns(file, "/verification/", quality_columns(), run,
              std::vector<Quality>{response.quality});
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
  file.add_scale({"/drawn/variable", "1", "the parameter that was drawn", {}},
                 texts(&DrawnFacts::variable));
  file.add({"/drawn/value", "1", "its value in this run, in the unit given", scale}, values);
  file.add({"/drawn/unit", "1", "unit of its value", scale}, texts(&DrawnFacts::unit));
  file.add({"/drawn/distribution", "1", "what it was drawn from, in the unit given", scale},
           texts(&DrawnFacts::distribution));
  file.add({"/drawn/file", "1", "data file that states it", scale}, texts(&DrawnFacts::file));
}

}  // namespace

void add_program(Hdf5Writer& file, const std::string& filetype, int format_version) {
  const build_info::BuildInfo build = build_info::build_info();
  file.set_attribute("/", "filetype", filetype);
  file.set_attribute("/", "format_version", std::int64_t{format_version});
  file.set_attribute("/", "program_version", build.program_version);
  file.set_attribute("/", "git_commit", build.git_commit);
  file.set_attribute("/", "compiler", build.compiler);
  file.set_attribute("/", "bullet_precision", build.bullet_precision);
  file.set_attribute("/", "cpu_class", build.cpu_class);
}

std::string results_image(const RunFacts& facts, const Response& response) {
  Hdf5Writer file;
  add_root(file, facts);
  add_runs(file, facts, response);
  add_tables(file, facts.scene, response);
  add_shapes(file, facts.scene);
  add_histories(file, facts, response);
  add_assumptions(file, facts.assumptions);
  if (facts.draw) add_drawn(file, facts.drawn);
  add_verification(file, response);
  return file.image();
}

}  // namespace gurney::study
