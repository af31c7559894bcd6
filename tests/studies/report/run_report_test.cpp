#include "studies/report/run_report.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "studies/render/render.h"
#include "tests/support/synthetic_run.h"
#include "tests/support/synthetic_ward.h"

namespace gurney::report {
namespace {

std::string summary(const study::RunFacts& facts, const Response& response) {
  return render::text(run_findings(facts, response));
}

/// Blanks in a row as one, so that the widths of columns do not matter.
std::string squeezed(const std::string& text) {
  std::string result;
  for (const char c : text)
    if (c != ' ' || !result.ends_with(' ')) result += c;
  return result;
}

nlohmann::json json_of(const study::RunFacts& facts, const Response& response) {
  return nlohmann::json::parse(render::json(run_findings(facts, response)));
}

void expect_contains(const std::string& text, const std::string& fragment) {
  EXPECT_NE(squeezed(text).find(fragment), std::string::npos) << "no '" << fragment << "' in\n"
                                                              << text;
}

TEST(Summary, SaysWhatRanAndWhatCameOut) {
  const std::string text = summary(synthetic_facts(), synthetic_response());
  expect_contains(text, "A trolley under a made-up motion");
  expect_contains(text, "Trolley: 96.5 kg on 4 casters");
  expect_contains(text, "made-up: 20.00 s, sampled every 0.005 s");
  // 3.92266 m/s2 is 0.4 g exactly.
  expect_contains(text, "PGA 0.4000 0.3000 0.2000 g");
  expect_contains(text, "residual velocity 0.0010 -0.0020 0.0000 m/s");
  // The tenth number of the demands is 10/8 rad = 71.62 deg.
  expect_contains(text, "peak yaw 71.62 deg");
  expect_contains(text, "front left");
  expect_contains(text, "energy closure 1.00e-07");
  expect_contains(text, "warning: the record ends with 2.0 mm/s");
  expect_contains(text,
                  "draw 3 of seed 1: 2 parameters\n parameter value unit\n"
                  " front left/tread.rolling_resistance_mm 1.0625 mm\n floor.slope 0.001\n");
  expect_contains(text, "parameters of this run have no published source and are assumed (");
  expect_contains(text, "r100.toml 1");
}

TEST(Summary, FitsATerminalOf100Columns) {
  study::RunFacts facts = synthetic_facts();
  facts.warnings.assign(2,
                        "a rather long warning that goes on and on and on and on and on and on, "
                        "until nobody wants to read it any more, and then a little");
  std::istringstream lines(summary(facts, synthetic_response()));
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 100u) << line;
}

TEST(Summary, SaysNothingOfWheelsWhereThereAreNone) {
  study::RunFacts facts = synthetic_facts();
  facts.scene.items[0].model.casters.clear();
  Response response = synthetic_response();
  response.items[0].demands.wheels.clear();
  response.items[0].demands.peak_tilt = 0.05;  // 2.86 deg
  const std::string text = summary(facts, response);
  expect_contains(text, "kg without casters");
  expect_contains(text, "It tilted by up to 2.9 deg.");
  for (const char* word : {"wheel", "Wheel", "peak normal force", "lifted time"})
    EXPECT_EQ(text.find(word), std::string::npos) << word;
}

// A second table has a row for each part and each item that stands on another, with what only these have; a lock that
// yields by a picometre has not opened.
TEST(Summary, HasATableOfPartsAndContents) {
  study::RunFacts facts = synthetic_facts();
  Response response = synthetic_response();
  for (const char* name : {"jug", "drawer", "lid"}) {
    facts.scene.items.push_back(facts.scene.items[0]);
    facts.scene.items.back().name = name;
    response.items.emplace_back().demands.wheels.resize(4);
    response.items.back().demands.points.resize(response.items[0].demands.points.size());
  }
  facts.scene.items[0].name = "cart";
  Demands &jug = response.items[1].demands, &drawer = response.items[2].demands,
          &lid = response.items[3].demands;
  jug.peak_slide = 0.0125;
  jug.time_of_toppling = 3.21;
  jug.time_of_fall = 3.5;
  drawer.peak_travel = 1e-12;
  drawer.largest_stop_speed = 0.125;
  lid.peak_swing = 0.5;  // 28.6 deg
  lid.time_of_release = 2;
  const std::string text = summary(facts, response);
  expect_contains(
      text,
      "item slid [mm] toppled [s] fell [s] latch open [s] opened [mm] swung [deg] stop [m/s]");
  expect_contains(text, "\njug 12.5 3.21 3.50 - - - -");
  expect_contains(text, "\ndrawer - - - - 0 - 0.12");
  expect_contains(text, "\nlid - - - 2.00 - 28.6 -");
  EXPECT_EQ(summary(synthetic_facts(), synthetic_response()).find("slid"), std::string::npos);
}

TEST(Summary, FlagsNumericalAccelerations) {
  expect_contains(
      summary(synthetic_facts(), synthetic_response()),
      "\nnote: accelerations of points leave out impacts that state a restitution and no "
      "stiffness; the\nnumerical ones there reach 98.5 m/s2.\n");
  Response response = synthetic_response();
  response.items[0].demands.points[0].numerical_acceleration = PointDemands::kNone;
  EXPECT_EQ(summary(synthetic_facts(), response).find("note:"), std::string::npos);
}

TEST(Summary, SaysOfEachDemandWhatItIsSettledTo) {
  Response response = synthetic_response();
  EXPECT_EQ(summary(synthetic_facts(), response).find("settled to"), std::string::npos)
      << "this run was not repeated";
  Predictability& p = response.items[0].predictability.emplace();
  p.half_step = p.twin = response.items[0].demands;
  p.half_step->peak_velocity *= 1.004;  // times 4: 2 %
  p.half_step->peak_yaw *= 2;
  p.half_step->points[0].peak_displacement *= 2;
  const std::string text = summary(synthetic_facts(), response);
  expect_contains(text, "\n peak velocity 1.000 m/s, settled to 2 %\n");
  expect_contains(text, "71.62 deg, NOT SETTLED\n");
  expect_contains(text, "\n~ not settled\n");
  const auto json = json_of(synthetic_facts(), response);
  const auto& settled = json["items"][0]["settled"];
  EXPECT_EQ(settled["demands"].size(), json["items"][0]["demands"].size());
  EXPECT_EQ(settled["demands"]["peak_displacement"]["settled_to"], 0.01);
  EXPECT_EQ(settled["demands"]["peak_velocity"]["settled_to"], 0.02);
  EXPECT_TRUE(settled["demands"]["peak_yaw"]["settled_to"].is_null());
  EXPECT_EQ(settled["demands"]["peak_yaw"]["step_change"], 0.5);
  EXPECT_EQ(settled["wheels"].size(), json["items"][0]["wheels"].size());
  EXPECT_EQ(settled["points"][0]["peak_displacement"]["step_change"], 0.5);
}

TEST(Summary, ShowsRoundingAsZero) {
  Response response = synthetic_response();
  response.items[0].demands.peak_velocity = 3.46e-13;
  expect_contains(summary(synthetic_facts(), response), "\n peak velocity 0 m/s\n");
  EXPECT_EQ(json_of(synthetic_facts(), response)["items"][0]["demands"]["peak_velocity"], 3.46e-13);
}

TEST(Summary, HasARowForEachOfSeveralItems) {
  const std::string text = summary(synthetic_ward(), synthetic_ward_response());
  expect_contains(text, "item bookcase: 80.0 kg without casters\n");
  expect_contains(text, "item moved at end turned tilt lifted impacts fastest overturned\n");
  expect_contains(text, " [mm] [mm] [deg] [deg] [s] [m/s] [s]\n");
  // Turned and leaning as the synthetic run states: 0.2 rad (1 - exp(-5)) and 90 deg.
  expect_contains(text, " 11.4 90.0 11.00 1 3.10 4.50\n");
  expect_contains(text, "bookcase 0 0 0.0 0.0 0.00 0 - -\n");
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 100u) << line;
}

