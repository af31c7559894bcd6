#include "engine/record/impact_log.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/solver/quadrature.h"
#include "studies/verification/scenes/blocks.h"

// Steps of 8 ms whose contacts are made by hand: a block's chassis, wheels there are none, with
// the floor (0) and a wall (1).
namespace gurney {
namespace {

constexpr double kStep = 0.008;

/// A contact through one step: compression at both ends, normal force of both stages, speed at its
/// end and of approach at its start.
struct Touch {
  double from = -1e-3, to = -1e-3, first = 0, end = 0, speed = 0, approach = 0;
  int other = 1;
  Vector3 point = Vector3::Zero();
};

Scene before_a_wall(const ContactConstants& wall) {
  Scene scene = blocks::block(10, {0.5, 0.4, 0.6}, {});
  blocks::add_wall(scene, 1, wall);
  return scene;
}

class Log {
 public:
  explicit Log(const ContactConstants& wall = {})
      : scene_(before_a_wall(wall)), assembly_(scene_), log_(scene_, assembly_) {}

  void step(const std::vector<Touch>& touches) {
    SceneState from, to;
    StageSolver::Output first, end;
    for (const Touch& touch : touches) {
      BodyContactState state;
      state.contact.other = touch.other;
      state.contact.normal = -Vector3::UnitX();
      state.compression = touch.from;
      state.approach_speed = touch.approach;
      from.contacts.push_back(state);
      state.compression = touch.to;
      to.contacts.push_back(state);
      first.contacts.push_back({touch.first, touch.speed, touch.point});
      end.contacts.push_back({touch.end, touch.speed, touch.point});
    }
    const Island island{{0}, 0, touches.size()};
    log_.observe({&island, time_, kStep, &from, &to, &first, &end, {}});
    time_ += kStep;
  }
  std::vector<Impact> impacts() const { return log_.finish(time_); }
  ImpactLog::Kinds kinds() const { return log_.impacts_of(0); }

