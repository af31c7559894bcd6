#include "engine/record/recorder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "studies/verification/scenes/blocks.h"
#include "studies/verification/scenes/small_scenes.h"

// Steps of one item, made by hand.
namespace gurney {
namespace {

using std::numbers::pi;

struct Motion {
  Vector3 position, velocity = Vector3::Zero();
  double yaw = 0, yaw_rate = 0, pitch = 0;
  Vector3 acceleration = Vector3::Zero(), floor = Vector3::Zero();
  double yaw_acceleration = 0;
};

/// A block of 0.5 x 0.4 x 0.6 m whose centre is 0.3 m over its origin; its marked points are that
/// centre and one 1 m ahead of it.
class Block {
 public:
  Block()
      : scene_(blocks::block(10, {0.5, 0.4, 0.6}, {})),
        assembly_(scene_),
        state_(start()),
        recorder_(scene_, assembly_, 0, state_) {}

  void move(double duration, const Motion& motion, const ImpactLog::Kinds& impacts = {}) {
    SceneState to = state_;
    State& item = to.items[0];
    item.time += duration;
    item.position = motion.position;
    item.rotation = Quaternion(Eigen::AngleAxisd(motion.yaw, Vector3::UnitZ()) *
                               Eigen::AngleAxisd(motion.pitch, Vector3::UnitY()));
    item.velocity.chassis << motion.velocity, 0, 0, motion.yaw_rate;
    StageSolver::Output first, end;
    first.items.resize(1);
    end.items.resize(1);
    end.items[0].acceleration.chassis << motion.acceleration, 0, 0, motion.yaw_acceleration;
    const Island island{{0}, 0, 0};
    recorder_.observe({&island,
                       state_.items[0].time,
                       duration,
                       &state_,
                       &to,
                       &first,
                       &end,
                       {motion.floor, motion.floor, Vector3::Zero()}},
                      impacts);
    state_ = to;
  }
  Recorder& recorder() { return recorder_; }
  const SceneState& state() const { return state_; }
  ItemResponse result(const EnergyAccount& account = {}, std::vector<Impact> impacts = {}) {
    Response response;
    response.items.clear();
    response.impacts = std::move(impacts);
    recorder_.finish(state_, account, -1, response);
    quality_ = response.quality;
    return response.items.at(0);
  }
  const Quality& quality() const { return quality_; }

 private:
  static SceneState start() {
    SceneState state;
    state.items.resize(1);
    state.items[0].position = {0, 0, 0.3};
    return state;
  }

