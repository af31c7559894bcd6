#include "studies/verification/cases/sliding_block.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "studies/verification/scenes/blocks.h"

namespace gurney::verification {

double SlidingBlock::yaw_inertia() const { return solid_box_inertia(mass, size)(2, 2); }

Scene SlidingBlock::scene(const Vector3& velocity) const {
  Scene scene = blocks::block(mass, size, {.friction = 0});
  scene.items[0].initial.velocity = velocity;
  return scene;
}

Response slide(Findings& findings, const Runner& runner, const Scene& scene, double travel,
               double closure) {
  constexpr double kStep = 0.004;
  const double speed = scene.items[0].initial.velocity.norm();
  Response response = runner(findings, scene, {}, blocks::run_for(travel / speed, kStep, kStep));
  findings.checks.push_back(
      {"closure of the energy account", "", response.quality.energy_closure, 0, closure,
       "a few times (pi/32)^4: a method of second order with 32 steps in "
       "half a period of the contact's spring; of the work of friction half of "
       "1/32, as it begins and ends inside a step"});
  findings.checks.push_back(
      {"impacts", "", static_cast<double>(response.impacts.size()), 1, 0, "it meets one thing"});
  return response;
}

double yaw_rate_at_end(const Response& response, std::size_t item) {
  const auto& history = response.items[item].history;
  const Sample &a = history[history.size() - 2], &b = history.back();
  return (b.yaw - a.yaw) / (b.time - a.time);
}

double longest_contact(double restitution) {
  return (1 + restitution) / (2 * std::sqrt(restitution));
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
