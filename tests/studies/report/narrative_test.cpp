#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/response/settled.h"
#include "studies/report/run_report.h"
#include "tests/support/synthetic_run.h"
#include "tests/support/synthetic_ward.h"

namespace gurney::report {
namespace {

/// The narrative as lines of text.
std::string text_of(const study::RunFacts& facts, const Response& response) {
  return fmt::format("{}", fmt::join(findings::lines_of(narrative(facts, response)), "\n"));
}

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

TEST(Story, ReportsEachOutcomeOfASingleItem) {
  const study::RunFacts facts = synthetic_facts();
  Response response = synthetic_response();
  EXPECT_THAT(text_of(facts, response),
              HasSubstr("The item moved at most 125 mm from its start (at 0.50 s)"));
  EXPECT_THAT(text_of(facts, response), HasSubstr("It was at rest at 24.00 s, 625 mm and "));
  response.outcome = Outcome::kStillMoving;
  EXPECT_THAT(text_of(facts, response),
              HasSubstr("STILL MOVED when the settling time was over at 24.00 s"));
  response.outcome = Outcome::kOverturned;
  response.items[0].demands.time_of_overturning = 7.5;
  EXPECT_THAT(text_of(facts, response),
              HasSubstr("It overturned and lay at 24.00 s, 625 mm from its start.\n"));
  EXPECT_THAT(text_of(facts, response), Not(HasSubstr("deg from its start")))
      << "it has no heading";
  EXPECT_THAT(text_of(facts, response), HasSubstr("\nTrolley OVERTURNED at 7.50 s."));
  response.outcome = Outcome::kDiverged;
  response.cause = "no solution";
  EXPECT_EQ(text_of(facts, response),
            "The run DIVERGED at 24 s: no solution. Its results must not be used.");
  response.outcome = Outcome::kUntrusted;
  response.cause = "energy from nowhere";
  EXPECT_EQ(text_of(facts, response),
            "The run is UNTRUSTED; it ended at 24 s: energy from nowhere. Its results must not be "
            "used.");
  response = {};
  response.items.resize(1);
  response.items[0].demands.wheels.resize(4);
  response.outcome = Outcome::kRested;
  EXPECT_THAT(text_of(facts, response),
              StartsWith("The item moved less than 1 mm. Every wheel stayed on the floor."));
}

TEST(Story, SaysHowAnItemLeftWhatItStoodOn) {
  Response response = synthetic_response();
  Demands& d = response.items[0].demands;
  d.peak_slide = 0.12;
  EXPECT_THAT(text_of(synthetic_facts(), response),
              HasSubstr("It slid at most 120 mm where it stood. "));
  d.time_of_fall = 5.3;
  EXPECT_THAT(text_of(synthetic_facts(), response),
              HasSubstr("It slid at most 120 mm where it stood and FELL at 5.30 s. "));
  d.time_of_toppling = 5.1;
  EXPECT_THAT(text_of(synthetic_facts(), response), HasSubstr("\nTrolley TOPPLED at 5.10 s."));
}

TEST(Story, SaysWhatHalfTheTimeStepChanges) {
  Response response = synthetic_response();
  ItemResponse& item = response.items[0];
  item.demands.peak_tilt = 0.02;
  Predictability& p = item.predictability.emplace();
  p.half_step = p.twin = item.demands;
  p.half_step->peak_displacement = 0.98 * item.demands.peak_displacement;
  p.half_step->peak_tilt = 1.003 * item.demands.peak_tilt;
  const std::string text = text_of(synthetic_facts(), response);
  EXPECT_THAT(text, HasSubstr("\nTime step: half of it changes the peak displacement by -2 %, "
                              "the peak tilt by +0.3 %."));
  p.half_step->peak_displacement = (1 - 8.2e-9) * item.demands.peak_displacement;
  p.half_step->peak_tilt = 2.3 * item.demands.peak_tilt;
  EXPECT_THAT(text_of(synthetic_facts(), response),
              HasSubstr("the peak displacement by less than 0.01 %, the peak tilt by +130 %."));
  p.half_step->peak_displacement = 0.98 * item.demands.peak_displacement;
  item.demands.peak_tilt = p.half_step->peak_tilt = 1e-3;  // less than 0.1 degrees: at rest
  EXPECT_THAT(text_of(synthetic_facts(), response), HasSubstr("peak displacement by -2 %."));
  p.verdict = Predictability::Verdict::kChaotic;  // its difference is not the step's
  EXPECT_THAT(text_of(synthetic_facts(), response), Not(HasSubstr("Time step")));
}

/// The run of one item without events, its repetitions equal.
Response repeated() {
  Response response = synthetic_response();
  ItemResponse& item = response.items[0];
  item.demands.impacts = 0;
  for (WheelDemands& wheel : item.demands.wheels) wheel.liftoffs = 0;
  Predictability& p = item.predictability.emplace();
  p.half_step = p.twin = item.demands;
  return response;
}

TEST(Story, SaysOfEachDemandWhetherItIsSettled) {
  Response response = repeated();
  const auto all = static_cast<std::size_t>(
      std::ranges::count_if(numbers_of(response.items[0].demands), [](const DemandNumber& number) {
        return !std::isnan(number.value);  // the others it does not have
      }));
  EXPECT_THAT(text_of(synthetic_facts(), response),
              HasSubstr(fmt::format("\nSettled, of {0} demands: {0} within 1 %.", all)));
  Predictability& p = *response.items[0].predictability;
  p.half_step->peak_yaw *= 0.4;
  p.half_step->residual_yaw *= -1;
  p.half_step->points[0].peak_absolute_acceleration *= 0.99;
  p.half_step->wheels[1].liftoffs += 1;
  p.half_step->time_of_overturning = 3;
  p.twin->path_length *= 1 + 1e-5;
  const std::string text = text_of(synthetic_facts(), response);
  // 4 times 1 % is within 5 %; five others are not settled.
  EXPECT_THAT(text, HasSubstr(fmt::format("{} within 1 % and 1 within 5 %; NOT SETTLED: path "
                                          "length (by the change of mass), peak yaw (-60 %), "
                                          "residual yaw (-200 %), time of overturning (comes or "
                                          "goes) and 1 number of wheels.",
                                          all - 5)));  // an overturning is one more
}

TEST(Story, SaysWhySmallChangesDoNotSettle) {
  Response response = repeated();
  ItemResponse& item = response.items[0];
  Predictability& p = *item.predictability;
  Demands& half = *p.half_step;
  item.demands.impacts = half.impacts = p.twin->impacts = 7;
  EXPECT_THAT(
      text_of(synthetic_facts(), response),
      HasSubstr("NOT SETTLED: impacts (as many at half the step, which settles no count)."));
  for (double* each : {&half.peak_yaw, &half.residual_yaw, &half.path_length, &half.lifted_time,
                       &half.peak_velocity, &half.residual_displacement})
    *each *= 2;
  for (WheelDemands& wheel : half.wheels)
    wheel = {2 * wheel.peak_normal_force, 2 * wheel.peak_tangential_force,
             2 * wheel.lifted_time,       wheel.liftoffs,
             2 * wheel.skid_distance,     wheel.liftoff_before_overturning};
  EXPECT_THAT(text_of(synthetic_facts(), response),
              HasSubstr("peak displacement (others change by more)"));
}

TEST(Story, DoesNotListDemandsWhereNoneIsSettled) {
  Response response = synthetic_response();
  ItemResponse& item = response.items[0];
  item.demands.impacts = 7;
  item.demands.largest_approach_speed = item.demands.largest_impulse = 1;
  item.demands.wheels[0].lifted_time = 1;
  item.demands.wheels[0].liftoffs = 1;
  Predictability& p = item.predictability.emplace();
  p.half_step = item.demands;
  Demands& twin = p.twin.emplace();  // without anything of what the item did
  twin.wheels.resize(item.demands.wheels.size());
  twin.points.resize(item.demands.points.size());
  const std::string text = text_of(synthetic_facts(), response);
  EXPECT_THAT(text, HasSubstr("\nSettled: none of "));
  EXPECT_THAT(text, Not(HasSubstr("NOT SETTLED")));
}

/// The heading at the end has its own words: `turned` is the largest turn.
TEST(Story, DoesNotStateATurnThatIsNone) {
  Response response = synthetic_response();
  Demands& d = response.items[0].demands;
  d.residual_yaw = -0.0005;  // -0.03 deg
  EXPECT_THAT(text_of(synthetic_facts(), response),
              HasSubstr("It was at rest at 24.00 s, 625 mm from its start."));
  d.residual_yaw = -0.5;
  EXPECT_THAT(text_of(synthetic_facts(), response),
              HasSubstr("It was at rest at 24.00 s, 625 mm and -28.6 deg from its start."));
}

TEST(Story, NamesTheItemThatTheTimeStepChangesMost) {
  Response response = synthetic_ward_response();
  for (std::size_t i = 0; i < response.items.size(); ++i) {
    const double peak = response.items[i].demands.peak_displacement = 0.1;
    response.items[i].demands.peak_tilt = 0;
    Demands half = response.items[i].demands;
    half.peak_displacement = peak * (i == 2 ? 0.9 : 1.05);
    response.items[i].predictability.emplace().half_step = half;
  }
  EXPECT_THAT(text_of(synthetic_ward(), response),
              HasSubstr("Time step: half of it changes peak displacements by at most 10 % ("));
}

TEST(Story, ReportsHowFarEachItemMoved) {
  const std::string text = text_of(synthetic_ward(), synthetic_ward_response());
  EXPECT_THAT(text, StartsWith("1 of 10 items overturned; the run ended at 15.00 s.\n"));
  EXPECT_THAT(text, HasSubstr("\n  moved less than 1 mm: bookcase\n"));
  EXPECT_THAT(text, HasSubstr("\n  infusion pump moved at most "));
  EXPECT_THAT(text, HasSubstr("; 4 of 4 wheels off the floor at once, 11 s in all\n"));
}

TEST(Story, SumsUpTheHitsOfAPairFastestFirst) {
  const std::string text = text_of(synthetic_ward(), synthetic_ward_response());
  EXPECT_THAT(
      text,
      HasSubstr(
          "Impacts: 6, fastest first:\n"
          "  infusion pump hit the floor at 4.75 s with 3.1 m/s (impulse 90 N s)\n"
          "  ventilator hit monitor 3 times from 2.50 s to 3.50 s, fastest at 2.90 s with 0.9 m/s "
          "(front right on rear left, impulse 42 N s)\n"
          "  bed 1 hit north wall at 3.75 s with 0.65 m/s (impulse 210 N s, peak force 5.2e+03 N)\n"
          "  crash cart hit column at 5.25 s with 0.125 m/s (front left, impulse 6 N s, peak force "
          "900 N)\n"));
}

TEST(Story, IsNotFloodedByImpacts) {
  Response response = synthetic_ward_response();
  for (int i = 0; i < 20; ++i) {
    Impact impact = response.impacts[5];
    impact.other = "shape " + std::to_string(i);
    impact.approach_speed = 0.1 - 0.001 * i;
    response.impacts.push_back(impact);
  }
  // 24 pairs; the twelve fastest are the four of the ward and eight of the new ones.
  EXPECT_THAT(text_of(synthetic_ward(), response),
              HasSubstr("  and 12 more pairs, with 0.092 m/s at most\n"));
}

TEST(Story, SaysWhatFellAndWhy) {
  // Half a sine of 2 m/s2 over 1 s: 4 / pi = 1.27 m/s.
  EXPECT_THAT(
      text_of(synthetic_ward(), synthetic_ward_response()),
      HasSubstr(
          "\ninfusion pump OVERTURNED at 4.50 s, falling towards -y (-90 deg from the x axis). "
          "Wheels that had left the floor by then and not come back: front left (4.08 s), rear "
          "left (4.10 s) and front right (4.40 s). A half cycle of the floor's motion "
          "towards +y (90 deg from the x axis) drove it, opposite to the motion of the item, from "
          "3.50 s to 4.50 s: 1.00 s long, up to 2 m/s2 (0.20 g, at 4.00 s) and 1.27 m/s; it "
          "changed the floor's velocity by 1.27 m/s."));
}

TEST(Story, NamesNoHalfCycleOfAFloorAtRest) {
  study::RunFacts facts = synthetic_ward();
  facts.floor = {};
  EXPECT_THAT(text_of(facts, synthetic_ward_response()), Not(HasSubstr("half cycle")));
}

TEST(Story, SaysWhichZonesAreBlocked) {
  Response response = synthetic_ward_response();
  EXPECT_THAT(
      text_of(synthetic_ward(), response),
      HasSubstr("\ndoorway is NARROWED at the end by infusion pump: a free width of 0.35 m is left "
                "of 1.10 m.\n"
                "egress lane is free at the end; it was occupied for 0.75 s from 1.50 s on, with a "
                "free width of 0.50 m left of 0.90 m at least.\n"));
  response.zones[1].time_of_entry = 0;
  EXPECT_THAT(text_of(synthetic_ward(), response),
              HasSubstr("it was occupied for 0.75 s from the start on, with"));
  response.zones[0].free_width_at_end = 0;
  response.zones[1] = {};
  EXPECT_THAT(
      text_of(synthetic_ward(), response),
      HasSubstr("\ndoorway is BLOCKED at the end by infusion pump: no free width is left of 1.10 "
                "m.\negress lane stayed free.\n"));
}

TEST(Story, SaysWhatBecameOfTethers) {
  EXPECT_THAT(
      text_of(synthetic_ward(), synthetic_ward_response()),
      testing::EndsWith("\npower cord of ventilator got taut at 3.25 s and BROKE at 3.50 s "
                        "(largest tension 300 N).\n"
                        "gas hose of anaesthesia workstation got taut at 5.75 s and held (largest "
                        "tension 120 N).\n"
                        "network cable of monitor stayed slack."));
}

TEST(Story, SaysWhetherHalvingTheTimeStepSettledTheDemands) {
  const auto text = [](long halvings, double change) {
    Response response = synthetic_response();
    response.quality.step_halvings = halvings;
    response.quality.peak_change = change;
    return text_of(synthetic_facts(), response);
  };
  EXPECT_THAT(text(0, 0), Not(HasSubstr("Time step")));
  EXPECT_THAT(text(3, 0.0037),
              HasSubstr("\nTime step: halved 3 times; the last two changed no judged demand by "
                        "more than 0.37 %."));
  EXPECT_THAT(text(6, std::numeric_limits<double>::infinity()),
              HasSubstr("\nTime step: halved 6 times, no shorter is tried; the last two changed "
                        "an outcome."));
}

}  // namespace
}  // namespace gurney::report
