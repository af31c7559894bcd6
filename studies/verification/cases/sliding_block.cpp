#include "studies/verification/cases/sliding_block.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "engine/base/units.h"
#include "engine/solver/quadrature.h"
#include "studies/verification/scenes/blocks.h"

namespace gurney::verification {

ImpactSteps::ImpactSteps(double mass, double mass_at_point, double points, double near)
    : phase(std::numbers::pi / kStepsInImpact * std::sqrt(points / near * mass_at_point / mass)) {}

double ImpactSteps::speed_error() const { return std::pow(kSdirkGamma * phase, 2); }

double SlidingBlock::effective_mass(const Vector3& point, const Vector3& direction) const {
  const Vector3 arm = point.cross(direction);
  return 1 / (1 / mass + arm.dot(solid_box_inertia(mass, size).inverse() * arm));
}

ImpactSteps SlidingBlock::front_steps() const {
  return {mass, effective_mass(0.5 * size, Vector3::UnitX()), 4, 4 + kFloorPoints};
}

double SlidingBlock::yaw_inertia() const { return solid_box_inertia(mass, size)(2, 2); }

Scene SlidingBlock::scene(const Vector3& velocity) const {
  Scene scene = blocks::block(mass, size, {.friction = 0});
  scene.items[0].initial.velocity = velocity;
  return scene;
}

Expected closes_over(double time, double speed) {
  return near_to(0, 2e-9 * kStandardGravity * time / speed,
                 "residual of the solve, 1e-9 M g h of momentum in a step of h, over M v / 2");
}

Response slide(Runner& runner, const Scene& scene, double travel) {
  constexpr double kStep = 0.004;
  const double speed = scene.items[0].initial.velocity.norm();
  Response response = runner(scene, {}, blocks::run_for(travel / speed, kStep, kStep));
  runner.check("impacts", "", response.impacts.size(), exactly(1, "it meets one thing"));
  runner.check("energy balance error", "", response.quality.energy_closure,
               closes_over(travel / speed, speed));
  return response;
}

double yaw_rate_at_end(const Response& response, std::size_t item) {
  const Sample& end = response.items[item].history.back();
  const Vector3 faster = end.points[1].velocity - end.points[0].velocity;  // of a point 1 m ahead
  return faster.dot(end.orientation * Vector3::UnitY());
}

CappedDamping::CappedDamping(double omega, double zeta) {
  const double fast = std::sqrt(2.0) * omega, c_over_k = 2 * zeta / omega;
  const double t1 = std::atan(fast * c_over_k) / fast;
  const double d1 = std::sin(fast * t1) / fast, v1 = std::cos(fast * t1);
  const double wd = omega * std::sqrt(1 - zeta * zeta);
  const double b = (v1 + zeta * omega * d1) / wd;
  const auto at = [&](double t) {
    const double decay = std::exp(-zeta * omega * t), c = std::cos(wd * t), s = std::sin(wd * t);
    const double d = decay * (d1 * c + b * s);
    const double v = -zeta * omega * d + decay * wd * (b * c - d1 * s);
    return std::pair(d, v);
  };
  double low = 0, high = std::numbers::pi / wd;
  for (int i = 0; i < 100; ++i) {
    const double t = 0.5 * (low + high);
    const auto [d, v] = at(t);
    (d + c_over_k * v > 0 ? low : high) = t;
  }
  restitution = -at(low).second;
  duration = t1 + low;
  peak = 2 * omega * omega * d1;
  constexpr int kParts = 2000;
  for (int i = 0; i < kParts; ++i) {
    const auto [d, v] = at(low * i / kParts);
    peak = std::max(peak, omega * omega * (d + c_over_k * v));
  }
}

}  // namespace gurney::verification
