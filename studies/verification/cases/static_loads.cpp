#include <Eigen/LU>
#include <cmath>
#include <numbers>

#include "engine/base/units.h"
#include "studies/verification/family.h"
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

constexpr double kGravity = kStandardGravity;

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
  Vector3 sum = -whole.mass * kGravity * Vector3(1, 0, 0);
  const Vector3 gravity_center = rotation * whole.center_of_mass;
  sum.tail<2>() = -whole.mass * kGravity * gravity_center.head<2>();
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

Findings stand(const Standing& c, const Runner& runner) {
  Findings findings;
  Scene scene = scene_of(item_of(c));
  const Response response = runner(findings, scene, {}, small::settings_for(0.004, 0.004));
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
  track.report(findings);
  findings.checks.push_back({"sum of the loads", "N", total,
                             whole_item(scene.items[0].model).mass * kGravity, 1e-6,
                             "1e-12 m of the treads is 1e-6 N"});
  return findings;
}

/// Every wheel carries at least 10 N.
bool stands(const Standing& c) {
  const EquipmentModel item = item_of(c);
  return imbalance(item, Vector3(-1e-3, 0, 0)).allFinite() && solve(item).minCoeff() > 10;
}

}  // namespace

Family static_loads() {
  return make_family<Standing>(
      {"static_loads", "standing", "Wheel loads of an item at rest with an eccentric payload",
       "sum N_i = M g, sum N_i (x_i, y_i) = M g (x_G, y_G), N_i = k_i d_i in the deformed position",
       "statics of a rigid body on springs"},
      {{{"casters", "", 3, 8, true}, &Standing::casters},
       {{"radius", "m", 0.28, 0.5}, &Standing::radius},
       {{"heading", "deg", 0, 360}, &Standing::heading},
       {{"turn", "deg", 0, 180}, &Standing::turn},
       {{"payload", "kg", 1, 60}, &Standing::payload},
       {{"x", "m", -0.25, 0.25}, &Standing::x},
       {{"y", "m", -0.15, 0.15}, &Standing::y},
       {{"z", "m", 0.2, 1.2}, &Standing::z}},
      {{"three", {3, 0.4, 0, 0, 20, 0.1, 0.05, 0.6}},
       {"three_turned", {3, 0.3, 20, 120, 13.6, -0.1, 0, 0.9}},
       {"four", {4, 0, 0, 0, 13.6, 0.3, 0.15, 0.8}},
       {"four_turned", {4, 0, 10, 95, 54.4, -0.2, 0.1, 0.3}},
       {"five", {5, 0.35, 0, 0, 30, 0.05, -0.2, 0.7}},
       {"five_turned", {5, 0.3, 5, 90, 5, 0.3, 0.3, 1}}},
      stand, stands);
}

}  // namespace gurney::verification
