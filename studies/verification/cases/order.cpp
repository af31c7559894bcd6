#include <cmath>
#include <functional>

#include "studies/verification/family.h"
#include "studies/verification/scenes/small_scenes.h"

// The method is of second order on smooth problems (docs/theory/solver.md).
namespace gurney::verification {
namespace {

constexpr double kStep = 0.002;
const char* const kWhy =
    "terms of third order move it by about h times a rate of the problem, below 0.25; a "
    "first-order "
    "method shows 1";
const char* const kOrder = "log2 |y_h - y_h/2| / |y_h/2 - y_h/4| = 2";
const char* const kSource = "Richardson's extrapolation";

/// The order of `quantity` from runs with steps of 2, 1 and 0.5 ms.
void add_order(const std::string& quantity, const std::function<double(double step)>& run,
               Findings& findings) {
  const double a = run(kStep), b = run(kStep / 2), c = run(kStep / 4);
  findings.checks.push_back(
      {"order of " + quantity, "", std::log2(std::abs(a - b) / std::abs(b - c)), 2, 0.25, kWhy});
}

struct Towed {
  double heading;  // [deg]
};

Findings towed(const Towed& c, const Runner& runner) {
  Findings findings;
  Tread tread = small::bare_tread(3e7, 1e7);
  tread.tangential_damping = 100;
  tread.static_friction = tread.kinetic_friction = 5;
  add_order(
      "the swivel angle",
      [&](double step) {
        const Scene scene = small::towed_caster(1, 0.034, c.heading, tread);
        return runner(findings, scene, {}, small::settings_for(step, 0.048))
            .items[0]
            .history.back()
            .wheels[0]
            .swivel_angle;
      },
      findings);
  return findings;
}

struct Heave {
  double speed;  // [m/s]
};

Findings heave(const Heave& c, const Runner& runner) {
  Findings findings;
  Scene scene = scene_of(small::trolley({0, 0, 0, 0}, small::bare_tread(3e5, 1e5)));
  scene.items[0].initial.velocity = {0, 0, c.speed};
  add_order(
      "the height",
      [&](double step) {
        return runner(findings, scene, {}, small::settings_for(step, 0.064))
            .items[0]
            .history.back()
            .displacement.z();
      },
      findings);
  return findings;
}

struct Turning {
  double speed, yaw_rate;  // [m/s], [rad/s]
};

Findings turning(const Turning& c, const Runner& runner) {
  Findings findings;
  Scene scene = scene_of({});
  Tread tread = small::bare_tread(3e5, 1e5);
  tread.normal_damping = 500;
  tread.tangential_damping = 50;
  tread.static_friction = tread.kinetic_friction = 5;
  scene.items[0].model = small::trolley({20, 60, -30, 100}, tread);
  scene.items[0].initial.velocity = {c.speed, c.speed / 3, 0};
  scene.items[0].initial.yaw_rate = c.yaw_rate;
  const auto run = [&](double step) {
    return runner(findings, scene, {}, small::settings_for(step, 0.8)).items[0].history.back();
  };
  add_order(
      "x", [&](double h) { return run(h).displacement.x(); }, findings);
  add_order(
      "y", [&](double h) { return run(h).displacement.y(); }, findings);
  add_order(
      "yaw", [&](double h) { return run(h).yaw; }, findings);
  return findings;
}

}  // namespace

Family order_towed() {
  Family family = make_family<Towed>(
      {"order_towed", "method", "Order of convergence of a towed caster", kOrder, kSource},
      {{{"heading", "deg", 20, 140}, &Towed::heading}}, {{"40", {40}}, {"120", {120}}}, towed);
  family.drawn = false;  // an error that happens to pass through zero has no order
  return family;
}

Family order_heave() {
  Family family = make_family<Heave>(
      {"order_heave", "method", "Order of convergence of a heaving trolley", kOrder, kSource},
      {{{"speed", "m/s", 0.005, 0.02}, &Heave::speed}}, {{"plain", {0.01}}}, heave);
  family.drawn = false;
  return family;
}

Family order_turning() {
  Family family =
      make_family<Turning>({"order_turning", "method",
                            "Order of convergence of a coasting, turning trolley", kOrder, kSource},
                           {{{"speed", "m/s", 0.1, 0.5}, &Turning::speed},
                            {{"yaw_rate", "rad/s", 0, 1}, &Turning::yaw_rate}},
                           {{"plain", {0.3, 0.5}}}, turning);
  family.drawn = false;
  return family;
}

}  // namespace gurney::verification
