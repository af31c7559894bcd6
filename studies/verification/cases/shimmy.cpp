#include <Eigen/LU>
#include <cmath>
#include <complex>
#include <numbers>

#include "engine/base/linear_algebra.h"
#include "engine/base/units.h"
#include "studies/verification/family.h"
#include "studies/verification/scenes/small_scenes.h"

// Shimmy of a caster whose pivot is led along x at v and held across by a spring k. Caster of mass
// m, its centre of mass a behind the pivot, yaw inertia Ic about it, trail L; the pivot carries a
// mass M. With the pivot at y, the heading theta and the lateral force F of the floor
//
//     (M + m) y'' - m a theta'' = F - k y,     (Ic + m a^2) theta'' - m a y'' = -L F
//
// and a wheel that does not slip sideways, y' = L theta' + v theta. Without F and y:
//
//     [Ic + m (L - a)^2 + M L^2] theta''' + [m (L - a) + M L] v theta'' + k L^2 theta'
//                                                                            + k L v theta = 0
//
// By Routh it is stable if Ic < m a (L - a), for every k, v and also M: the terms of M cancel. The
// spin of the wheel gives a moment I_w (v / R) theta' about x only, which the guide of the pivot
// takes.
namespace gurney::verification {
namespace {

constexpr double kTread = 1e9, kStart = 1e-4;
constexpr int kCount = 600, kSettled = 80;  // steps of a run, and of these those not looked at

struct Pivot {
  double mass, trail, center;  // m, L, a
  double inertia;              // Ic / (m a (L - a))
  double spring, speed;        // k, v
  double pivot_mass;           // M
};

double inertia_of(const Pivot& c) { return c.inertia * c.mass * c.center * (c.trail - c.center); }

/// (theta, theta', theta'')' = A (...)
Eigen::MatrixXd rigid_wheel(const Pivot& c) {
  const double l = c.trail, b = l - c.center, m = c.mass;
  const double leading = inertia_of(c) + m * b * b + c.pivot_mass * l * l;
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(3, 3);
  a(0, 1) = a(1, 2) = 1;
  a.row(2) << -c.spring * l * c.speed / leading, -c.spring * l * l / leading,
      -(m * b + c.pivot_mass * l) * c.speed / leading;
  return a;
}

/// (y, theta, y', theta', e)' = A (...) with a tread of stiffness kTread that is deflected by e:
/// e' = y' - L theta' - v theta, F = -kTread e.
Eigen::MatrixXd elastic_tread(const Pivot& c) {
  const double l = c.trail;
  Matrix2 mass;
  mass << c.pivot_mass + c.mass, -c.mass * c.center, -c.mass * c.center,
      inertia_of(c) + c.mass * c.center * c.center;
  const Matrix2 compliance = mass.inverse();
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(5, 5);
  a(0, 2) = a(1, 3) = 1;
  a.block<2, 1>(2, 0) = compliance * Vector2(-c.spring, 0);
  a.block<2, 1>(2, 4) = compliance * Vector2(-kTread, l * kTread);
  a.row(4) << 0, -c.speed, 1, -l, 0;
  return a;
}

/// Of the exponents of a real system the one that oscillates with less than 1000 rad/s.
std::complex<double> oscillation(const Eigen::VectorXcd& exponents) {
  std::complex<double> found = 0;
  for (const auto& e : exponents)
    if (e.imag() > found.imag() && e.imag() < 1000) found = e;
  return found;
}

Caster caster_of(const Pivot& c, Caster caster) {
  caster.tread.relaxation_length = 1e9;
  caster.wheel_mass = 0.05 * c.mass;
  caster.wheel_axial_inertia = 0.02 * inertia_of(c);
  caster.wheel_transverse_inertia = 0.02 * inertia_of(c);
  caster.fork_mass = c.mass - caster.wheel_mass;
  const double center = (c.mass * c.center - caster.wheel_mass * c.trail) / caster.fork_mass;
  caster.fork_center_of_mass = {-center, 0, -0.05};
  const double yaw = inertia_of(c) - caster.wheel_transverse_inertia -
                     caster.wheel_mass * std::pow(c.trail - c.center, 2) -
                     caster.fork_mass * std::pow(center - c.center, 2);
  caster.fork_inertia = yaw * Matrix3::Identity();
  return caster;
}

std::vector<double> swivel_angles(const Pivot& c, double step, const Runner& runner,
                                  Findings& findings) {
  Scene scene = small::towed_caster(c.speed, c.trail, kStart / kRadiansPerDegree,
                                    small::bare_tread(1e6, kTread));
  scene.items[0].fixture.guides[1] = {Guide::Kind::kSpring, 0, c.spring, 0};
  // At the critical inertia the start alone moves the pivot by nothing: a push does.
  const double force = kStart * c.trail * c.spring;
  scene.items[0].loads = {
      PointForce{"push", {0, 0, 0.15}, {0, 1, 0}, {0, 0.5 * kSettled * step}, {force, force}}};
  EquipmentModel& item = scene.items[0].model;
  item.chassis_mass = c.pivot_mass;
  item.chassis_center_of_mass = {0, 0, 0.15};
  item.chassis_inertia = 0.01 * c.pivot_mass * Matrix3::Identity();
  item.casters[0] = caster_of(c, item.casters[0]);
  auto settings = small::settings_for(step, kCount * step);
  settings.residual = 1e-12;  // the forces of the start are 1e-4 of the weight
  const Response response = runner(findings, scene, {}, settings);
  std::vector<double> angles;
  for (const Sample& sample : response.items[0].history)
    angles.push_back(sample.wheels[0].swivel_angle);
  return angles;
}

/// Steps for which the method's own error is 0.02 % of |lambda|.
double step_of(const Pivot& c) { return 0.03 / std::abs(oscillation(eigenvalues(rigid_wheel(c)))); }

Findings shake(const Pivot& c, const Runner& runner) {
  Findings findings;
  const auto exact = oscillation(eigenvalues(rigid_wheel(c)));
  const auto elastic = oscillation(eigenvalues(elastic_tread(c)));
  const double step = step_of(c);
  const auto method = oscillation(
      Eigen::VectorXcd(eigenvalues(small::sdirk_step(rigid_wheel(c), step)).array().log() / step));
  std::vector<double> angles = swivel_angles(c, step, runner, findings);
  angles.erase(angles.begin(), angles.begin() + kSettled);  // the push is over
  const auto found = oscillation(small::exponents(angles, step, 3));
  double largest = 0;
  for (const double angle : angles) largest = std::max(largest, std::abs(angle));
  const double rest = std::abs(elastic - exact) + (1e-5 + largest * largest / 40) * std::abs(exact);
  const char* const why =
      "what the method makes of it, |log R(h lambda) / h - lambda|, and a tread of 1e9 N/m; "
      "1e-5 |lambda| and theta^2/40 of it for cubic terms";
  if (std::abs(c.inertia - 1) > 1e-3)
    findings.checks.push_back({"grows (1) or decays (0), by the cubic", "",
                               exact.real() > 0 ? 1.0 : 0.0, c.inertia > 1 ? 1.0 : 0.0, 0,
                               "Routh: grows if Ic > m a (L - a)"});
  findings.checks.push_back({"growth rate", "1/s", found.real(), exact.real(),
                             std::abs(method.real() - exact.real()) + rest, why});
  findings.checks.push_back({"frequency", "rad/s", found.imag(), exact.imag(),
                             std::abs(method.imag() - exact.imag()) + rest, why});
  return findings;
}

/// The caster can be built, it oscillates, and its angle stays small.
bool oscillates(const Pivot& c) {
  if (!(c.center < 0.8 * c.trail)) return false;
  const auto root = oscillation(eigenvalues(rigid_wheel(c)));
  return caster_of(c, {}).fork_inertia(2, 2) > 0 && root.imag() > 5 * std::abs(root.real()) &&
         root.imag() < 800 && root.real() * kCount * step_of(c) < 5 &&
         std::abs(oscillation(eigenvalues(elastic_tread(c))) - root) < 1e-4 * std::abs(root);
}

struct Known {
  double inertia, growth, frequency;  // Ic / critical, [1/s], [Hz]
};

Findings known(const Known& k, const Runner&) {
  const auto root = oscillation(eigenvalues(rigid_wheel({1, 0.05, 0.03, k.inertia, 2e4, 1, 0})));
  const char* const digits = "the digits of the independent solution";
  return {{{"formula, growth rate", "1/s", root.real(), k.growth, 6e-4, digits},
           {"formula, frequency", "Hz", root.imag() / (2 * std::numbers::pi), k.frequency, 6e-3,
            digits}},
          {}};
}

}  // namespace

Family shimmy() {
  return make_family<Pivot>(
      {"shimmy", "casters",
       "A caster on a pivot that a spring holds across the direction of rolling",
       "[Ic + m (L-a)^2 + M L^2] th''' + [m (L-a) + M L] v th'' + k L^2 th' + k L v th = 0; onset "
       "at Ic = m a (L - a)",
       "after Den Hartog, Mechanical Vibrations; Routh"},
      {{{"mass", "kg", 0.3, 2}, &Pivot::mass},
       {{"trail", "m", 0.03, 0.08}, &Pivot::trail},
       {{"center", "m", 0.01, 0.05}, &Pivot::center},
       {{"inertia", "Ic/(m a (L - a))", 0.4, 3}, &Pivot::inertia},
       {{"spring", "N/m", 5e3, 5e4}, &Pivot::spring},
       {{"speed", "m/s", 0.3, 2}, &Pivot::speed},
       {{"pivot_mass", "kg", 1e-3, 20}, &Pivot::pivot_mass}},
      {{"light_0.5", {1, 0.05, 0.03, 0.5, 2e4, 1, 1e-3}},
       {"light_0.9", {1, 0.05, 0.03, 0.9, 2e4, 1, 1e-3}},
       {"light_onset", {1, 0.05, 0.03, 1, 2e4, 1, 1e-3}},
       {"light_3", {1, 0.05, 0.03, 3, 2e4, 1, 1e-3}},
       {"light_soft", {1, 0.05, 0.03, 1.1, 5e3, 2, 1e-3}},
       {"light_stiff", {1, 0.05, 0.03, 0.8, 5e4, 0.5, 1e-3}},
       {"light_short", {0.5, 0.034, 0.02, 0.7, 1e4, 1.5, 1e-3}},
       {"light_short_1.5", {0.5, 0.034, 0.02, 1.5, 3e4, 1.5, 1e-3}},
       {"heavy_0.9", {1, 0.05, 0.03, 0.9, 2e4, 1, 2}},
       {"heavy_onset", {1, 0.05, 0.03, 1, 2e4, 1, 5}},
       {"heavy_1.2", {1, 0.05, 0.03, 1.2, 2e4, 2, 5}},
       {"heavy_3", {0.6, 0.04, 0.015, 3, 4e4, 1, 20}},
       {"heavy_0.5", {0.6, 0.04, 0.015, 0.5, 4e4, 1, 20}}},
      shake, oscillates);
}

Family shimmy_formula() {
  Family family = make_family<Known>(
      {"shimmy_formula", "casters", "The cubic of shimmy gives the known roots of a massless pivot",
       "as shimmy, M = 0, m = 1 kg, L = 0.05 m, a = 0.03 m, k = 2e4 N/m, v = 1 m/s",
       "an independent solution of the cubic"},
      {{{"inertia", "Ic/(m a (L - a))", 0, 3}, &Known::inertia},
       {{"growth", "1/s", -10, 10}, &Known::growth},
       {{"frequency", "Hz", 0, 100}, &Known::frequency}},
      {{"0.5", {0.5, -4.262, 42.48}},
       {"0.9", {0.9, -0.634, 36.70}},
       {"onset", {1, 0, 35.588}},
       {"3", {3, 5.362, 24.09}}},
      known);
  family.drawn = false;
  return family;
}

}  // namespace gurney::verification
