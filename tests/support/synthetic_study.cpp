#include "tests/support/synthetic_study.h"

#include <fmt/format.h>

#include "engine/base/units.h"
#include "studies/results/columns.h"
#include "studies/results/growing_table.h"
#include "studies/results/names.h"
#include "studies/results/results_file.h"
#include "studies/results/study_reader.h"
#include "studies/run/study_file.h"

namespace gurney {

const std::vector<double> SyntheticStudy::kLevels{0.1, 0.2, 0.3, 0.5, 0.8, 1.2};

namespace {

using Study = SyntheticStudy;

constexpr const char* kJob = R"toml(title = "Synthetic & <plain>"
[study]
draws = 1
synthetic_records = 40
step_check = 0.02
measures = ["PGA larger", "Sa(1.0) RotD50", "Sa(1.0, 2%) RotD50", "FIV3(1.0)"]
[study.intensity]
measure = "PGA"
component = "larger"
unit = "g"
@
[[study.factor]]
name = "brakes"
key = "item.brakes"
values = [false, true]
)toml";

std::string job_text(bool ida) {
  const std::string levels = "levels = [0.1, 0.2, 0.3, 0.5, 0.8, 1.2]";
  const std::string traced = R"(ida = { first = 0.1, increment = 0.1, until = "moved" })";
  std::string text = kJob;
  return text.replace(text.find('@'), 1, ida ? traced : levels);
}

struct TextColumn {
  std::string name;
  std::vector<std::string> values;
};

void write_texts(study::Hdf5Writer& file, const std::string& name,
                 const std::vector<TextColumn>& columns) {
  study::GrowingTable table(file, name);
  for (const TextColumn& column : columns) table.add_text(column.name, column.name, 80);
  for (std::size_t row = 0; row < columns.front().values.size(); ++row) {
    for (const TextColumn& column : columns) table.put(column.values[row]);
    table.end_row();
  }
  table.finish();
}

void write_heads(study::Hdf5Writer& file, bool ida) {
  study::add_program(file, "gurney-study", study::kStudyFormatVersion);
  for (const auto& [name, value] :
       std::vector<std::pair<std::string, std::string>>{{"job_name", "synthetic"},
                                                        {"job_text", job_text(ida)},
                                                        {"job_sha256", "abc"},
                                                        {"title", "Synthetic & <plain>"},
                                                        {"seed", "1"},
                                                        {"intensity_measure", "PGA larger"},
                                                        {"intensity_units", "m/s2"}})
    file.set_attribute("/", name, value);
  write_texts(file, "configurations", {{"name", {"false", "true"}}, {"brakes", {"false", "true"}}});
  std::vector<std::string> names, files, warnings;
  for (std::size_t i = 0; i < Study::kRecords; ++i) {
    names.push_back(fmt::format("record {}", i));
    files.push_back(fmt::format("{:064d} record_{}.csv", i, i));
    warnings.push_back(i == 3 ? "no vertical component" : "");
  }
  const std::vector<std::string> zeros(Study::kRecords, "0"), none(Study::kRecords);
  write_texts(file, "records",
              {{"set", zeros},
               {"name", names},
               {"files", files},
               {"processing", none},
               {"warnings", warnings}});
  write_texts(file, "assumptions",
              {{"configuration", {"0", "1"}},
               {"key", {"chassis.mass_kg", "chassis.mass_kg"}},
               {"value", {"100", "100"}},
               {"range", {"80 to 120", "80 to 120"}},
               {"drawn", {"no", "no"}},
               {"reason", {"weighed once, \"by hand\"", "weighed once, \"by hand\""}},
               {"file", {"bed.toml", "bed.toml"}}});
}

/// The tables with rows for runs; all rows of one table are written before the next is begun.
class Tables {
 public:
  explicit Tables(study::Hdf5Writer& file) : file_(file) {}

  void write(bool step_check) {
    write_runs();
    write_motions();
    write_items("items", Study::kRecords * 2 * Study::kLevels.size(), 0);
    if (step_check) write_items("half_step", 10, 0.01);
    if (step_check) write_warnings();
    write_points();
    write_drawn();
    study::GrowingTable failures(file_, "failures");
    failures.add_whole("run", "run");
    failures.add_text("cause", "cause", 80);
    failures.put(double(Study::kFailed)).put("did not converge, \"badly\"").end_row();
    failures.finish();
  }

 private:
  struct Place {
    std::size_t configuration, record, level;
  };

  static Place place_of(std::size_t run) {
    const std::size_t levels = Study::kLevels.size();
    return {run / (Study::kRecords * levels), run / levels % Study::kRecords, run % levels};
  }

  static double pga(std::size_t run) {
    return Study::kLevels[place_of(run).level] * kStandardGravity;
  }