  Scene scene_;
  Assembly assembly_;
  SceneState state_;
  Recorder recorder_;
  Quality quality_;
};

// 3 m forward, 4 m to the left, back to the start along the diagonal.
TEST(Recorder, SumsThePathAndKeepsThePeaks) {
  Block block;
  block.move(1, {.position = {3, 0, 0.3}, .velocity = {1.5, 0, 0.7}});
  block.move(1, {.position = {3, -4, 0.3}, .velocity = {0, -2, 0}});
  block.move(1, {.position = {0, -1, 0.3}});
  const Demands demands = block.result().demands;
  EXPECT_NEAR(demands.path_length, 3 + 4 + std::hypot(3, 3), 1e-14);
  EXPECT_NEAR(demands.peak_displacement, 5, 1e-14);
  EXPECT_EQ(demands.time_of_peak_displacement, 2);
  EXPECT_NEAR(demands.peak_displacement_x, 3, 1e-14);
  EXPECT_NEAR(demands.peak_displacement_y, 4, 1e-14);
  EXPECT_NEAR(demands.residual_displacement, 1, 1e-14);
  EXPECT_NEAR(demands.residual_displacement_y, -1, 1e-14);
  EXPECT_EQ(demands.peak_velocity, 2);
}

// The origin is 0.3 m below the centre: a pitch throws it back by 0.3 sin(pitch).
TEST(Recorder, FollowsTheOriginOfAnItemThatTilts) {
  Block block;
  block.move(1, {.position = {0, 0, 0.3}, .pitch = 0.2});
  block.move(1, {.position = {0, 0, 0.3}, .pitch = 0.1});
  const Demands demands = block.result().demands;
  EXPECT_NEAR(demands.peak_displacement, 0.3 * std::sin(0.2), 1e-14);
  EXPECT_NEAR(demands.residual_displacement_x, -0.3 * std::sin(0.1), 1e-14);
  EXPECT_NEAR(demands.peak_tilt, 0.2, 1e-12);
  EXPECT_EQ(demands.time_of_peak_tilt, 1);
}

TEST(Recorder, CountsTurnsOfTheYaw) {
  Block block;
  for (int i = 1; i <= 10; ++i) block.move(1, {.position = {0, 0, 0.3}, .yaw = 0.8 * i});
  for (int i = 9; i >= 8; --i) block.move(1, {.position = {0, 0, 0.3}, .yaw = 0.8 * i});
  const Demands demands = block.result().demands;
  EXPECT_NEAR(demands.peak_yaw, 8, 1e-12);
  EXPECT_NEAR(demands.residual_yaw, 6.4, 1e-12);
}

// 1 m ahead of a centre that accelerates with (1, 0, 0) on a floor with (0, 2, 0), turned by 90
// degrees: -w' along x, -w^2 along y.
TEST(Recorder, AddsTheAccelerationsOfCentreTurnAndFloor) {
  Block block;
  block.move(1, {.position = {0, 0, 0.3},
                 .yaw = pi / 2,
                 .yaw_rate = 3,
                 .acceleration = {1, 0, 0},
                 .floor = {0, 2, 0},
                 .yaw_acceleration = 5});
  const Demands demands = block.result().demands;
  ASSERT_EQ(demands.points.size(), 2u);
  EXPECT_NEAR(demands.points[0].peak_absolute_acceleration, std::hypot(1, 2), 1e-12);
  EXPECT_NEAR(demands.points[1].peak_absolute_acceleration, std::hypot(1 - 5, 2 - 9), 1e-12);
  EXPECT_NEAR(demands.points[1].peak_displacement, std::numbers::sqrt2, 1e-12);
}

TEST(Recorder, BooksAccelerationsOfImpactsByTheirLaw) {
  Block block;
  const auto shake = [&](double a, const ImpactLog::Kinds& kinds) {
    block.move(1, {.position = {0, 0, 0.3}, .acceleration = {a, 0, 0}}, kinds);
  };
  shake(1, {});
  EXPECT_TRUE(std::isnan(block.result().demands.points[0].impact_acceleration));
  EXPECT_TRUE(std::isnan(block.result().demands.points[0].numerical_acceleration));
  shake(7, {.restitution = true});
  shake(5, {.restitution = true, .compliant = true});
  shake(3, {.compliant = true});
  shake(2, {.compliant = true});
  const PointDemands point = block.result().demands.points[0];
  EXPECT_EQ(point.numerical_acceleration, 7);
  EXPECT_EQ(point.peak_absolute_acceleration, 3);
  EXPECT_EQ(point.impact_acceleration, 3);
}

// 10 kg at 2 m/s have 20 J, of which the floor is stated to have given 19.
TEST(Recorder, ClosesTheEnergyAccountOverTheLargestEnergy) {
  Block block;
  EnergyAccount account;
  block.recorder().sample(block.state(), account, true);
  block.move(1, {.position = {0, 0, 0.3}, .velocity = {2, 0, 0}});
  account.work_of_floor = 19;
  block.recorder().sample(block.state(), account, false);
  block.recorder().check(block.state(), account);
  block.recorder().sample(block.state(), account, true);
  const ItemResponse item = block.result(account);
  EXPECT_NEAR(item.energy.kinetic, 20, 1e-13);
  EXPECT_NEAR(block.quality().energy_closure, 1.0 / 20, 1e-13);
  EXPECT_NEAR(block.recorder().energy_error(), 1.0 / 20, 1e-13);
  ASSERT_EQ(item.history.size(), 2u);  // the second was not to be kept
  EXPECT_EQ(item.history[1].time, 1);
}

TEST(Recorder, TakesTheImpactsOfItsItemOnly) {
  Block block;
  Impact own, other, met;
  own.approach_speed = 1;
  own.impulse = 5;
  own.peak_force = std::nan("");
  other.item = 1;
  other.approach_speed = 9;
  met.item = 1;
  met.other_item = 0;
  met.approach_speed = 2;
  met.impulse = 3;
  met.peak_force = 40;
  const Demands demands = block.result({}, {own, other, met}).demands;
  EXPECT_EQ(demands.impacts, 2);
  EXPECT_EQ(demands.largest_approach_speed, 2);
  EXPECT_EQ(demands.largest_impulse, 5);
  EXPECT_EQ(demands.peak_impact_force, 40);
}

TEST(Recorder, NamesTheWayInWhichTheItemLeans) {
  Block block;
  block.move(1, {.position = {0, 0, 0.3}, .yaw = 2, .pitch = 1});
  block.recorder().overturned();
  EXPECT_NEAR(block.result().demands.direction_of_overturning, 2, 1e-12);
}

// --- wheels

/// A trolley of 96.5 kg at rest on treads of 1e6 N/m, whose wheels are lifted by hand.
class Wheels {
 public:
  Wheels()
      : scene_(scene()),
        assembly_(scene_),
        state_(start()),
        recorder_(scene_, assembly_, 0, state_) {}

