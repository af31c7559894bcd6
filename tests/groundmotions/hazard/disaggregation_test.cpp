#include "groundmotions/hazard/disaggregation.h"

#include <gmock/gmock.h>

#include <cmath>

#include "engine/base/units.h"
#include "tests/support/expect_error.h"
#include "tests/support/temp_folder.h"

namespace gurney::groundmotions {
namespace {

class DisaggregationTest : public testing::Test {
 protected:
  Disaggregation read(const std::string& name, const std::string& text,
                      const DisaggregationRequest& request = {}) {
    return read_disaggregation(folder_.write(name, text), request);
  }

  TempFolder folder_;
};

/// Synthetic, in the form of OpenQuake 3: a comment, titles, a row for each bin.
std::string bins(const std::string& rows, const std::string& titles = "eps,mean") {
  return "#,,,,,,\"generated_by='OpenQuake engine 3.25.0', investigation_time=50.0, lon=0.1\"\n"
         "imt,iml,poe,mag,dist," +
         titles + "\n" + rows;
}

// Weights are rates, -ln(1 - poe): with 0.1 and 0.19 they are in the ratio 1 to 2.
TEST_F(DisaggregationTest, MeansAreWeightedByRates) {
  const Disaggregation mean = read("a.csv", bins("PGA,1,0.1,9,9,9,0.5\n"
                                                 "SA(1.0),0.4,0.1,6,10,0.5,0.1\n"
                                                 "SA(1.0),0.4,0.1,7.5,40,2,0.19\n"));
  EXPECT_EQ(mean.period, 1);
  EXPECT_DOUBLE_EQ(mean.acceleration, 0.4 * kStandardGravity);
  EXPECT_NEAR(mean.magnitude, 7, 1e-12);  // (6 + 2 * 7.5) / 3; rounding
  EXPECT_NEAR(mean.distance, 30, 1e-12);
  EXPECT_NEAR(*mean.epsilon, 1.5, 1e-12);
  EXPECT_FALSE(read("b.csv", bins("SA(1.0),0.4,0.1,6,10,0.1\n", "rlz0")).epsilon);
}

TEST_F(DisaggregationTest, OfSeveralOneIsChosen) {
  const std::string text = bins(
      "SA(0.2),0.4,0.1,6,10,0.5,0.1\n"
      "SA(1.0),0.3,0.1,6.5,10,0.5,0.1\n"
      "SA(1.0),0.6,0.0199999,7,10,0.5,0.1\n");
  EXPECT_DOUBLE_EQ(read("a.csv", text, {.period = 0.2}).magnitude, 6);
  EXPECT_DOUBLE_EQ(read("a.csv", text, {.period = 1, .poe = 0.02}).magnitude, 7);
  EXPECT_ERROR(read("a.csv", text), "a.csv: period_s is not stated: must be one of 0.2, 1");
  EXPECT_ERROR(read("a.csv", text, {.period = 2}), "period_s = 2: must be one of 0.2, 1");
  EXPECT_ERROR(read("a.csv", text, {.period = 1}), "poe is not stated: must be one of 0.1, 0.01");
}

TEST_F(DisaggregationTest, WhatIsWrongHasItsPlace) {
  EXPECT_ERROR(read("a.csv", "#\nimt,iml,poe,mag,mean\n"), "a.csv:2:1: is no disaggregation");
  EXPECT_ERROR(read("a.csv", bins("", "eps,rlz0,rlz1")), "'mean', and not one realization");
  EXPECT_ERROR(read("a.csv", bins("SA(1.0),0.4,0.1,6,10,0.5\n")), "a.csv:3:1: has 6 values for 7");
  EXPECT_ERROR(read("a.csv", bins("SA(1.0),0.4,0.1,x,10,0.5,1.0\n")),
               "a.csv:3:17: mag 'x': must be a finite number > 0");
  EXPECT_ERROR(read("a.csv", bins("SA(1.0),0.4,0.1,6,10,0.5,1.0\n")),
               "a.csv:3:26: mean '1.0': must be a probability below 1");
  EXPECT_ERROR(read("a.csv", bins("PGA,0.4,0.1,6,10,0.5,0.1\n")), "has no disaggregation of SA");
  EXPECT_ERROR(read("a.csv", bins("SA(1.0),0.4,0.1,6,10,0.5,0\n")), "no earthquake exceeds");
}

// A level of 0 has no logarithm, a target has one level.
TEST_F(DisaggregationTest, LevelMagnitudeAndDistanceAreThoseOfEarthquakes) {
  for (const char* level : {"0", "-0.4"})
    EXPECT_ERROR(read("a.csv", bins(std::string("SA(1.0),") + level + ",0.1,6,10,0.5,0.1\n")),
                 std::string("a.csv:3:9: iml '") + level + "': must be a finite number > 0");
  EXPECT_ERROR(read("a.csv", bins("SA(1.0),0.4,0.1,-6.5,10,0.5,0.1\n")),
               "a.csv:3:17: mag '-6.5': must be a finite number > 0");
  EXPECT_ERROR(read("a.csv", bins("SA(1.0),0.4,0.1,6.5,-15,0.5,0.1\n")),
               "a.csv:3:21: dist '-15': must be a finite number >= 0");
  EXPECT_EQ(read("a.csv", bins("SA(1.0),0.4,0.1,6.5,0,0.5,0.1\n")).distance, 0);
  EXPECT_ERROR(read("a.csv", bins("SA(1.0),0.4,0.1,6.5,15,0.5,0.1\n"
                                  "SA(1.0),0.5,0.1,7.5,15,0.5,0.1\n")),
               "a.csv:4:9: iml 0.5: must be 0.4, as of the other rows of SA(1) and poe 0.1");
}

/// Synthetic, in the form of the services of the USGS.
std::string summary(const std::string& targets, const std::string& level,
                    const std::string& im = "0.6", const std::string& m = "6.9",
                    const std::string& r = "12.5") {
  return R"j("data": [{"component": "Grid", "summary": []}, {"component": "Total", "summary": [
    {"name": ")j" +
         targets + R"j(", "data": [
      {"name": "Return period", "value": 2475, "units": "yrs"},
      {"name": ")j" +
         level + R"j(", "value": )j" + im + R"j(, "units": "g"}]},
    {"name": "Mean (over all sources)", "data": [
      {"name": "m", "value": )j" +
         m + R"j(}, {"name": "r", "value": )j" + r +
         R"j(, "units": "km"},
      {"name": "ε₀", "value": 1.4, "units": "σ"}]},
    {"name": "Mode (largest m-r bin)", "data": [{"name": "m", "value": 9}]}]}])j";
}

