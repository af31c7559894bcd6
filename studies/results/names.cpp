#include "studies/results/names.h"

#include "engine/base/names.h"

namespace gurney::study {

std::vector<std::string> item_names(const Scene& scene) {
  std::vector<std::string> names;
  for (const PlacedItem& item : scene.items)
    names.push_back(item.name.empty() ? item.model.name : item.name);
  return names;
}

std::vector<std::string> caster_names(const EquipmentModel& model) {
  return names_of(model.casters);
}

std::vector<std::string> point_names(const EquipmentModel& model) {
  return names_of(model.marked_points);
}

std::string part_of(const DemandNumber& number, const EquipmentModel& model) {
  switch (number.of) {
    case DemandNumber::Of::kItem:
      break;
    case DemandNumber::Of::kWheel:
      return model.casters.at(number.part).name;
    case DemandNumber::Of::kPoint:
      return model.marked_points.at(number.part).name;
  }
  return "";
}

}  // namespace gurney::study