  /// All wheels sink in by 1 mm but the first, which is `height` above the floor and moves with
  /// `rate` at the end.
  void move(double duration, double height, double rate) {
    SceneState to = state_;
    to.items[0].time += duration;
    StageSolver::Output first, end;
    first.items.resize(1);
    end.items.resize(1);
    for (std::size_t i = 0; i < 4; ++i) {
      TreadLaw::Result& tread = end.items[0].treads[i];
      tread.compression = i == 0 ? -height : 1e-3;
      tread.compression_rate = i == 0 ? -rate : 0;
      tread.force[2] = std::max(0.0, 1e6 * tread.compression);
      first.items[0].treads[i].slip_speed = 0.2;
      tread.slip_speed = 0.2;
    }
    const Island island{{0}, 0, 0};
    recorder_.observe({&island, state_.items[0].time, duration, &state_, &to, &first, &end, {}},
                      {});
    state_ = to;
  }
  Demands demands() {
    Response response;
    response.items.clear();
    recorder_.finish(state_, {}, -1, response);
    return response.items.at(0).demands;
  }
  Recorder& recorder() { return recorder_; }

 private:
  static Scene scene() {
    Scene scene = scene_of(small::trolley({0, 0, 0, 0}, small::bare_tread(1e6, 1e6)));
    return scene;
  }
  SceneState start() const {
    SceneState state;
    state.items.push_back(assembly_.items[0].placed({}));
    state.items[0].position.z() -= 1e-3;
    return state;
  }

  Scene scene_;
  Assembly assembly_;
  SceneState state_;
  Recorder recorder_;
};

// From 1 mm in the floor to 1 mm over it at a constant rate: the second half of the step is in the
// air. It comes down alike, after one more step there.
TEST(Recorder, CountsTheTimeInTheAirFromInsideAStep) {
  Wheels wheels;
  wheels.move(0.01, -1e-3, 0.2);
  wheels.move(0.01, 1e-3, 0.2);
  wheels.move(0.01, 1e-3, -0.2);
  wheels.move(0.01, -1e-3, -0.2);
  const Demands demands = wheels.demands();
  EXPECT_NEAR(demands.wheels[0].lifted_time, 0.02, 1e-15);
  EXPECT_NEAR(demands.lifted_time, 0.02, 1e-15);
  EXPECT_EQ(demands.wheels[1].lifted_time, 0);
  EXPECT_EQ(demands.wheels[0].liftoffs, 1);
  EXPECT_EQ(demands.wheels[1].liftoffs, 0);
  EXPECT_EQ(demands.most_wheels_lifted, 1);
  EXPECT_NEAR(demands.peak_normal_force, 1000, 1e-9);
  EXPECT_NEAR(demands.wheels[1].skid_distance, 0.2 * 0.04, 1e-15);
}

// Up and down within one step, at 1 m/s: between its ends it is above the floor.
TEST(Recorder, SeesALiftThatBeginsAndEndsInsideAStep) {
  Wheels wheels;
  wheels.move(0.01, -1e-4, 1);
  wheels.move(0.01, -1e-4, -1);
  const Demands demands = wheels.demands();
  // The cubic -1e-4 + 1e-2 s (1 - s) is above zero from s = 0.01 to 0.99, and so in the middles of
  // all 16 parts, from 1/32 on.
  EXPECT_NEAR(demands.wheels[0].lifted_time, 0.01, 1e-15);
  EXPECT_EQ(demands.wheels[0].liftoffs, 0);  // at no end of a step
}

TEST(Recorder, NotesWhenWheelsInTheAirHadLeftAsTheItemOverturns) {
  Wheels wheels;
  wheels.move(0.01, -1e-3, 0.2);
  wheels.move(0.01, 1e-3, 0.2);
  wheels.move(0.01, 3e-3, 0.2);
  wheels.recorder().overturned();
  const Demands demands = wheels.demands();
  EXPECT_NEAR(demands.wheels[0].liftoff_before_overturning, 0.02, 1e-15);
  EXPECT_LT(demands.wheels[1].liftoff_before_overturning, 0);
}

}  // namespace
}  // namespace gurney
