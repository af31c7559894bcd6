#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/bullet/contact_search.h"
#include "engine/run/simulate.h"
#include "engine/run/start.h"
#include "engine/solver/stepper.h"
#include "studies/verification/scenes/blocks.h"
#include "studies/verification/scenes/small_scenes.h"

// Bodies that ride on what holds them: as if they did not, but for what contacts and joints yield.
namespace gurney {
namespace {

constexpr double kGravity = 9.80665, kStep = 0.004;

ContactConstants rough(double friction, double restitution = 0.05) {
  ContactConstants constants;
  constants.friction = friction;
  constants.restitution = restitution;
  return constants;
}

PlacedItem box_on(std::size_t below, double height, double mass, const Vector3& size,
                  const std::string& material) {
  PlacedItem item = blocks::block(mass, size, {}).items[0];
  item.name = material + " box";
  item.model.material = material;
  item.on = Support{Support::Kind::kItem, below, height};
  return item;
}

/// A block of 40 kg, 1 m x 1 m x 0.5 m, and a box of 10 kg and 0.2 m on it.
Scene box_on_block(double friction_below, double friction_between) {
  Scene scene = blocks::block(40, {1, 1, 0.5}, rough(friction_below));
  scene.items[0].name = "block";
  scene.items.push_back(box_on(0, 0.5, 10, {0.2, 0.2, 0.2}, "rubber"));
  scene.pairs.push_back({"rubber", "steel", rough(friction_between)});
  scene.pairs.push_back({"rubber", "concrete", rough(0.5)});
  return scene;
}

/// A trolley on four casters with a drawer that is locked: 8 kg, beside and above its middle.
Scene trolley_with_drawer() {
  Scene scene = scene_of(small::trolley({10, 100, 200, 300}, small::bare_tread(3e5, 1e5)));
  for (Caster& caster : scene.items[0].model.casters) caster.tread.rolling_friction_length = 1e-3;
  scene.items[0].name = "trolley";
  PlacedItem drawer = blocks::block(8, {0.3, 0.2, 0.1}, {}).items[0];
  drawer.name = "drawer";
  drawer.model.material.clear();
  drawer.model.marked_points.clear();
  drawer.model.chassis_center_of_mass = {0.1, 0.15, 0.8};
  drawer.model.shape[0].center = {0.1, 0.15, 0.8};
  scene.items.push_back(drawer);
  Joint joint;
  joint.kind = Joint::Kind::kSlider;
  joint.name = "drawer";
  joint.base = 0;
  joint.part = 1;
  joint.point = {0.1, 0.15, 0.8};
  joint.axis = Vector3::UnitY();
  joint.latch = Joint::kFree;
  scene.joints = {joint};
  return scene;
}

SimulationSettings free_bodies(SimulationSettings settings) {
  settings.merge_held_bodies = false;
  return settings;
}

// A drawer that is locked and rides makes one body with its trolley: that of the same mass, centre and inertia. Free,
// its joint yields 0.1 um. At the start it has yielded so, and the trolley has come to rest with it: 1e-6 m of path.
TEST(Riders, ALockedPartIsOfOneBodyWithItsChassis) {
  const Scene parts = trolley_with_drawer();
  Scene one = parts;
  one.joints.clear();
  one.items.pop_back();
  const EquipmentModel& drawer = parts.items[1].model;
  one.items[0].model.payloads.push_back(
      {"drawer", 8, drawer.chassis_center_of_mass, drawer.chassis_inertia});
  const FloorMotion floor = small::noise_record(3, 8, {3, 2, 1});
  const SimulationSettings settings = blocks::run_for(8, kStep, 0.02);
  const Response merged = simulate(parts, floor, settings), rigid = simulate(one, floor, settings);
  ASSERT_GT(rigid.items[0].demands.peak_displacement, 0.02);
  ASSERT_GT(rigid.items[0].demands.peak_yaw, 0.02);
  for (std::size_t k = 0; k < rigid.items[0].history.size(); ++k)
    ASSERT_LT(
        (merged.items[0].history[k].displacement - rigid.items[0].history[k].displacement).norm(),
        1e-6)
        << k;
  // It has no unknowns of its own: as many iterations, but for a few where a stage is at the edge of its tolerance.
  EXPECT_NEAR(merged.quality.newton_iterations, rigid.quality.newton_iterations,
              0.02 * rigid.quality.newton_iterations);
  // The closure is that of the trolley under these motions; the drawer adds none of its kind.
  EXPECT_LT(merged.quality.energy_closure, 2 * rigid.quality.energy_closure);
}

// A bumper that is locked to its block meets another block off its centre, as one of one body does: by the same
// equations, so that Newton's method takes as many iterations.
class OneBody : public testing::TestWithParam<bool> {};

TEST_P(OneBody, PushesAsItsPartsTogether) {
  const bool other_first = GetParam();
  Scene parts = blocks::block(40, {1, 1, 0.5}, rough(0));
  parts.items[0].name = "block";
  parts.items[0].initial.velocity = {1, 0, 0};
  PlacedItem bumper = blocks::block(8, {0.2, 0.2, 0.2}, {}).items[0];
  bumper.name = "bumper";
  bumper.model.marked_points.clear();
  bumper.model.chassis_center_of_mass = {0.6, 0.3, 0.3};
  bumper.model.shape[0].center = {0.6, 0.3, 0.3};
  bumper.initial.velocity = {1, 0, 0};
  PlacedItem other = parts.items[0];
  other.name = "other";
  other.initial.position = {1.3, 0.2, 0};
  other.initial.velocity.setZero();
  Scene one = parts;
  one.items[0].model.shape.push_back(bumper.model.shape[0]);
  one.items[0].model.payloads.push_back(
      {"bumper", 8, bumper.model.chassis_center_of_mass, bumper.model.chassis_inertia});
  parts.items.push_back(bumper);
  for (Scene* scene : {&one, &parts})
    scene->items.insert(other_first ? scene->items.begin() : scene->items.end(), other);
  for (Scene* scene : {&one, &parts}) scene->pairs.push_back({"steel", "steel", rough(0.3, 0.4)});
  parts.joints = trolley_with_drawer().joints;
  const std::size_t block = other_first ? 1 : 0;
  parts.joints[0].base = block;
  parts.joints[0].part = block + 1;
  const SimulationSettings settings = blocks::run_for(0.6, kStep, kStep);
  const Response merged = simulate(parts, {}, settings), rigid = simulate(one, {}, settings);
  ASSERT_FALSE(rigid.impacts.empty());
  ASSERT_EQ(merged.impacts.size(), rigid.impacts.size());
  EXPECT_NEAR(merged.impacts[0].impulse, rigid.impacts[0].impulse, 1e-4 * rigid.impacts[0].impulse);
  EXPECT_GT(std::abs(rigid.items[block].demands.residual_yaw), 0.05);
  EXPECT_NEAR(merged.items[block].demands.residual_yaw, rigid.items[block].demands.residual_yaw,
              1e-5);
  // Both runs solve the same equations; blocks in another order make some matrices serve longer. A wrong matrix takes a
  // fifth more iterations.
  EXPECT_NEAR(merged.quality.newton_iterations, rigid.quality.newton_iterations,
              0.1 * rigid.quality.newton_iterations);
}

INSTANTIATE_TEST_SUITE_P(Riders, OneBody, testing::Bool());

// Boxes stick on a trolley that rolls. Free, they yield by 12 kg 1 m/s2 / (4 points 8e6 N/m) = 4e-7 m, and as the
// trolley swings on treads without damping ten times that: 1e-5 m in all.
TEST(Riders, MoveAsWithoutRiding) {
  Scene scene = scene_of(small::trolley({10, 100, 200, 300}, small::bare_tread(3e5, 1e5)));
  scene.items[0].name = "trolley";
  scene.items[0].model.material = "steel";
  scene.items[0].model.shape = {{{0, 0, 0.4}, {0.8, 0.5, 0.6}}};
  scene.items.push_back(box_on(0, 0.7, 10, {0.2, 0.2, 0.2}, "rubber"));
  scene.items.push_back(box_on(1, 0.9, 2, {0.1, 0.1, 0.1}, "paper"));
  scene.items[1].initial.position = {0.2, 0.1, 0};
  scene.items[2].initial.position = {0.2, 0.1, 0};
  scene.floor_material = "concrete";
  for (const char* material : {"steel", "rubber", "paper"})
    scene.pairs.push_back({material, "concrete", rough(0.6)});
  for (const auto& [a, b] : {std::pair{"rubber", "steel"}, {"paper", "rubber"}, {"paper", "steel"}})
    scene.pairs.push_back({a, b, rough(0.6)});
  const FloorMotion floor = small::noise_record(4, 8, {1, 0.7, 0});
  const SimulationSettings settings = blocks::run_for(8, kStep, 0.02);
  const Response merged = simulate(scene, floor, settings),
                 freely = simulate(scene, floor, free_bodies(settings));
  for (std::size_t i = 0; i < 3; ++i) {
    const Demands &a = merged.items[i].demands, &b = freely.items[i].demands;
    EXPECT_NEAR(a.peak_displacement, b.peak_displacement, 1e-5) << i;
    EXPECT_NEAR(a.residual_yaw, b.residual_yaw, 1e-4) << i;
    EXPECT_EQ(a.impacts, 0) << i;
  }
  EXPECT_GT(merged.items[0].demands.peak_displacement, 0.02);
  // A body that rides does not move at all on its carrier.
  EXPECT_LT(merged.items[2].demands.peak_slide, freely.items[2].demands.peak_slide);
  EXPECT_LT(freely.items[2].demands.peak_slide, 1e-5);
  EXPECT_LT(merged.quality.newton_iterations, 0.6 * freely.quality.newton_iterations);
  EXPECT_LT(merged.quality.energy_closure, 1e-4);
}

// Without friction below, a box that slides on a block until both go on together, and ride, keeps the momentum of
// both: to the residual of 1e-9 M g h a step, 250 steps.
TEST(Riders, KeepMomentum) {
  Scene scene = box_on_block(0, 0.3);
  scene.items[0].initial.velocity = {0.5, 0, 0};
  const Response response = simulate(scene, {}, blocks::run_for(1, kStep, kStep));
  for (const std::size_t k : {std::size_t{120}, std::size_t{250}}) {
    const Vector3 p =
        40 * response.items[0].history[k].velocity + 10 * response.items[1].history[k].velocity;
    EXPECT_NEAR(p.x(), 20, 250 * 1e-9 * 50 * kGravity * kStep) << k;
  }
  const auto gap = [&](std::size_t k) {
    return (response.items[1].history[k].displacement - response.items[0].history[k].displacement)
        .x();
  };
  // It rides from 0.34 s + 0.05 s on: the distance between the two stays to the last bits.
  EXPECT_GT(std::abs(gap(250)), 0.02);
  EXPECT_NEAR(gap(120), gap(250), 1e-12);
}

// A block without friction below meets a wall that gives nothing back and stops within milliseconds, pushed on by the
// box that has ridden on it and is free from then on: it goes on over v^2 / (2 mu g). The end of slip inside a step
// leaves v h / 8.
TEST(Riders, LeaveWhereTheCarrierIsStopped) {
  const double v = 1, mu = 0.3;
  Scene scene = box_on_block(0, mu);
  scene.items[0].initial.velocity = {v, 0, 0};
  scene.items[1].initial.velocity = {v, 0, 0};
  blocks::add_wall(scene, 0.7, rough(0));
  scene.pairs.push_back({"rubber", "plaster", rough(0)});
  const Response merged = simulate(scene, {}, blocks::run_for(1.5, kStep, kStep));
  const Response freely = simulate(scene, {}, free_bodies(blocks::run_for(1.5, kStep, kStep)));
  const double slide = v * v / (2 * mu * kGravity);
  EXPECT_NEAR(merged.items[1].demands.peak_slide, freely.items[1].demands.peak_slide, 1e-3);
  EXPECT_NEAR(merged.items[1].demands.peak_slide, slide, v * kStep / 8);
  ASSERT_FALSE(merged.impacts.empty());
  EXPECT_NEAR(merged.impacts[0].approach_speed, v, 1e-6);
  EXPECT_NEAR(merged.impacts[0].impulse, freely.impacts[0].impulse,
              0.01 * freely.impacts[0].impulse);
}

// A box that slides into one that rides pushes it as it would a free one: momentum and energy of the three.
TEST(Riders, ArePushedByOthers) {
  Scene scene = box_on_block(0, 0.4);
  scene.items.push_back(box_on(0, 0.5, 5, {0.2, 0.2, 0.2}, "paper"));
  scene.items[1].initial.position = {0.2, 0, 0};
  scene.items[2].initial.position = {-0.2, 0, 0};
  scene.items[2].initial.velocity = {1.2, 0, 0};
  scene.pairs.push_back({"paper", "steel", rough(0.1)});
  scene.pairs.push_back({"paper", "rubber", rough(0.1, 0.3)});
  scene.pairs.push_back({"paper", "concrete", rough(0.1)});
  const Response merged = simulate(scene, {}, blocks::run_for(1, kStep, kStep));
  const Response freely = simulate(scene, {}, free_bodies(blocks::run_for(1, kStep, kStep)));
  Vector3 p = Vector3::Zero();
  for (std::size_t i = 0; i < 3; ++i)
    p += scene.items[i].model.chassis_mass * merged.items[i].history.back().velocity;
  EXPECT_NEAR(p.x(), 6, 1e-5);
  ASSERT_EQ(merged.impacts.size(), freely.impacts.size());
  ASSERT_FALSE(merged.impacts.empty());
  EXPECT_NEAR(merged.impacts[0].impulse, freely.impacts[0].impulse,
              0.01 * freely.impacts[0].impulse);
  EXPECT_GT(merged.items[1].demands.peak_slide, 1e-3);
  EXPECT_NEAR(merged.items[1].demands.peak_slide, freely.items[1].demands.peak_slide, 5e-4);
  EXPECT_LT(merged.quality.energy_closure, 1e-4);
}

// A box that leaves its block gives the scene new contacts in the middle of a step, before those of another block and
// its box, which slides and stays as it is without the first two.
TEST(Riders, LeaveOthersAlone) {
  Scene scene = box_on_block(0, 0.3);
  scene.items[0].initial.velocity = scene.items[1].initial.velocity = {1, 0, 0};
  blocks::add_wall(scene, 0.7, rough(0));
  scene.pairs.push_back({"rubber", "plaster", rough(0)});
  for (const char* material : {"steel", "rubber"})
    scene.pairs.push_back({material, material, rough(0.3)});
  Scene both = scene;
  for (std::size_t i = 0; i < 2; ++i) {
    PlacedItem item = scene.items[i];
    item.name += " behind";
    item.initial.position = {-20, 0, 0};
    item.initial.velocity = {i == 0 ? 1.0 : 0.2, 0, 0};
    if (item.on) item.on->index = 2;
    both.items.push_back(item);
  }
  Scene behind = both;
  behind.items.erase(behind.items.begin(), behind.items.begin() + 2);
  behind.items[1].on->index = 0;
  const SimulationSettings settings = blocks::run_for(0.5, kStep, kStep);
  const Response of_both = simulate(both, {}, settings), alone = simulate(behind, {}, settings),
                 first = simulate(scene, {}, settings);
  ASSERT_EQ(of_both.outcome, Outcome::kStopped) << of_both.cause;
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR(of_both.items[2 + i].demands.peak_displacement,
                alone.items[i].demands.peak_displacement, 1e-9);
    EXPECT_NEAR(of_both.items[i].demands.peak_displacement,
                first.items[i].demands.peak_displacement, 1e-9);
  }
  EXPECT_GT(alone.items[1].demands.peak_slide, 0.05);
  EXPECT_GT(first.items[1].demands.peak_slide, 0.05);
}

/// Riders of a scene at rest, after so long that what is held rides.
class AtRest {
 public:
  explicit AtRest(const Scene& scene)
      : scene_(scene), assembly_(scene_), state_(start_of(scene_, assembly_)) {
    ContactSearch search(scene_, assembly_, true);
    for (BodyContactState& memory : state_.contacts) memory.approach_speed = 0.5;  // of a landing
    for (double time = 0; time < 3 * Riders::kHoldTime; time += kStep) {
      stepper_.board(state_);
      stepper_.set_contacts(search.find(state_, kStep, &riders()), state_);
      EXPECT_FALSE(stepper_.advance(state_, time + kStep, {}).has_value());
    }
  }
  const Riders& riders() const { return stepper_.riders(); }
  /// Contacts that a body has which leaves under this wrench.
  std::vector<BodyContactState> left(const Vector6& wrench) {
    Riders riders = this->riders();
    std::vector<EnergyAccount> accounts(scene_.items.size());
    std::vector<BodyContactState> contacts;
    riders.hold(1, wrench);
    riders.leave(1, state_, accounts, contacts);
    EXPECT_FALSE(riders.rides(1));
    return contacts;
  }
  const SceneState& state() const { return state_; }
  bool bears(const Vector3& force, const Vector3& moment) const {
    Vector6 wrench;
    wrench << force, moment;
    return riders().bears(1, state_, wrench);
  }

