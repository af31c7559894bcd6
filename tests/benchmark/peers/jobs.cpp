#include "tests/benchmark/peers/jobs.h"

#include <limits>

#include "engine/run/twin.h"
#include "tests/benchmark/regimes.h"

namespace gurney::benchmark {
namespace {

using peers::CrossCheck;

constexpr double kPeak = 0.4, kLockedPeak = 0.8;  // of the motions of the trolley [g]
constexpr double kClearance = 0.15;               // between its sides and the walls [m]
constexpr double kTwinStep = 0.001;               // [s]

void simplify(Scene& scene) {
  for (Caster& caster : scene.items[0].model.casters) {
    caster.tread.static_friction = caster.tread.kinetic_friction;
    caster.tread.patch_width = 0;
    caster.axle = caster.swivel = {};
    if (caster.brake_torque > 0) caster.brake_torque = std::numeric_limits<double>::infinity();
  }
}

void lock(Caster& caster) {
  caster.brake_torque = std::numeric_limits<double>::infinity();
  caster.swivels = false;
}

/// Around the chassis alone, above the wheels.
void add_walls(CrossCheck& check) {
  constexpr double kThickness = 0.2, kLength = 6, kBottom = 0.2, kHeight = 2;
  const BodyShape& box = check.scene.items[0].model.shape[0];
  for (int axis = 0; axis < 2; ++axis)
    for (const double side : {1.0, -1.0}) {
      const double inner = 0.5 * box.size[axis] + kClearance;
      Vector3 center(0, 0, kBottom + 0.5 * kHeight), size(kLength, kLength, kHeight);
      center[axis] = side * (inner + 0.5 * kThickness);
      size[axis] = kThickness;
      check.scene.room.push_back({"wall " + std::to_string(check.walls.size() + 1), "", center,
                                  Quaternion::Identity(), RoomBox{size}});
      check.walls.push_back({-side * Vector3::Unit(axis), -inner});
    }
}

bool predictable(const CrossCheck& check) {
  const Scene scene = with_rigid_treads(check.scene);
  const SimulationSettings settings{
      .time_step = kTwinStep, .duration = kDuration, .history_step = kSampling};
  const auto found =
      predictability(scene, check.floor, settings, simulate(scene, check.floor, settings));
  return !found.empty() && found[0].verdict == Predictability::Verdict::kPredictable;
}

CrossCheck free_trolley() {
  CrossCheck check;
  check.scene = trolley({10, 100, 200, 300});
  check.duration = kDuration;
  check.sampling = kSampling;
  return check;
}

Job predictable_job(const std::string& name, CrossCheck check, double peak, int motions) {
  Job job{name, {}, {}};
  simplify(check.scene);
  for (unsigned seed = 1; static_cast<int>(job.runs.size()) < motions && seed <= 100; ++seed) {
    check.floor = shaking(seed, peak);
    if (!predictable(check)) continue;
    job.seeds.push_back(seed);
    job.runs.push_back(check);
  }
  return job;
}

}  // namespace

Scene with_rigid_treads(const Scene& scene) {
  Scene rigid = scene;
  make_rigid(rigid, kRigid, kRigidTangential);
  return rigid;
}

Job free_trolley_job(int motions) {
  return predictable_job("free trolley", free_trolley(), kPeak, motions);
}

Job half_locked_job(int motions) {
  CrossCheck check = free_trolley();
  for (const std::size_t i : {0, 1}) lock(check.scene.items[0].model.casters[i]);
  return predictable_job("half-locked cart", check, kLockedPeak, motions);
}

std::vector<Job> smooth_jobs(int motions) {
  CrossCheck walls = free_trolley();
  add_walls(walls);
  return {free_trolley_job(motions), half_locked_job(motions),
          predictable_job("trolley between walls", walls, kPeak, motions)};
}

Job rocking_job(int motions) {
  const Regime regime{"braked, strong motion", 4, 0.4, 0.8, false};
  Job job{"braked ventilator that rocks", {}, {}};
  CrossCheck check;
  check.scene = scene_of_regime(regime);
  simplify(check.scene);
  check.duration = kDuration;
  check.sampling = kSampling;
  for (int k = 0; k < motions; ++k) {
    check.floor = motion_of_regime(regime, k, motions);
    job.seeds.push_back(static_cast<unsigned>(k + 1));
    job.runs.push_back(check);
  }
  return job;
}

}  // namespace gurney::benchmark
