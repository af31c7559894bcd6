#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "engine/base/linear_algebra.h"
#include "engine/base/units.h"
#include "studies/verification/family.h"
#include "studies/verification/scenes/small_scenes.h"

// Flutter of a caster led along x at speed v, near the line. With the swivel angle theta, the trail
// L, I_p the inertia about the swivel axis, and the wheel rolling (R w = v):
//
//     lateral velocity of the material contact point   u = -(L theta' + v theta)
//     deflection of the tread                          e' = u - (v / sigma) e
//     force on the wheel                               F = -(k e + c e')
//     moment about the swivel axis, arm -L             I_p theta'' = -L F
//
// In y = (theta, theta', e) this is y' = A y: one oscillation of about sqrt(k L^2 / I_p) and one
// decay near -v / L (the alignment).
namespace gurney::verification {
namespace {

constexpr double kStart = 1e-4, kStep = 2.5e-4, kStiffness = 1e5;
constexpr int kSteps = 400;

struct Towing {
  double speed, damping, relaxation;  // [m/s], c_t [N s/m], sigma [m]
  double trail = 0.034;
};

Matrix3 linear_model(const Towing& c, double inertia) {
  const double v = c.speed, s = v / c.relaxation, k = kStiffness, d = c.damping, l = c.trail;
  Matrix3 a;
  a << 0, 1, 0,                                                               //
      -l * d * v / inertia, -l * d * l / inertia, l * (k - d * s) / inertia,  //
      -v, -l, -s;
  return a;
}

/// The eigenvalue with the largest imaginary part.
std::complex<double> oscillation(const Eigen::VectorXcd& exponents) {
  std::complex<double> found = exponents[0];
  for (const auto& e : exponents)
    if (e.imag() > found.imag()) found = e;
  return found;
}

Scene towed(const Towing& c) {
  Tread tread = small::bare_tread(3e5, kStiffness);
  tread.tangential_damping = c.damping;
  tread.relaxation_length = c.relaxation;
  return small::towed_caster(c.speed, c.trail, kStart / kRadiansPerDegree, tread);
}

void swing(const Towing& c, Runner& runner) {
  const Scene scene = towed(c);
  auto settings = small::settings_for(kStep, kSteps * kStep);
  settings.residual = 1e-12;  // the forces of the start are 1e-4 of the weight
  const Response response = runner(scene, {}, settings);
  const Matrix3 a = linear_model(c, small::swivel_inertia(scene.items[0].model.casters[0]));
  const auto exact = oscillation(eigenvalues(a));
  const Matrix3 one_step = small::sdirk_step(a, kStep);

  // Nothing but the method stands between the simulated angles and the linear model, but for the
  // direction of the wheel: a stage takes it as predicted, at most a step ahead, and misses the
  // third derivative, h^3 |lambda|^3 theta / 6. In u that counts with v, half of it in phase.
  const double lag = c.speed / c.trail * std::pow(kStep * std::abs(exact), 3) / 12;  // [1/s]
  std::vector<double> angles, expected;
  Vector3 y(kStart, -c.speed / c.trail * kStart, 0);
  for (const Sample& s : response.items[0].history) {
    angles.push_back(s.wheels[0].swivel_angle);
    expected.push_back(y[0]);
    y = one_step * y;
  }
  const double largest = std::abs(
      *std::ranges::max_element(expected, {}, [](double angle) { return std::abs(angle); }));
  const double duration = kSteps * kStep;
  Track track("swivel angle against the linear model by the same method", "rad",
              "directions predicted a step ahead, (v / L) (h |lambda|)^3 / 12 of the largest angle "
              "in a second; 1e-5 and theta^2 / 8 of it for cubic terms");
  for (std::size_t i = 0; i < angles.size(); ++i)
    track.add(static_cast<double>(i) * kStep, angles[i], expected[i],
              (lag * duration + 1e-5 + largest * largest / 8) * largest);
  runner.report(track);

  const auto method = oscillation(Eigen::VectorXcd(eigenvalues(one_step).array().log() / kStep));
  const auto found = oscillation(small::exponents(angles, kStep, 3));
  const double rest = lag + (1e-5 + largest * largest / 40) * std::abs(exact);
  const char* const why =
      "what the method makes of it, |log R(h lambda) / h - lambda|; directions predicted a step "
      "ahead, (v / L) (h |lambda|)^3 / 12; 1e-5 |lambda| and theta^2 / 40 of it for cubic terms";
  runner.check("growth rate", "1/s", found.real(),
               near_to(exact.real(), std::abs(method.real() - exact.real()) + rest, why));
  runner.check("frequency", "rad/s", found.imag(),
               near_to(exact.imag(), std::abs(method.imag() - exact.imag()) + rest, why));
}

/// It oscillates at more than twice its decay, below 120 Hz, stays small, and is not over before
/// the run is: its exponents are read from all of it.
bool oscillates(const Towing& c) {
  const auto root = oscillation(
      eigenvalues(linear_model(c, small::swivel_inertia(towed(c).items[0].model.casters[0]))));
  return std::abs(root.real()) < 0.3 * root.imag() && root.imag() < 750 &&
         root.real() * kSteps * kStep > -6 &&
         kStart * std::exp(root.real() * kSteps * kStep) < 0.02;
}

// --- shimmy
//
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

constexpr double kTread = 1e9;
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

/// Exponent of a real system, the one that shimmies with less than 1000 rad/s.
std::complex<double> slow_oscillation(const Eigen::VectorXcd& exponents) {
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

std::vector<double> swivel_angles(const Pivot& c, double step, Runner& runner) {
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
  const Response response = runner(scene, {}, settings);
  std::vector<double> angles;
  for (const Sample& sample : response.items[0].history)
    angles.push_back(sample.wheels[0].swivel_angle);
  return angles;
}

/// Steps for which the method's own error is 0.02 % of |lambda|.
double step_of(const Pivot& c) {
  return 0.03 / std::abs(slow_oscillation(eigenvalues(rigid_wheel(c))));
}

void shake(const Pivot& c, Runner& runner) {
  const auto exact = slow_oscillation(eigenvalues(rigid_wheel(c)));
  const auto elastic = slow_oscillation(eigenvalues(elastic_tread(c)));
  const double step = step_of(c);
  const auto method = slow_oscillation(
      Eigen::VectorXcd(eigenvalues(small::sdirk_step(rigid_wheel(c), step)).array().log() / step));
  std::vector<double> angles = swivel_angles(c, step, runner);
  angles.erase(angles.begin(), angles.begin() + kSettled);  // the push is over
  const auto found = slow_oscillation(small::exponents(angles, step, 3));
  double largest = 0;
  for (const double angle : angles) largest = std::max(largest, std::abs(angle));
  const double rest = std::abs(elastic - exact) + (1e-5 + largest * largest / 40) * std::abs(exact);
  const char* const why =
      "what the method makes of it, |log R(h lambda) / h - lambda|, and a tread of 1e9 N/m; 1e-5 "
      "|lambda| and theta^2/40 of it for cubic terms";
  if (std::abs(c.inertia - 1) > 1e-3)
    runner.check("grows (1) or decays (0), by the cubic", "", exact.real() > 0 ? 1.0 : 0.0,
                 exactly(c.inertia > 1 ? 1.0 : 0.0, "Routh: grows if Ic > m a (L - a)"));
  runner.check("growth rate", "1/s", found.real(),
               near_to(exact.real(), std::abs(method.real() - exact.real()) + rest, why));
  runner.check("frequency", "rad/s", found.imag(),
               near_to(exact.imag(), std::abs(method.imag() - exact.imag()) + rest, why));
}

/// The caster can be built, it shimmies, and its angle stays small.
bool shimmies(const Pivot& c) {
  if (!(c.center < 0.8 * c.trail)) return false;
  const auto root = slow_oscillation(eigenvalues(rigid_wheel(c)));
  return caster_of(c, {}).fork_inertia(2, 2) > 0 && root.imag() > 5 * std::abs(root.real()) &&
         root.imag() < 800 && root.real() * kCount * step_of(c) < 5 &&
         std::abs(slow_oscillation(eigenvalues(elastic_tread(c))) - root) < 1e-4 * std::abs(root);
}

struct Known {
  double inertia, growth, frequency;  // Ic / critical, [1/s], [Hz]
};

void known(const Known& k, Runner& runner) {
  const auto root =
      slow_oscillation(eigenvalues(rigid_wheel({1, 0.05, 0.03, k.inertia, 2e4, 1, 0})));
  const char* const digits = "the digits of the independent solution";
  runner.check("formula, growth rate", "1/s", root.real(), near_to(k.growth, 6e-4, digits));
  runner.check("formula, frequency", "Hz", root.imag() / (2 * std::numbers::pi),
               near_to(k.frequency, 6e-3, digits));
}

}  // namespace

Family flutter() {
  return make_family<Towing>(
      {"flutter", "casters", "A caster that is led along a line flutters",
       "theta'' = -L F / I_p, F = -(k e + c e'), e' = -(L theta' + v theta) - (v / sigma) e",
       "linear equations of tread and swivel; Routh: decays if c > I_p v / L^3 or sigma < L"},
      fields(FIELD(Towing, speed, "m/s", 0.3, 3), FIELD(Towing, damping, "N s/m", 0, 80),
             FIELD(Towing, relaxation, "m", 0.008, 0.2), FIELD(Towing, trail, "m", 0.025, 0.06)),
      cases(at("grows", 1, 0, 1e9), at("grows_slow", 0.5, 0, 1e9), at("grows_fast", 2, 0, 1e9),
            at("grows_damped", 1, 10, 1e9), at("decays_damped", 1, 30, 1e9),
            at("decays_fast", 2, 60, 1e9), at("decays_relaxed_slow", 0.5, 0, 0.01),
            at("decays_relaxed", 1, 0, 0.01), at("decays_relaxed_fast", 2, 0, 0.01),
            at("decays_both", 2, 20, 0.01), at("grows_long_relaxation", 1, 0, 0.05)),
      swing, oscillates);
}

Family shimmy() {
  return make_family<Pivot>(
      {"shimmy", "casters",
       "A caster on a pivot that a spring holds across the direction of rolling",
       "[Ic + m (L-a)^2 + M L^2] th''' + [m (L-a) + M L] v th'' + k L^2 th' + k L v th = 0; onset "
       "at Ic = m a (L - a)",
       "after Den Hartog, Mechanical Vibrations; Routh"},
      fields(FIELD(Pivot, mass, "kg", 0.3, 2), FIELD(Pivot, trail, "m", 0.03, 0.08),
             FIELD(Pivot, center, "m", 0.01, 0.05),
             FIELD(Pivot, inertia, "Ic/(m a (L - a))", 0.4, 3),
             FIELD(Pivot, spring, "N/m", 5e3, 5e4), FIELD(Pivot, speed, "m/s", 0.3, 2),
             FIELD(Pivot, pivot_mass, "kg", 1e-3, 20)),
      cases(at("light_0.5", 1, 0.05, 0.03, 0.5, 2e4, 1, 1e-3),
            at("light_0.9", 1, 0.05, 0.03, 0.9, 2e4, 1, 1e-3),
            at("light_onset", 1, 0.05, 0.03, 1, 2e4, 1, 1e-3),
            at("light_3", 1, 0.05, 0.03, 3, 2e4, 1, 1e-3),
            at("light_soft", 1, 0.05, 0.03, 1.1, 5e3, 2, 1e-3),
            at("light_stiff", 1, 0.05, 0.03, 0.8, 5e4, 0.5, 1e-3),
            at("light_short", 0.5, 0.034, 0.02, 0.7, 1e4, 1.5, 1e-3),
            at("light_short_1.5", 0.5, 0.034, 0.02, 1.5, 3e4, 1.5, 1e-3),
            at("heavy_0.9", 1, 0.05, 0.03, 0.9, 2e4, 1, 2),
            at("heavy_onset", 1, 0.05, 0.03, 1, 2e4, 1, 5),
            at("heavy_1.2", 1, 0.05, 0.03, 1.2, 2e4, 2, 5),
            at("heavy_3", 0.6, 0.04, 0.015, 3, 4e4, 1, 20),
            at("heavy_0.5", 0.6, 0.04, 0.015, 0.5, 4e4, 1, 20)),
      shake, shimmies);
}

Family shimmy_formula() {
  return never_drawn(make_family<Known>(
      {"shimmy_formula", "casters", "The cubic of shimmy gives the known roots of a massless pivot",
       "as shimmy, M = 0, m = 1 kg, L = 0.05 m, a = 0.03 m, k = 2e4 N/m, v = 1 m/s",
       "an independent solution of the cubic"},
      fields(FIELD(Known, inertia, "Ic/(m a (L - a))", 0, 3), FIELD(Known, growth, "1/s", -10, 10),
             FIELD(Known, frequency, "Hz", 0, 100)),
      cases(at("0.5", 0.5, -4.262, 42.48), at("0.9", 0.9, -0.634, 36.70), at("onset", 1, 0, 35.588),
            at("3", 3, 5.362, 24.09)),
      known));
}

}  // namespace gurney::verification
