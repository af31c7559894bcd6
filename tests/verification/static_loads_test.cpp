#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <numbers>
#include <ostream>

#include "engine/base/units.h"
#include "engine/simulate.h"
#include "studies/verification/scenes/small_scenes.h"
#include "tests/support/error_text.h"

// Normal forces of an item that stands: the treads are springs k_i under a rigid body, so heave z
// and two tilts (a, b) follow from
//
//     sum N_i = M g,   sum N_i (x_i, y_i) = M g (x_G, y_G),   N_i = k_i d_i
//
// in the deformed position: the body tilts about 1e-3 rad, which moves the centre of mass by 0.2 %
// of the base. d_i is the depth of the lowest point of wheel i. Solved here by Newton's method with
// a numerical Jacobian; the engine settles by implicit Euler steps to 1e-12 m.
namespace gurney {
namespace {

constexpr double kGravity = kStandardGravity;

struct Standing {
  std::vector<Vector2> mounts;
  std::vector<double> headings;
  Payload payload;
};

EquipmentModel item_of(const Standing& standing) {
  EquipmentModel item =
      small::item_on(standing.mounts, standing.headings, small::bare_tread(3e5, 1e8));
  item.payloads = {standing.payload};
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
  EXPECT_LT(imbalance(item, pose).norm(), 1e-8);
  return normal_forces(item, pose);
}

Payload payload(double mass, const Vector3& center) {
  return {"payload", mass, center, solid_box_inertia(mass, {0.2, 0.2, 0.2})};
}

void PrintTo(const Standing& standing, std::ostream* out) {
  *out << standing.mounts.size() << " casters, payload " << standing.payload.mass << " kg at "
       << standing.payload.center_of_mass.transpose();
}

class StaticLoads : public testing::TestWithParam<Standing> {};

TEST_P(StaticLoads, AreThoseOfTheStiffnessSolution) {
  Scene scene;
  scene.items[0].model = item_of(GetParam());
  const Response response = simulate(scene, {}, small::settings_for(0.004, 0.004));
  const Eigen::VectorXd expected = solve(scene.items[0].model);
  double total = 0;
  for (std::size_t i = 0; i < scene.items[0].model.casters.size(); ++i) {
    const double force = response.items[0].history.front().wheels[i].normal_force;
    // Locked swivels of k = 10 k_t R^2 wind up by N trail 1e-3 / k = 1e-8 rad under the tilt, which
    // moves a wheel by 1e-9 of the base; 1e-12 m of a tread is 1e-6 N.
    EXPECT_NEAR(force, expected[static_cast<Eigen::Index>(i)], 2e-6) << "caster " << i;
    EXPECT_GT(force, 10) << "caster " << i;
    total += force;
  }
  EXPECT_NEAR(total, whole_item(scene.items[0].model).mass * kGravity, 1e-6);
}

const std::vector<Vector2> kFour = {{0.4, 0.2}, {0.4, -0.2}, {-0.4, 0.2}, {-0.4, -0.2}};

std::vector<Vector2> star(int points, double radius) {
  std::vector<Vector2> mounts;
  for (int i = 0; i < points; ++i)
    mounts.push_back(radius * Vector2(std::cos(2 * std::numbers::pi * i / points),
                                      std::sin(2 * std::numbers::pi * i / points)));
  return mounts;
}

INSTANTIATE_TEST_SUITE_P(
    Items, StaticLoads,
    testing::Values(Standing{star(3, 0.4), {0, 0, 0}, payload(20, {0.1, 0.05, 0.6})},
                    Standing{star(3, 0.3), {20, 150, 260}, payload(13.6, {-0.1, 0, 0.9})},
                    Standing{kFour, {0, 0, 0, 0}, payload(13.6, {0.3, 0.15, 0.8})},
                    Standing{kFour, {10, 100, 200, 300}, payload(54.4, {-0.2, 0.1, 0.3})},
                    Standing{star(5, 0.35), {0, 0, 0, 0, 0}, payload(30, {0.05, -0.2, 0.7})},
                    Standing{star(5, 0.3), {5, 95, 185, 275, 355}, payload(5, {0.3, 0.3, 1})}));

TEST(StaticLoads, AnItemWhoseCentreOfMassLiesOutsideItsSupportIsRefused) {
  const std::string refusal =
      "the item does not stand on its casters: its centre of mass lies outside their support";
  Scene scene;
  scene.items[0].model = item_of({kFour, {0, 0, 0, 0}, payload(200, {0.7, 0, 0.5})});
  EXPECT_EQ(error_text([&] { simulate(scene, {}, {}); }), refusal);
  scene.items[0].model = item_of({{{0.4, 0}, {-0.4, 0}}, {0, 0}, payload(1, {0, 0.01, 0.5})});
  EXPECT_EQ(error_text([&] { simulate(scene, {}, {}); }), refusal);
}

TEST(StaticLoads, ARunStartsAtRest) {
  // Nothing drops, swings or creeps: braked rigid casters keep their forces and stand still.
  Scene scene;
  scene.items[0].model = item_of({kFour, {10, 100, 200, 300}, payload(30, {0.2, 0.1, 0.8})});
  for (Caster& c : scene.items[0].model.casters) {
    c.swivels = false;
    c.brake_torque = INFINITY;
  }
  const Response response = simulate(scene, {}, small::settings_for(0.004, 2, 10));
  for (const Sample& sample : response.items[0].history) {
    // The tilt of 1e-3 rad shifts the treads sideways once they hold: 1e-6 of the weight.
    for (std::size_t i = 0; i < 4; ++i)
      EXPECT_NEAR(sample.wheels[i].normal_force,
                  response.items[0].history[0].wheels[i].normal_force, 1e-3);
    EXPECT_LT(sample.displacement.norm(), 1e-8);
  }
}

TEST(StaticLoads, ThreeCastersFollowFromStaticsAlone) {
  // Stiff treads: no tilt, and the lever rule holds.
  Scene scene;
  scene.items[0].model = small::item_on({{0.4, 0}, {-0.2, 0.3}, {-0.2, -0.3}}, {0, 0, 0},
                                        small::bare_tread(1e10, 1e5));
  const MassProperties whole = whole_item(scene.items[0].model);
  const Response response = simulate(scene, {}, small::settings_for(0.004, 0.004));
  const double trail = scene.items[0].model.casters[0].trail;
  const double front = whole.mass * kGravity * (whole.center_of_mass.x() + 0.2 + trail) / 0.6;
  // Tilt N / k / 0.6 m of about 1e-7 rad.
  EXPECT_NEAR(response.items[0].history[0].wheels[0].normal_force, front, 1e-6 * front);
  EXPECT_NEAR(response.items[0].history[0].wheels[1].normal_force,
              0.5 * (whole.mass * kGravity - front), 1e-6 * front);
}

}  // namespace
}  // namespace gurney