 private:
  Scene scene_;
  Assembly assembly_;
  ImpactLog log_;
  double time_ = 0;
};

double impulse(double first, double end) {
  return kStep * ((1 - kSdirkGamma) * first + kSdirkGamma * end);
}

// It touches after 1/4 of the second step and parts after 3/5 of the fourth.
TEST(ImpactLog, TimesAnImpactByWhereTheGapCrossesZeroAndSumsItsImpulse) {
  Log log;
  log.step({{.from = -5e-3, .to = -1e-3}});
  log.step({{.from = -1e-3,
             .to = 3e-3,
             .first = 100,
             .end = 400,
             .speed = -0.3,
             .approach = 0.4,
             .point = {1, 2, 3}}});
  log.step({{.from = 3e-3, .to = 3e-3, .first = 600, .end = 500, .speed = 0.1, .approach = 9}});
  log.step({{.from = 3e-3, .to = -2e-3, .first = 200, .speed = 0.4}});
  log.step({{.from = -2e-3, .to = -6e-3}});
  const std::vector<Impact> impacts = log.impacts();
  ASSERT_EQ(impacts.size(), 1u);
  const Impact& impact = impacts[0];
  EXPECT_EQ(impact.body, "chassis");
  EXPECT_EQ(impact.other, "wall");
  EXPECT_EQ(impact.wheel, -1);
  EXPECT_EQ(impact.normal, Vector3(-1, 0, 0));
  EXPECT_EQ(impact.point, Vector3(1, 2, 3));
  EXPECT_EQ(impact.approach_speed, 0.4);
  EXPECT_NEAR(impact.time, 1.25 * kStep, 1e-15);
  EXPECT_NEAR(impact.duration, (3.6 - 1.25) * kStep, 1e-15);
  EXPECT_NEAR(impact.impulse, impulse(100, 400) + impulse(600, 500) + impulse(200, 0), 1e-12);
  EXPECT_TRUE(std::isnan(impact.peak_force));  // restitution states none
}

TEST(ImpactLog, KeepsThePeakForceOfAStatedStiffness) {
  Log log({.kind = ContactConstants::Kind::kCompliant, .stiffness = 1e5});
  log.step({{.to = 1e-3, .first = 100, .end = 400, .speed = -1, .approach = 1}});
  EXPECT_TRUE(log.kinds().compliant);
  EXPECT_FALSE(log.kinds().restitution);
  log.step({{.from = 1e-3, .to = 1e-3, .first = 700, .end = 300, .speed = 1}});
  EXPECT_EQ(log.impacts().at(0).peak_force, 700);
}

TEST(ImpactLog, TakesNoTouchSlowerThanItsLimitForAnImpact) {
  Log log;
  log.step({{.to = 1e-3, .first = 1, .end = 1, .approach = ImpactLog::kSlowestImpact}});
  EXPECT_TRUE(log.impacts().empty());
  EXPECT_FALSE(log.kinds().restitution);
  // What touches already makes none, however fast its points were once.
  log.step({{.from = 1e-3, .to = 1e-3, .first = 1, .end = 1, .approach = 5}});
  EXPECT_TRUE(log.impacts().empty());
}

TEST(ImpactLog, CountsPointsThatTouchMeanwhileToTheSameImpact) {
  Log log;
  log.step({{.to = 1e-3, .first = 10, .end = 10, .speed = -1, .approach = 0.2}, {}});
  log.step({{.from = 1e-3, .to = 1e-3, .first = 10, .end = 10, .speed = 1},
            {.to = 1e-3, .first = 20, .end = 20, .speed = -1, .approach = 0.6}});
  log.step({{.from = 1e-3, .to = -1e-3}, {.from = 1e-3, .to = -1e-3}});
  const std::vector<Impact> impacts = log.impacts();
  ASSERT_EQ(impacts.size(), 1u);
  EXPECT_EQ(impacts[0].approach_speed, 0.6);
  EXPECT_NEAR(impacts[0].impulse, kStep * (10 + 10 + 20), 1e-12);
}

TEST(ImpactLog, CountsASecondTouchAfterPartingAsAnother) {
  Log log;
  for (int i = 0; i < 3; ++i) {
    log.step({{.to = 1e-3, .first = 10, .end = 10, .speed = -1, .approach = 0.2}});
    log.step({{.from = 1e-3, .to = -1e-3}});
  }
  EXPECT_EQ(log.impacts().size(), 3u);
}

// Slower than half the limit from the end of the first step on: in the third step after it, beyond
// 20 ms, that has become rest, and the impact has ended where it began.
TEST(ImpactLog, EndsAnImpactThatComesToRest) {
  Log log;
  log.step({{.from = 0, .to = 1e-3, .first = 10, .end = 10, .speed = -1, .approach = 0.2}});
  const Touch rests{.from = 1e-3, .to = 1e-3, .first = 10, .end = 10, .speed = 0.02};
  log.step({rests});
  log.step({rests});
  EXPECT_TRUE(log.kinds().restitution);
  log.step({rests});
  EXPECT_FALSE(log.kinds().restitution);
  log.step({rests});
  const std::vector<Impact> impacts = log.impacts();
  ASSERT_EQ(impacts.size(), 1u);
  EXPECT_NEAR(impacts[0].duration, kStep, 1e-15);
  EXPECT_NEAR(impacts[0].impulse, kStep * 4 * 10, 1e-12);
}

// An impact faster than half the limit, either way, lasts for as long as it touches.
TEST(ImpactLog, AnImpactThatStillMovesLasts) {
  for (const double speed : {0.03, -0.03}) {
    Log log;
    log.step({{.from = 0, .to = 1e-3, .first = 10, .end = 10, .speed = -1, .approach = 0.2}});
    for (int i = 0; i < 9; ++i)
      log.step({{.from = 1e-3, .to = 1e-3, .first = 10, .end = 10, .speed = speed}});
    EXPECT_TRUE(log.kinds().restitution);
    EXPECT_NEAR(log.impacts().at(0).duration, 10 * kStep, 1e-15);
  }
}

TEST(ImpactLog, EndsAnImpactWhoseContactIsGoneAndCutsOffWhatLasts) {
  Log log;
  log.step({{.from = 0, .to = 1e-3, .first = 10, .end = 10, .speed = -1, .approach = 0.2}});
  log.step({});
  log.step({{.from = 0, .to = 1e-3, .first = 10, .end = 10, .speed = -1, .approach = 0.3}});
  log.step({{.from = 1e-3, .to = 1e-3, .first = 10, .end = 10, .speed = -1}});
  const std::vector<Impact> impacts = log.impacts();
  ASSERT_EQ(impacts.size(), 2u);
  EXPECT_NEAR(impacts[0].duration, kStep, 1e-15);
  EXPECT_NEAR(impacts[1].duration, 2 * kStep, 1e-15);
}

// Floor and wall are hit in one step, the floor first.
TEST(ImpactLog, KeepsPairsApartAndSortsImpactsByTime) {
  Log log;
  log.step({{.from = -3e-3, .to = 1e-3, .first = 0, .end = 10, .speed = -1, .approach = 0.2},
            {.from = -1e-3,
             .to = 3e-3,
             .first = 1,
             .end = 20,
             .speed = -1,
             .approach = 0.4,
             .other = 0}});
  const std::vector<Impact> impacts = log.impacts();
  ASSERT_EQ(impacts.size(), 2u);
  EXPECT_EQ(impacts[0].other, "floor");
  EXPECT_NEAR(impacts[0].time, 0.25 * kStep, 1e-15);
  EXPECT_EQ(impacts[1].other, "wall");
  EXPECT_NEAR(impacts[1].time, 0.75 * kStep, 1e-15);
}

}  // namespace
}  // namespace gurney
