#include "studies/loss/study_loss.h"

#include <gmock/gmock.h>

#include <cmath>

#include "engine/base/random/normal_draw.h"
#include "engine/base/units.h"
#include "studies/analysis/fitted_curve.h"
#include "studies/statistics/special.h"
#include "tests/studies/analysis/small_study.h"
#include "tests/support/cart_prices.h"
#include "tests/support/expect_error.h"
#include "tests/support/temp_folder.h"

namespace gurney::study {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// A cart of 1000 that costs 100 where it moves 10 cm, and 600 where it falls.
const std::string kFile = kCartPrices + R"([[consequence]]
limit_state = "moved"
cost_ratio = { value = 0.1, assumption = "a guess", range = [0, 0.2] }
days = 1
injury = "none"
service = "check"
[[consequence]]
limit_state = "fell"
cost_ratio = 0.6
days = 7
injury = "serious"
service = "lost"
)";

Consequences consequences(const std::string& text = kFile) {
  config::Document document(text, "c.toml");
  return Consequences::read(document);
}

class StudyLossTest : public testing::Test {
 protected:
  /// 40 records at three levels. Capacities of falling are twice those of moving, record by record.
  StudyLossTest() {
    for (std::size_t record = 0; record < 40; ++record) {
      const double z = normal_quantile((static_cast<double>(record) + 0.5) / 40);
      const double capacity = 2 * std::exp(0.4 * z);  // [m/s2]
      for (const double im : {1.0, 2.0, 4.0})
        runs_.push_back({record, im, 0.1 * im / capacity, im > 2 * capacity});
    }
    write_small_study(path_, runs_);
  }

  StudyLoss loss(const LossRequest& request = {}, const std::string& text = kFile) {
    const StudyData data(path_);
    return study_losses(data, consequences(text), request).front();
  }

  TempFolder folder_;
  std::string path_ = folder_.file("s.h5");
  std::vector<SmallRun> runs_;
};

TEST_F(StudyLossTest, AtALevelItIsTheMeanOfTheWorstStateOfEachRun) {
  const StudyLoss found = loss();
  EXPECT_THAT(found.unpriced, ElementsAre("bed"));
  ASSERT_EQ(found.levels.size(), 3);
  for (std::size_t level = 0; level < 3; ++level) {
    double cost = 0, days = 0, fell = 0, high = 0;
    for (const SmallRun& run : runs_) {
      if (run.intensity != std::vector<double>{1, 2, 4}[level]) continue;
      const bool moved = run.displacement > 0.1;
      cost += (run.fell ? 600 : moved ? 100 : 0) / 40.0;
      high += (run.fell ? 600 : moved ? 200 : 0) / 40.0;
      days += (run.fell ? 7 : moved ? 1 : 0) / 40.0;
      fell += run.fell ? 1 / 40.0 : 0;
    }
    const LossAtLevel& at = found.levels[level];
    EXPECT_NEAR(at.cost.value, cost, 1e-9);
    EXPECT_NEAR(at.days.value, days, 1e-9);
    EXPECT_NEAR(at.out_of_use.estimate, fell, 1e-12);
    EXPECT_NEAR(at.high, high, 1e-9);
    ASSERT_TRUE(at.cost.interval);
    EXPECT_LE(at.cost.interval->low, cost);
    EXPECT_GE(at.cost.interval->high, cost);
  }
}

/// Cornell's k0 theta^-k exp(k^2 beta^2 / 2) for each step of the cost (hazard.h), with the hazard of
/// the job, k0 = 1e-3 and k = 2 over PGA in g. The curves are those of the outcomes, fitted apart.
TEST_F(StudyLossTest, ItsAnnualValueIsTheClosedFormOfLognormalCurvesAndAPowerLaw) {
  const StudyLoss found = loss();
  double expected = 0;
  const auto add = [&](double amount, auto happened) {
    std::vector<statistics::Observation> seen;
    for (const SmallRun& run : runs_) seen.push_back({run.intensity, happened(run), run.record});
    const statistics::LognormalCurve curve = *statistics::fit_fragility(seen).curve;
    const double theta = curve.theta / kStandardGravity;
    expected += amount * 1e-3 * std::pow(theta, -2) * std::exp(2 * curve.beta * curve.beta);
  };
  add(100, [](const SmallRun& run) { return run.displacement > 0.1; });
  add(500, [](const SmallRun& run) { return run.fell; });
  ASSERT_TRUE(found.annual);
  EXPECT_NEAR(found.annual->cost.value, expected, 1e-9 * expected);
  ASSERT_EQ(found.steps.size(), 2);
  EXPECT_EQ(found.steps[0].states, "moved or fell");
  EXPECT_EQ(found.steps[1].cost, 500);
  // Falls are out of use: one event with its own curve.
  EXPECT_NEAR(found.annual->out_of_use.value, *found.steps[1].rate, 1e-15);
  ASSERT_TRUE(found.annual->cost.interval);
  EXPECT_LT(found.annual->cost.interval->low, expected);
  EXPECT_GT(found.annual->cost.interval->high, expected);
}

