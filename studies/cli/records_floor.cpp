#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/base/error.h"
#include "engine/base/units.h"
#include "groundmotions/buildings/building.h"
#include "groundmotions/buildings/floor_record.h"
#include "groundmotions/measures/peaks.h"
#include "studies/cli/commands.h"
#include "studies/cli/output.h"
#include "studies/cli/process.h"
#include "studies/cli/record_source.h"
#include "studies/cli/shared_options.h"
#include "studies/report/formats.h"

namespace gurney::cli {
namespace {

struct FloorOptions {
  RecordSource source;
  std::string building, floor = "roof", output;
  std::vector<double> place = {0, 0};
  bool overwrite = false, json = false;
};

int floor_of(const std::string& text, const groundmotions::Building& building) {
  const std::optional<int> floor = groundmotions::floor_of(building, text);
  require(floor.has_value(), fmt::format("--floor (--storey) {}: must be {}", text,
                                         groundmotions::floor_names(building)));
  return *floor;
}

/// How far the floor dips along a horizontal direction: its rotation about the other one [rad].
double peak_dip(const FloorRotation& rotation, groundmotions::Direction direction) {
  return rotation.angle.row(direction == groundmotions::Direction::kH1 ? 1 : 0)
      .cwiseAbs()
      .maxCoeff();
}

double peak_yaw(const FloorRotation& rotation) {
  return rotation.angle.row(2).cwiseAbs().maxCoeff();
}

groundmotions::Peaks peaks_of(const groundmotions::Component& component) {
  return groundmotions::peaks(component.time_step, component.acceleration);
}

/// PGA and PGV, PFA and PFV of the components; how far the floor rotates; storeys and isolators.
findings::Section floor_findings(const groundmotions::Building& building, int floor,
                                 const groundmotions::Record& ground,
                                 const groundmotions::BuildingResponse& response) {
  const findings::Format g{".3g", "g", kStandardGravity}, speed{".3g", "m/s"}, angle{".2g", "rad"};
  const auto& rotation = response.floor.rotation;
  findings::Section all(
      "", fmt::format("{}, floor {} of {}", building.name, name_of_floor(building, floor),
                      name_of_floor(building, building.storeys)));
  all.json("building", building.name).json("floor", floor).json("storeys", building.storeys);
  if (building.tables) all.json("floor_name", name_of_floor(building, floor));
  findings::Table components{"{}", "", {}};
  for (const groundmotions::Direction direction : groundmotions::kDirections) {
    if (!response.floor[direction]) continue;
    std::optional<groundmotions::Peaks> below;
    if (ground[direction]) below = peaks_of(*ground[direction]);
    const groundmotions::Peaks peak = peaks_of(*response.floor[direction]);
    std::optional<double> dip;
    if (rotation && direction != groundmotions::Direction::kVertical)
      dip = peak_dip(*rotation, direction);
    using Value = findings::Value;
    report::add_row(
        components,
        {{{"component", "component"}, name_of(direction)},
         {{"pga_m_per_s2", "PGA", g}, below ? Value(below->acceleration) : Value()},
         {{"pfa_m_per_s2", "PFA", g}, peak.acceleration},
         {{"pgv_m_per_s", "PGV", speed}, below ? Value(below->velocity) : Value()},
         {{"pfv_m_per_s", "PFV", speed}, peak.velocity},
         {{"peak_dip_rad", rotation && building.torsion.empty() ? "rotation along it" : "", angle},
          dip}});
  }
  all.add(std::move(components));
  if (rotation && !building.torsion.empty())
    all.fact("peak_yaw_rad", "floor twists by up to", peak_yaw(*rotation), angle);
  for (const std::string& finding : response.findings) all.say(finding);
  if (response.isolators) {
    findings::Section isolators("isolators");
    isolators.fact("peak_m", "isolators, peak", response.isolators->peak, {".3g", "m"})
        .fact("residual_m", "isolators, residual", response.isolators->residual.norm(),
              {".2g", "m"});
    all.add(std::move(isolators));
  }
  if (response.storey_drift_ratio)
    all.json("peak_storey_drift_ratio", *response.storey_drift_ratio);
  if (response.storeys) {
    findings::Section storeys("storey_response");
    storeys.json("ductility", response.storeys->ductility)
        .json("residual_drift_m", response.storeys->residual_drift);
    all.add(std::move(storeys));
  }
  return all.json("processing", response.floor.processing)
      .json("warnings", response.floor.warnings);
}

std::string text_of(const std::vector<groundmotions::Refusal>& refused) {
  std::string text;
  for (const groundmotions::Refusal& each : refused)
    text += (text.empty() ? "" : "\n") + groundmotions::text_of(each);
  return text;
}

/// @throws Error unless what was asked for can be done with the building
void check(const FloorOptions& options, const groundmotions::Building& building) {
  constexpr double kFarthest = groundmotions::kFarthestPlace;
  const std::vector<double>& place = options.place;
  require(!building.torsion.empty() || place == std::vector<double>{0, 0},
          "--position: has no effect: the building has no torsion");
  require(
      std::abs(place[0]) <= kFarthest && std::abs(place[1]) <= kFarthest,
      fmt::format("--position {:g},{:g}: must be within {:g} m, along h1 and h2, of the axis of "
                  "stiffness [m]",
                  place[0], place[1], kFarthest));
  require(!building.tables || options.source.steps.empty(),
          "--step: must not go with floor motions of another program, which fit the unprocessed "
          "record");
  check_csv_output(options.output, options.overwrite);
}

int floor(const FloorOptions& options) {
  const groundmotions::Building building = groundmotions::building_from_file(
      data_file(equipment::DataKind::kBuilding, options.building, "--building "));
  const int number = floor_of(options.floor, building);
  check(options, building);
  std::vector<groundmotions::Refusal> refused;
  std::optional<groundmotions::Record> ground;
  const int code =
      for_each_record(options.source, &refused,
                      [&](const groundmotions::SuiteRecord&, const groundmotions::Record& record) {
                        require(!ground, "one record is needed, several were given");
                        ground = record;
                      });
  if (!ground && options.json) throw Error(text_of(refused));
  if (!ground) return code;
  const groundmotions::BuildingResponse response = groundmotions::building_response(
      *ground, building, number, {options.place[0], options.place[1]});
  refuse_input_as_output(options.output, *ground);
  print_findings(floor_findings(building, number, *ground, response), options.json);
  for (const std::string& warning : response.floor.warnings)
    if (!options.json && std::ranges::find(ground->warnings, warning) ==
                             ground->warnings.end())  // those were reported
      print_error("warning: {}\n", warning);
  write_output(options.output, record_csv(response.floor), options.overwrite, options.json);
  return code;
}

}  // namespace

void add_records_floor(Commands& commands) {
  commands.add<FloorOptions>(
      {"floor", "Compute floor motions from a ground motion and a building model",
       "gurney records floor groundmotions/records/synthetic_3c.csv \\\n"
       "  --building groundmotions/buildings/lead_rubber_hospital.toml --floor roof -o roof.csv"},
      floor, [](Options& add, FloorOptions& options) {
        add_source_options(add, options.source);
        add.required("--building FILE", options.building,
                     "A building of the catalogue (gurney equipment ls), or a building file");
        add("--storey,--floor", options.floor,
            "0 (the base) to the number of storeys, roof, or the name of a floor");
        add.required("-o,--output FILE", options.output, "The .csv file to write");
        add("--position X,Y", options.place,
            "Place on a floor that twists, from its axis of stiffness along h1 and h2 [m]")
            ->delimiter(',')
            ->expected(2);
        add("--json", options.json, "Print the peaks as JSON");
        add("--overwrite", options.overwrite, "Replace a file that exists");
      });
}

}  // namespace gurney::cli
