#include <fmt/format.h>

#include <set>

#include "engine/base/error.h"
#include "engine/base/toml_string.h"
#include "equipment/catalogue/catalogue.h"
#include "equipment/catalogue/item_sheet.h"
#include "equipment/catalogue/load_item.h"
#include "studies/hospital/outcomes.h"
#include "studies/hospital/toml_text.h"

namespace gurney::study {
namespace {

// Distances to the walls of a bay, as in the fragility catalogue: assumptions, 0.05 to 0.5 m.
constexpr double kGapBehind = 0.1, kGapBeside = 0.3, kWall = 0.1, kHeight = 2.8;  // [m]

constexpr const char* kAnyWay =
    R"({ value = 0, distribution = { kind = "uniform", low = -180, high = 180, assumption = "any way round" } })";

/// Name of a level: an item at its place.
std::string level_of(const HospitalItem& item) { return item.equipment + " " + item.place; }

std::string bay_walls(const HospitalItem& item, const std::string& path) {
  const EquipmentModel model =
      equipment::load_item(equipment::find_data(equipment::DataKind::kItem, item.equipment, path))
          .model;
  const Vector3 size = equipment::item_sheet(model).size;
  const double back = size.x() / 2 + kGapBehind + kWall / 2, front = size.x() / 2,
               side = size.y() / 2 + kGapBeside + kWall / 2;
  const auto wall = [](const char* name, double x0, double y0, double x1, double y1) {
    return fmt::format(
        "  {{ name = \"{}\", from_m = [{:.3f}, {:.3f}], to_m = [{:.3f}, {:.3f}], thickness_m = "
        "{:g}, height_m = {:g} }},\n",
        name, x0, y0, x1, y1, kWall, kHeight);
  };
  return "room.wall = [\n" + wall("back wall", -back, -side - kWall / 2, -back, side + kWall / 2) +
         wall("left wall", -back, side, front, side) +
         wall("right wall", -back, -side, front, -side) + "]\n";
}

/// Rows of the design, each once, in the order in which the file needs them.
class Design {
 public:
  explicit Design(const Hospital& hospital) {
    for (const Room& room : hospital.rooms)
      for (const HospitalItem& item : room.items)
        add(hospital, room, item, item.securing.brakes, item.securing.share);
    for (const HospitalAction& action : hospital.actions)
      for (const auto& [room, item] : action.items)
        if (action.brakes)
          add(hospital, hospital.rooms[room], hospital.rooms[room].items[item], *action.brakes, 1);
  }

  const std::vector<HospitalItem>& items() const { return items_; }
  const std::string& rows() const { return rows_; }

 private:
  void add(const Hospital& hospital, const Room& room, const HospitalItem& item, Brakes brakes,
           double share) {
    const Storey& storey = hospital.storeys[room.storey];
    if (levels_.insert(level_of(item)).second) items_.push_back(item);
    if (share < 1) add(hospital, room, item, Brakes::kOff, 1);
    if (!seen_.insert(configuration_of(item, storey, brakes)).second) return;
    rows_ += fmt::format("  [{}, {}, {}],\n", toml_string(level_of(item)), toml_string(storey.name),
                         toml_string(brakes_names()[static_cast<std::size_t>(brakes)]));
  }

  std::set<std::string> levels_, seen_;
  std::vector<HospitalItem> items_;
  std::string rows_;
};

std::string limit_states_of(const Consequences& consequences) {
  std::string text;
  for (const LimitState& state : consequences.limit_states()) {
    if (!state.is_simple()) continue;
    text += fmt::format("# {}: {}\n", state.name, state.words);
  }
  return text;
}

}  // namespace

std::string study_job(const Hospital& hospital, const Consequences& consequences) {
  require(hospital.study.has_value(),
          hospital.path + ": simulation: must be given for a study: a table [simulation]");
  const HospitalStudy& study = *hospital.study;
  const Design design(hospital);
  std::string text = fmt::format(
      "schema = \"gurney-job/1\"\ntitle = {}\n# Written by gurney hospital; each configuration is "
      "a "
      "setting of an item of the hospital.\n# Asked of the runs are the states of {}:\n{}\n"
      "[item]\nequipment = {}\nheadings_deg = {}\n\n",
      toml_string(hospital.title.empty() ? "Hospital" : hospital.title),
      toml_string(consequences.path()), limit_states_of(consequences),
      toml_string(design.items().front().equipment), kAnyWay);
  if (!study.covering.empty())
    text += "[floor]\ncovering = " + toml_string(study.covering) + "\n\n";
  // An item that has fallen is out of use: what it does on the floor costs time, and may fail the run.
  text += "[excitation]\nrecord = " + study.record +
          "\n\n[settings]\nfollow_overturning = false\n\n[study]\n";
  if (study.synthetic_records > 0)
    text += fmt::format("synthetic_records = {}\n", study.synthetic_records);
  text += fmt::format(
      "draws = {}\nsampling = \"latin-hypercube\"\nseed = {}\ncombinations = [\n{}]\n\n"
      "[study.intensity]  # of the ground\nmeasure = \"PGV\"\ncomponent = \"larger\"\nunit = "
      "\"m/s\"\nlevels = [{}]\n\n[[study.factor]]\nname = \"item\"\n",
      study.draws, study.seed, design.rows(), fmt::join(hospital.levels, ", "));
  for (const HospitalItem& item : design.items())
    text += fmt::format("[study.factor.level.{}]\nitem.equipment = {}\n{}",
                        toml_string(level_of(item)), toml_string(item.equipment),
                        item.place == "bay" ? bay_walls(item, hospital.path)
                                            : fmt::format("item.yaw_deg = {}\n", kAnyWay));
  text += "\n[[study.factor]]\nname = \"storey\"\n";
  for (const Storey& storey : hospital.storeys)
    text += fmt::format(
        "[study.factor.level.{}]\n{}", toml_string(storey.name),
        storey.building.empty() ? "" : "excitation.building = " + storey.building + "\n");
  return text +
         "\n[[study.factor]]\nname = \"brakes\"\n[study.factor.level.off]\nitem.brakes = false\n"
         "[study.factor.level.on]\nitem.brakes = true\n[study.factor.level.locked]\n"
         "item.brakes = true\nitem.swivel_locks = true\n";
}

}  // namespace gurney::study