TEST_F(StudyLossTest, AtAnIntensityItIsTheSumOfTheStepsProbabilities) {
  const StudyLoss found = loss({.at = {3}});
  double expected = 0;
  for (const FittedStep& step : found.steps) expected += step.cost * step.curve.probability(3);
  EXPECT_NEAR(found.at.front().cost.value, expected, 1e-9);
}

/// A fall costs 600, a move 100, and both have fixed prices: above any value below 100 the loss is as
/// often as the first step, above any from there to below 600 as the second. Their rates are the
/// closed form of the test above.
TEST_F(StudyLossTest, ExceedsAValueAsOftenAsTheLimitStatesThatCostMore) {
  std::string fixed = kFile;
  const std::string guess = "{ value = 0.1, assumption = \"a guess\", range = [0, 0.2] }";
  fixed.replace(fixed.find(guess), guess.size(), "0.1");
  const StudyLoss found = loss({.at = {3}}, fixed);
  ASSERT_EQ(found.steps.size(), 2);
  ASSERT_TRUE(found.annual);
  std::vector<double> costs;
  for (const LossExceedance& each : found.annual->exceedance) {
    const FittedStep& step = found.steps[each.cost < 100 ? 0 : 1];
    EXPECT_NEAR(each.chance.value, *step.rate, 1e-12 * *step.rate) << each.cost;
    const double theta = step.curve.curve()->theta / kStandardGravity;
    const double beta = step.curve.curve()->beta;
    const double closed = 1e-3 * std::pow(theta, -2) * std::exp(2 * beta * beta);
    EXPECT_NEAR(each.chance.value, closed, 1e-9 * closed) << each.cost;
    ASSERT_TRUE(each.chance.interval);
    EXPECT_LE(each.chance.interval->low, closed);
    EXPECT_GE(each.chance.interval->high, closed);
    EXPECT_TRUE(each.fitted);
    costs.push_back(each.cost);
  }
  EXPECT_THAT(costs, ElementsAre(90, 100, 200, 300, 400, 500));
  const auto& at = found.at.front().exceedance;
  ASSERT_EQ(at.size(), costs.size());
  EXPECT_NEAR(at.front().chance.value, found.steps[0].curve.probability(3), 1e-12);
  EXPECT_NEAR(at.back().chance.value, found.steps[1].curve.probability(3), 1e-12);
}

TEST(ExceedanceCosts, AreRoundFromBelowTheLeastToBelowTheMost) {
  EXPECT_THAT(exceedance_costs({0, 0}), testing::IsEmpty());
  EXPECT_THAT(exceedance_costs({0, 5}), ElementsAre(4));
  EXPECT_THAT(exceedance_costs({100, 0, 2500}), ElementsAre(50, 100, 200, 500, 1000, 2000));
  EXPECT_THAT(exceedance_costs({0.3, 0.6}), ElementsAre(0.2, 0.3, 0.4, 0.5));
}

TEST_F(StudyLossTest, IsTheSameForAnyNumberOfThreads) {
  const StudyLoss one = loss({.at = {3}, .threads = 1}), three = loss({.at = {3}, .threads = 3});
  EXPECT_EQ(one.annual->cost.interval->low, three.annual->cost.interval->low);
  EXPECT_EQ(one.at.front().cost.interval->high, three.at.front().cost.interval->high);
}

TEST_F(StudyLossTest, NeedsAPrice) {
  std::string text = kFile;
  text.replace(text.find("\"cart\""), 6, "\"bike\"");
  EXPECT_ERROR(loss({}, text), "none of its items has a price in c.toml: cart, bed; it has bike");
}

TEST(EventCurve, WithoutACurveHasTheSharesOfTheRunsAndTheirRate) {
  // None of 10 at 1, all at 2: linear in ln im between. With the hazard im^-k the rate is
  // P2 l2 + integral of (ln x / ln 2) k x^(-k - 1) = l2 + [1 - 2^-k (1 + k ln 2)] / (k ln 2).
  const EventCurve curve(std::vector<statistics::Stripe>{{1, 10, 0}, {2, 10, 10}});
  EXPECT_FALSE(curve.is_fitted());
  EXPECT_EQ(curve.probability(0.9), 0);
  EXPECT_NEAR(curve.probability(std::sqrt(2.0)), 0.5, 1e-15);
  EXPECT_EQ(curve.probability(3), 1);
  const double k = 2, last = std::pow(2, -k), x = k * std::log(2.0);
  const double exact = last + (1 - last * (1 + x)) / x;
  // Midpoints of 64 panels: (k ln 2 / 64)^2 / 12 of it.
  EXPECT_NEAR(curve.rate(statistics::HazardCurve::power_law(1, k)), exact, 4e-5 * exact);
}