TEST(Summary, SaysTheSameAsJson) {
  const auto json = json_of(synthetic_facts(), synthetic_response());
  const auto& item = json["items"][0];
  EXPECT_EQ(item["name"], "Trolley");
  EXPECT_EQ(item["demands"]["peak_yaw"], 1.25);
  EXPECT_TRUE(item["demands"]["time_of_overturning"].is_null());
  EXPECT_TRUE(item["demands"]["peak_impact_force"].is_null());
  EXPECT_EQ(item["wheels"][3]["name"], "rear right");
  EXPECT_EQ(item["wheels"][3]["liftoffs"], 3);
  EXPECT_EQ(item["points"][0]["numerical_acceleration"], 98.5);
  EXPECT_TRUE(json["impacts"].empty());
  EXPECT_EQ(json["record"]["residual_velocity_m_per_s"][1], -0.002);
  EXPECT_EQ(json["outcome"], "rested");
  EXPECT_EQ(json["assumptions"][0]["key"], "tread.rolling_resistance_m");
  EXPECT_EQ(json["draw"]["draw"], 3);
  EXPECT_EQ(json["draw"]["parameters"][0]["value"], 1.0625);
  EXPECT_EQ(json["draw"]["parameters"][0]["unit"], "mm");
  const auto still = json_of(synthetic_facts(true), synthetic_response(true));
  EXPECT_TRUE(still["record"].is_null());
}

TEST(Summary, ReportsOfSeveralItemsInJson) {
  const auto json = json_of(synthetic_ward(), synthetic_ward_response());
  EXPECT_EQ(json["items"].size(), 10u);
  EXPECT_EQ(json["items"][3]["demands"]["time_of_overturning"], 4.5);
  EXPECT_EQ(json["impacts"][1]["item"], "ventilator");
  EXPECT_EQ(json["impacts"][1]["other_body"], "rear left");
  EXPECT_EQ(json["impacts"][3]["peak_force"], 5200);
  EXPECT_TRUE(json["impacts"][0]["peak_force"].is_null()) << "restitution states no force";
  ASSERT_EQ(json["overturnings"].size(), 1u);
  EXPECT_EQ(json["overturnings"][0]["item"], "infusion pump");
  EXPECT_EQ(json["overturnings"][0]["liftoffs"][2]["wheel"], "front right");
  EXPECT_NEAR(json["overturnings"][0]["floor_pulse"]["time_of_peak_s"].get<double>(), 4.0, 0.006);
  EXPECT_EQ(json["zones"][0]["name"], "doorway");
  EXPECT_EQ(json["zones"][0]["occupied_at_end"], 1);
  EXPECT_TRUE(json["tethers"][2]["time_taut"].is_null());
}

}  // namespace
}  // namespace gurney::report
