#pragma once

#include <string>
#include <vector>

#include "studies/results/columns.h"
#include "studies/results/growing_table.h"
#include "studies/results/study_reader.h"

/// A study file with known outcomes, without a simulation.
namespace gurney::study {

inline constexpr const char* kSmallStudy = R"(schema = "gurney-job/1"
title = "small"
[study]
measures = "PGA h1"
performance = ["moved", "fell"]
[study.intensity]
measure = "PGA"
component = "h1"
unit = "g"
levels = [0.1, 0.2, 0.4]
[study.hazard]
k0 = 1e-3
k = 2
[[study.limit_state]]
name = "moved"
demand = "peak_displacement"
above = 10
unit = "cm"
[[study.limit_state]]
name = "fell"
event = "overturned"
item = "cart"
[[study.limit_state]]
name = "both"
all_of = ["moved", "fell"]
)";

struct SmallRun {
  std::size_t record;
  double intensity;     ///< [m/s2]
  double displacement;  ///< of the first item [m]
  bool fell = false;    ///< the first item
  bool failed = false;
  bool untrusted = false;
  double scale = 1;
  bool content_fell = false;  ///< of the first item, and 3 m away from it
};

/// A row of /zones.
struct SmallZone {
  std::size_t run;
  std::string zone;
  ZoneOutcome outcome;
};

inline void write_zones(Hdf5Writer& file, const std::vector<SmallZone>& zones) {
  if (zones.empty()) return;
  GrowingTable table(file, "zones");
  table.add_whole("run", "run");
  table.add_text("zone", "zone", 8);
  table.add(zone_columns());
  for (const SmallZone& each : zones)
    table.put(double(each.run)).put(each.zone).put(zone_columns(), each.outcome).end_row();
  table.finish();
}

/// One configuration; items `cart` and, at rest, `bed`.
inline void write_small_study(const std::string& path, const std::vector<SmallRun>& runs,
                              const std::string& job = kSmallStudy,
                              const std::vector<SmallZone>& zones = {}) {
  Hdf5Writer file(path);
  file.set_attribute("/", "filetype", std::string("gurney-study"));
  file.set_attribute("/", "format_version", std::int64_t{kStudyFormatVersion});
  file.set_attribute("/", "job_text", job);
  file.set_attribute("/", "title", std::string("small"));
  file.set_attribute("/", "intensity_measure", std::string("PGA h1"));
  file.set_attribute("/", "intensity_units", std::string("m/s2"));
  GrowingTable configurations(file, "configurations");
  configurations.add_text("name", "levels", 4);
  configurations.put("all").end_row();
  GrowingTable table(file, "runs"), items(file, "items");
  for (const char* name : {"run", "analysis_case", "configuration", "record", "motion"})
    table.add_whole(name, name);
  for (const char* name : {"scale", "intensity", "pfa", "pfv"}) table.add_number(name, "1", name);
  table.add_text("outcome", "outcome", 10);
  items.add_whole("run", "run");
  items.add_text("item", "item", 8);
  items.add(demand_columns());
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const SmallRun& run = runs[i];
    table.put(double(i)).put(double(run.record)).put(0.0).put(double(run.record)).put(double(i));
    table.put(run.scale).put(run.intensity).put(run.intensity).put(0.1 * run.intensity);
    table
        .put(std::string(run.untrusted ? "untrusted"
                         : run.failed  ? "diverged"
                         : run.fell    ? "overturned"
                                       : "rested"))
        .end_row();
    if (run.failed || run.untrusted) continue;
    Demands cart;
    cart.peak_displacement = run.displacement;
    if (run.fell) cart.time_of_overturning = 0.0;
    items.put(double(i)).put("cart").put(demand_columns(), cart).end_row();
    if (run.content_fell) {
      Demands jug;
      jug.peak_displacement = 3;
      jug.time_of_fall = jug.time_of_toppling = 1;
      items.put(double(i)).put("cart/jug").put(demand_columns(), jug).end_row();
    }
    items.put(double(i)).put("bed").put(demand_columns(), Demands{}).end_row();
  }
  write_zones(file, zones);
  configurations.finish();
  table.finish();
  items.finish();
  file.finish();
}

}  // namespace gurney::study