/// Runs of an IDA: records hardly differ in what is above and below their capacity, but in where.
TEST_F(StudyLossTest, TakesTheCapacitiesOfAnIda) {
  std::string job = kSmallStudy;
  const std::string levels = "levels = [0.1, 0.2, 0.4]\n";
  job.replace(job.find(levels), levels.size(),
              "ida = { first = 0.1, increment = 0.1, until = \"fell\" }\n");
  runs_.clear();
  double squares = 0;
  for (std::size_t record = 0; record < 40; ++record) {
    const double z = normal_quantile((static_cast<double>(record) + 0.5) / 40);
    const double capacity = 2 * std::exp(0.4 * z);
    squares += z * z;
    for (const double part : {0.3, 0.6, 0.95, 1.05})
      runs_.push_back({record, part * capacity, part > 0.5 ? 0.2 : 0.05, part > 1});
  }
  write_small_study(path_, runs_, job);
  const StudyLoss found = loss({.at = {3}});
  const StudyData data(path_);
  ASSERT_EQ(found.steps.size(), 2);
  for (const std::size_t state : {0, 1}) {
    const auto curve = fitted_curve(data, state, 0, data.measure("")).curve();
    ASSERT_TRUE(curve && found.steps[state].curve.curve()) << state;
    EXPECT_EQ(found.steps[state].curve.curve()->theta, curve->theta);
    EXPECT_EQ(found.steps[state].curve.curve()->beta, curve->beta);
  }
  // Capacities of 2 exp(0.4 z) in brackets from 0.95 to 1.05 and from 0.3 to 0.6 of them, whose middles
  // are at 0.9987 and 0.424. beta of ML is the spread of the 40, but for w^2 / 12 of a bracket, w =
  // 0.1: (w^2 / 12) / (2 beta) = 0.001.
  EXPECT_NEAR(found.steps[1].curve.curve()->theta, 2 * 0.9987, 2 * 0.001);
  EXPECT_NEAR(found.steps[1].curve.curve()->beta, 0.4 * std::sqrt(squares / 40), 0.0015);
  EXPECT_NEAR(found.steps[0].curve.curve()->theta, 2 * 0.424, 2 * 0.01);
  const auto& cost = found.at.front().cost;
  ASSERT_TRUE(cost.interval);
  EXPECT_LE(cost.interval->low, cost.value);
  EXPECT_GE(cost.interval->high, cost.value);
}

TEST(EventCurve, OfSeparatedCapacitiesHasTheirShares) {
  const EventCurve curve(std::vector<statistics::Capacity>{{0, 1, 3}, {1, 2, 4}});
  EXPECT_FALSE(curve.is_fitted());
  EXPECT_EQ(curve.probability(1), 0);
  EXPECT_EQ(curve.probability(2), 0);
  EXPECT_EQ(curve.probability(4), 1);
}

/// The first run costs nothing whatever is drawn: that it failed changes nothing of the others.
TEST_F(StudyLossTest, DrawsTheSameNumbersWhereARunFailed) {
  std::string text = kFile;
  const std::string price = "price = 1000";
  text.replace(
      text.find(price), price.size(),
      "price = { value = 1000, assumption = \"a guess\", range = [500, 2000], distribution "
      "= { kind = \"lognormal\", median = 1000, beta = 0.3, low = 500, high = 2000, "
      "assumption = \"a guess\" } }");
  runs_.insert(runs_.begin(), {40, 1.0, 0.0});
  write_small_study(path_, runs_);
  const double before = loss({}, text).levels.back().largest;
  runs_.front().failed = true;
  write_small_study(path_, runs_);
  EXPECT_EQ(loss({}, text).levels.back().largest, before);
}

TEST_F(StudyLossTest, SaysThatTheHazardIsOverAnotherMeasure) {
  const StudyLoss found = loss({.measure = "pfv"});
  EXPECT_FALSE(found.annual);
  EXPECT_THAT(found.cautions,
              testing::Contains("no annual rate: the hazard of the job is over PGA h1"));
}

// Falls have a median of 4 m/s2, the strongest runs; of the unbraked half few fall.
TEST_F(StudyLossTest, CautionsOfCurvesAreSaid) {
  EXPECT_THAT(loss({.at = {2}}).cautions, testing::Not(testing::Contains(HasSubstr("beyond"))));
  const StudyLoss far = loss({.at = {0.5, 2, 40}});
  EXPECT_THAT(far.cautions, testing::Contains(HasSubstr("lies beyond the runs")).Times(2));
  for (SmallRun& run : runs_)
    if (run.record % 8 != 0) run.fell = false;
  write_small_study(path_, runs_);
  EXPECT_THAT(loss().cautions, testing::Contains(testing::AllOf(HasSubstr("fell: only"),
                                                                HasSubstr("of 120 runs exceed"))));
}

}  // namespace
}  // namespace gurney::study
