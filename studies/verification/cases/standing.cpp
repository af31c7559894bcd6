#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <string>

#include "studies/verification/family.h"
#include "studies/verification/scenes/scenes.h"
#include "studies/verification/scenes/small_scenes.h"

// Normal forces of an item that stands: the treads are springs k_i under a rigid body, so heave z
// and two tilts (a, b) follow from
//
//     sum N_i = M g,   sum N_i (x_i, y_i) = M g (x_G, y_G),   N_i = k_i d_i
//
// in the deformed position: the body tilts about 1e-3 rad, which moves the centre of mass by 0.2 %
// of the base. d_i is the depth of the lowest point of wheel i. Solved here by Newton's method with
// a numerical Jacobian; the engine settles by implicit Euler steps to 1e-12 m.
namespace gurney::verification {
namespace {

struct Standing {
  double casters, radius;   // on a circle [m]; four stand at (+-0.4, +-0.2)
  double heading, turn;     // of the first caster, and from each to the next [deg]
  double payload, x, y, z;  // [kg], [m]
};

/// Smallest distance of the swivel axes from the middle, along an axis of the base.
double item_base(const Standing& c) { return c.casters == 4 ? 0.2 : c.radius; }

EquipmentModel item_of(const Standing& c) {
  std::vector<Vector2> mounts = {{0.4, 0.2}, {0.4, -0.2}, {-0.4, 0.2}, {-0.4, -0.2}};
  const int casters = static_cast<int>(c.casters);
  if (casters != 4) {
    mounts.clear();
    for (int i = 0; i < casters; ++i) {
      const double angle = 2 * std::numbers::pi * i / casters;
      mounts.push_back(c.radius * Vector2(std::cos(angle), std::sin(angle)));
    }
  }
  std::vector<double> headings;
  for (int i = 0; i < casters; ++i) headings.push_back(c.heading + i * c.turn);
  EquipmentModel item = small::item_on(mounts, headings, small::bare_tread(3e5, 1e8));
  item.payloads = {
      {"payload", c.payload, {c.x, c.y, c.z}, solid_box_inertia(c.payload, {0.2, 0.2, 0.2})}};
  for (std::size_t i = 0; i < item.casters.size(); ++i)
    item.casters[i].tread.normal_stiffness *= 1 + 0.2 * static_cast<double>(i);
  return item;
}

Eigen::VectorXd normal_forces(const EquipmentModel& item, const Vector3& pose) {
  const Matrix3 rotation =
      (Eigen::AngleAxisd(pose[1], Vector3::UnitX()) * Eigen::AngleAxisd(pose[2], Vector3::UnitY()))
          .toRotationMatrix();
  Eigen::VectorXd forces(item.casters.size());
  for (std::size_t i = 0; i < item.casters.size(); ++i) {
    const Caster& c = item.casters[i];
    const Vector3 forward(std::cos(c.heading), std::sin(c.heading), 0);
    const Vector3 center = c.mount - c.trail * forward - Vector3(0, 0, c.height - c.wheel_radius);
    const double lean = (rotation * Vector3(-forward.y(), forward.x(), 0)).z();
    const double depth =
        c.wheel_radius * std::sqrt(1 - lean * lean) - (rotation * center).z() - pose[0];
    forces[static_cast<Eigen::Index>(i)] = c.tread.normal_stiffness * std::max(depth, 0.0);
  }
  return forces;
}

/// Imbalance of vertical force and of the moments about the origin [N], [N m].
Vector3 imbalance(const EquipmentModel& item, const Vector3& pose) {
  const Matrix3 rotation =
      (Eigen::AngleAxisd(pose[1], Vector3::UnitX()) * Eigen::AngleAxisd(pose[2], Vector3::UnitY()))
          .toRotationMatrix();
  const MassProperties whole = whole_item(item);
  const Eigen::VectorXd forces = normal_forces(item, pose);
  Vector3 sum = -whole.mass * kG * Vector3(1, 0, 0);
  const Vector3 gravity_center = rotation * whole.center_of_mass;
  sum.tail<2>() = -whole.mass * kG * gravity_center.head<2>();
  for (std::size_t i = 0; i < item.casters.size(); ++i) {
    const Caster& c = item.casters[i];
    const Vector3 forward(std::cos(c.heading), std::sin(c.heading), 0);
    const Vector3 center = c.mount - c.trail * forward - Vector3(0, 0, c.height - c.wheel_radius);
    const Vector3 axle = rotation * Vector3(-forward.y(), forward.x(), 0);
    const Vector3 up = (Vector3::UnitZ() - axle.z() * axle).normalized();
    const Vector3 contact = rotation * center - c.wheel_radius * up;
    const double force = forces[static_cast<Eigen::Index>(i)];
    sum += force * Vector3(1, contact.x(), contact.y());
  }
  return sum;
}

Eigen::VectorXd solve(const EquipmentModel& item) {
  Vector3 pose(-1e-3, 0, 0);
  for (int iteration = 0; iteration < 30; ++iteration) {
    Matrix3 jacobian;
    for (int k = 0; k < 3; ++k) {
      const Vector3 step = 1e-7 * Vector3::Unit(k);
      jacobian.col(k) = (imbalance(item, pose + step) - imbalance(item, pose - step)) / 2e-7;
    }
    pose -= jacobian.partialPivLu().solve(imbalance(item, pose));
  }
  return normal_forces(item, pose);
}

void stand(const Standing& c, Runner& runner) {
  Scene scene = scene_of(item_of(c));
  const Response response = runner(scene, {}, small::settings_for(0.004, 0.004));
  const Eigen::VectorXd expected = solve(scene.items[0].model);
  // A locked swivel of 10 k_t R^2 winds up under the tilt N / (k_n b) and takes its wheel along.
  const Caster& caster = scene.items[0].model.casters[0];
  const double base = item_base(c), load = expected.maxCoeff();
  const double tilt = load / (caster.tread.normal_stiffness * base);
  const double turn = load * caster.trail * tilt /
                      (10 * caster.tread.tangential_stiffness * std::pow(caster.wheel_radius, 2));
  const double tolerance = 1e-6 + load * caster.trail * turn / base;
  Track track("load of a wheel", "N",
              "1e-12 m of a tread is 1e-6 N; a locked swivel winds up by N L tilt / (10 k_t R^2), "
              "tilt N / (k_n b), and its trail L takes that share of the base b",
              "wheel [number]");
  double total = 0;
  for (Eigen::Index i = 0; i < expected.size(); ++i) {
    const double force =
        response.items[0].history.front().wheels[static_cast<std::size_t>(i)].normal_force;
    track.add(static_cast<double>(i), force, expected[i], tolerance);
    total += force;
  }
  runner.report(track);
  runner.check(
      "sum of the loads", "N", total,
      near_to(whole_item(scene.items[0].model).mass * kG, 1e-6, "1e-12 m of the treads is 1e-6 N"));
}

/// Every wheel carries at least 10 N.
bool stands(const Standing& c) {
  const EquipmentModel item = item_of(c);
  return imbalance(item, Vector3(-1e-3, 0, 0)).allFinite() && solve(item).minCoeff() > 10;
}

// --- below resistance or friction
//
// Rolling resistance holds like dry friction: at rest the trolley carries up to f_r = (Cr / R) N
// without creep.

using namespace scenes;

constexpr double kShare = 0.9;  // slope over Cr / R

struct Slope {
  double slope, down = 0;  // tan(angle); 1: casters trail as it rolls down
  double odd = 0;          // 1: casters at odd headings, with friction on the swivels
  double mass = 96.5;
};

void hold(const Slope& c, Runner& runner) {
  ItemOptions options;
  options.total_mass = c.mass;
  Caster& caster = options.caster;
  caster.tread.rolling_friction_length = c.slope / kShare * caster.wheel_radius;
  options.headings.assign(4, c.down * std::numbers::pi);
  if (c.odd != 0) {
    options.headings = {0.3, 1.6, 2.8, 5.2};
    caster.swivel.coulomb = 0.03;
  }
  Scene scene = scene_of(trolley(options));
  scene.slope = c.slope;
  const Response response = runner(scene, {}, run_for(60, 0.004, 30));
  const ItemResponse& item = response.items[0];
  const double crept = (item.history[2].displacement - item.history[1].displacement).norm();
  // The residual of the solve, 1e-9 M g, on springs.
  const double residual = 1e-9 * c.mass * kG / (4 * caster.tread.tangential_stiffness);
  runner.check("creep from 30 s to 60 s", "m", crept,
               near_to(0, 1e-9 + 1000 * residual,
                       "1e-9 m, and a thousand times 1e-9 M g on the springs of the treads: no "
                       "step's residual adds to the last"));
  if (c.odd != 0) return;  // it moves a little first, until its casters hold it
  runner.check("peak displacement in 60 s", "m", item.demands.peak_displacement,
               near_to(0, 1e-9, "a run starts from equilibrium: 1e-9 m"));
  runner.check("rolling loss", "J", item.energy.rolling_loss, exactly(0, "nothing rolls"));
  int sticking = 0;
  for (int i = 0; i < 4; ++i) sticking += item.history.back().wheels[i].mode == WheelMode::kSticks;
  runner.check("wheels that stick", "", sticking * 1.0, exactly(4, "all of them"));
}

// Below the threshold (Cr / R) g a harmonic floor only sways the trolley on its treads; an envelope
// keeps them from ringing. X is the path of the axles, P the pitch on the treads about them, d the
// height of the centre of mass over the axles:
//
//     (k - M w^2) X - M d w^2 P = M A,   -M d w^2 X + (k_p - (I + M d^2) w^2) P = M d A
//
// with k = n k_t 10/11 and k_p = n k_n b^2; the item's origin, on the floor, goes X - R P.
struct Harmonic {
  double amplitude, frequency;  // [g], [Hz]
  double stiffness = 1e5, mass = 96.5;
};

Response shaken(const Harmonic& c, double resistance, Runner& runner) {
  ItemOptions options;
  options.total_mass = c.mass;
  options.caster.tread.tangential_stiffness = c.stiffness;
  options.caster.tread.rolling_friction_length = resistance * options.caster.wheel_radius;
  Scene scene = scene_of(trolley(options));
  const FloorMotion floor = floor_motion(0.004, 60, Vector3::UnitX(), [&](double t) {
    return c.amplitude * kG * std::min({1.0, t / 5, (60 - t) / 5}) *
           std::sin(2 * std::numbers::pi * c.frequency * t);
  });
  return runner(scene, floor, run_for(65, 0.004, 0.05));
}

constexpr double kBase = 0.49;  // half of the wheelbase [m]

/// (w / w_t)^2 of the sway, that of pitching on the treads included.
double quickness(const Harmonic& c) {
  const double k = 4 * c.stiffness * 10 / 11, h = ItemOptions().chassis_center.z();
  return std::pow(2 * std::numbers::pi * c.frequency, 2) * c.mass *
         (1 / k + h * h / (4 * Tread().normal_stiffness * kBase * kBase));
}

struct Sway {
  double origin, pitch;  // [m], [rad]
};

Sway steady(const Harmonic& c) {
  ItemOptions options;
  options.total_mass = c.mass;
  const MassProperties whole = whole_item(trolley(options));
  const double w2 = std::pow(2 * std::numbers::pi * c.frequency, 2), R = Caster().wheel_radius;
  const double M = c.mass, d = whole.center_of_mass.z() - R;
  Matrix2 matrix;
  matrix << 4 * c.stiffness * 10 / 11 - M * w2, -M * d * w2, -M * d * w2,
      4 * Tread().normal_stiffness * kBase * kBase - (whole.inertia(1, 1) + M * d * d) * w2;
  const Vector2 found = matrix.inverse() * (M * c.amplitude * kG * Vector2(1, d));
  return {found[0] - R * found[1], found[1]};
}

/// No wheel rolls by itself: the one with the least load, on a base a trail behind the centre of
/// mass, carries its share of 0.9 of the threshold.
bool holds_on_every_wheel(const Harmonic& c) {
  const double h = ItemOptions().chassis_center.z();
  return 0.9 * (1 + quickness(c)) < 1 - (Caster().trail + c.amplitude * h) / kBase;
}

void sway_below(const Harmonic& c, Runner& runner) {
  const Response response = shaken(c, c.amplitude / 0.9, runner);
  const ItemResponse& item = response.items[0];
  const double w = 2 * std::numbers::pi * c.frequency, k = 4 * c.stiffness * 10 / 11;
  const double omega = std::sqrt(k / c.mass);
  const Sway sway = steady(c);
  // A change of the envelope's rate, 1/5 per second, rings with 1 / (5 omega).
  const double share = 1 / (5 * omega) + std::pow(0.004 * w, 2) / 8;
  const double leaning = c.mass * kG * ItemOptions().chassis_center.z() /
                         (4 * Tread().normal_stiffness * kBase * kBase);
  runner.check("peak sway", "m", item.demands.peak_displacement,
               near_to(sway.origin,
                       share * sway.origin + (leaning + std::pow(Caster().trail / kBase, 2)) *
                                                 sway.pitch * Caster().wheel_radius,
                       "1 / (5 s omega) of it, with which the envelope's kinks ring, and (w dt)^2 "
                       "/ 8 for samples of the floor; of R P the share M g h / k_p by which the "
                       "weight helps to pitch, and (L/b)^2 for wheels a trail behind"));
  runner.check("rolling loss", "J", item.energy.rolling_loss,
               near_to(0, 1e-15, "nothing rolls: rounding"));
  runner.check("displacement left", "m", item.demands.residual_displacement,
               near_to(0, 1e-8, "swung out, no creep in 60 s"));
  const double moved = shaken(c, c.amplitude / 1.1, runner).items[0].energy.rolling_loss;
  runner.check("rolls at 1.1 of the threshold (1 yes)", "", moved > 0 ? 1.0 : 0.0,
               exactly(1, "it loses energy by rolling"));
}

// --- small vibrations
//
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

constexpr double kRadius = 0.05;
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
  stiffness(2, 2) = -whole.mass * kG * (height - (forward ? kRadius : 0));
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

Response vibrate(const Scene& scene, double step, Runner& runner) {
  auto settings = small::settings_for(step, 0.3);
  settings.residual = 1e-12;
  return runner(scene, {}, settings);
}

void follow(const Scene& scene, const LinearModel& model, Runner& runner) {
  constexpr double kStep = 5e-4;
  const Response run = vibrate(scene, kStep, runner);
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
  runner.report(sway, heave, tilt);
}

/// Heave, which is none of the other modes' business, by its own samples: w^2 = 4 k_n / M, decay
/// 2 c_n / M. At a step h the method moves lambda by 0.04 h^2 |lambda|^3.
void heave(const Body& c, const Scene& scene, Runner& runner) {
  constexpr double kStep = 2.5e-4;
  const Response run = vibrate(scene, kStep, runner);
  std::vector<double> height;
  for (const Sample& sample : run.items[0].history) height.push_back(sample.displacement.z());
  const std::complex<double> found = small::exponents(height, kStep, 2)[0];
  const double mass = whole_item(scene.items[0].model).mass;
  const double rate = 2 * c.normal_damping / mass, omega = std::sqrt(4 * c.normal_stiffness / mass);
  const double tolerance = 0.041 * std::pow(kStep, 2) * std::pow(omega, 3) + 1e-4 * omega;
  const char* const why =
      "the method moves an exponent by 0.041 h^2 |lambda|^3; 1e-4 of it for cubic terms";
  runner.check("frequency of heave", "rad/s", std::abs(found.imag()),
               near_to(std::sqrt(omega * omega - rate * rate), tolerance, why));
  runner.check("decay of heave", "1/s", -found.real(), near_to(rate, tolerance, why));
}

void vibrations(const Body& c, Runner& runner) {
  const Scene scene = scene_of_body(c);
  follow(scene, linear_model(c, scene.items[0].model), runner);
  heave(c, scene, runner);
}

}  // namespace

Family static_loads() {
  return make_family<Standing>(
      {"static_loads", "standing", "Wheel loads of an item at rest with an eccentric payload",
       "sum N_i = M g, sum N_i (x_i, y_i) = M g (x_G, y_G), N_i = k_i d_i in the deformed position",
       "statics of a rigid body on springs"},
      fields(FIELD(Standing, casters, "", 3, 8, true), FIELD(Standing, radius, "m", 0.28, 0.5),
             FIELD(Standing, heading, "deg", 0, 360), FIELD(Standing, turn, "deg", 0, 180),
             FIELD(Standing, payload, "kg", 1, 60), FIELD(Standing, x, "m", -0.25, 0.25),
             FIELD(Standing, y, "m", -0.15, 0.15), FIELD(Standing, z, "m", 0.2, 1.2)),
      cases(at("three", 3, 0.4, 0, 0, 20, 0.1, 0.05, 0.6),
            at("three_turned", 3, 0.3, 20, 120, 13.6, -0.1, 0, 0.9),
            at("four", 4, 0, 0, 0, 13.6, 0.3, 0.15, 0.8),
            at("four_turned", 4, 0, 10, 95, 54.4, -0.2, 0.1, 0.3),
            at("five", 5, 0.35, 0, 0, 30, 0.05, -0.2, 0.7),
            at("five_turned", 5, 0.3, 5, 90, 5, 0.3, 0.3, 1)),
      stand, stands);
}

Family hold() {
  return make_family<Slope>(
      {"hold", "standing", "A trolley rests for a minute on 0.9 of the slope from which it rolls",
       "x = 0 while tan(a) < Cr/R", "rolling resistance as dry friction"},
      fields(FIELD(Slope, slope, "tan", 0.003, 0.05),
             FIELD(Slope, down, "1 casters trail downhill", 0, 1, true),
             FIELD(Slope, odd, "1 odd headings", 0, 1, true), FIELD(Slope, mass, "kg", 40, 250)),
      cases(at("gentle_up", 0.005), at("gentle_down", 0.005, 1), at("gentle_odd", 0.005, 0, 1),
            at("plain_up", 0.01), at("plain_down", 0.01, 1), at("plain_odd", 0.01, 0, 1),
            at("steep_up", 0.03), at("steep_down", 0.03, 1), at("steep_odd", 0.03, 0, 1)),
      hold);
}

Family sway() {
  return make_family<Harmonic>(
      {"sway", "standing",
       "Below its threshold a shaken trolley sways on its treads and goes nowhere",
       "(k - M w^2) X - M d w^2 P = M A, -M d w^2 X + (k_p - (I + M d^2) w^2) P = M d A, k = n k_t "
       "10/11, while A < (Cr/R) g",
       "Newton's law for two oscillators"},
      fields(FIELD(Harmonic, amplitude, "g", 0.003, 0.01), FIELD(Harmonic, frequency, "Hz", 0.3, 1),
             FIELD(Harmonic, stiffness, "N/m", 8e4, 4e5), FIELD(Harmonic, mass, "kg", 60, 150)),
      cases(at("half_Hz", 0.005, 0.5), at("1_Hz", 0.005, 1)), sway_below, holds_on_every_wheel);
}

Family heave_pitch() {
  return make_family<Body>(
      {"heave_pitch", "standing", "Small vibrations of a trolley: sway, heave, pitch and wheels",
       "M q'' + C q' + K q = 0 of seven coordinates; heave w^2 = 4 k_n / M, decay 2 c_n / M",
       "Lagrange's equations of a rigid body on springs"},
      fields(FIELD(Body, crosswise, "1 casters at 90 deg", 0, 1, true),
             FIELD(Body, braked, "1 wheels locked", 0, 1, true),
             FIELD(Body, normal_damping, "N s/m", 0, 800),
             FIELD(Body, tangential_damping, "N s/m", 0, 200),
             FIELD(Body, normal_stiffness, "N/m", 2e5, 1e6),
             FIELD(Body, tangential_stiffness, "N/m", 6e4, 4e5)),
      cases(at("braked_undamped", 0, 1, 0, 0), at("braked", 0, 1, 500, 100),
            at("free", 0, 0, 200, 20), at("crosswise_undamped", 1, 0, 0, 0),
            at("crosswise_braked", 1, 1, 500, 50)),
      vibrations);
}

}  // namespace gurney::verification
