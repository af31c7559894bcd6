#include <algorithm>
#include <cmath>
#include <complex>

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

Findings swing(const Towing& c, const Runner& runner) {
  Findings findings;
  const Scene scene = towed(c);
  auto settings = small::settings_for(kStep, kSteps * kStep);
  settings.residual = 1e-12;  // the forces of the start are 1e-4 of the weight
  const Response response = runner(findings, scene, {}, settings);
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
  track.report(findings);

  const auto method = oscillation(Eigen::VectorXcd(eigenvalues(one_step).array().log() / kStep));
  const auto found = oscillation(small::exponents(angles, kStep, 3));
  const double rest = lag + (1e-5 + largest * largest / 40) * std::abs(exact);
  const char* const why =
      "what the method makes of it, |log R(h lambda) / h - lambda|; directions predicted a step "
      "ahead, (v / L) (h |lambda|)^3 / 12; 1e-5 |lambda| and theta^2 / 40 of it for cubic terms";
  findings.checks.push_back({"growth rate", "1/s", found.real(), exact.real(),
                             std::abs(method.real() - exact.real()) + rest, why});
  findings.checks.push_back({"frequency", "rad/s", found.imag(), exact.imag(),
                             std::abs(method.imag() - exact.imag()) + rest, why});
  return findings;
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

}  // namespace

Family flutter() {
  return make_family<Towing>(
      {"flutter", "casters", "A caster that is led along a line flutters",
       "theta'' = -L F / I_p, F = -(k e + c e'), e' = -(L theta' + v theta) - (v / sigma) e",
       "linear equations of tread and swivel; Routh: decays if c > I_p v / L^3 or sigma < L"},
      {{{"speed", "m/s", 0.3, 3}, &Towing::speed},
       {{"damping", "N s/m", 0, 80}, &Towing::damping},
       {{"relaxation", "m", 0.008, 0.2}, &Towing::relaxation},
       {{"trail", "m", 0.025, 0.06}, &Towing::trail}},
      {{"grows", {1, 0, 1e9}},
       {"grows_slow", {0.5, 0, 1e9}},
       {"grows_fast", {2, 0, 1e9}},
       {"grows_damped", {1, 10, 1e9}},
       {"decays_damped", {1, 30, 1e9}},
       {"decays_fast", {2, 60, 1e9}},
       {"decays_relaxed_slow", {0.5, 0, 0.01}},
       {"decays_relaxed", {1, 0, 0.01}},
       {"decays_relaxed_fast", {2, 0, 0.01}},
       {"decays_both", {2, 20, 0.01}},
       {"grows_long_relaxation", {1, 0, 0.05}}},
      swing, oscillates);
}

}  // namespace gurney::verification
