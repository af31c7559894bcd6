#include <gmock/gmock.h>

#include "engine/base/units.h"
#include "groundmotions/formats/readers.h"
#include "tests/groundmotions/formats/array_samples.h"
#include "tests/groundmotions/formats/text_file.h"
#include "tests/support/error_text.h"

namespace gurney::groundmotions {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

void expect_the_motion(const Component& component, double sign = 1) {
  ASSERT_EQ(component.acceleration.size(), 10);
  for (int i = 0; i < 10; ++i)
    EXPECT_NEAR(component.acceleration[i], sign * 0.01 * kSmcSamples[static_cast<std::size_t>(i)],
                1e-15);
}

TEST(UsgsSmc, ReadsACorrectedAccelerogram) {
  const auto components = read_text(smc_file());
  ASSERT_EQ(components.size(), 1u);
  const Component& component = components[0];
  expect_the_motion(component);
  EXPECT_EQ(component.format, "USGS SMC");
  EXPECT_EQ(component.time_step, 0.005);
  EXPECT_EQ(component.unit, "cm/s2");
  EXPECT_EQ(component.name, "65");
  EXPECT_DOUBLE_EQ(component.azimuth.value(), 65 * kRadiansPerDegree);
  EXPECT_FALSE(component.direction);
  EXPECT_EQ(component.start_time, 991407937.5);  // date -u -d '2001-06-01 15:05:37.5' +%s.%N
  EXPECT_EQ(fact(component, "high-pass corner [Hz]"), "0.1");
  EXPECT_THAT(component.warnings, IsEmpty());
}

TEST(UsgsSmc, ReadsLongNumbersThatStickTogether) {
  const std::string text = smc_file({.has_long_numbers = true});
  EXPECT_THAT(text, HasSubstr(" 1.5000000E+00-2.2500000E+00"));
  expect_the_motion(read_text(text)[0]);
}

TEST(UsgsSmc, TakesAnUnknownTypeAsAcceleration) {
  const auto component = read_text(smc_file({.first = "0 UNKNOWN"}))[0];
  expect_the_motion(component);
  EXPECT_THAT(component.warnings, ElementsAre(HasSubstr("the file does not say what it holds")));
}

TEST(UsgsSmc, BringsPairsToEvenSteps) {
  const auto component = read_text(smc_pairs())[0];
  EXPECT_EQ(component.time_step, 0.005);
  // Samples at 0, 6, 10, 16, ... ms: that at 5 ms lies on the line from 1.5 to -2.25.
  EXPECT_NEAR(component.acceleration[0], 0.015, 1e-15);
  EXPECT_NEAR(component.acceleration[1], 0.01 * (1.5 + 5.0 / 6 * (-2.25 - 1.5)), 1e-15);
  EXPECT_NEAR(component.acceleration[2], 0.005, 1e-15);
  EXPECT_THAT(component.warnings,
              ElementsAre(HasSubstr("brought to even steps of 0.005 s by straight lines")));
  EXPECT_EQ(read_text(smc_pairs(), {.time_step = 0.01})[0].time_step, 0.01);
}

TEST(UsgsSmc, LeavesOutALineMoreOfPairs) {
  const auto component = read_text(smc_pairs() + " 5.0000E+0 9.0000E+0\r\n")[0];
  EXPECT_EQ(component.acceleration, read_text(smc_pairs())[0].acceleration);
  EXPECT_THAT(component.warnings,
              testing::Contains("more lines follow the 20 numbers of the header; they were "
                                "ignored"));
}

TEST(UsgsSmc, RefusesPairsThatAreNone) {
  EXPECT_THAT(error_text([] {
                read_text(smc_file({.reals = {{2, 1.7e38}}, .numbers = {0, 1, 0.01}}));
              }),
              HasSubstr("3 numbers are no pairs of time and sample"));
  EXPECT_THAT(error_text([] {
                read_text(smc_file({.reals = {{2, 1.7e38}}, .numbers = {0, 1, 0.02, 1, 0.01, 2}}));
              }),
              HasSubstr("time 3 of 3 decreases"));
  EXPECT_THAT(error_text([] {
                read_text(smc_file({.reals = {{2, 1.7e38}}, .numbers = {0, 1, 90000, 1}}));
              }),
              HasSubstr("times that follow each other are up to 90000 s apart, 2 s is allowed"));
}

TEST(UsgsSmc, RefusesOtherQuantities) {
  for (const char* type : {"3 VELOCITY", "4 DISPLACEMENT", "5 RESPONSE SPECTRA"})
    EXPECT_EQ(error_text([&] { read_text(smc_file({.first = type})); }),
              std::string("f:1:1: a record must be acceleration, but this file holds '") + type +
                  "'; take the accelerogram of this component (type 1 or 2)");
}

TEST(UsgsSmc, KnowsUpAndDown) {
  EXPECT_EQ(
      read_text(smc_file({.component = "   up", .integers = {{13, 0}, {14, -32768}}}))[0].direction,
      Direction::kVertical);
  const auto down = read_text(smc_file({.component = "down", .integers = {{13, 180}}}))[0];
  expect_the_motion(down, -1);
  EXPECT_EQ(down.direction, Direction::kVertical);
  EXPECT_THAT(down.warnings, ElementsAre(HasSubstr("points down (180 degrees from up)")));
  // A component that is level without an azimuth, or neither level nor upright, has that of its text.
  for (const int from_up : {-32768, 90, 45}) {
    const int from_north = from_up == 45 ? 20 : -32768;
    const auto by_text = read_text(
        smc_file({.component = "N45E", .integers = {{13, from_up}, {14, from_north}}}))[0];
    EXPECT_DOUBLE_EQ(by_text.azimuth.value(), 45 * kRadiansPerDegree) << from_up;
  }
  EXPECT_THAT(read_text(smc_file({.component = "  up"}))[0].warnings,
              ElementsAre(HasSubstr("says component 'up', its numbers say 90 degrees from up")));
}

TEST(UsgsSmc, NamesStructuresAndWarnsOfProblems) {
  const auto building = read_text(smc_file({.integers = {{19, 1}, {25, 12}}}))[0];
  EXPECT_EQ(fact(building, "location"), "a building, floor 12");
  EXPECT_EQ(fact(read_text(smc_file({.integers = {{28, 2}}}))[0], "location"), "a dam");
  EXPECT_THAT(read_text(smc_file({.integers = {{18, 1}}}))[0].warnings,
              ElementsAre("the header flags a problem; its comments: invented"));
}

TEST(UsgsSmc, HasNoStartTimeWithoutMilliseconds) {
  EXPECT_FALSE(read_text(smc_file({.integers = {{7, -32768}}}))[0].start_time);
}

TEST(UsgsSmc, ChecksWhatTheHeaderStates) {
  EXPECT_THAT(error_text([] {
                read_text(smc_file({.integers = {{17, 12}}}));
              }),
              HasSubstr("'' is not a number of the format 8E10.4"));
  EXPECT_THAT(error_text([] {
                read_text(smc_file({.integers = {{17, 8}}}));
              }),
              HasSubstr("more lines follow the 8 samples of the header"));
  EXPECT_THAT(error_text([] {
                read_text(smc_file({.integers = {{16, 3}}}));
              }),
              HasSubstr("the header states 3 lines of comments, but the file has 2"));
  EXPECT_THAT(error_text([] {
                read_text(smc_file({.reals = {{32, -25.0}}}));
              }),
              HasSubstr("the file states a peak of 0.25 m/s2, but its samples have 0.125 m/s2"));
  EXPECT_THAT(read_text(smc_file({.reals = {{32, -13.0}}}))[0].warnings,
              ElementsAre(HasSubstr("the file states a peak of 0.13 m/s2")));
  EXPECT_THAT(error_text([] {
                read_text(smc_file({.reals = {{2, 0.5}}}));
              }),
              HasSubstr("the time step must be in [1e-05, 1] s, got 2"));
}

TEST(UsgsSmc, ChecksTheRateAgainstTheTimesOfThePeaks) {
  EXPECT_EQ(read_one(smc_file({.reals = {{29, 0.03}, {31, 0.015}}})).time_step, 0.005);
  EXPECT_EQ(read_one(smc_file({.reals = {{29, 0.035}, {31, 0.02}}})).time_step, 0.005);
  EXPECT_EQ(error_text([] {
              read_text(smc_file({.reals = {{2, 100}, {29, 0.03}, {31, 0.015}}}));
            }),
            "f:23:1: the times that the header states for its peaks do not fit 100 samples in a "
            "second (line 18)");
}

TEST(UsgsSmc, ChecksTheOptions) {
  EXPECT_THAT(error_text([] { read_text(smc_file(), {.unit = "g"}); }),
              HasSubstr("the file states the unit cm/s2, but unit = \"g\" was given"));
  EXPECT_THAT(error_text([] { read_text(smc_file(), {.time_step = 0.01}); }),
              HasSubstr("the file states a time step of 0.005 s, but time_step_s = 0.01"));
}

}  // namespace
}  // namespace gurney::groundmotions
