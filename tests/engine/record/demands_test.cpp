#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <string>

#include "engine/record/recorder.h"
#include "engine/response/demand_columns.h"
#include "studies/verification/scenes/small_scenes.h"

// Each demand of a run of three steps in which nothing happens but one act: not at all, in the first
// step, in the last, in the last with the opposite sign, and of the other item.
namespace gurney {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kStep = 0.1;       // [s]
constexpr double kStiffness = 1e6;  // of the treads [N/m]
constexpr double kSink = 1e-3;      // of all wheels in the floor when nothing happens [m]
constexpr double kStatic = kStiffness * kSink;

/// What an item does at the end of one step; before and after it stands still.
struct Act {
  Vector3 displacement = Vector3::Zero(), velocity = Vector3::Zero();
  double yaw = 0;                          ///< about the vertical through its centre [rad]
  double pitch = 0;                        ///< about its centre, y axis [rad]
  double rise = 0;                         ///< of the first wheel [m]
  Vector2 friction = Vector2::Zero();      ///< on the first wheel [N]
  double slip_speed = 0;                   ///< of the first wheel, at both stages [m/s]
  Vector3 acceleration = Vector3::Zero();  ///< of its centre [m/s2]
  ImpactLog::Kinds kinds = {};             ///< of impacts that the item is in
  bool overturns = false, impact = false;
};

Act times(double sign, Act act) {
  for (Vector3* v : {&act.displacement, &act.velocity, &act.acceleration}) *v *= sign;
  for (double* x : {&act.yaw, &act.pitch, &act.rise}) *x *= sign;
  act.friction *= sign;
  return act;
}

/// Two trolleys, of which the second is recorded.
class Pair {
 public:
  static constexpr std::size_t kRecorded = 1;

  Pair() : assembly_(scene_), state_(start()), recorder_(scene_, assembly_, kRecorded, state_) {}

  /// One step, in which `item` acts.
  void step(std::size_t item, const Act& act) {
    SceneState to = at_rest_;
    StageSolver::Output first, end;
    first.items.resize(2);
    end.items.resize(2);
    for (std::size_t i = 0; i < 2; ++i) {
      const Act now = i == item ? act : Act{};
      State& state = to.items[i];
      state.time = state_.items[i].time + kStep;
      state.position += now.displacement;
      state.rotation = Quaternion(Eigen::AngleAxisd(now.yaw, Vector3::UnitZ()) *
                                  Eigen::AngleAxisd(now.pitch, Vector3::UnitY()));
      state.velocity.chassis.head<3>() = now.velocity;
      end.items[i].acceleration.chassis.head<3>() = now.acceleration;
      for (std::size_t wheel = 0; wheel < 4; ++wheel) {
        TreadLaw::Result& tread = end.items[i].treads[wheel];
        tread.compression = kSink - (wheel == 0 ? now.rise : 0);
        tread.force[2] = kStiffness * std::max(0.0, tread.compression);
        if (wheel == 0) {
          tread.force.head<2>() = now.friction;
          tread.slip_speed = first.items[i].treads[0].slip_speed = now.slip_speed;
        }
      }
    }
    const double time = state_.items[0].time;
    const Island island{{0, 1}, 0, 0};
    recorder_.observe({&island, time, kStep, &state_, &to, &first, &end, {}},
                      item == kRecorded ? act.kinds : ImpactLog::Kinds{});
    state_ = to;
    if (act.impact) note_impact(item, time);
    if (act.overturns && item == kRecorded) {
      recorder_.overturned();
      overturned_at_ = state_.items[0].time;
    }
  }

  Demands demands() {
    Response response;
    response.items.clear();
    response.impacts = impacts_;
    recorder_.finish(state_, {}, overturned_at_, response);
    return response.items.at(0).demands;
  }

