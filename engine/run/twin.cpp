#include "engine/run/twin.h"

#include <algorithm>
#include <cmath>

#include "engine/run/simulate.h"
#include "engine/scene/perturbed.h"

namespace gurney {
namespace {

constexpr double kLeastDisplacement = Predictability::kLeastDisplacement,
                 kLeastTilt = Predictability::kLeastTilt, kLeastYaw = Predictability::kLeastYaw;

double time_of_peaks(const Demands& d) {
  if (d.time_of_overturning >= 0) return d.time_of_overturning;
  const bool moves = d.peak_displacement >= kLeastDisplacement, tilts = d.peak_tilt >= kLeastTilt;
  return std::max(moves ? d.time_of_peak_displacement : 0, tilts ? d.time_of_peak_tilt : 0);
}

/// s of docs/theory/predictability.md.
class Separation {
 public:
  explicit Separation(const Demands& d)
      : displacement_(std::max(d.peak_displacement, kLeastDisplacement)),
        tilt_(std::max(d.peak_tilt, kLeastTilt)),
        yaw_(std::max(d.peak_yaw, kLeastYaw)) {}

  double of(const Sample& a, const Sample& b) const {
    const double moved = (a.displacement - b.displacement).head<2>().norm();
    return std::max(
        {moved / displacement_, std::abs(a.tilt - b.tilt) / tilt_, std::abs(a.yaw - b.yaw) / yaw_});
  }

 private:
  double displacement_, tilt_, yaw_;
};

Predictability::Verdict verdict_of(double amplification) {
  using Verdict = Predictability::Verdict;
  if (!(amplification < Predictability::kChaotic)) return Verdict::kChaotic;
  return amplification < Predictability::kSensitive ? Verdict::kPredictable : Verdict::kSensitive;
}

Predictability of_item(const ItemResponse& run, const ItemResponse& twin) {
  Predictability result;
  result.twin = twin.demands;
  result.time_of_peaks = time_of_peaks(run.demands);
  const Separation separation(run.demands);
  for (std::size_t k = 0; k < run.history.size(); ++k) {
    const Sample& sample = run.history[k];
    const Sample& other = twin.history[std::min(k, twin.history.size() - 1)];  // rests from there
    const double grown = separation.of(sample, other) / kPerturbation;
    result.amplification = std::max(result.amplification, grown);
    if (sample.time <= result.time_of_peaks) result.amplification_at_peaks = result.amplification;
    if (std::isnan(result.horizon) && !(grown < Predictability::kSensitive))
      result.horizon = sample.time;
  }
  const bool one_overturns =
      (run.demands.time_of_overturning >= 0) != (twin.demands.time_of_overturning >= 0);
  result.verdict =
      one_overturns ? Predictability::Verdict::kChaotic : verdict_of(result.amplification_at_peaks);
  return result;
}

}  // namespace

std::vector<Predictability> compare_twin(const Response& run, const Response& twin) {
  std::vector<Predictability> result;
  for (std::size_t i = 0; i < run.items.size(); ++i)
    result.push_back(of_item(run.items[i], twin.items[i]));
  return result;
}

std::vector<Predictability> predictability(const Scene& scene, const FloorMotion& floor,
                                           SimulationSettings settings, const Response& run) {
  if (settings.history_step == 0) {
    settings.history_step = SimulationSettings().history_step;
    return predictability(scene, floor, settings, simulate(scene, floor, settings));
  }
  const Response twin = twin_run(scene, floor, settings);
  if (is_failure(twin.outcome)) return {};
  return compare_twin(run, twin);
}

Response twin_run(const Scene& scene, const FloorMotion& floor,
                  const SimulationSettings& settings) {
  return simulate(perturbed(scene, 1), floor, settings);
}

Response half_step_run(const Scene& scene, const FloorMotion& floor,
                       const SimulationSettings& settings) {
  SimulationSettings finer = settings;
  lengthen_steps(0.5, finer);
  finer.history_step = 0;
  return simulate(scene, floor, finer);
}

void add_half_step(const Response& half, std::vector<Predictability>& of_items) {
  if (is_failure(half.outcome)) return;
  for (std::size_t i = 0; i < of_items.size(); ++i) of_items[i].half_step = half.items[i].demands;
}

}  // namespace gurney
