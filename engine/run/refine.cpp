#include "engine/run/refine.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/run/predictability.h"
#include "engine/run/simulate.h"

namespace gurney {
namespace {

/// By item, whether its motion has a number.
std::vector<bool> judged_items(const Scene& scene, const FloorMotion& floor,
                               const SimulationSettings& settings, const Response& run) {
  std::vector<bool> judged(scene.items.size(), true);
  if (is_failure(run.outcome)) return judged;
  const std::vector<Predictability> found = predictability(scene, floor, settings, run);
  for (std::size_t i = 0; i < found.size(); ++i)
    judged[i] = found[i].verdict != Predictability::Verdict::kChaotic;
  return judged;
}

double largest_change(const Response& run, const Response& finer, const std::vector<bool>& judged) {
  if (is_failure(run.outcome) || is_failure(finer.outcome))
    return std::numeric_limits<double>::infinity();
  double largest = 0;
  for (std::size_t i = 0; i < judged.size(); ++i)
    if (judged[i])
      largest = std::max(largest, peak_change(run.items[i].demands, finer.items[i].demands));
  return largest;
}

}  // namespace

double peak_change(const Demands& run, const Demands& finer) {
  const bool here = run.time_of_overturning >= 0, there = finer.time_of_overturning >= 0;
  if (here != there) return std::numeric_limits<double>::infinity();
  if (here) return std::abs(run.time_of_overturning / finer.time_of_overturning - 1);
  const auto change = [](double a, double b, double least) {
    return std::max(a, b) < least ? 0 : std::abs(a / b - 1);
  };
  return std::max(
      change(run.peak_displacement, finer.peak_displacement, Predictability::kLeastDisplacement),
      change(run.peak_tilt, finer.peak_tilt, Predictability::kLeastTilt));
}

SimulationSettings refined_settings(const SimulationSettings& settings, const Quality& quality) {
  if (settings.peak_error == 0) return settings;
  SimulationSettings result =
      with_steps_times(std::pow(0.5, static_cast<double>(quality.step_halvings)), settings);
  result.peak_error = 0;
  return result;
}

Response refine(const Scene& scene, const FloorMotion& floor, const SimulationSettings& settings) {
  Quality quality;
  SimulationSettings step = refined_settings(settings, quality);
  Response run = simulate(scene, floor, step);
  const std::vector<bool> judged = judged_items(scene, floor, step, run);
  if (std::ranges::find(judged, true) == judged.end()) return run;
  // One small change may be a crossing of errors that are not.
  double before = std::numeric_limits<double>::infinity(), last = before;
  while (std::max(before, last) > 0.5 * settings.peak_error &&
         quality.step_halvings < Quality::kLargestHalvings) {
    ++quality.step_halvings;
    step = refined_settings(settings, quality);
    Response finer = simulate(scene, floor, step);
    before = last;
    last = largest_change(run, finer, judged);
    run = std::move(finer);
  }
  run.quality.step_halvings = quality.step_halvings;
  run.quality.peak_change = std::max(before, last);
  return run;
}

}  // namespace gurney
