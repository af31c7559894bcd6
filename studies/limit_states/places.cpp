#include "studies/limit_states/places.h"

#include <algorithm>

#include "engine/base/error.h"
#include "engine/config/nearest_name.h"
#include "studies/results/names.h"

namespace gurney::study {
namespace {

template <class Named>
std::vector<std::string> names_in(const std::vector<Named>& list) {
  std::vector<std::string> names;
  for (const Named& each : list) names.push_back(each.name);
  return names;
}

void must_be(const std::string& kind, const std::string& name,
             const std::vector<std::string>& names, const std::string& owner) {
  require(std::ranges::find(names, name) != names.end(),
          owner + " has no " + kind + " '" + name + "'" + config::suggestion(name, names));
}

}  // namespace

Places places_of(const Scene& scene) {
  Places places{item_names(scene), names_in(scene.zones), names_in(scene.tethers), {}};
  for (std::size_t i = 0; i < scene.items.size(); ++i)
    for (const std::string& name : point_names(scene.items[i].model))
      places.points.emplace_back(places.items[i], name);
  return places;
}

void check_names(const LimitState& state, const Places& places, const std::string& owner) {
  const Quantity& quantity = state.quantity;
  if (!state.is_simple()) return;
  if (!quantity.item.empty()) must_be("item", quantity.item, places.items, owner);
  if (quantity.of == Quantity::Of::kZone) must_be("zone", quantity.part, places.zones, owner);
  if (quantity.of == Quantity::Of::kTether) must_be("tether", quantity.part, places.tethers, owner);
  if (quantity.of != Quantity::Of::kPoint) return;
  std::vector<std::string> points;
  for (const auto& [item, point] : places.points)
    if (quantity.item.empty() || quantity.item == item) points.push_back(point);
  must_be("marked point", quantity.part, points, owner);
}

}  // namespace gurney::study
