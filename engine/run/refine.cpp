#include "engine/run/refine.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/base/error.h"
#include "engine/response/settled.h"
#include "engine/run/simulate.h"
#include "engine/run/twin.h"
#include "engine/scene/perturbed.h"

namespace gurney {
namespace {

/// By item and number of numbers_of(), whether it has a value; of a run that failed: empty.
using Judged = std::vector<std::vector<bool>>;

/// Items that overturn are judged by the time and direction of that alone.
bool is_asked(const DemandNumber& number, bool overturns) {
  return !overturns || number.is_of_overturning();
}

Judged judged_demands(const Scene& scene, const FloorMotion& floor,
                      const SimulationSettings& settings, const Response& run) {
  Judged judged;
  if (is_failure(run.outcome)) return judged;
  const std::vector<Predictability> found = predictability(scene, floor, settings, run);
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Demands& demands = run.items[i].demands;
    const std::vector<DemandNumber> numbers = numbers_of(demands),
                                    twin = numbers_of(*found[i].twin);
    std::vector<bool>& of_item = judged.emplace_back();
    for (std::size_t k = 0; k < numbers.size(); ++k)
      of_item.push_back(
          found[i].verdict != Predictability::Verdict::kChaotic &&
          is_asked(numbers[k], demands.lies_from() >= 0) && !numbers[k].counts_events() &&
          std::abs(change_between(numbers[k], twin[k])) < Predictability::kChaotic * kPerturbation);
  }
  return judged;
}

bool any_of(const Judged& judged) {
  return judged.empty() || std::ranges::any_of(judged, [](const std::vector<bool>& of_item) {
           return std::ranges::find(of_item, true) != of_item.end();
         });
}

double largest_change(const Response& run, const Response& finer, const Judged& judged) {
  if (is_failure(run.outcome) || is_failure(finer.outcome))
    return std::numeric_limits<double>::infinity();
  double largest = 0;
  for (std::size_t i = 0; i < run.items.size(); ++i)
    largest = std::max(largest, demand_change(run.items[i].demands, finer.items[i].demands,
                                              judged.empty() ? std::vector<bool>{} : judged[i]));
  return largest;
}

}  // namespace

double demand_change(const Demands& run, const Demands& finer, const std::vector<bool>& judged) {
  const std::vector<DemandNumber> from = numbers_of(run), to = numbers_of(finer);
  double largest = 0;
  for (std::size_t k = 0; k < from.size(); ++k)
    if (judged.empty() || judged[k])
      largest = std::max(largest, std::abs(change_between(from[k], to[k])));
  return largest;
}

SimulationSettings refined_settings(SimulationSettings settings, const Quality& quality) {
  lengthen_steps(std::pow(0.5, static_cast<double>(quality.step_halvings)), settings);
  return settings;
}

Response refine(const Scene& scene, const FloorMotion& floor, const SimulationSettings& settings,
                double peak_error) {
  require(peak_error > 0 && peak_error <= 0.1,
          fmt::format("settings: peak_error = {}: must be in [0, 0.1]", peak_error));
  Quality quality;
  SimulationSettings step = refined_settings(settings, quality);
  Response run = simulate(scene, floor, step);
  const Judged judged = judged_demands(scene, floor, step, run);
  if (!any_of(judged)) return run;
  // One small change may be a crossing of errors that are not.
  double before = std::numeric_limits<double>::infinity(), last = before;
  while (std::max(before, last) > 0.5 * peak_error &&
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
