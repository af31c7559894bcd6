#include "studies/report/summary.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/studies/fabricated_run.h"

namespace gurney {
namespace {

void expect_contains(const std::string& text, const std::string& fragment) {
  EXPECT_NE(text.find(fragment), std::string::npos) << "no '" << fragment << "' in\n" << text;
}

TEST(Summary, SaysWhatRanAndWhatCameOut) {
  const std::string text = summary(fabricated_facts(), fabricated_response());
  expect_contains(text, "A trolley under a made-up motion");
  expect_contains(text, "Trolley: 96.5 kg on 4 casters");
  expect_contains(text, "made-up: 20.00 s, sampled every 0.005 s");
  // 3.92266 m/s2 is 0.4 g exactly.
  expect_contains(text, "PGA                                   0.4000      0.3000      0.2000 g");
  expect_contains(text, "residual velocity                     0.0010     -0.0020      0.0000 m/s");
  // The tenth number of the demands is 10/8 rad = 71.62 deg.
  expect_contains(text, "peak yaw                               71.62 deg");
  expect_contains(text, "front left");
  expect_contains(text, "energy closure                      1.00e-07");
  expect_contains(text, "warning: the record ends with 2.0 mm/s");
  expect_contains(text,
                  "\n  draw 3 of seed 1: 2 numbers\n"
                  "  front left/tread.rolling_resistance_mm      1.0625 mm\n"
                  "  floor.slope                                  0.001\n");
  expect_contains(text, "of the numbers behind this have no published source and are assumed (");
  expect_contains(text, "r100.toml 1");
}

TEST(Summary, FitsATerminalOf100Columns) {
  RunFacts facts = fabricated_facts();
  facts.warnings.assign(2,
                        "a rather long warning that goes on and on and on and on and on and on, "
                        "until nobody wants to read it any more, and then a little");
  std::istringstream lines(summary(facts, fabricated_response()));
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 100u) << line;
}

TEST(Summary, TellsEachOutcome) {
  Response response = fabricated_response();
  expect_contains(story(response), "The item moved at most 125 mm from its start (at 0.50 s)");
  expect_contains(story(response), "It was at rest at 24.00 s, 625 mm from its start");
  response.outcome = Outcome::kStillMoving;
  expect_contains(story(response), "STILL MOVED when the settling time was over at 24.00 s");
  response.outcome = Outcome::kOverturned;
  response.items[0].demands.time_of_overturning = 7.5;
  expect_contains(story(response), "It OVERTURNED at 7.50 s.");
  response.outcome = Outcome::kDiverged;
  response.cause = "no solution";
  EXPECT_EQ(story(response),
            "The run DIVERGED at 24 s: no solution. Its numbers must not be used.");
  response = {};
  response.outcome = Outcome::kRested;
  expect_contains(story(response), "The item did not move. Every wheel stayed on the floor.");
}

TEST(Summary, SaysTheSameAsJson) {
  const auto json = nlohmann::json::parse(summary_json(fabricated_facts(), fabricated_response()));
  EXPECT_EQ(json["demands"]["peak_yaw"], 1.25);
  EXPECT_TRUE(json["demands"]["time_of_overturning"].is_null());
  EXPECT_EQ(json["wheels"][3]["name"], "rear right");
  EXPECT_EQ(json["wheels"][3]["wheel_liftoffs"], 3);
  EXPECT_EQ(json["record"]["residual_velocity_m_per_s"][1], -0.002);
  EXPECT_EQ(json["outcome"], "rested");
  EXPECT_EQ(json["assumptions"][0]["key"], "tread.rolling_resistance_m");
  EXPECT_EQ(json["draw"]["draw"], 3);
  EXPECT_EQ(json["draw"]["numbers"][0]["value"], 1.0625);
  EXPECT_EQ(json["draw"]["numbers"][0]["unit"], "mm");
  const auto still =
      nlohmann::json::parse(summary_json(fabricated_facts(true), fabricated_response(true)));
  EXPECT_TRUE(still["record"].is_null());
}

}  // namespace
}  // namespace gurney
