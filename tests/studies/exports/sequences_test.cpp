#include <gmock/gmock.h>

#include <cmath>

#include "studies/exports/fragility_export.h"

namespace gurney::study {
namespace {

using testing::ElementsAre;

ChosenCurve curve(const std::string& name, const std::string& column, double limit, double theta,
                  double beta, LimitState::Kind kind = LimitState::Kind::kAbove) {
  ChosenCurve result;
  result.configuration = "c";
  result.state.name = name;
  result.state.kind = kind;
  result.state.quantity = {Quantity::Of::kItem, column, "", ""};
  result.state.limit = limit;
  result.curve = {theta, beta};
  return result;
}

std::vector<std::string> names(const std::vector<CurveSequence>& all) {
  std::vector<std::string> result;
  for (const CurveSequence& each : all) result.push_back(each.name);
  return result;
}

TEST(Sequences, CombineStricterLimitsOfOneQuantity) {
  ChosenCurves chosen;
  chosen.curves = {
      curve("far", "peak_displacement", 1, 3, 0.4), curve("near", "peak_displacement", 0.1, 1, 0.4),
      curve("fast", "peak_velocity", 1, 2, 0.4), curve("mid", "peak_displacement", 0.5, 2, 0.4)};
  EXPECT_THAT(names(sequences(chosen, true)), ElementsAre("near_mid_far", "fast"));
  EXPECT_THAT(names(sequences(chosen, false)), ElementsAre("far", "near", "fast", "mid"));
  chosen.curves[3].configuration = "other";
  EXPECT_THAT(names(sequences(chosen, true)), ElementsAre("near_far", "fast", "mid"));
}

TEST(Sequences, KeepApartWhatIsNotNested) {
  ChosenCurves chosen;
  const auto kBelow = LimitState::Kind::kBelow;
  chosen.curves = {curve("narrow", "free_width", 0.9, 1, 0.4, kBelow),
                   curve("blocked", "free_width", 0.5, 2, 0.4, kBelow),
                   curve("wide", "free_width", 0.9, 1, 0.4),
                   curve("same", "free_width", 0.9, 1, 0.4, kBelow)};
  chosen.curves.push_back(curve("two", "free_width", 0.4, 3, 0.4, kBelow));
  chosen.curves.back().state.at_least = 2;
  EXPECT_THAT(names(sequences(chosen, true)), ElementsAre("narrow_blocked", "wide", "same", "two"));
}

TEST(Sequences, GiveCrossingCurvesOneBetaAndKeepTheirTenthParts) {
  std::vector<statistics::LognormalCurve> apart{{1, 0.4}, {4, 0.45}};
  EXPECT_FALSE(in_order(apart));
  EXPECT_EQ(apart[1].beta, 0.45);

  const std::vector<statistics::LognormalCurve> fitted{{1, 0.3}, {1.5, 0.5}};
  std::vector<statistics::LognormalCurve> curves = fitted;
  EXPECT_TRUE(in_order(curves));
  for (std::size_t i = 0; i < curves.size(); ++i) {
    EXPECT_DOUBLE_EQ(curves[i].beta, 0.4);
    // 1.28 stands for 1.28155: 0.00155 |1 - b / b'| = 4e-4 of z, times the density 0.18 there
    EXPECT_NEAR(curves[i].probability(fitted[i].quantile(0.1)), 0.1, 1e-4);
  }
  for (const double im : {0.01, 0.1, 1.0, 10.0})
    EXPECT_GE(curves[0].probability(im), curves[1].probability(im));
}

// Their 10 % points are 0.77 and 0.38: with one beta the stricter state would come first.
TEST(Sequences, GiveAStricterStateAtLeastTheMedianOfAMilderOne) {
  std::vector<statistics::LognormalCurve> curves{{1, 0.2}, {1.05, 0.8}};
  EXPECT_TRUE(in_order(curves));
  EXPECT_DOUBLE_EQ(curves[0].theta, std::exp(1.28 * 0.3));
  EXPECT_EQ(curves[1].theta, curves[0].theta);
  EXPECT_DOUBLE_EQ(curves[1].beta, 0.5);
}

TEST(Sequences, AreIncompleteWhereTheRunsDoNotSupportACurve) {
  ChosenCurves chosen;
  chosen.curves = {curve("near", "peak_displacement", 0.1, 1, 0.4),
                   curve("far", "peak_displacement", 1, 3, 0.4)};
  for (ChosenCurve& each : chosen.curves) {
    each.audit.theta = each.curve.theta;
    each.audit.lowest = 0.5;
    each.audit.highest = 4;
    each.audit.outcomes = 100;
    each.audit.exceeded = 40;
    each.audit.effective = each.audit.fewest = 8;
  }
  EXPECT_FALSE(is_incomplete(sequences(chosen, true).front()));
  chosen.curves[1].audit.exceeded = 9;  // of 10
  const CurveSequence few = sequences(chosen, true).front();
  EXPECT_TRUE(is_incomplete(few));
  EXPECT_EQ(few.curves.size(), 2u);
  EXPECT_EQ(supported_part(few).name, "near");
  chosen.curves[1].audit.exceeded = 40;
  chosen.curves[1].audit.highest = 2.9;  // theta is 3
  EXPECT_TRUE(is_incomplete(sequences(chosen, true).front()));
  chosen.curves[1].audit.highest = 4;
  chosen.curves[1].audit.effective = 7.9;
  EXPECT_TRUE(is_incomplete(sequences(chosen, true).front()));
}

}  // namespace
}  // namespace gurney::study
