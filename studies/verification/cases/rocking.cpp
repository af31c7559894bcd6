#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "studies/verification/cases.h"
#include "studies/verification/cases/rocking_body.h"
#include "studies/verification/gravity.h"
#include "studies/verification/scenes/blocks.h"
#include "studies/verification/scenes/scenes.h"

// A block that a half sine sets rocking: how long it swings and what an impact leaves.
namespace gurney::verification {
namespace {

using std::numbers::pi;
constexpr double kStep = 1e-3;  // [s]

struct Rocking {
  double alpha, radius, inertia;  // [rad], [m], I_O / (M R^2)
  double ratio, strength;         // omega / p, a / (alpha g)

  RockingBody body() const { return {alpha, radius, inertia}; }
  double length() const { return pi / (ratio * body().block().p); }
  double acceleration(double t) const {
    return t < length() ? strength * alpha * kG * std::sin(pi * t / length()) : 0;
  }
};

/// Tops of the tilt after the pulse.
struct Tops {
  std::vector<double> tilt, time;
};

Tops tops(const Rocking& c, const std::vector<Sample>& h) {
  Tops found;
  for (std::size_t i = 1; i + 1 < h.size(); ++i)
    if (h[i].time > c.length() && h[i].tilt > h[i - 1].tilt && h[i].tilt >= h[i + 1].tilt &&
        h[i].tilt > 0.1 * c.alpha) {
      found.tilt.push_back(h[i].tilt);
      found.time.push_back(h[i].time);
    }
  return found;
}

Findings rock(const Rocking& c, const Runner& runner) {
  Findings findings;
  const RockingBody body = c.body();
  const RockingBlock block = body.block();
  const FloorMotion floor = scenes::floor_motion(kStep, c.length(), Vector3::UnitX(),
                                                 [&](double t) { return c.acceleration(t); });
  SimulationSettings settings = blocks::run_for(c.length() + 8 / block.p, kStep, kStep);
  settings.follow_overturning = false;
  const Response response = runner(findings, body.scene(), floor, settings);
  const Tops found = tops(c, response.items[0].history);
  auto& checks = findings.checks;
  const auto energy = [&](double tilt) {
    return std::cos(block.alpha - tilt) - std::cos(block.alpha);
  };
  const double sink = RockingBody::kMass * kG / (2 * RockingBody::kStiffness) / c.radius;
  const auto count = std::min<std::size_t>(found.tilt.size(), 4);
  if (count < 2)
    checks.push_back({"swings above 0.1 alpha", "", static_cast<double>(count), 2, 0,
                      "two at least, to compare them"});
  for (std::size_t n = 0; n + 1 < count; ++n) {
    const std::string which = ", impact " + std::to_string(n + 1);
    const double after = energy(found.tilt[n + 1]);
    checks.push_back(
        {"angular velocity after over before" + which, "", std::sqrt(after / energy(found.tilt[n])),
         block.eta, body.eta_error() + sink / after,
         "e (1 - eta) for an edge that rebounds with e = 0.01; the edges sink by W / 2 "
         "k, over the height of the swing"});
    checks.push_back(
        {"time between tops" + which, "s", found.time[n + 1] - found.time[n],
         quarter_period(block, found.tilt[n]) + quarter_period(block, found.tilt[n + 1]),
         2 * kStep + 2 * body.loading_time(),
         "samples of 1 ms, two; an edge unloads and one loads, pi/2 sqrt(M / k) each"});
  }
  checks.push_back({"energy balance error", "", response.quality.energy_closure, 0, 0.01,
                    "1 %: 32 steps in the loading of an edge lose (pi/32)^2 of what it takes"});
  return findings;
}

/// It swings to between 0.4 and 0.9 alpha, and so for a while, and does not fall.
bool swings(const Rocking& c) {
  RockingReference r(c.body().block());
  double highest = 0;
  for (double t = 0; t < c.length() + 8 / c.body().block().p; t += 0.01) {
    r.advance([&](double s) { return c.acceleration(s); }, 0.01);
    if (t > c.length()) highest = std::max(highest, std::abs(r.theta()));
  }
  return !r.fallen() && highest > 0.4 * c.alpha && highest < 0.9 * c.alpha;
}

}  // namespace

Family rocking() {
  return make_family<Rocking>(
      {"rocking", "blocks", "A block rocks freely after a half sine of the floor",
       "eta = 1 - 2 M R^2 sin(alpha)^2 / I_O; theta'' = -p^2 sin(alpha - theta), p^2 = M g R / I_O",
       "Housner 1963, Bull. Seism. Soc. Am. 53"},
      {{{"alpha", "rad", 0.15, 0.4}, &Rocking::alpha},
       {{"radius", "m", 0.4, 2}, &Rocking::radius},
       {{"inertia", "I_O over M R^2", 1.15, 1.6}, &Rocking::inertia},
       {{"ratio", "omega over p", 3, 12}, &Rocking::ratio},
       {{"strength", "a over alpha g", 1.5, 8}, &Rocking::strength}},
      {{"slender", {0.245, 0.618, 4.0 / 3, 4, 2.2}},
       {"stocky", {0.322, 0.79, 4.0 / 3, 4, 2.2}},
       {"tall", {0.25, 1.749, 1.224175, 6, 3.5}},
       {"small", {0.25, 0.7, 4.0 / 3, 6, 3.5}},
       {"very_slender", {0.2, 1, 4.0 / 3, 6, 3.5}},
       {"broad", {0.33, 0.9, 1.5, 6, 3.5}}},
      rock, swings);
}

}  // namespace gurney::verification