TEST_F(DisaggregationTest, MeansOfTheUsgsAreTaken) {
  const std::string today = R"j({"response": {"disaggs": [{"imt": {"value": "PGA"}, )j" +
                            summary("x", "y") + R"j(}, {"imt": {"value": "SA1P0"}, )j" +
                            summary("Disaggregation targets", "1.0 s SA ground motion") + "}]}}";
  const std::string before = R"j({"response": [{"metadata": {"imt": {"value": "SA1P0"}}, )j" +
                             summary("Deaggregation targets", "Exceedance IML") + "}]}";
  for (const std::string& text : {today, before}) {
    const Disaggregation mean = read("a.json", text);
    EXPECT_EQ(mean.period, 1);
    EXPECT_DOUBLE_EQ(mean.acceleration, 0.6 * kStandardGravity);
    EXPECT_EQ(mean.magnitude, 6.9);
    EXPECT_EQ(mean.distance, 12.5);
    EXPECT_EQ(mean.epsilon, 1.4);
  }
  EXPECT_ERROR(read("a.json", today, {.period = 2}), "period_s = 2: must be one of 1");
  EXPECT_ERROR(read("a.json", R"j({"response": [{"metadata": {"imt": {"value": "SA1P0"}}, )j" +
                                  summary("Recovered", "x") + "}]}"),
               "a.json:/response/0/data/1: has no summary 'aggregation targets'");
  EXPECT_ERROR(read("a.json", R"j({"response": {"hazardCurves": []}})j"), "is a hazard curve");
  const auto bad = [](const std::string& im, const std::string& m, const std::string& r) {
    return R"j({"response": {"disaggs": [{"imt": {"value": "SA1P0"}, )j" +
           summary("Disaggregation targets", "SA ground motion", im, m, r) + "}]}}";
  };
  const std::string place = "a.json:/response/disaggs/0/data/1/summary/";
  EXPECT_ERROR(read("a.json", bad("0", "6.9", "12.5")),
               place + "0/data/1/value: value of 'SA ground motion' must be a finite number > 0");
  EXPECT_ERROR(read("a.json", bad("0.6", "-6.5", "12.5")),
               place + "1/data/0/value: value of 'm' must be a finite number > 0");
  EXPECT_ERROR(read("a.json", bad("0.6", "6.5", "-15")),
               place + "1/data/1/value: value of 'r' must be a finite number >= 0");
}

}  // namespace
}  // namespace gurney::groundmotions
