#include "studies/explanation/caster_words.h"

#include <cmath>

namespace gurney::explanation {

std::string place_of(const EquipmentModel& item, std::size_t caster) {
  constexpr double kMiddle = 0.02;  // [m]
  Vector3 middle = Vector3::Zero();
  for (const Caster& each : item.casters)
    middle += each.mount / static_cast<double>(item.casters.size());
  const Vector3 from = item.casters.at(caster).mount - middle;
  const std::string along = from.x() > kMiddle ? "front" : from.x() < -kMiddle ? "rear" : "";
  const std::string across = from.y() > kMiddle ? "left" : from.y() < -kMiddle ? "right" : "";
  if (along.empty() && across.empty()) return "middle";
  return along + (along.empty() || across.empty() ? "" : " ") + across;
}

std::string caster_words(const EquipmentModel& item, std::size_t caster) {
  const std::string& name = item.casters.at(caster).name;
  const std::string place = place_of(item, caster);
  if (name.empty()) return place + " caster";
  return name.find(place) != std::string::npos ? name : name + " (" + place + ")";
}

}  // namespace gurney::explanation
