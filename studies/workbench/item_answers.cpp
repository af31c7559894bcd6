#include <filesystem>
#include <nlohmann/json.hpp>

#include "engine/base/error.h"
#include "engine/config/document.h"
#include "engine/config/file_snapshot.h"
#include "equipment/catalogue/at_rest.h"
#include "equipment/catalogue/catalogue.h"
#include "equipment/catalogue/check_file.h"
#include "equipment/catalogue/load_item.h"
#include "studies/report/equipment_report.h"
#include "studies/workbench/answers.h"
#include "studies/workbench/as_json.h"

namespace gurney::workbench {
namespace {

Json numbers(const Vector3& v) { return {v.x(), v.y(), v.z()}; }

Json boxes_of(const EquipmentModel& model) {
  Json all = Json::array();
  const char* const forms[] = {"box", "cylinder", "sphere", "hull"};
  for (const BodyShape& shape : model.shape)
    all.push_back({{"at", numbers(shape.center)},
                   {"size", numbers(shape.size)},
                   {"form", forms[shape.solid.index()]}});
  return all;
}

Json casters_of(const EquipmentModel& model) {
  Json all = Json::array();
  for (const Caster& each : model.casters)
    all.push_back({{"name", each.name},
                   {"at", numbers(each.mount)},
                   {"heading", each.heading},
                   {"swivels", each.swivels},
                   {"braked", each.brake_torque > 0},
                   {"trail", each.trail},
                   {"radius", each.wheel_radius},
                   {"width", each.wheel_width}});
  return all;
}

/// What moves while somebody drags.
Json key_facts(const findings::Section& all) {
  findings::Section chosen;
  for (const char* const key :
       {"mass_kg", "center_of_mass_m", "tilt_as_placed_rad", "tilt_rad", "tips_from_g",
        "rolls_from_g", "moves_with_brakes_as_they_are_from_g", "slides_from_g"})
    if (const auto* const fact = findings::find<findings::Fact>(all, key); fact != nullptr)
      chosen.parts.push_back(*fact);
  return shown(chosen);
}

Json answer_of(const std::string& path) {
  const equipment::ItemDescription item = equipment::load_item_description(path).stated();
  const equipment::LoadedItem loaded = equipment::at_rest(equipment::assemble_item(item));
  const report::EquipmentFacts facts = report::equipment_facts(item, loaded);
  const findings::Section all = report::equipment_findings(facts, false);
  Json polygon = Json::array();
  for (const Vector2& corner : facts.sheet.support_polygon)
    polygon.push_back({corner.x(), corner.y()});
  return {{"name", item.name},
          {"boxes", boxes_of(loaded.model)},
          {"casters", casters_of(loaded.model)},
          {"chassis", numbers(loaded.model.chassis_center_of_mass)},
          {"whole", numbers(facts.sheet.whole.center_of_mass)},
          {"polygon", polygon},
          {"facts", key_facts(all)},
          {"shown", shown(all)},
          {"warnings", facts.warnings}};
}

}  // namespace

Json source_answer(const std::string& equipment) {
  const std::string file = equipment::find_data(equipment::DataKind::kItem, equipment, kJob);
  return {{"text", config::FileSnapshot::bytes_of(file)},
          {"name", std::filesystem::path(file).filename().string()}};
}

Json item_answer(const std::string& name, const std::string& text) {
  const std::string path = kFolder + name;
  config::FileSnapshot snapshot;
  const config::FileSnapshot::Scope scope(snapshot);
  config::FileSnapshot::note(path, text);
  config::Document document(text, path);
  const Json tree = tree_of(document.tree());
  Json answer;
  try {
    equipment::refuse_other_kind(document, "gurney-item/1");
    answer = answer_of(path);
  } catch (const Error& error) {
    answer["error"] = error.what();
  }
  answer["tree"] = tree;
  return answer;
}

}  // namespace gurney::workbench
