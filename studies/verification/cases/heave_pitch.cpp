#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <complex>

#include "engine/base/units.h"
#include "studies/verification/family.h"
#include "studies/verification/scenes/small_scenes.h"

// Small vibrations of an item on four rigid casters, symmetric about the x-z plane, all at heading
// 0 or all at 90 degrees. Coordinates q: x and z of the whole's centre of mass G, pitch b about y,
// and the turn of each wheel about its axle. With height H of G above the floor, contact points at
// (x_i, 0) and the turn t_i of wheel i (axle to the left; x-direction for heading 0):
//
//     normal       d_i  = -z + b x_i                       k_n, c_n
//     tangential   e_i  = x - b H - R t_i  (heading 0)     k_t, c_t;  x - b H (heading 90)
//     brake        t_i                                     10 k_t R^2 when its torque is infinite
//     gravity      -M g (H - H_p) b^2 / 2
//
// H_p is the height at which a tilting wheel keeps its lowest point: R when it tilts about its axle
// (heading 0), 0 when it leans over its edge (heading 90). The wheels' spin adds I_a (t' + b')^2 /
// 2 in place of their share I_a b'^2 / 2 of the pitch inertia. M q'' + C q' + K q = 0.
namespace gurney::verification {
namespace {

constexpr double kGravity = kStandardGravity, kRadius = 0.05;
constexpr double kSway = 5e-4, kHeave = 7e-4;  // speeds at the start [m/s]

struct Body {
  double crosswise, braked;  // heading 90 instead of 0; wheels cannot turn
  double normal_damping, tangential_damping;
  double normal_stiffness = 3e5, tangential_stiffness = 1e5;
};

Scene scene_of_body(const Body& c) {
  Tread tread = small::bare_tread(c.normal_stiffness, c.tangential_stiffness);
  tread.normal_damping = c.normal_damping;
  tread.tangential_damping = c.tangential_damping;
  tread.relaxation_length = 1e6;
  tread.static_friction = tread.kinetic_friction = 3;
  Scene scene = scene_of({});
  const double heading = c.crosswise != 0 ? 90 : 0;
  scene.items[0].model = small::trolley({heading, heading, heading, heading}, tread);
  for (Caster& caster : scene.items[0].model.casters) {
    caster.swivels = false;
    caster.trail = 0;
    caster.fork_center_of_mass.x() = 0;
    if (c.braked != 0) caster.brake_torque = INFINITY;
  }
  // Amplitudes of a few micrometres: 1 % of the static compression.
  scene.items[0].initial.velocity = {kSway, 0, kHeave};
  scene.items[0].initial.wheels_roll = false;
  return scene;
}

/// State matrix of (q, q'): x, z, b and the four wheels.
struct LinearModel {
  Eigen::MatrixXd state;
  double height;  // H
};

LinearModel linear_model(const Body& c, const EquipmentModel& item) {
  constexpr int kCoordinates = 7;
  const MassProperties whole = whole_item(item);
  const double height = whole.center_of_mass.z();
  Eigen::MatrixXd mass = Eigen::MatrixXd::Zero(kCoordinates, kCoordinates), damping = mass,
                  stiffness = mass;
  mass(0, 0) = mass(1, 1) = whole.mass;
  mass(2, 2) = whole.inertia(1, 1);
  const bool forward = c.crosswise == 0;
  stiffness(2, 2) = -whole.mass * kGravity * (height - (forward ? kRadius : 0));
  for (int i = 0; i < 4; ++i) {
    const Caster& caster = item.casters[static_cast<std::size_t>(i)];
    const Tread& tread = caster.tread;
    const int wheel = 3 + i;
    mass(wheel, wheel) = caster.wheel_axial_inertia;
    Eigen::RowVectorXd normal = Eigen::RowVectorXd::Zero(kCoordinates), tangential = normal;
    normal[1] = -1;
    normal[2] = caster.mount.x();
    tangential[0] = 1;
    tangential[2] = -height;
    if (forward) {
      mass(2, wheel) = mass(wheel, 2) = caster.wheel_axial_inertia;
      tangential[wheel] = -kRadius;
    }
    stiffness += tread.normal_stiffness * normal.transpose() * normal +
                 tread.tangential_stiffness * tangential.transpose() * tangential;
    damping += tread.normal_damping * normal.transpose() * normal +
               tread.tangential_damping * tangential.transpose() * tangential;
    if (c.braked != 0)
      stiffness(wheel, wheel) += 10 * tread.tangential_stiffness * kRadius * kRadius;
  }
  LinearModel model{Eigen::MatrixXd::Zero(2 * kCoordinates, 2 * kCoordinates), height};
  model.state.topRightCorner(kCoordinates, kCoordinates).setIdentity();
  model.state.bottomLeftCorner(kCoordinates, kCoordinates) = -mass.lu().solve(stiffness);
  model.state.bottomRightCorner(kCoordinates, kCoordinates) = -mass.lu().solve(damping);
  return model;
}

Response vibrate(const Scene& scene, double step, const Runner& runner, Findings& findings) {
  auto settings = small::settings_for(step, 0.3);
  settings.residual = 1e-12;
  return runner(findings, scene, {}, settings);
}

void follow(const Scene& scene, const LinearModel& model, const Runner& runner,
            Findings& findings) {
  constexpr double kStep = 5e-4;
  const Response run = vibrate(scene, kStep, runner, findings);
  const Eigen::MatrixXd one_step = small::sdirk_step(model.state, kStep);
  Eigen::VectorXd y = Eigen::VectorXd::Zero(14);
  y[7] = kSway;
  y[8] = kHeave;
  std::vector<Vector3> expected;
  Vector3 largest = Vector3::Zero();
  for (std::size_t i = 0; i < run.items[0].history.size(); ++i) {
    // The origin of the item lies H below the centre of mass.
    expected.emplace_back(y[0] - model.height * y[2], y[1], std::abs(y[2]));
    largest = largest.cwiseMax(expected.back().cwiseAbs());
    y = one_step * y;
  }
  const char* const why = "2e-4 of the largest: cubic terms, lever arms at the predicted position";
  Track sway("sway against the linear model by the same method", "m", why);
  Track heave("heave against the linear model", "m", why);
  Track tilt("tilt against the linear model", "rad",
             std::string(why) + "; 2e-8 rad, the rounding of an arc cosine near 1");
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const Sample& s = run.items[0].history[i];
    sway.add(s.time, s.displacement.x(), expected[i].x(), 2e-4 * largest.x());
    heave.add(s.time, s.displacement.z(), expected[i].y(), 2e-4 * largest.y());
    tilt.add(s.time, s.tilt, expected[i].z(), 2e-4 * largest.z() + 2e-8);
  }
  sway.report(findings);
  heave.report(findings);
  tilt.report(findings);
}

/// Heave, which is none of the other modes' business, by its own samples: w^2 = 4 k_n / M, decay
/// 2 c_n / M. At a step h the method moves lambda by 0.04 h^2 |lambda|^3.
void heave(const Body& c, const Scene& scene, const Runner& runner, Findings& findings) {
  constexpr double kStep = 2.5e-4;
  const Response run = vibrate(scene, kStep, runner, findings);
  std::vector<double> height;
  for (const Sample& sample : run.items[0].history) height.push_back(sample.displacement.z());
  const std::complex<double> found = small::exponents(height, kStep, 2)[0];
  const double mass = whole_item(scene.items[0].model).mass;
  const double rate = 2 * c.normal_damping / mass, omega = std::sqrt(4 * c.normal_stiffness / mass);
  const double tolerance = 0.041 * std::pow(kStep, 2) * std::pow(omega, 3) + 1e-4 * omega;
  const char* const why =
      "the method moves an exponent by 0.041 h^2 |lambda|^3; 1e-4 of it for cubic terms";
  findings.checks.push_back({"frequency of heave", "rad/s", std::abs(found.imag()),
                             std::sqrt(omega * omega - rate * rate), tolerance, why});
  findings.checks.push_back({"decay of heave", "1/s", -found.real(), rate, tolerance, why});
}

Findings vibrations(const Body& c, const Runner& runner) {
  Findings findings;
  const Scene scene = scene_of_body(c);
  follow(scene, linear_model(c, scene.items[0].model), runner, findings);
  heave(c, scene, runner, findings);
  return findings;
}

}  // namespace

Family heave_pitch() {
  return make_family<Body>(
      {"heave_pitch", "standing", "Small vibrations of a trolley: sway, heave, pitch and wheels",
       "M q'' + C q' + K q = 0 of seven coordinates; heave w^2 = 4 k_n / M, decay 2 c_n / M",
       "Lagrange's equations of a rigid body on springs"},
      {{{"crosswise", "1 casters at 90 deg", 0, 1, true}, &Body::crosswise},
       {{"braked", "1 wheels locked", 0, 1, true}, &Body::braked},
       {{"normal_damping", "N s/m", 0, 800}, &Body::normal_damping},
       {{"tangential_damping", "N s/m", 0, 200}, &Body::tangential_damping},
       {{"normal_stiffness", "N/m", 2e5, 1e6}, &Body::normal_stiffness},
       {{"tangential_stiffness", "N/m", 6e4, 4e5}, &Body::tangential_stiffness}},
      {{"braked_undamped", {0, 1, 0, 0}},
       {"braked", {0, 1, 500, 100}},
       {"free", {0, 0, 200, 20}},
       {"crosswise_undamped", {1, 0, 0, 0}},
       {"crosswise_braked", {1, 1, 500, 50}}},
      vibrations);
}

}  // namespace gurney::verification
