#include "engine/run/twin.h"

#include <algorithm>
#include <cmath>

#include "engine/response/settled.h"
#include "engine/run/simulate.h"
#include "engine/scene/perturbed.h"

namespace gurney {
namespace {

constexpr double kLeastDisplacement = Predictability::kLeastDisplacement,
                 kLeastTilt = Predictability::kLeastTilt, kLeastYaw = Predictability::kLeastYaw;

double time_of_peaks(const Demands& d) {
  if (d.lies_from() >= 0) return d.lies_from();
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
  const bool one_overturns = (run.demands.lies_from() >= 0) != (twin.demands.lies_from() >= 0);
  result.verdict =
      one_overturns ? Predictability::Verdict::kChaotic : verdict_of(result.amplification_at_peaks);
  return result;
}

/// Radius of the circle about its origin that holds an item in the plan, lying or standing [m].
double radius_of(const EquipmentModel& model, bool lies) {
  double radius = 0;
  for (const BodyShape& shape : model.shape)
    for (const Vector3& point : outline_points(shape))
      radius = std::max(radius, lies ? point.norm() : point.head<2>().norm());
  return radius;
}

/// How far places of an item change with half the step [m].
double change_of_place(const Demands& run, const Demands& half) {
  return std::max({std::abs(run.peak_displacement - half.peak_displacement),
                   std::abs(run.peak_displacement_x - half.peak_displacement_x),
                   std::abs(run.peak_displacement_y - half.peak_displacement_y),
                   std::abs(run.residual_displacement_x - half.residual_displacement_x),
                   std::abs(run.residual_displacement_y - half.residual_displacement_y)});
}

/// Least distance of two items' circles in a run; a bound from their peaks where it has no history [m].
double least_gap(const Scene& scene, const Response& run, std::size_t i, std::size_t j) {
  const ItemResponse &a = run.items[i], &b = run.items[j];
  const auto radius = [&](std::size_t k) {
    return radius_of(scene.items[k].model, run.items[k].demands.lies_from() >= 0);
  };
  const Vector2 from =
      (scene.items[i].initial.position - scene.items[j].initial.position).head<2>();
  double distance = from.norm() - a.demands.peak_displacement - b.demands.peak_displacement;
  const std::size_t samples = std::min(a.history.size(), b.history.size());
  for (std::size_t k = 0; k < samples; ++k) {
    const Vector2 apart = from + (a.history[k].displacement - b.history[k].displacement).head<2>();
    distance = k == 0 ? apart.norm() : std::min(distance, apart.norm());
  }
  return distance - radius(i) - radius(j);
}

/// Whether errors of the time step may decide that two items meet or how. Bodies of one mechanism do not touch,
/// and an item that stands on another acts on it all the time, which its own changes show.
bool may_meet(const Scene& scene, const Response& run, const Response& half, std::size_t i,
              std::size_t j) {
  const auto carries = [&](std::size_t below, std::size_t above) {
    const std::optional<Support>& on = scene.items[above].on;
    return on && on->kind == Support::Kind::kItem && on->index == below;
  };
  if (root_of(scene, i) == root_of(scene, j) || carries(i, j) || carries(j, i)) return false;
  const auto change = [&](std::size_t k) {
    return change_of_place(run.items[k].demands, half.items[k].demands);
  };
  return least_gap(scene, run, i, j) < SettledDemand::kMargin * (change(i) + change(j));
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

void add_half_step(const Scene& scene, const Response& run, const Response& half,
                   std::vector<Predictability>& of_items) {
  if (is_failure(half.outcome)) return;
  const std::size_t count = of_items.size();
  for (std::size_t i = 0; i < count; ++i) of_items[i].half_step = half.items[i].demands;
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = 0; j < count; ++j)
      if (i != j && may_meet(scene, run, half, i, j))
        of_items[i].change_of_neighbours =
            std::max(of_items[i].change_of_neighbours,
                     change_of_a_quarter(run.items[j].demands, of_items[j]));
}

}  // namespace gurney
