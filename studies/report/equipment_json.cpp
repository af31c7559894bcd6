#include <nlohmann/json.hpp>

#include "studies/report/equipment_report.h"

namespace gurney::report {
namespace {

using Json = nlohmann::ordered_json;

Json list(const Vector3& v) { return {v.x(), v.y(), v.z()}; }
Json list(const Vector2& v) { return {v.x(), v.y()}; }

Json tilts(const equipment::ItemSheet& sheet) {
  Json result = Json::array();
  for (const equipment::TiltTowards& t : sheet.tilts)
    result.push_back(
        {{"direction_rad", t.direction}, {"as_placed_rad", t.as_placed}, {"worst_rad", t.worst}});
  return result;
}

Json wheels(const EquipmentFacts& facts) {
  Json result = Json::array();
  for (std::size_t i = 0; i < facts.sheet.wheels.size(); ++i) {
    const equipment::WheelAtRest& wheel = facts.sheet.wheels[i];
    const Caster& caster = facts.model.casters[i];
    result.push_back({{"caster", wheel.caster},
                      {"contact_m", list(wheel.contact)},
                      {"load_n", wheel.load},
                      {"sink_m", wheel.sink},
                      {"swivels", caster.swivels},
                      {"braked", caster.brake_torque > 0},
                      {"swivel_locked", caster.swivel_lock_torque > 0}});
  }
  return result;
}

Json contact(const EquipmentFacts& facts) {
  const ContactConstants& floor = facts.floor;
  const bool compliant = floor.kind == ContactConstants::Kind::kCompliant;
  return {{"material", facts.model.material},
          {"friction", floor.friction},
          {"restitution", compliant ? Json(nullptr) : Json(floor.restitution)},
          {"stiffness_n_per_m", floor.stiffness},
          {"damping_n_s_per_m", compliant ? Json(floor.damping) : Json(nullptr)}};
}

Json assumptions(const std::vector<equipment::Assumption>& all) {
  Json result = Json::array();
  for (const equipment::Assumption& a : all) {
    const bool number = a.choice.empty();
    result.push_back({{"key", a.key},
                      {"value", number ? Json(a.value) : Json(a.choice)},
                      {"range", number ? Json{a.low, a.high} : Json(nullptr)},
                      {"reason", a.reason}});
  }
  return result;
}

}  // namespace

std::string equipment_json(const EquipmentFacts& facts) {
  const equipment::ItemSheet& sheet = facts.sheet;
  Json inertia = Json::array(), polygon = Json::array();
  for (int row = 0; row < 3; ++row) inertia.push_back(list(Vector3(sheet.whole.inertia.row(row))));
  for (const Vector2& corner : sheet.support_polygon) polygon.push_back(list(corner));
  const bool rolls = !facts.model.casters.empty();
  const Json result = {
      {"name", facts.model.name},
      {"description", facts.description},
      {"variants", facts.variants},
      {"mass_kg", sheet.whole.mass},
      {"size_m", list(sheet.size)},
      {"center_of_mass_m", list(sheet.whole.center_of_mass)},
      {"inertia_kg_m2", inertia},
      {"principal_inertia_kg_m2", list(sheet.principal_inertia)},
      {"support_polygon_m", polygon},
      {"base_over_height", sheet.stability.base / sheet.stability.height},
      {"base_over_height_as_placed", sheet.tipping_share},
      {"tilt_rad", sheet.stability.tilt},
      {"tilt_direction_rad", sheet.stability.direction},
      {"tilt_as_placed_rad", sheet.stability.tilt_as_placed},
      {"tilts", tilts(sheet)},
      {"wheels", wheels(facts)},
      {"floor_contact", contact(facts)},
      {"rolling_resistance_n", rolls ? Json(sheet.rolling_resistance_force) : Json(nullptr)},
      {"rolls_from_g", rolls ? Json(sheet.rolling_resistance_coefficient) : Json(nullptr)},
      {"moves_with_brakes_as_they_are_from_g", rolls ? Json(sheet.holding_share) : Json(nullptr)},
      {"slides_from_g", sheet.sliding_share},
      {"tips_from_g", sheet.tipping_share},
      {"assumptions", assumptions(facts.assumptions)},
      {"warnings", facts.warnings}};
  return result.dump(2) + "\n";
}

}  // namespace gurney::report
