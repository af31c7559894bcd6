#include "studies/report/fall.h"

#include <algorithm>
#include <cmath>

#include "engine/base/units.h"

namespace gurney::report {
namespace {

/// Whether histories that the settings ask for have a sample at `time`.
bool asked_for(double time, const SimulationSettings& settings) {
  constexpr double kSame = 1e-6;  // of a spacing
  const double spacing =
      settings.time_step *
      static_cast<double>(std::max(1L, std::lround(settings.history_step / settings.time_step)));
  return settings.history_step > 0 && std::abs(std::remainder(time / spacing, 1)) < kSame;
}

double began_to_tip(const ItemResponse& item, double time, const SimulationSettings& settings) {
  constexpr double kStands = 1 * kRadiansPerDegree;
  double stood = time;
  for (const Sample& sample : item.history)
    if (sample.time < time && sample.tilt < kStands && asked_for(sample.time, settings))
      stood = sample.time;
  return stood;
}

std::vector<Fall::Liftoff> liftoffs_of(const Demands& demands, const EquipmentModel& item) {
  std::vector<Fall::Liftoff> result;
  for (std::size_t w = 0; w < demands.wheels.size(); ++w)
    if (demands.wheels[w].liftoff_before_overturning >= 0)
      result.push_back({item.casters.at(w).name, demands.wheels[w].liftoff_before_overturning});
  std::ranges::stable_sort(result, {}, &Fall::Liftoff::time);
  return result;
}

}  // namespace

std::vector<Fall> falls(const study::RunFacts& facts, const Response& response) {
  std::vector<Fall> result;
  if (is_failure(response.outcome)) return result;
  for (std::size_t i = 0; i < response.items.size(); ++i) {
    const Demands& d = response.items[i].demands;
    if (d.time_of_overturning < 0) continue;
    Fall fall{i,
              d.time_of_overturning,
              d.direction_of_overturning,
              liftoffs_of(d, facts.scene.items.at(i).model),
              0,
              {}};
    fall.start = fall.liftoffs.empty() ? began_to_tip(response.items[i], fall.time, facts.settings)
                                       : fall.liftoffs.front().time;
    if (std::isfinite(fall.direction))
      fall.half_cycle = driving_half_cycle(
          facts.floor, -Vector2(std::cos(fall.direction), std::sin(fall.direction)), fall.start,
          fall.time);
    result.push_back(fall);
  }
  return result;
}

}  // namespace gurney::report
