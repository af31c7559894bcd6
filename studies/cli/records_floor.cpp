#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
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

/// PGA and PGV, PFA and PFV of the components.
nlohmann::ordered_json facts_json(const groundmotions::Building& building, int floor,
                                  const groundmotions::Record& ground,
                                  const groundmotions::BuildingResponse& response) {
  nlohmann::ordered_json facts = {
      {"building", building.name}, {"floor", floor}, {"storeys", building.storeys}};
  if (building.tables) facts["floor_name"] = name_of_floor(building, floor);
  for (const groundmotions::Direction direction : groundmotions::kDirections) {
    if (!response.floor[direction]) continue;
    nlohmann::ordered_json& of = facts[name_of(direction)];
    if (ground[direction]) {
      const groundmotions::Peaks below = peaks_of(*ground[direction]);
      of["pga_m_per_s2"] = below.acceleration;
      of["pgv_m_per_s"] = below.velocity;
    }
    const groundmotions::Peaks peak = peaks_of(*response.floor[direction]);
    of["pfa_m_per_s2"] = peak.acceleration;
    of["pfv_m_per_s"] = peak.velocity;
    if (response.floor.rotation && direction != groundmotions::Direction::kVertical)
      of["peak_dip_rad"] = peak_dip(*response.floor.rotation, direction);
  }
  if (response.floor.rotation && !building.torsion.empty())
    facts["peak_yaw_rad"] = peak_yaw(*response.floor.rotation);
  if (response.isolators)
    facts["isolators"] = {{"peak_m", response.isolators->peak},
                          {"residual_m", response.isolators->residual.norm()}};
  if (response.storey_drift_ratio) facts["peak_storey_drift_ratio"] = *response.storey_drift_ratio;
  if (response.storeys) {
    const auto numbers = [](const Eigen::VectorXd& v) { return std::vector(v.begin(), v.end()); };
    facts["storey_response"] = {{"ductility", numbers(response.storeys->ductility)},
                                {"residual_drift_m", numbers(response.storeys->residual_drift)}};
  }
  facts["processing"] = response.floor.processing;
  facts["warnings"] = response.floor.warnings;
  return facts;
}

void print_facts(const groundmotions::Building& building, int floor,
                 const groundmotions::Record& ground,
                 const groundmotions::BuildingResponse& response) {
  fmt::print("{}, floor {} of {}\n", building.name, name_of_floor(building, floor),
             name_of_floor(building, building.storeys));
  for (const groundmotions::Direction direction : groundmotions::kDirections) {
    if (!response.floor[direction]) continue;
    const groundmotions::Peaks below =
        ground[direction] ? peaks_of(*ground[direction]) : groundmotions::Peaks{};
    const groundmotions::Peaks peak = peaks_of(*response.floor[direction]);
    fmt::print("  {:<9} PGA {:.3g} g, PFA {:.3g} g; PGV {:.3g} m/s, PFV {:.3g} m/s{}\n",
               name_of(direction), below.acceleration / kStandardGravity,
               peak.acceleration / kStandardGravity, below.velocity, peak.velocity,
               ground[direction] ? "" : " (not in the record)");
  }
  if (response.floor.rotation && !building.torsion.empty())
    fmt::print("  floor twists by up to {:.2g} rad\n", peak_yaw(*response.floor.rotation));
  else if (response.floor.rotation)
    fmt::print("  floor rotates by up to {:.2g} rad along h1, {:.2g} rad along h2\n",
               peak_dip(*response.floor.rotation, groundmotions::Direction::kH1),
               peak_dip(*response.floor.rotation, groundmotions::Direction::kH2));
  for (const std::string& finding : response.findings) fmt::print("  {}\n", finding);
  if (response.isolators)
    fmt::print("  isolators {:.3g} m, residual {:.2g} m\n", response.isolators->peak,
               response.isolators->residual.norm());
  for (const std::string& warning : response.floor.warnings)
    if (std::ranges::find(ground.warnings, warning) ==
        ground.warnings.end())  // those were reported
      print_error("warning: {}\n", warning);
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
  if (options.json)
    fmt::print("{}\n", facts_json(building, number, *ground, response).dump(2));
  else
    print_facts(building, number, *ground, response);
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
