#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/contact/body_form.h"
#include "engine/run/overlaps.h"
#include "engine/run/simulate.h"
#include "studies/verification/scenes/blocks.h"
#include "studies/verification/scenes/small_scenes.h"

// Bodies that are cylinders, spheres and hulls, against closed forms and against boxes.
namespace gurney {
namespace {

constexpr double kGravity = 9.80665;
constexpr double kPi = std::numbers::pi;

ContactConstants rough(double friction, double restitution = 0.05) {
  ContactConstants constants;
  constants.friction = friction;
  constants.restitution = restitution;
  return constants;
}

/// A uniform solid that stands or lies on the floor.
Scene solid(double mass, const BodyShape& shape, const ContactConstants& floor) {
  Scene scene = blocks::block(mass, Vector3::Ones(), floor);
  EquipmentModel& model = scene.items[0].model;
  const MassProperties body = uniform_solid(mass, shape);
  model.chassis_center_of_mass = body.center_of_mass;
  model.chassis_inertia = body.inertia;
  model.shape = {shape};
  model.marked_points.clear();
  scene.items[0].name = "solid";
  return scene;
}

BodyShape lying(double radius, double length, const Vector3& axis = Vector3::UnitY()) {
  return cylinder_shape({0, 0, radius}, {axis, radius, length});
}
BodyShape upright(double radius, double height) {
  return cylinder_shape({0, 0, height / 2}, {Vector3::UnitZ(), radius, height});
}

FloorMotion steady(double acceleration, double duration, double direction = 0) {
  const auto count = static_cast<Eigen::Index>(std::lround(duration / 0.001)) + 1;
  Eigen::Matrix3Xd a = Eigen::Matrix3Xd::Zero(3, count);
  a.row(0).setConstant(acceleration * std::cos(direction));
  a.row(1).setConstant(acceleration * std::sin(direction));
  return {0.001, a};
}

/// Displacement of the centre of mass: that of the origin turns with the body.
Vector3 moved(const Scene& scene, std::size_t item, const Sample& at) {
  const Vector3& center = scene.items[item].model.chassis_center_of_mass;
  return at.displacement + at.orientation * center - center;
}

/// The same shape with its corners as a hull.
void as_hull(EquipmentModel& model) {
  for (BodyShape& shape : model.shape) shape = hull_shape(outline_points(shape));
}

// A box and the hull of its corners are one body: what differs is the rounding of where they are.
TEST(Shapes, AHullOfABoxRocksAsTheBox) {
  Scene box = blocks::block(300, {0.4, 0.6, 1.6}, rough(0.8, 0.3));
  Scene hull = box;
  as_hull(hull.items[0].model);
  const FloorMotion floor = small::noise_record(11, 3, {4, 3, 1});
  const SimulationSettings settings = blocks::run_for(3, 0.002, 0.02);
  const Response a = simulate(box, floor, settings), b = simulate(hull, floor, settings);
  ASSERT_EQ(a.items[0].history.size(), b.items[0].history.size());
  EXPECT_GT(a.items[0].demands.peak_tilt, 0.02);
  for (std::size_t k = 0; k < a.items[0].history.size(); ++k) {
    const auto &one = a.items[0].history[k], &other = b.items[0].history[k];
    ASSERT_LT((one.displacement - other.displacement).norm(), 1e-9) << k;
    ASSERT_LT(one.orientation.angularDistance(other.orientation), 1e-9) << k;
  }
}

TEST(Shapes, AHullOfABoxMeetsAWallAndABoxAsTheBox) {
  Scene box = blocks::block(50, {0.3, 0.4, 0.5}, rough(0.1));
  box.items[0].name = "first";
  blocks::add_wall(box, 0.4, rough(0.3, 0.5));
  box.items.push_back(box.items[0]);
  box.items[1].name = "second";
  box.items[1].initial.position = {-0.5, 0.05, 0};
  box.items[1].initial.velocity = {1.5, 0.1, 0};
  box.pairs.push_back({"steel", "steel", rough(0.3, 0.5)});
  Scene hull = box;
  for (PlacedItem& item : hull.items) as_hull(item.model);
  const SimulationSettings settings = blocks::run_for(1, 0.002, 0.02);
  const Response a = simulate(box, {}, settings), b = simulate(hull, {}, settings);
  EXPECT_GT(a.items[0].demands.impacts + a.items[1].demands.impacts, 1);
  for (std::size_t i = 0; i < 2; ++i) {
    const auto &one = a.items[i].history.back(), &other = b.items[i].history.back();
    EXPECT_LT((one.displacement - other.displacement).norm(), 1e-9) << i;
    EXPECT_LT(one.orientation.angularDistance(other.orientation), 1e-9) << i;
  }
}

// Steps of 1/32 of pi sqrt(m_c / 8 k): m_c = m / 4 acts at a corner, and eight corners touch wall and floor. The block
// itself on the four corners of the wall has half a period of pi sqrt(m / 4 k), 2 sqrt(2) as long; where 0.3 of its
// speed is given back, damping makes that some 2.5 times as long.
TEST(Shapes, ABlowTakesTheStepsOfItsHalfPeriod) {
  Scene scene = blocks::block(100, {1, 1, 1}, rough(0));
  scene.items[0].initial.velocity = {1, 0, 0};
  blocks::add_wall(scene, 0.7, rough(0, 0.3));
  const Response response = simulate(scene, {}, blocks::run_for(0.4, 0.004, 0.1));
  ASSERT_EQ(response.impacts.size(), 1u);
  EXPECT_GT(response.quality.event_steps, 32 * 2.8);
  EXPECT_LT(response.quality.event_steps, 32 * 2.8 * 4);
}

struct Roller {
  const char* name;
  BodyShape shape;
  double share;  // I / (m r^2)
};
const Roller kRollers[] = {{"cylinder", lying(0.05, 0.2), 0.5},
                           {"sphere", sphere_shape({0, 0, 0.05}, 0.05), 0.4}};

// F = m a_c and F r = I w' with w' r = a - a_c for a floor that accelerates at a: a_c = a k / (1 + k) with
// k = I / (m r^2), and the body stays back by a / (1 + k): 2 a / 3 and 5 a / 7. What the tangential spring
// of the contact yields, F / k_t below 1e-7 m, and the start of the motion within the first step are left.
TEST(Shapes, RollOnAFloorThatAccelerates) {
  const double a = 0.8, duration = 1;
  for (const Roller& each : kRollers) {
    const Scene scene = solid(2, each.shape, rough(0.5));
    const Response r = simulate(scene, steady(a, duration), blocks::run_for(duration, 0.002, 0.1));
    ASSERT_EQ(r.outcome, Outcome::kStopped) << r.cause;
    const Vector3 end = moved(scene, 0, r.items[0].history.back());
    EXPECT_NEAR(end.x(), -0.5 * a / (1 + each.share) * duration * duration, 2e-6) << each.name;
    EXPECT_NEAR(end.y(), 0, 1e-9);
    EXPECT_NEAR(end.z(), 0, 1e-6);
    EXPECT_LT(r.items[0].demands.peak_tilt, 1e-6) << "it rolls, it does not overturn";
    EXPECT_LT(r.quality.energy_closure, 1e-3) << each.name;
  }
}

// Down a slope at g sin(angle) / (1 + k), for one turn and more; and sliding at mu g cos(angle) less where
// friction does not hold: mu < tan(angle) k / (1 + k).
TEST(Shapes, RollDownASlope) {
  const double slope = 0.1, angle = std::atan(slope), duration = 1.2;
  for (const Roller& each : kRollers) {
    Scene scene = solid(2, each.shape, rough(0.5));
    scene.slope = slope;
    const Response r = simulate(scene, {}, blocks::run_for(duration, 0.002, 0.1));
    const double way = -0.5 * kGravity * std::sin(angle) / (1 + each.share) * duration * duration;
    EXPECT_NEAR(moved(scene, 0, r.items[0].history.back()).x(), way, 1e-4 * std::abs(way))
        << each.name;
    const double friction = 0.5 * slope * each.share / (1 + each.share);
    scene.pairs[0].constants.friction = friction;
    const Response slides = simulate(scene, {}, blocks::run_for(duration, 0.002, 0.1));
    const double slid =
        -0.5 * kGravity * (std::sin(angle) - friction * std::cos(angle)) * duration * duration;
    EXPECT_NEAR(moved(scene, 0, slides.items[0].history.back()).x(), slid, 1e-3 * std::abs(slid))
        << each.name;
  }
}

ContactConstants resisting(double length) {
  ContactConstants constants = rough(0.5);
  constants.rolling_resistance = length;
  return constants;
}

// With F the friction and the moment b N against the turn: m a_c = -F and I w' = F r - b N give, rolling,
// a_c = -(b / r) g / (1 + k). The pressure needs a path of b to run ahead, and b again when the body stands.
TEST(Shapes, WhatRollsIsSlowedAndStops) {
  const double radius = 0.05, length = 1e-3, start = 0.5;
  for (const Roller& each : kRollers) {
    Scene scene = solid(2, each.shape, resisting(length));
    scene.items[0].initial.velocity = {start, 0, 0};
    const Response r = simulate(scene, {}, blocks::run_for(6, 0.002, 0.05));
    ASSERT_FALSE(is_failure(r.outcome)) << r.cause;
    const auto x = [&](double time) {
      const auto k = static_cast<std::size_t>(std::lround(time / 0.05));
      return moved(scene, 0, r.items[0].history[k]).x();
    };
    // It slides first, until it turns as fast as it moves. Then it rolls.
    const double slows = length / radius * kGravity / (1 + each.share);
    EXPECT_NEAR(x(0.5) - 2 * x(1) + x(1.5), -slows * 0.25, 1e-3 * slows) << each.name;
    const double rolls = x(1.5) - x(0.5), path = rolls * rolls / (2 * slows);
    EXPECT_NEAR(x(6) - x(1), path, 2 * length) << each.name;
    EXPECT_NEAR(x(6), x(5.5), 1e-5) << each.name << " stands";
    EXPECT_LT(r.quality.energy_closure, 1e-3) << each.name;
  }
}

// Stands on a slope below b / r, and beyond goes down at g (sin - b / r cos) / (1 + k).
TEST(Shapes, RollingResistanceHoldsASlope) {
  const double radius = 0.05, length = 2e-3;
  for (const Roller& each : kRollers) {
    Scene scene = solid(2, each.shape, resisting(length));
    scene.slope = 0.95 * length / radius;
    const Response stands = simulate(scene, {}, blocks::run_for(20, 0.002, 0.1));
    EXPECT_LT(stands.items[0].demands.peak_displacement, 2 * length) << each.name;
    scene.slope = 0.1;
    const double angle = std::atan(scene.slope);
    const Response r = simulate(scene, {}, blocks::run_for(1.2, 0.002, 0.1));
    const double pull = std::sin(angle) - length / radius * std::cos(angle);
    const auto x = [&](std::size_t k) { return moved(scene, 0, r.items[0].history[k]).x(); };
    const double speeds_up = kGravity * pull / (1 + each.share);
    EXPECT_NEAR(x(2) - 2 * x(7) + x(12), -speeds_up * 0.25, 1e-3 * speeds_up) << each.name;
  }
}

// Below the limit the body rocks on its flat: of what the floor gives, the spring gives back all that damping
// leaves, which is no loss.
TEST(Shapes, RockingWithinTheRollingLengthKeepsItsEnergyBalance) {
  for (const Roller& each : kRollers) {
    const Scene scene = solid(2, each.shape, resisting(2e-3));
    const auto count = Eigen::Index{4001};
    Eigen::Matrix3Xd a = Eigen::Matrix3Xd::Zero(3, count);
    for (Eigen::Index k = 0; k < count; ++k)
      a(0, k) = 0.01 * kGravity * std::sin(2 * kPi * 0.001 * static_cast<double>(k));
    const Response r = simulate(scene, {0.001, a}, blocks::run_for(4, 0.002, 0.1));
    ASSERT_FALSE(is_failure(r.outcome)) << r.cause;
    EXPECT_LT(r.items[0].demands.peak_displacement, 4e-3) << each.name;
    EXPECT_LT(r.quality.energy_closure, 1e-3) << each.name;
  }
}

// A cylinder that rolls keeps the heading of its axis, and a sphere has none.
TEST(Shapes, WhatRollsDoesNotTurn) {
  for (const Roller& each : kRollers) {
    Scene scene = solid(2, each.shape, rough(0.5));
    scene.slope = 0.1;
    const Response r = simulate(scene, {}, blocks::run_for(1.2, 0.002, 0.1));
    EXPECT_LT(r.items[0].demands.peak_yaw, 1e-6) << each.name;
  }
}

// The resistance takes from a ball and gives to the trolley below, which has no friction: momentum stays,
// and in the end both move together.
TEST(Shapes, RollingResistanceActsOnBothBodies) {
  Scene scene = blocks::block(2, {1.5, 1, 0.3}, rough(0));
  scene.items[0].name = "tray";
  PlacedItem ball = solid(1, kRollers[1].shape, {}).items[0];
  ball.name = "ball";
  ball.model.material = "rubber";
  ball.on = Support{Support::Kind::kItem, 0, 0.3};
  ball.initial.position.x() = -0.6;
  ball.initial.velocity = {0.4, 0, 0};
  scene.items.push_back(ball);
  scene.pairs.push_back({"rubber", "steel", resisting(2e-3)});
  scene.pairs.push_back({"rubber", "concrete", rough(0.5)});
  const Response r = simulate(scene, {}, blocks::run_for(3, 0.002, 0.1));
  ASSERT_FALSE(is_failure(r.outcome)) << r.cause;
  const auto speed = [&](std::size_t i) {
    const std::vector<Sample>& history = r.items[i].history;
    return (moved(scene, i, history.back()) - moved(scene, i, history[history.size() - 2])).x() /
           0.1;
  };
  EXPECT_NEAR(2 * speed(0) + 1 * speed(1), 1 * 0.4, 1e-6);
  EXPECT_NEAR(speed(0), speed(1), 1e-4);
  EXPECT_LT(r.quality.energy_closure, 1e-3);
}

// On a tray that the floor carries along, the ball stays back by 5 a / 7.
TEST(Shapes, ABallRollsOnATrayAndOffIt) {
  Scene scene = blocks::block(40, {1, 1, 0.5}, rough(1));
  scene.items[0].name = "tray";
  PlacedItem ball = solid(0.5, kRollers[1].shape, {}).items[0];
  ball.name = "ball";
  ball.model.material = "rubber";
  ball.on = Support{Support::Kind::kItem, 0, 0.5};
  scene.items.push_back(ball);
  scene.pairs.push_back({"rubber", "steel", rough(0.5)});
  scene.pairs.push_back({"rubber", "concrete", rough(0.5)});
  EXPECT_TRUE(find_overlaps(scene).empty());
  const double a = 0.8, until = 1;
  const Response on = simulate(scene, steady(a, until), blocks::run_for(until, 0.002, 0.1));
  ASSERT_EQ(on.outcome, Outcome::kStopped) << on.cause;
  const auto at = [&](std::size_t i) { return moved(scene, i, on.items[i].history.back()).x(); };
  EXPECT_NEAR(at(1) - at(0), -0.5 * 5. / 7 * a * until * until, 5e-6);
  EXPECT_EQ(on.items[1].demands.time_of_fall, -1);
  // Its centre passes the edge after sqrt(2 0.5 m / (5 a / 7)) = 1.32 s.
  const Response off = simulate(scene, steady(a, 2), blocks::run_for(2, 0.002, 0.1));
  ASSERT_FALSE(is_failure(off.outcome)) << off.cause;
  const double passes = std::sqrt(2 * 0.5 * 7 / (5 * a));
  EXPECT_GT(off.items[1].demands.time_of_fall, passes);
  EXPECT_LT(off.items[1].demands.time_of_fall, passes + 0.15);
  EXPECT_GT(off.items[1].demands.largest_approach_speed, 0.9 * std::sqrt(2 * kGravity * 0.4));
}

// An upright cylinder of radius r and height h lifts off at a = g r / (h / 2), whatever the direction. The 8
// points that it keeps stand in for the rim up to a tilt of 1e-3: towards the middle between two of them it
// gives way earlier, at cos(22.5 deg) = 0.92 of that, and comes to rest on its rim.
TEST(Shapes, ACylinderTopplesAtItsSlenderness) {
  const double r = 0.04, h = 0.3, a = kGravity * r / (h / 2);
  for (const double direction : {0.0, kPi / 8, 1.0}) {
    const Scene scene = solid(1, upright(r, h), rough(2));
    const auto run = [&](double share) {
      return simulate(scene, steady(share * a, 2, direction), blocks::run_for(2, 0.002, 0.02));
    };
    const Response stands = run(0.97), topples = run(1.03);
    EXPECT_LT(stands.items[0].demands.peak_tilt, 0.01) << direction;
    EXPECT_GT(topples.items[0].demands.peak_tilt, kPi / 4) << direction;
  }
}

// A bottle that topples comes to lie and rolls; nothing gains energy.
TEST(Shapes, ABottleTopplesLiesAndRolls) {
  Scene scene = solid(1, upright(0.04, 0.3), rough(0.5, 0.3));
  scene.items[0].initial.velocity = {1.2, 0.1, 0};
  const Response r = simulate(scene, {}, blocks::run_for(4, 0.002, 0.02));
  ASSERT_FALSE(is_failure(r.outcome)) << r.cause;
  const auto& end = r.items[0].history.back();
  EXPECT_NEAR((end.orientation * Vector3::UnitZ()).z(), 0, 1e-3) << "lies";
  EXPECT_NEAR(moved(scene, 0, end).z(), 0.04 - 0.15, 1e-3);
  EXPECT_LT(r.quality.energy_closure, 0.01);
}

/// A regular hexagonal prism whose faces look along x.
BodyShape hexagon(double radius, double height) {
  std::vector<Vector3> points;
  for (int i = 0; i < 6; ++i)
    for (const double z : {0.0, height})
      points.emplace_back(radius * std::cos(kPi / 6 + kPi / 3 * i),
                          radius * std::sin(kPi / 6 + kPi / 3 * i), z);
  return hull_shape(points);
}

// Two hulls face to face, and off their middles, on a floor without friction: the sum of m v stays to the
// rounding of the solver, and with a restitution of 1 so does the energy, to 1 % (docs/theory/impact.md).
TEST(Shapes, HullsExchangeMomentumAndEnergy) {
  for (const double aside : {0.0, 0.03}) {
    Scene scene = solid(3, hexagon(0.1, 0.1), rough(0, 0.3));
    scene.items.push_back(solid(1, hexagon(0.1, 0.1), {}).items[0]);
    scene.items[0].name = "first";
    scene.items[1].name = "second";
    scene.items[1].initial.position = {0.25, aside, 0};
    scene.items[0].initial.velocity = {1, 0, 0};
    scene.pairs.push_back({"steel", "steel", rough(0, 1)});
    const Response r = simulate(scene, {}, blocks::run_for(0.5, 0.002, 0.1));
    const auto &a = r.items[0].history.back(), &b = r.items[1].history.back();
    EXPECT_LT((3 * a.velocity + b.velocity - Vector3(3, 0, 0)).head<2>().norm(), 1e-6);
    if (aside == 0) {
      EXPECT_NEAR(a.velocity.x(), 0.5, 0.01) << "(3 - 1) / (3 + 1)";
      EXPECT_NEAR(b.velocity.x(), 1.5, 0.01) << "2 * 3 / (3 + 1)";
    }
    EXPECT_LT(r.quality.energy_closure, 0.01);
  }
}

// Spheres of equal mass on a floor without friction: the one that is hit takes the part of the velocity
// along the line between them.
TEST(Shapes, SpheresExchangeVelocityAlongTheirLine) {
  const double radius = 0.05;
  Scene scene = solid(1, sphere_shape({0, 0, radius}, radius), rough(0, 0.3));
  scene.items.push_back(scene.items[0]);
  scene.items[0].name = "first";
  scene.items[1].name = "second";
  scene.items[1].initial.position = {0.3, radius, 0};  // offset r: the line is at 30 deg
  scene.items[0].initial.velocity = {1, 0, 0};
  scene.pairs.push_back({"steel", "steel", rough(0, 1)});
  const Response r = simulate(scene, {}, blocks::run_for(0.6, 0.001, 0.1));
  const Vector2 line(std::cos(kPi / 6), 0.5);
  const Vector2 hit = r.items[1].history.back().velocity.head<2>();
  EXPECT_LT((hit - line * line.x()).norm(), 0.01);
  EXPECT_LT(
      (r.items[0].history.back().velocity.head<2>() - (Vector2(1, 0) - line * line.x())).norm(),
      0.01);
}

// Two bottles beside each other: upright they touch along a line, thrown together they part again, and a
// third that lies on two others stays there.
TEST(Shapes, BottlesPushEachOther) {
  Scene scene = solid(1, upright(0.04, 0.2), rough(0, 0.3));
  scene.items.push_back(scene.items[0]);
  scene.items[0].name = "first";
  scene.items[1].name = "second";
  scene.items[1].initial.position = {0.2, 0, 0};
  scene.items[0].initial.velocity = {0.8, 0, 0};
  scene.pairs.push_back({"steel", "steel", rough(0, 1)});
  const Response r = simulate(scene, {}, blocks::run_for(0.4, 0.001, 0.1));
  EXPECT_NEAR(r.items[0].history.back().velocity.x(), 0, 0.008);
  EXPECT_NEAR(r.items[1].history.back().velocity.x(), 0.8, 0.008);
  EXPECT_LT(r.items[1].demands.peak_tilt, 0.01);
}

}  // namespace
}  // namespace gurney
