#include "studies/calibration/fit/trial_item.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/base/error.h"
#include "equipment/catalogue/catalogue.h"
#include "equipment/catalogue/load_item.h"

namespace gurney::calibration {
namespace {

constexpr double kMassAgrees = 0.02;

std::string found(equipment::DataKind kind, const std::string& name) {
  try {
    return equipment::find_data(kind, name, "");
  } catch (const Error& error) {
    throw Error("'" + name + "': " + error.what());
  }
}

}  // namespace

EquipmentModel item_of(const TrialSetup& setup) {
  equipment::ItemOptions options;
  if (!setup.caster.empty())
    options.caster =
        equipment::load_caster_type(found(equipment::DataKind::kCaster, setup.caster)).stated();
  const std::vector<std::string> floors = equipment::catalogue_names(equipment::DataKind::kFloor);
  if (std::ranges::find(floors, setup.floor) != floors.end())
    options.floor =
        equipment::load_floor_covering(find_data(equipment::DataKind::kFloor, setup.floor, ""))
            .stated();
  if (!setup.payload_name.empty()) options.payloads = {{setup.payload_name, setup.payload_count}};
  options.headings = setup.headings;
  if (setup.headings.size() == 1)
    options.headings.assign(static_cast<std::size_t>(setup.wheels), setup.headings[0]);
  EquipmentModel model =
      equipment::load_item(found(equipment::DataKind::kItem, setup.item), options).model;
  const double mass = whole_item(model).mass;
  require(setup.mass == 0 || std::abs(mass / setup.mass - 1) < kMassAgrees,
          fmt::format("{} weighs {:.4g} kg with its payload, but the trial {:.4g} kg", setup.item,
                      mass, setup.mass));
  require(!model.casters.empty(), setup.item + " has no casters");
  return model;
}

}  // namespace gurney::calibration
