#include "studies/cli/records_floor.h"

#include <fmt/format.h>

#include <charconv>
#include <memory>
#include <optional>

#include "engine/base/error.h"
#include "engine/base/units.h"
#include "groundmotions/buildings/building_reader.h"
#include "groundmotions/buildings/floor_record.h"
#include "studies/cli/record_source.h"
#include "studies/cli/records_output.h"

namespace gurney {
namespace {

struct FloorOptions {
  RecordSource source;
  std::string building, floor = "roof", output;
  bool overwrite = false;
};

int floor_of(const std::string& text, const Building& building) {
  if (text == "roof") return building.storeys;
  int floor = -1;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), floor);
  require(
      error == std::errc() && end == text.data() + text.size() && floor >= 0 &&
          floor <= building.storeys,
      fmt::format("--floor {}: must be roof, or a number from 0 to {}", text, building.storeys));
  return floor;
}

double peak(const std::optional<Component>& component) {
  return component ? component->acceleration.cwiseAbs().maxCoeff() / kStandardGravity : 0;
}

int floor(const FloorOptions& options) {
  const Building building = building_from_file(options.building);
  const int number = floor_of(options.floor, building);
  std::optional<Record> made;
  const int code =
      for_each_record(options.source, nullptr, [&](const SuiteRecord&, const Record& ground) {
        require(!made, "one record is needed, several were given");
        const BuildingResponse response = building_response(ground, building, number);
        made = response.floor;
        fmt::print("{}, floor {} of {}\n", building.name, number, building.storeys);
        for (const Direction direction : kDirections)
          if (ground[direction])
            fmt::print("  {:<9} PGA {:.3g} g, PFA {:.3g} g\n", name_of(direction),
                       peak(ground[direction]), peak(response.floor[direction]));
        if (response.isolators)
          fmt::print("  isolators {:.3g} m, {:.2g} m left at the end\n", response.isolators->peak,
                     response.isolators->residual.norm());
      });
  if (!made) return code;
  for (const std::string& warning : made->warnings) fmt::print(stderr, "warning: {}\n", warning);
  write_output(options.output, record_csv(*made), options.overwrite);
  return code;
}

}  // namespace

void add_records_floor(CLI::App& records, std::function<int()>& act) {
  auto options = std::make_shared<FloorOptions>();
  CLI::App* const command = records.add_subcommand(
      "floor", "Let a ground motion pass through a building and write the motion of a floor");
  add_source_options(*command, options->source);
  command
      ->add_option("--building", options->building,
                   "A building file (docs/formats/building_file.md)")
      ->required();
  command->add_option("--floor", options->floor, "0 (the base) to the number of storeys, or roof");
  command->add_option("-o,--output", options->output, "The .csv file to write")->required();
  command->add_flag("--overwrite", options->overwrite, "Replace a file that exists");
  command->callback([options, &act] { act = [options] { return floor(*options); }; });
}

}  // namespace gurney
