#include "studies/figures/run_figure.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>

#include "studies/figures/panel.h"
#include "tests/support/synthetic_run.h"
#include "tests/support/synthetic_ward.h"

namespace gurney::figures {
namespace {

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

TEST(Ticks, AreRoundAndInside) {
  EXPECT_EQ(ticks({0, 10}, 5), (std::vector<double>{0, 2, 4, 6, 8, 10}));
  EXPECT_EQ(ticks({-0.31, 0.42}, 4), (std::vector<double>{-0.2, 0, 0.2, 0.4}));
  const auto small = ticks({1e-7, 9e-7}, 4);
  ASSERT_EQ(small.size(), 4u);
  EXPECT_NEAR(small[0], 2e-7, 1e-20);
}

TEST(Ticks, AreOneTwoFiveOfEachDecade) {
  std::vector<double> values;
  for (const double at : decade_ticks({-1, std::log10(5)})) values.push_back(std::pow(10, at));
  ASSERT_EQ(values.size(), 6u);
  const double expected[] = {0.1, 0.2, 0.5, 1, 2, 5};
  for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(values[i], expected[i], 1e-12);
}

TEST(Figure, HasEveryPanelWithUnits) {
  const std::string svg = run_figure(synthetic_facts(), synthetic_response());
  for (const char* label : {"x (m)", "y (m)", "Time (s)", "Displacement (m)", "Velocity (m/s)",
                            "Acceleration (m/s\u00b2)", "Yaw and tilt", "Normal force (N)",
                            "Swivel angle (deg)", "Energy (J)", "front left"})
    EXPECT_GE(count(svg, label), 1u) << label;
  EXPECT_EQ(count(svg, "Force (N)"), 0u) << "nothing pulls";
  EXPECT_EQ(count(svg, "nan"), 0u);
  // Each wheel's force on axes of its own, besides the six other panels and twice the plan.
  EXPECT_EQ(count(svg, "<clipPath"), 4u + 6 + 2);
  EXPECT_EQ(count(svg, "Floor acceleration"), 0u) << "the floor is at rest";
  // Box and four casters, at start and end: each caster has one circle at its mount.
  EXPECT_EQ(count(svg, "r=\"2.20\""), 8u);
}

TEST(Figure, ShowsTheInput) {
  study::RunFacts facts = synthetic_facts();
  Eigen::Matrix3Xd motion = Eigen::Matrix3Xd::Zero(3, 400);
  motion.row(1).setConstant(2);
  facts.floor = FloorMotion(0.01, motion);
  const std::string svg = run_figure(facts, synthetic_response());
  EXPECT_EQ(count(svg, "Floor acceleration"), 1u);
  EXPECT_EQ(count(svg, "<clipPath"), 4u + 7 + 2);
}

TEST(Figure, MarksFronts) {
  // The plan's only triangles: at the start and at the end.
  const std::string svg = run_figure(synthetic_facts(), synthetic_response());
  std::size_t triangles = 0;
  for (auto at = svg.find("<polygon points=\""); at != std::string::npos;
       at = svg.find("<polygon points=\"", at + 1)) {
    const std::string points = svg.substr(at + 17, svg.find('"', at + 17) - at - 17);
    triangles += std::ranges::count(points, ',') == 3;
  }
  EXPECT_EQ(triangles, 2u);
}

TEST(Figure, ShowsThePull) {
  EXPECT_EQ(count(run_figure(synthetic_facts(true), synthetic_response(true)), ">Force (N)<"), 1u);
}

TEST(Figure, ShowsARoomOfSeveralItems) {
  const study::RunFacts facts = synthetic_ward();
  const std::string svg = run_figure(facts, synthetic_ward_response());
  if (const char* path = std::getenv("GURNEY_SAVE_FIGURE")) std::ofstream(path) << svg;
  EXPECT_EQ(count(svg, "nan"), 0u);
  for (const PlacedItem& item : facts.scene.items)
    EXPECT_EQ(count(svg, ">" + item.name + ", "), 1u) << item.name;
  EXPECT_EQ(count(svg, "infusion pump, overturned"), 1u);
  // 9 items on four casters at the start; without the one that lies at the end.
  EXPECT_EQ(count(svg, "r=\"2.20\""), 4u * 9 + 4u * 8);
  EXPECT_EQ(count(svg, "fill=\"#c4c4c4\""), 6u) << "walls and column";
  EXPECT_EQ(count(svg, "fill=\"#eadfc8\""), 1u) << "threshold";
  EXPECT_EQ(count(svg, "fill=\"#e69f00\" stroke=\"none\" opacity=\"0.3\""), 1u) << "doorway";
  EXPECT_EQ(count(svg, "stroke=\"#c00000\" stroke-width=\"1.6\""), 2u * 6) << "crosses";
  EXPECT_EQ(count(svg, "stroke-dasharray=\"2 3\""), 1u) << "the broken cord";
  EXPECT_EQ(count(svg, ">1 m<"), 1u);
  EXPECT_EQ(count(svg, "Tilt"), 1u);
}

/// The origin of an item that lies is a point below its base, off its outline.
TEST(Figure, MarksTheOriginOnlyWhileItStands) {
  const std::string end = "r=\"3.50\" fill=\"" + palette(1) + '"';
  Response response = synthetic_response();
  EXPECT_EQ(count(run_figure(synthetic_facts(), response), end), 1u);
  response.items[0].history.back().tilt = 1.5;
  const std::string svg = run_figure(synthetic_facts(), response);
  EXPECT_EQ(count(svg, end), 0u);
  EXPECT_EQ(count(svg, ">path while it stands<"), 1u);
}

TEST(Figure, ShowsTheRoomOfASingleItem) {
  study::RunFacts facts = synthetic_facts();
  facts.scene.room = {{"wall", "", {2, 0, 1}, Quaternion::Identity(), RoomBox{{0.2, 4, 2}}}};
  const std::string svg = run_figure(facts, synthetic_response());
  EXPECT_EQ(count(svg, "fill=\"#c4c4c4\""), 1u);
  EXPECT_EQ(count(svg, ">Normal force (N)<"), 1u);
  EXPECT_EQ(count(svg, ">Energy (J)<"), 1u);
}

TEST(Figure, SurvivesWhatDivergedAndWhatHasNoHistory) {
  Response response = synthetic_response();
  response.items[0].history.resize(3);
  for (Sample& sample : response.items[0].history) sample.displacement.x() = std::nan("");
  response.items[0].history.front().displacement.setZero();
  const std::string svg = run_figure(synthetic_facts(), response);
  EXPECT_EQ(count(svg, "nan"), 0u);
  EXPECT_EQ(count(svg, "inf"), 0u);
  response.items[0].history.clear();
  EXPECT_EQ(count(run_figure(synthetic_facts(), response), "No history was kept"), 1u);
}

TEST(Figure, EscapesText) {
  study::RunFacts facts = synthetic_facts();
  facts.title = "<a & b>";
  EXPECT_EQ(count(run_figure(facts, synthetic_response()), "&lt;a &amp; b&gt;"), 1u);
}

}  // namespace
}  // namespace gurney::figures