 private:
  Scene scene_;
  Assembly assembly_;
  SceneState state_;
  FloorMotion floor_;
  Stepper stepper_{assembly_, floor_, blocks::run_for(1, kStep, kStep)};
};

// N = 98 N on a base of 0.2 m, 0.1 m below the centre, mu = 0.5: 0.9 mu N along it, 0.9 x 0.1 m of centre of
// pressure, and 0.9 mu N times the 0.1 m sqrt(2) of its corners about it.
TEST(Riders, BearNineTenthsOfWhatHoldsThem) {
  const AtRest box(box_on_block(0.5, 0.5));
  ASSERT_TRUE(box.riders().rides(1));
  EXPECT_FALSE(box.riders().rides(0));
  EXPECT_EQ(box.riders().carrier(1), 0U);
  EXPECT_TRUE(box.riders().together(0, 1));
  const double n = 10 * kGravity, limit = 0.9 * 0.5 * n;
  // A force along the base, at the base: its moment about the centre is taken out.
  const auto along = [&](double f) {
    return box.bears({f, 0, n}, Vector3(0, 0, -0.1).cross(Vector3(f, 0, 0)));
  };
  EXPECT_TRUE(along(0.99 * limit));
  EXPECT_FALSE(along(1.01 * limit));
  EXPECT_FALSE(along(-1.01 * limit));
  for (const double side : {-1.0, 1.0}) {
    EXPECT_TRUE(box.bears({0, 0, n}, {0, side * 0.089 * n, 0}));
    EXPECT_FALSE(box.bears({0, 0, n}, {0, side * 0.091 * n, 0}));
    EXPECT_TRUE(box.bears({0, 0, n}, {side * 0.089 * n, 0, 0}));
    EXPECT_FALSE(box.bears({0, 0, n}, {side * 0.091 * n, 0, 0}));
    const double turning = limit * 0.1 * std::numbers::sqrt2;
    EXPECT_TRUE(box.bears({0, 0, n}, {0, 0, side * 0.99 * turning}));
    EXPECT_FALSE(box.bears({0, 0, n}, {0, 0, side * 1.01 * turning}));
  }
  EXPECT_FALSE(box.bears({0, 0, -1}, Vector3::Zero()));
  EXPECT_FALSE(box.bears({0, 0, 0}, Vector3::Zero()));
}

// A body that leaves is where the springs below it bear the wrench that has held it: their
// compressions and deflections, and its place, from which those follow. It turns by 9e-6 m over 0.2
// m: what is of second order in this, 4e-10 m and 4e-5 of the wrench, is left out. With the centre
// of pressure at the edge the two points behind part.
TEST(Riders, LeaveWithTheWrenchInTheirContacts) {
  constexpr double kStiffness = 1e7, kTangential = 0.8 * kStiffness;
  for (const double off : {0.02, 0.08, 0.0999}) {
    AtRest box(box_on_block(0.5, 0.5));
    Vector6 wrench;
    wrench << 12, -7, 90, 7 * -0.1, 12 * -0.1 + off * 90, 0.6;
    const std::vector<BodyContactState> contacts = box.left(wrench);
    ASSERT_EQ(contacts.size(), 4U);
    const State &own = box.state().items[1], &below = box.state().items[0];
    Vector6 sum = Vector6::Zero();
    for (const BodyContactState& memory : contacts) {
      const Vector3 arm = own.rotation * memory.contact.other_side.local;
      const Vector3 on_block = below.position + below.rotation * memory.contact.side.local;
      const double overlap = (own.position + arm - on_block).dot(memory.contact.normal);
      EXPECT_NEAR(memory.compression + memory.slack, overlap, 4e-10);
      EXPECT_EQ(memory.approach_speed, 0);
      if (memory.compression <= 0) continue;
      const Vector3 force =
          kTangential * memory.deflection - kStiffness * memory.compression * memory.contact.normal;
      sum.head<3>() += force;
      sum.tail<3>() += arm.cross(force);
    }
    EXPECT_LT((sum - wrench).norm(), 4e-5 * wrench.norm()) << off;
  }
}

// A latch of 15 N holds its drawer along its axis up to 13.5 N, across it whatever comes; a hinge by its moment about
// the axis, to which a force at the centre adds its arm.
TEST(Riders, LatchesBearNineTenths) {
  Scene scene = trolley_with_drawer();
  scene.joints[0].latch = 15;
  const AtRest drawer(scene);
  ASSERT_TRUE(drawer.riders().rides(1));
  EXPECT_TRUE(drawer.riders().rests(0));
  for (const double side : {-1.0, 1.0}) {
    EXPECT_TRUE(drawer.bears({100, side * 13.4, 50}, {100, 100, 100}));
    EXPECT_FALSE(drawer.bears({0, side * 13.6, 0}, Vector3::Zero()));
  }
  Scene door = trolley_with_drawer();
  door.joints[0].kind = Joint::Kind::kHinge;
  door.joints[0].axis = Vector3::UnitZ();
  door.joints[0].point = {-0.1, 0.15, 0.8};  // 0.2 m behind the centre
  door.joints[0].latch = 15;
  const AtRest hinge(door);
  ASSERT_TRUE(hinge.riders().rides(1));
  EXPECT_TRUE(hinge.bears({0, 0.99 * 13.5 / 0.2, 0}, Vector3::Zero()));
  EXPECT_FALSE(hinge.bears({0, 1.01 * 13.5 / 0.2, 0}, Vector3::Zero()));
  EXPECT_TRUE(hinge.bears({0, 10 / 0.2, 0}, {0, 0, 3}));
  EXPECT_FALSE(hinge.bears({0, 10 / 0.2, 0}, {0, 0, 4}));
}

// A latch of 15 N and friction of 5 N, which both yield by 0.1 mm, bear 12 N at 0.06 mm. Friction that was wound up the
// other way pushes with them, by 5 N; where the latch would have to bear more than its strength, it is just closed. A
// stop of 1e5 N/m beside them takes a third.
TEST(Riders, LeaveWhereLatchFrictionAndStopBear) {
  Scene scene = trolley_with_drawer();
  scene.joints[0].latch = 15;
  scene.joints[0].friction = 5;
  const auto yielded = [&](double along, double wind) {
    const Assembly assembly(scene);
    JointState state = assembly.joints[0].initial_state();
    state.wind = wind;
    return assembly.joints[0].yielded(state, along);
  };
  EXPECT_NEAR(yielded(-12, 0).coordinate, 12 / 2e5, 1e-12);
  EXPECT_NEAR(yielded(-12, 0).wind, 12 / 2e5, 1e-12);
  EXPECT_NEAR(yielded(12, 0).coordinate, -12 / 2e5, 1e-12);
  EXPECT_NEAR(yielded(-12, -1e-4).coordinate, 17 / 2e5, 1e-12);
  EXPECT_NEAR(yielded(-18, -1e-4).coordinate, 0.999e-4, 1e-12);
  scene.joints[0].lower = 0;
  EXPECT_NEAR(yielded(12, 0).coordinate, -12 / 3e5, 1e-12);
  EXPECT_NEAR(yielded(-12, 0).coordinate, 12 / 2e5, 1e-12);
}

FloorMotion slow_sine(double size, double duration) {
  Eigen::Matrix3Xd a = Eigen::Matrix3Xd::Zero(3, std::lround(duration / 0.001) + 1);
  for (Eigen::Index i = 0; i < a.cols(); ++i)
    a(0, i) = size * std::min(1.0, 0.001 * double(i)) *
              std::sin(2 * std::numbers::pi * 0.001 * double(i));
  return {0.001, a};
}

// A drawer of 40 kg on a latch of 20 N is a soft one, 11 rad/s on its 0.1 mm, damped by 6 %. At
// 0.95 F / m it has left its ride and holds still, from where its latch bore it: a step of its load
// would open it at half of its strength.
TEST(Riders, LeaveTheirLatchesLoaded) {
  Scene scene = blocks::block(400, {1, 1, 0.5}, rough(0.9));
  scene.items[0].name = "block";
  for (Guide& guide : scene.items[0].fixture.guides) guide.kind = Guide::Kind::kHeld;
  PlacedItem drawer = blocks::block(40, {0.4, 0.4, 0.2}, {}).items[0];
  drawer.name = "drawer";
  drawer.model.chassis_center_of_mass = drawer.model.shape[0].center = {0, 0, 0.25};
  scene.items.push_back(drawer);
  scene.joints = trolley_with_drawer().joints;
  scene.joints[0].axis = Vector3::UnitX();
  scene.joints[0].point = {0, 0, 0.25};
  scene.joints[0].latch = 20;
  scene.pairs.push_back({"steel", "steel", rough(0.5)});
  const auto peak = [&](double part) {
    return simulate(scene, slow_sine(part * 20 / 40, 4), blocks::run_for(4, kStep, kStep))
        .items[1]
        .demands.peak_travel;
  };
  EXPECT_LT(peak(0.95), JointLaw::kYield);
  EXPECT_GT(peak(1.05), 0.01);
}

// A heavy box on a light one on a middle one. As the lowest leaves its table, the boxes that ride
// on it go down with it: by some micrometres, whose weight is in the energy balance.
TEST(Riders, TakeAlongWhatRidesOnThem) {
  Scene scene = blocks::block(400, {1, 1, 0.5}, rough(0.9));
  scene.items[0].name = "table";
  scene.items.push_back(box_on(0, 0.5, 10, {0.3, 0.3, 0.2}, "rubber"));
  scene.items.push_back(box_on(1, 0.7, 8, {0.25, 0.25, 0.1}, "paper"));
  scene.items.push_back(box_on(2, 0.8, 30, {0.2, 0.2, 0.2}, "wood"));
  const char* materials[] = {"steel", "rubber", "paper", "wood"};
  for (const char* a : materials)
    for (const char* b : materials)
      if (a != std::string("steel") || b != std::string("steel"))
        scene.pairs.push_back(
            {a, b, rough(b == std::string("steel") || a == std::string("steel") ? 0.3 : 0.9)});
  for (const char* a : {"rubber", "paper", "wood"})
    scene.pairs.push_back({a, "concrete", rough(0.5)});
  const Response response = simulate(scene, slow_sine(4, 3), blocks::run_for(3, kStep, kStep));
  EXPECT_GT(response.items[1].demands.peak_slide, 1e-3);
  EXPECT_LT(response.items[3].demands.peak_slide, 1e-4);
  EXPECT_LT(response.quality.energy_closure, 1e-4);
  // The work of the springs below them while they rode is no error of the integration.
  EXPECT_LT(std::abs(response.quality.numerical_loss), 0.02);
}

// A cord between bodies that move together is in the matrix of the one that carries them. Under a steady push a box
// slides until its strap is taut, which holds it, and rides: three iterations a step; without that, seven.
TEST(Riders, MayBeTiedToTheirCarrier) {
  Scene scene = box_on_block(0.8, 0.1);
  scene.tethers = {{.name = "strap",
                    .item = 1,
                    .point = {0, 0, 0.1},
                    .anchor = {0.4, 0, 0.9},
                    .slack_length = 0.51,
                    .stiffness = 1e7,
                    .damping = 1e4}};
  scene.tethers[0].anchor_item = 0;
  Eigen::Matrix3Xd a = Eigen::Matrix3Xd::Zero(3, 4001);
  for (Eigen::Index i = 0; i < a.cols(); ++i)
    a(0, i) = 1.5 + 0.4 * std::sin(2 * std::numbers::pi * 2 * 0.001 * double(i));
  const Response merged = simulate(scene, {0.001, a}, blocks::run_for(4, kStep, kStep));
  ASSERT_GE(merged.tethers[0].time_taut, 0);
  EXPECT_LT(merged.quality.newton_iterations, 4 * merged.quality.steps);
}

// A box on contacts of 1e6 N/m, which yield by 98 N / 4e6 N/m = 0.0245 mm, moves on them.
TEST(Riders, AreNotWhatStandsOnSoftContacts) {
  Scene scene = box_on_block(0.5, 0.5);
  scene.pairs[1].constants.stiffness = 1e6;
  EXPECT_FALSE(AtRest(scene).riders().rides(1));
  scene.pairs[1].constants.stiffness = 1.3e6;
  EXPECT_TRUE(AtRest(scene).riders().rides(1));
}

// A spring that wants to move a latched part, a ball or a bag on a hinge without a latch: all of these move by
// themselves.
TEST(Riders, AreOnlyWhatIsHeld) {
  Scene scene = trolley_with_drawer();
  scene.joints[0].latch = 0;
  scene.joints[0].friction = 5;
  EXPECT_FALSE(AtRest(scene).riders().rides(1));
  scene.joints[0].latch = 15;
  scene.joints[0].stiffness = 10;
  EXPECT_FALSE(AtRest(scene).riders().rides(1));
  scene.joints[0] = trolley_with_drawer().joints[0];
  scene.joints[0].kind = Joint::Kind::kFixed;
  scene.joints[0].latch = 0;
  EXPECT_TRUE(AtRest(scene).riders().rides(1));
  SimulationSettings settings = blocks::run_for(0.1, kStep, kStep);
  settings.merge_held_bodies = false;
  const Assembly assembly(scene);
  SceneState state = start_of(scene, assembly);
  const FloorMotion floor;
  Stepper stepper(assembly, floor, settings);
  stepper.board(state);
  EXPECT_FALSE(stepper.riders().rides(1));
}

}  // namespace
}  // namespace gurney
