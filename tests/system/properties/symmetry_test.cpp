#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <functional>

#include "engine/base/units.h"
#include "engine/scene/perturbed.h"
#include "tests/system/properties/motions.h"

/// The floor has no preferred direction and no preferred hand.
namespace gurney::properties {
namespace {

constexpr double kDuration = 1.5;  // [s]

Response run(const Scene& scene, const FloorMotion& floor) {
  SimulationSettings settings;
  settings.duration = kDuration;
  settings.settle_time = 0;
  settings.history_step = 0.02;
  return simulate(scene, floor, settings);
}

/// Largest distance between two paths, the second one seen through `back` [m].
double apart(const Response& one, const Response& other,
             const std::function<Vector3(const Vector3&)>& back) {
  const auto &a = one.items[0].history, &b = other.items[0].history;
  RC_ASSERT(a.size() == b.size());
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    largest = std::max(largest, (a[i].displacement - back(b[i].displacement)).norm());
  return largest;
}

/// How far two runs that differ by rounding may be apart.
///
/// Rounding changes forces by some 1e-16 of themselves in each of a run's operations, of which a
/// step has far fewer than 1e6: less than the change of the masses by kPerturbation = 1e-9 whose
/// effect on this very run is `of_masses`. Besides, each step ends with a residual of momentum of at
/// most 1e-9 M g dt, in another direction in each run: a speed of 1e-9 g t and a distance of half
/// 1e-9 g t^2, in either run, and grown as the perturbation of the masses has, which moved the cart
/// by 1e-9 of its path at first.
double tolerance(double of_masses, double path) {
  const double of_residual = 1e-9 * kStandardGravity * kDuration * kDuration;
  const double growth = std::max(1.0, of_masses / (kPerturbation * std::max(path, 1e-3)));
  return of_masses + growth * of_residual;
}

Vector3 unchanged(const Vector3& v) { return v; }

struct Symmetry {
  std::function<void(Scene&)> of_scene;
  std::function<Vector3(const Vector3&)> of_vector, back;
};

void check(const Symmetry& symmetry) {
  Scene scene = scene_of(low_cart());
  scene.items[0].initial.yaw = *between(0, 2 * std::numbers::pi);
  const FloorMotion floor = pulse(1);
  Scene other_scene = scene;
  symmetry.of_scene(other_scene);
  Eigen::Matrix3Xd a = floor.acceleration();
  for (Eigen::Index i = 0; i < a.cols(); ++i) a.col(i) = symmetry.of_vector(a.col(i));
  const Response response = run(scene, floor);
  const double of_masses = apart(response, run(perturbed(scene, 1), floor), unchanged);
  const double found =
      apart(response, run(other_scene, FloorMotion(floor.time_step(), a)), symmetry.back);
  const double path = response.items[0].demands.peak_displacement;
  RC_LOG() << found << " m apart, by the masses " << of_masses << " m, of " << path << " m\n";
  RC_ASSERT(response.outcome == Outcome::kStopped);
  RC_ASSERT(found <= tolerance(of_masses, path));
}

RC_GTEST_PROP(Symmetry, ARotatedRoomGivesARotatedMotion, ()) {
  const double angle = *between(0, 2 * std::numbers::pi);
  const Eigen::AngleAxisd turn(angle, Vector3::UnitZ());
  check({[&](Scene& scene) { scene.items[0].initial.yaw += angle; },
         [&](const Vector3& v) -> Vector3 { return turn * v; },
         [&](const Vector3& v) -> Vector3 { return turn.inverse() * v; }});
}

Vector3 in_mirror(const Vector3& v) { return {v.x(), -v.y(), v.z()}; }

void mirror(Scene& scene) {
  PlacedItem& item = scene.items[0];
  item.initial.yaw = -item.initial.yaw;
  item.model.chassis_center_of_mass = in_mirror(item.model.chassis_center_of_mass);
  for (Caster& caster : item.model.casters) {
    caster.mount = in_mirror(caster.mount);
    caster.heading = -caster.heading;
  }
}

RC_GTEST_PROP(Symmetry, AMirroredRoomGivesAMirroredMotion, ()) {
  check({mirror, in_mirror, in_mirror});
}

}  // namespace
}  // namespace gurney::properties