 private:
  void note_impact(std::size_t item, double time) {
    Impact impact;
    impact.time = time;
    impact.item = item;
    impact.approach_speed = 2;
    impact.impulse = 3;
    impact.peak_force = 40;
    impacts_.push_back(impact);
  }
  static Scene scene() {
    Scene scene = scene_of(small::trolley({0, 0, 0, 0}, small::bare_tread(kStiffness, kStiffness)));
    scene.items[0].model.marked_points = {{"centre", scene.items[0].model.chassis_center_of_mass}};
    scene.items.push_back(scene.items[0]);
    return scene;
  }
  SceneState start() {
    for (const Mechanism& mechanism : assembly_.items) {
      at_rest_.items.push_back(mechanism.placed({}));
      at_rest_.items.back().position.z() -= kSink;
    }
    return at_rest_;
  }

  Scene scene_ = scene();
  Assembly assembly_;
  SceneState at_rest_, state_;
  Recorder recorder_;
  std::vector<Impact> impacts_;
  double overturned_at_ = -1;
};

struct Expected {
  Act act;
  double nothing, early, late, opposite;
};

/// The demands of the wheel and the point are those of the first.
template <class Row>
double value_in(const Demands& demands, const TableColumn<Row>& column) {
  if constexpr (std::is_same_v<Row, WheelDemands>)
    return column.value(demands.wheels.at(0));
  else if constexpr (std::is_same_v<Row, PointDemands>)
    return column.value(demands.points.at(0));
  else
    return column.value(demands);
}

template <class Row>
void expect_demands(std::span<const TableColumn<Row>> columns,
                    const std::map<std::string, Expected>& rows) {
  EXPECT_EQ(rows.size(), columns.size());
  for (const TableColumn<Row>& column : columns) {
    ASSERT_EQ(rows.count(column.name), 1u) << "a demand without a row: " << column.name;
    const Expected& row = rows.at(column.name);
    const auto of = [&](std::size_t item, int step, const Act& act) {
      Pair pair;
      for (int i = 1; i <= 3; ++i) pair.step(item, i == step ? act : Act{});
      return value_in(pair.demands(), column);
    };
    const auto expect = [&](double value, double expected, const char* when) {
      if (std::isnan(expected))
        EXPECT_TRUE(std::isnan(value)) << column.name << ", " << when << ": " << value;
      else  // sums and roots of numbers of the order of 1 and 1000 [-]
        EXPECT_NEAR(value, expected, 1e-12 * std::max(1.0, std::abs(expected)))
            << column.name << ", " << when;
    };
    const std::size_t own = Pair::kRecorded, other = 1 - own;
    expect(of(own, 0, row.act), row.nothing, "nothing happens");
    expect(of(other, 3, row.act), row.nothing, "the other item acts");
    expect(of(own, 1, row.act), row.early, "early");
    expect(of(own, 3, row.act), row.late, "late");
    expect(of(own, 3, times(-1, row.act)), row.opposite, "opposite");
  }
}

const Act kMove{.displacement = {0.3, -0.4, 0}};
const Act kTurn{.yaw = 0.7};
const Act kLean{.pitch = 0.2};
// From 1 mm below the floor to 1 mm above, at rest at both ends: the cubic between them is odd about
// its middle, so that half of the step is in the air, and half of the next.
const Act kLift{.rise = 2 * kSink};
const Act kFall{.yaw = 0.5, .pitch = 1.2, .overturns = true};
const Act kHit{.impact = true};
const Act kShake{.acceleration = {0, -3, 4}};

Act in_impact(const ImpactLog::Kinds& kinds) {
  Act act = kShake;
  act.kinds = kinds;
  return act;
}

TEST(Demands, AreThoseOfTheActOfTheirItem) {
  const double first = kStep, last = 3 * kStep, pi = std::numbers::pi;
  const std::map<std::string, Expected> rows = {
      {"peak_displacement", {kMove, 0, 0.5, 0.5, 0.5}},
      {"peak_displacement_x", {kMove, 0, 0.3, 0.3, 0.3}},
      {"peak_displacement_y", {kMove, 0, 0.4, 0.4, 0.4}},
      {"time_of_peak_displacement", {kMove, 0, first, last, last}},
      {"residual_displacement", {kMove, 0, 0, 0.5, 0.5}},
      {"residual_displacement_x", {kMove, 0, 0, 0.3, -0.3}},
      {"residual_displacement_y", {kMove, 0, 0, -0.4, 0.4}},
      {"peak_velocity", {{.velocity = {0.5, -1.2, 7}}, 0, 1.3, 1.3, 1.3}},
      {"path_length", {kMove, 0, 1, 0.5, 0.5}},
      {"peak_yaw", {kTurn, 0, 0.7, 0.7, 0.7}},
      {"residual_yaw", {kTurn, 0, 0, 0.7, -0.7}},
      {"peak_tilt", {kLean, 0, 0.2, 0.2, 0.2}},
      {"time_of_peak_tilt", {kLean, 0, first, last, last}},
      {"peak_normal_force", {{.rise = -kSink}, kStatic, 2 * kStatic, 2 * kStatic, kStatic}},
      {"lifted_time", {kLift, 0, kStep, kStep / 2, 0}},
      {"most_wheels_lifted", {kLift, 0, 1, 1, 0}},
      {"time_of_overturning", {kFall, -1, first, last, last}},
      {"direction_of_overturning", {kFall, kNone, 0.5, 0.5, pi - 0.5}},
      {"impacts", {kHit, 0, 1, 1, 1}},
      {"largest_approach_speed", {kHit, 0, 2, 2, 2}},
      {"largest_impulse", {kHit, 0, 3, 3, 3}},
      {"peak_impact_force", {kHit, kNone, 40, 40, 40}},
      // Those of what stands above the floor are in supported_items_test.cpp.
      {"peak_slide", {kMove, kNone, kNone, kNone, kNone}},
      {"time_of_fall", {kMove, -1, -1, -1, -1}},
      {"time_of_toppling", {kFall, -1, -1, -1, -1}},
      // Those of parts are in parts_test.cpp.
      {"peak_travel", {kMove, kNone, kNone, kNone, kNone}},
      {"residual_travel", {kMove, kNone, kNone, kNone, kNone}},
      {"peak_swing", {kMove, kNone, kNone, kNone, kNone}},
      {"residual_swing", {kMove, kNone, kNone, kNone, kNone}},
      {"time_of_release", {kMove, -1, -1, -1, -1}},
      {"largest_stop_speed", {kMove, kNone, kNone, kNone, kNone}},
  };
  expect_demands(demand_columns(), rows);
}

TEST(Demands, OfAWheelAreThoseOfTheActOfItsItem) {
  Act overturn_on_three = kLift;
  overturn_on_three.overturns = true;
  const std::map<std::string, Expected> rows = {
      {"peak_normal_force", {{.rise = -kSink}, kStatic, 2 * kStatic, 2 * kStatic, kStatic}},
      {"peak_tangential_force", {{.friction = {30, -40}}, 0, 50, 50, 50}},
      {"lifted_time", {kLift, 0, kStep, kStep / 2, 0}},
      {"liftoffs", {kLift, 0, 1, 1, 0}},
      {"skid_distance", {{.slip_speed = 0.2}, 0, 0.2 * kStep, 0.2 * kStep, 0.2 * kStep}},
      {"liftoff_before_overturning", {overturn_on_three, -1, kStep, 3 * kStep, -1}},
  };
  expect_demands(wheel_demand_columns(), rows);
}

TEST(Demands, OfAPointAreThoseOfTheActOfItsItem) {
  const std::map<std::string, Expected> rows = {
      {"peak_displacement", {kMove, 0, 0.5, 0.5, 0.5}},
      {"peak_absolute_acceleration", {kShake, 0, 5, 5, 5}},
      {"impact_acceleration", {in_impact({.compliant = true}), kNone, 5, 5, 5}},
      {"numerical_acceleration", {in_impact({.restitution = true}), kNone, 5, 5, 5}},
  };
  expect_demands(point_demand_columns(), rows);
}

}  // namespace
}  // namespace gurney
