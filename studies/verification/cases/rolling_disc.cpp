#include "studies/verification/scenes/rolling_disc.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "engine/base/units.h"
#include "studies/verification/cases.h"
#include "studies/verification/gravity.h"

// A disc that rolls on its edge without slip, in 3D: scenes/rolling_disc.h has its equations, and
// how the engine carries it.
namespace gurney::verification {
namespace {

constexpr double kStepAngle = 0.01;  // that the disc turns by in a step, h n [rad]

// --- straight

struct Straight {
  double mass, radius, axial, ratio;  // [kg], [m], C / (m r^2), speed over the critical one
  Disc disc() const { return {mass, radius, axial}; }
};

Findings roll_straight(const Straight& c, const Runner& runner) {
  Findings findings;
  // The lean x of a disc that rolls upright at n = v / r and is given a breath of yaw rate:
  //   x = X (1 - cos(sqrt(L) t)),   X = (C + m r^2) n yaw_rate / ((A + m r^2) L);
  //   L < 0: cosh(sqrt(-L) t). It leans by 1e-4 at most: the rest of the sine is 1e-9 of it.
  constexpr double kPhase = 7, kLean = 1e-4;  // a cycle, or a growth by e^7
  const Disc disc = c.disc();
  const double v = c.ratio * disc.critical_speed(), n = v / disc.radius;
  const double stiffness = disc.stiffness(v), lambda = std::sqrt(std::abs(stiffness));
  const double amplitude = stiffness > 0 ? kLean / 2 : -kLean / std::cosh(kPhase);
  const double mr2 = disc.m() * disc.radius * disc.radius;
  const double yaw_rate = amplitude * (disc.A() + mr2) * stiffness / ((disc.C() + mr2) * n);
  const double step = kStepAngle / std::max(n, lambda);
  const int count = static_cast<int>(kPhase / lambda / step);
  const Response response =
      runner(findings, rolling_disc(disc, v, yaw_rate), {}, disc_settings(step, count * step, 1));
  Track lean(
      "lean", "rad",
      "(h n)^2 = 1e-4 of the largest lean for each radian of lambda t, 7: a method of second "
      "order whose rates miss by less");
  for (const Sample& sample : response.items[0].history) {
    const double phase = lambda * sample.time;
    lean.add(sample.time, disc_axle(sample).z(),
             amplitude * (1 - (stiffness > 0 ? std::cos(phase) : std::cosh(phase))),
             kPhase * kStepAngle * kStepAngle * kLean);
  }
  lean.report(findings);
  findings.checks.push_back({"stable", "", stiffness > 0 ? 1. : 0., c.ratio > 1 ? 1. : 0., 0,
                             "above the critical speed, not below"});
  return findings;
}

bool off_critical(const Straight& c) { return std::abs(c.ratio - 1) > 0.015; }

// --- upright, with a weight at its axle

struct Weighted {
  double mass, radius, axial;                  // [kg], [m], C / (m r^2)
  double force = 0.3, lever = 0.4, ratio = 2;  // over m g, r, critical speed
  Disc disc() const { return {mass, radius, axial}; }
};

Findings carry_weight(const Weighted& c, const Runner& runner) {
  Findings findings;
  const Disc disc = c.disc();
  const double force = c.force * disc.m() * kG, lever = c.lever * disc.radius;
  const double v = c.ratio * disc.critical_speed();
  const double rate = force * lever / (v * (disc.C() / disc.radius + disc.m() * disc.radius));
  const double turn = 2 * std::numbers::pi / rate, step = kStepAngle * disc.radius / v;
  Scene scene = rolling_disc(disc, v, rate);
  scene.items[0].loads = {
      PointForce{"weight", {0, lever, disc.radius}, -Vector3::UnitZ(), {0, turn}, {force, force}}};
  const Response response = runner(findings, scene, {}, disc_settings(step, turn, 20));
  const double sink = (disc.m() * kG + force) / (kDiscTread * disc.radius);
  const double radius = v / rate;
  Track off("distance from the circle", "m",
            "2.2 pi (h n)^2 of its radius: a second-order method misses less than (h n)^2 of the "
            "angle, 2 pi");
  Track lean("lean", "rad", "twice what the tread sinks in, (m g + F) / k, over r");
  for (const Sample& sample : response.items[0].history) {
    const double angle = rate * sample.time;
    const Vector3 circle = radius * Vector3(std::sin(angle), 1 - std::cos(angle), 0);
    off.add(sample.time, (sample.points[0].displacement - circle).norm(), 0,
            2.2 * std::numbers::pi * kStepAngle * kStepAngle * radius);
    lean.add(sample.time, disc_axle(sample).z(), 0, 2 * sink);
  }
  off.report(findings);
  lean.report(findings);
  return findings;
}

bool stays_upright(const Weighted& c) { return c.force * c.lever > 0.02; }

// --- turning

struct Turning {
  double mass, radius, axial, speed, yaw_rate;  // [kg], [m], C / (m r^2), [m/s], [rad/s]
  Disc disc() const { return {mass, radius, axial}; }
  DiscReference reference() const {
    return {disc(), Vector3::UnitY(), {0, speed / radius, yaw_rate}};
  }
};

/// Each 0.01 s: the axle's direction and the path of the centre over r.
struct Path {
  std::vector<Vector3> axle, center;
  double closure = 0;  ///< of the energy balance
};

Path run(const Turning& c, double step, double tread, const Runner& runner, Findings& findings) {
  const int stride = static_cast<int>(std::lround(0.01 / step));
  const Response response = runner(findings, rolling_disc(c.disc(), c.speed, c.yaw_rate, tread), {},
                                   disc_settings(step, 1, stride));
  Path path;
  path.closure = response.quality.energy_closure;
  for (const Sample& sample : response.items[0].history) {
    path.axle.push_back(disc_axle(sample));
    path.center.push_back(sample.points[0].displacement / c.radius);
  }
  return path;
}

Path integrated(const Turning& c, std::size_t samples) {
  DiscReference reference = c.reference();
  Path path;
  for (std::size_t i = 0; i < samples; ++i) {
    if (i > 0) reference.advance(0.01);
    path.axle.push_back(reference.axle());
    path.center.push_back(reference.moved() / c.radius);
  }
  return path;
}

double largest(const std::vector<Vector3>& a, const std::vector<Vector3>& b) {
  double most = 0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
    most = std::max(most, (a[i] - b[i]).norm());
  return most;
}

Findings turn(const Turning& c, const Runner& runner) {
  Findings findings;
  constexpr double kStep = 5e-4;
  const Path coarse = run(c, 2 * kStep, kDiscTread, runner, findings),
             fine = run(c, kStep, kDiscTread, runner, findings),
             soft = run(c, kStep, kDiscTread / 2, runner, findings),
             exact = integrated(c, fine.axle.size());
  auto& checks = findings.checks;
  const auto check = [&](const char* quantity, const char* unit, std::vector<Vector3> Path::*of) {
    checks.push_back({quantity, unit, largest(fine.*of, exact.*of), 0,
                      largest(coarse.*of, fine.*of) / 2 + 2 * largest(soft.*of, fine.*of),
                      kDiscTolerance});
  };
  check("axle's direction", "rad", &Path::axle);
  check("path of the centre, over r", "", &Path::center);
  checks.push_back({"energy balance error", "", fine.closure, 0, coarse.closure / 3 + 1e-9,
                    "a third of that with the double step, for a method of second order; rounding, "
                    "1e-9"});
  return findings;
}

/// It leans by 9 to 57 degrees (from 60 on a wheel lies on its side), and turns by at most 1/20 in
/// a step of 1 ms.
bool leans(const Turning& c) {
  DiscReference reference = c.reference();
  double lean = 0, rate = 0;
  for (int i = 0; i < 100; ++i) {
    reference.advance(0.01);
    lean = std::max(lean, std::abs(std::asin(reference.axle().z())));
    rate = std::max(rate, reference.angular_velocity().norm());
    if (!(lean < 57 * kRadiansPerDegree)) return false;
  }
  return lean > 9 * kRadiansPerDegree && rate < 50;
}

std::vector<Parameter> disc_parameters() {
  return {{"mass", "kg", 0.5, 10}, {"radius", "m", 0.05, 0.3}, {"axial", "C over m r^2", 0.45, 1}};
}

}  // namespace

Family disc_straight() {
  const auto p = disc_parameters();
  return make_family<Straight>(
      {"disc_straight", "rolling disc", "A disc that rolls straight wobbles or falls over",
       "x = X (1 - cos(sqrt(L) t)), L = [C (C + m r^2) n^2 / A - m g r] / (A + m r^2)",
       "Routh 1905, Advanced Rigid Dynamics; O'Reilly 1996, Nonlinear Dynamics 10"},
      {{p[0], &Straight::mass},
       {p[1], &Straight::radius},
       {p[2], &Straight::axial},
       {{"ratio", "v over v_crit", 0.5, 2}, &Straight::ratio}},
      {{"disc_12", {1, 0.05, 0.5, 1.2}},
       {"disc_15", {1, 0.05, 0.5, 1.5}},
       {"disc_20", {1, 0.05, 0.5, 2}},
       {"disc_08", {1, 0.05, 0.5, 0.8}},
       {"disc_above", {1, 0.05, 0.5, 1.02}},
       {"disc_below", {1, 0.05, 0.5, 0.98}},
       {"hoop_12", {1, 0.05, 1, 1.2}},
       {"hoop_15", {1, 0.05, 1, 1.5}},
       {"hoop_20", {1, 0.05, 1, 2}},
       {"hoop_08", {1, 0.05, 1, 0.8}},
       {"hoop_above", {1, 0.05, 1, 1.02}},
       {"hoop_below", {1, 0.05, 1, 0.98}},
       {"wheel_above", {8, 0.3, 0.7, 1.3}},
       {"wheel_below", {8, 0.3, 0.7, 0.6}}},
      roll_straight, off_critical);
}

Family disc_weight() {
  const auto p = disc_parameters();
  return make_family<Weighted>(
      {"disc_weight", "rolling disc",
       "A weight at the axle of an upright disc turns it on a circle",
       "F d = Om (C n + m v r), n = v / r", "moment of momentum"},
      {{p[0], &Weighted::mass},
       {p[1], &Weighted::radius},
       {p[2], &Weighted::axial},
       {{"force", "m g", 0.1, 0.6}, &Weighted::force},
       {{"lever", "r", 0.1, 0.6}, &Weighted::lever},
       {{"ratio", "v over v_crit", 1.5, 3}, &Weighted::ratio}},
      {{"disc", {1, 0.05, 0.5}}, {"hoop", {2, 0.1, 1}}, {"wheel", {8, 0.3, 0.7}}}, carry_weight,
      stays_upright);
}

Family disc_turning() {
  const auto p = disc_parameters();
  return make_family<Turning>(
      {"disc_turning", "rolling disc", "A disc with a yaw rate leans out, turns and rises again",
       "d/dt [A w + (C - A) (w . a) a] = -r u x m (dv/dt + g z)",
       "Routh 1905, Advanced Rigid Dynamics; O'Reilly 1996, Nonlinear Dynamics 10"},
      {{p[0], &Turning::mass},
       {p[1], &Turning::radius},
       {p[2], &Turning::axial},
       {{"speed", "m/s", 0.3, 2}, &Turning::speed},
       {{"yaw_rate", "rad/s", -5, 5}, &Turning::yaw_rate}},
      {{"disc_slow_turn", {1, 0.05, 0.5, 0.8, 2}},
       {"disc", {1, 0.05, 0.5, 0.8, 5}},
       {"disc_slow", {1, 0.05, 0.5, 0.5, 2}},
       {"hoop", {1, 0.05, 1, 0.6, 2}},
       {"wheel", {8, 0.3, 0.7, 1.5, 2}},
       {"wheel_fast_turn", {8, 0.3, 0.7, 1.5, 3}},
       {"wheel_slow", {8, 0.3, 0.7, 1.3, 2.5}}},
      turn, leans);
}

}  // namespace gurney::verification