  void write_runs() {
    study::GrowingTable runs(file_, "runs");
    for (const char* name : {"run", "analysis_case", "configuration", "record", "motion", "draw"})
      runs.add_whole(name, name);
    runs.add_number("angle", "rad", "angle");
    runs.add_number("scale", "1", "scale");
    runs.add_number("intensity", "1", "intensity");
    runs.add_number("pfa", "m/s2", "pfa");
    runs.add_number("pfv", "m/s", "pfv");
    runs.add_text("outcome", "outcome", 12);
    runs.add_number("energy_closure", "1", "closure");
    for (std::size_t run = 0; run < Study::kRecords * 2 * Study::kLevels.size(); ++run) {
      const auto [configuration, record, level] = place_of(run);
      runs.put(double(run)).put(double(run / Study::kLevels.size())).put(double(configuration));
      runs.put(double(record)).put(double(record * Study::kLevels.size() + level));
      runs.put(double(record)).put(0).put(pga(run) / 2).put(pga(run));
      runs.put(1.5 * pga(run)).put(0.1 * pga(run));
      runs.put(run == Study::kFailed ? "diverged" : "rested");
      runs.put(run == 30 ? 2e-4 : 1e-6).end_row();
    }
    runs.finish();
  }

  void write_motions() {
    study::GrowingTable motions(file_, "motions");
    motions.add_whole("set", "set");
    motions.add_whole("record", "record");
    motions.add_number("scale", "1", "scale");
    motions.add_number("PGA larger", "m/s2", "PGA");
    motions.add_number("Sa(1) RotD50", "m/s2", "Sa");
    motions.add_number("Sa(1, 2%) RotD50", "m/s2", "Sa");
    motions.add_number("FIV3(1) geomean", "m/s", "FIV3");
    for (std::size_t i = 0; i < Study::kRecords * Study::kLevels.size(); ++i) {
      motions.put(0).put(double(place_of(i).record)).put(pga(i) / 2).put(pga(i));
      motions.put(0.8 * pga(i)).put(pga(i)).put(pga(i)).end_row();
    }
    motions.finish();
  }

  void write_items(const std::string& name, std::size_t runs, double longer) {
    study::GrowingTable items(file_, name);
    items.add_whole("run", "run");
    items.add_text("item", "item", 20);
    items.add(study::demand_columns());
    for (std::size_t run = 0; run < runs; ++run) {
      if (run == Study::kFailed) continue;
      const auto [configuration, record, level] = place_of(run);
      bool moved = Study::moved(configuration, record, level);
      if (run == Study::kChanged && longer > 0) moved = !moved;
      Demands demands;
      demands.peak_displacement = 0.1 * (longer > 0 ? 1 + longer * double(1 + run) : 1);
      demands.residual_displacement = moved ? 0.05 : 0.001;
      items.put(double(run)).put("ICU bed").put(study::demand_columns(), demands).end_row();
    }
    items.finish();
  }

  void write_warnings() {
    study::GrowingTable warnings(file_, "warnings");
    warnings.add_whole("run", "run");
    warnings.add_text("warning", "warning", 80);
    warnings.put(40).put("the isolators reach their limit").end_row();
    warnings.put(41).put(study::kHalfStepFailed + std::string("it diverged")).end_row();
    warnings.finish();
  }

  void write_points() {
    study::GrowingTable points(file_, "points");
    points.add_whole("run", "run");
    points.add_text("item", "item", 20);
    points.add_text("point", "point", 20);
    points.add(study::point_demand_columns());
    points.put(0)
        .put("ICU bed")
        .put("tray")
        .put(study::point_demand_columns(), PointDemands{})
        .end_row();
    points.finish();
  }

  void write_drawn() {
    study::GrowingTable drawn(file_, "drawn");
    drawn.add_whole("configuration", "configuration");
    drawn.add_whole("draw", "draw");
    drawn.add_text("variable", "variable", 40);
    drawn.add_number("value", "1", "value");
    for (int configuration : {0, 1})
      for (std::size_t draw = 0; draw < Study::kRecords; ++draw)
        drawn.put(configuration)
            .put(double(draw))
            .put("tread.patch_width_mm")
            .put(3 + 0.1 * double(draw))
            .end_row();
    drawn.finish();
  }

  study::Hdf5Writer& file_;
};

}  // namespace

statistics::LognormalCurve SyntheticStudy::curve(std::size_t configuration) {
  return configuration == 0 ? statistics::LognormalCurve{0.35, 0.4}
                            : statistics::LognormalCurve{0.6, 0.5};
}

std::size_t SyntheticStudy::run(std::size_t configuration, std::size_t record, std::size_t level) {
  return (configuration * kRecords + record) * kLevels.size() + level;
}

bool SyntheticStudy::moved(std::size_t configuration, std::size_t record, std::size_t level) {
  return kLevels[level] >= curve(configuration).quantile((double(record) + 0.5) / kRecords);
}

void SyntheticStudy::write(const std::string& path, bool step_check, bool ida) {
  study::Hdf5Writer file(path);
  write_heads(file, ida);
  Tables(file).write(step_check);
  file.finish();
}

}  // namespace gurney
