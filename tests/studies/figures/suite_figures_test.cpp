#include <gmock/gmock.h>

#include <regex>

#include "engine/base/units.h"
#include "studies/figures/plan_figures.h"
#include "studies/figures/record_figures.h"
#include "studies/figures/study_figures.h"
#include "studies/results/names.h"
#include "tests/support/expect_error.h"
#include "tests/support/synthetic_ward.h"

namespace gurney::figures {
namespace {

using testing::HasSubstr;
using testing::Not;

std::vector<double> numbers(const std::string& text, const std::string& pattern) {
  std::vector<double> found;
  const std::regex expression(pattern);
  for (auto at = std::sregex_iterator(text.begin(), text.end(), expression);
       at != std::sregex_iterator(); ++at)
    found.push_back(std::stod((*at)[1]));
  return found;
}

study::SensitiveInput input(const char* name, double low, double high) {
  study::SensitiveInput made;
  made.names = {name};
  made.bar = {.low = low, .high = high, .low_runs = 14, .high_runs = 12};
  return made;
}

TEST(TornadoFigure, LongestBarsAreAbove) {
  study::StudySensitivity found;
  found.output = "ICU bed: peak_displacement";
  found.units = "m";
  found.mean = 0.2;
  found.inputs = {input("short", 0.19, 0.21), input("long", 0.1, 0.4), input("record", 0, 0)};
  found.inputs.back().drawn = false;
  const std::string svg = tornado_figure({}, "title", {{"brakes off", found, ""}});
  EXPECT_THAT(svg, HasSubstr("ICU bed: Peak displacement, brakes off"));
  EXPECT_THAT(svg, HasSubstr("Mean over 12 runs or more (m)"));
  EXPECT_THAT(svg, Not(HasSubstr(">record<")));
  EXPECT_LT(svg.find(">long<"), svg.find(">short<"));
  // The bars of low inputs, and their key: 0.1 and 0.01 from the mean, drawn to 0.01 px.
  const auto low = numbers(svg, "width=\"([0-9.]+)\" height=\"6.00\" fill=\"#0072B2\"");
  ASSERT_EQ(low.size(), 2);
  EXPECT_NEAR(low[0], 10 * low[1], 10 * 0.005 + 0.005);
}

/// Means of few runs are none: the reason is said, or is the error where it is all there is.
TEST(TornadoFigure, SaysWhyThereAreNoBars) {
  study::StudySensitivity found;
  found.output = "ICU bed: peak_displacement";
  found.units = "m";
  found.runs = 30;
  found.inputs = {input("mass", std::nan(""), std::nan(""))};
  found.inputs[0].bar.low_runs = found.inputs[0].bar.high_runs = 3;
  const char* const why =
      "30 runs: the lowest and the highest 10 % of an input have 3 runs each, and a mean needs 10";
  EXPECT_ERROR(tornado_figure({}, "title", {{"off", found, ""}}), why);
  EXPECT_THAT(sensitivity_figure({"off", found, ""}), HasSubstr("no tornado: 30 runs: the lowest"));
  EXPECT_THAT(sensitivity_figure({"off", found, ""}), Not(HasSubstr("Mean (m)")));
  study::StudySensitivity drawn = found;
  drawn.inputs = {input("mass", 0.1, 0.4)};
  const std::string svg = tornado_figure({}, "title", {{"off", found, ""}, {"on", drawn, ""}});
  EXPECT_THAT(svg, HasSubstr("no tornado of ICU bed: Peak displacement, off"));
  EXPECT_THAT(svg, HasSubstr("Peak displacement, on<"));
}

/// Ends and middle of an interval are lines: a rectangle without an area is not drawn.
TEST(SensitivityFigure, DrawsIntervals) {
  study::StudySensitivity found;
  found.output = "ICU bed: peak_displacement";
  found.units = "m";
  found.inputs = {input("mass", 0.1, 0.4)};
  found.inputs[0].index = statistics::VarianceIndex{0.5, {0.25, 0.75}};
  const std::string svg = sensitivity_figure({"off", found, ""});
  EXPECT_THAT(svg, Not(HasSubstr("height=\"0.00\"")));
  EXPECT_THAT(svg, Not(HasSubstr("width=\"0.00\"")));
  EXPECT_EQ(numbers(svg, "<line x1=\"([0-9.]+)\"[^>]*stroke-width=\"1.4\"").size(), 3u);
}

study::StoredImpact impact(const std::string& item, double speed) {
  return {.run = 0, .item = item, .other = "wall", .x = 1, .y = 1, .speed = speed};
}

TEST(CollisionFigure, AreasAreInProportionToSpeeds) {
  const Scene scene = synthetic_ward().scene;
  const std::string item = study::item_names(scene).front();
  const std::string svg = collision_figure(
      {}, "title", "note",
      {{"brakes on", scene, {impact(item, 0.1), impact(item, 0.7), impact(item, 4)}, 3}});
  EXPECT_THAT(svg, HasSubstr("brakes on: 3 impacts in 3 runs"));
  for (const char* label : {">2 to 5 m/s<", ">1 to 2 m/s<", ">0.5 to 1 m/s<", ">to 0.5 m/s<"})
    EXPECT_THAT(svg, HasSubstr(label));
  const auto radii =
      numbers(svg, "r=\"([0-9.]+)\" fill=\"#0072B2\" stroke=\"#0072B2\" stroke-width=\"0.7\"");
  ASSERT_EQ(radii.size(), 3);  // the largest first: 7 px of up to 5 m/s, printed to 0.01
  EXPECT_NEAR(radii[0], 7, 0.005);
  EXPECT_NEAR(radii[1], 7 * std::sqrt(1 / 5.0), 0.005);
  EXPECT_NEAR(radii[2], 7 * std::sqrt(0.5 / 5), 0.005);
}

study::SuiteSpectra suite(bool building) {
  study::SuiteSpectra made;
  made.configurations = {"a", "b"};
  made.combination = groundmotions::Combination::kGeometricMean;
  made.level = "PGA geomean = 0.4 g";
  made.periods = Eigen::Vector3d(0.1, 1, 10);
  for (const double size : {1.0, 2.0, 4.0}) {
    const Eigen::VectorXd ground = size * kStandardGravity * Eigen::Vector3d(1, 0.5, 0.1);
    made.records.push_back({"record", 1 / size, ground, {}});
    if (building) made.records.back().floor = 3 * ground;
  }
  return made;
}

TEST(SpectraFigure, HasRecordsAndFractiles) {
  const std::string svg = spectra_figure({}, "title", {suite(false)});
  EXPECT_THAT(svg, HasSubstr("Records as read and processed"));
  EXPECT_THAT(svg, HasSubstr("Scaled to PGA geomean = 0.4 g, factors 0.25 to 1"));
  EXPECT_THAT(svg, Not(HasSubstr("Floor")));
  EXPECT_THAT(svg, HasSubstr("Sa geomean (g), log scale"));
  EXPECT_EQ(numbers(svg, "polyline points=\"([0-9.]+),").size(), 2u * (3 + 3));
  EXPECT_THAT(svg, HasSubstr("16 and 84 % fractiles"));
}

TEST(SpectraFigure, DrawsWhatIsAskedFor) {
  const std::string svg = spectra_figure({}, "title", {suite(true)}, {"floor"});
  EXPECT_THAT(svg, HasSubstr("Floor, records scaled to PGA geomean = 0.4 g"));
  EXPECT_THAT(svg, Not(HasSubstr("as read")));
  EXPECT_ERROR(spectra_figure({}, "title", {suite(false)}, {"floor"}), "no building");
  EXPECT_ERROR(spectra_figure({}, "title", {suite(false)}, {"flor"}), "no spectra of 'flor'");
}

// A report holds no more than this, however large the suite.
TEST(SpectraFigure, OfManyRecordsIsSmall) {
  study::SuiteSpectra large = suite(false);
  large.periods = Eigen::VectorXd::LinSpaced(32, 0.02, 10);
  large.records.assign(1000, {"record", 2, large.periods.cwiseInverse(), {}});
  const std::string svg = spectra_figure({.most_marks = 8}, "", {large}, {"scaled"});
  EXPECT_LT(svg.size(), 20000);
  // The first record and 8 others, the median and both fractiles.
  EXPECT_EQ(numbers(svg, "polyline points=\"([0-9.]+),").size(), 1u + 8 + 3);
}

TEST(SpectraFigure, OfAFloorHasACurveForEachAxis) {
  const Eigen::VectorXd periods = Eigen::Vector3d(0.1, 1, 10);
  const std::string svg =
      floor_spectra_figure({}, "", {periods, {{"x", periods}, {"y", 2 * periods}}});
  EXPECT_THAT(svg, HasSubstr(">x<"));
  EXPECT_THAT(svg, HasSubstr(">y<"));
  EXPECT_EQ(numbers(svg, "polyline points=\"([0-9.]+),").size(), 2);
}

TEST(SpectraFigure, NamesTheConfigurationsOfSeveralSuites) {
  EXPECT_THAT(spectra_figure({}, "title", {suite(false), suite(false)}, {"records"}),
              HasSubstr("Records as read and processed, a and 1 more"));
}

}  // namespace
}  // namespace gurney::figures
