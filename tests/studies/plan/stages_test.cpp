#include "studies/plan/stages.h"

#include <gmock/gmock.h>

#include <cmath>

#include "engine/base/random/normal_draw.h"
#include "studies/run/run_batch.h"
#include "studies/statistics/fragility.h"
#include "tests/studies/small_study.h"

namespace gurney::study {
namespace {

using testing::DoubleEq;
using testing::ElementsAre;

TEST(NextLevels, AreThoseOfTheOptimalDesignAboutTheCurve) {
  // Exact fractions of theta 2, beta 0.5 at 1, 2 and 4: the fit is that curve.
  std::vector<statistics::Stripe> stripes;
  for (const double im : {1.0, 2.0, 4.0})
    stripes.push_back({im, 1000, 1000 * normal_cdf(std::log(im / 2) / 0.5)});
  // 2 exp(-+ 1.138 / 2), in three digits.
  EXPECT_THAT(next_levels(stripes, 1), ElementsAre(DoubleEq(1.13), DoubleEq(3.53)));
  const double g = 9.80665;
  for (statistics::Stripe& stripe : stripes) stripe.im *= g;
  EXPECT_THAT(next_levels(stripes, g), ElementsAre(DoubleEq(1.13 * g), DoubleEq(3.53 * g)));
}

// The determinant of the information of (slope, intercept) from one run at each of two levels is
// largest there.
TEST(NextLevels, TellMostOfBothNumbers) {
  const auto determinant = [](double score) {
    double sum[3] = {0, 0, 0};
    for (const double z : {-score, score}) {
      const double p = normal_cdf(z), density = std::exp(-z * z / 2);
      const double weight = density * density / (p * (1 - p));
      for (int i = 0; i < 3; ++i) sum[i] += weight * std::pow(z, i);
    }
    return sum[0] * sum[2] - sum[1] * sum[1];
  };
  EXPECT_GT(determinant(1.138), determinant(1.138 + 0.01));
  EXPECT_GT(determinant(1.138), determinant(1.138 - 0.01));
}

TEST(NextLevels, LookFartherWhereThereIsNoCurve) {
  using Stripes = std::vector<statistics::Stripe>;
  EXPECT_THAT(next_levels(Stripes{{1, 9, 0}, {2, 9, 0}}, 1), ElementsAre(DoubleEq(3), DoubleEq(4)));
  EXPECT_THAT(next_levels(Stripes{{1, 9, 9}, {2, 9, 9}}, 1),
              ElementsAre(DoubleEq(0.5), DoubleEq(0.667)));
  // Thirds of (1, 8) on a logarithmic scale.
  EXPECT_THAT(next_levels(Stripes{{1, 9, 0}, {8, 9, 9}}, 1), ElementsAre(DoubleEq(2), DoubleEq(4)));
  // Both outcomes at 2 only; then there is no neighbour.
  EXPECT_THAT(next_levels(Stripes{{1, 9, 0}, {2, 9, 4}, {8, 9, 9}}, 1),
              ElementsAre(DoubleEq(1.41), DoubleEq(4)));
  EXPECT_THAT(next_levels(Stripes{{2, 9, 4}}, 1), ElementsAre(DoubleEq(1.33), DoubleEq(3)));
  EXPECT_THAT(next_levels(Stripes{{1, 9, 5}, {2, 9, 5}, {4, 9, 4}}, 1),
              ElementsAre(DoubleEq(0.667), DoubleEq(6)));
  EXPECT_THAT(next_levels(Stripes{{1, 0, 0}, {2, 0, 0}}, 1),
              ElementsAre(DoubleEq(0.667), DoubleEq(3)))
      << "every run failed";
  // A shallow curve asks for more than twice the highest, and less than half the lowest.
  EXPECT_THAT(next_levels(Stripes{{1, 99, 40}, {2, 99, 55}}, 1),
              ElementsAre(DoubleEq(0.5), DoubleEq(4)));
}

TEST(NextLevels, AreNotThoseThatWereMade) {
  std::vector<statistics::Stripe> stripes;
  for (const double im : {1.13, 2.0, 3.5})
    stripes.push_back({im, 1000, 1000 * normal_cdf(std::log(im / 2) / 0.5)});
  // 1.13 / 1.05; 3.53 is within 1 % of 3.5, so 3.53 x 1.05.
  EXPECT_THAT(next_levels(stripes, 1), ElementsAre(DoubleEq(1.08), DoubleEq(3.71)));
}

constexpr const char* kAdaptive = R"(angles_deg = [0, 25, 50, 75]
[study.intensity]
measure = "PGA"
component = "h1"
unit = "g"
levels = [0.1, 2]
adaptive = { stages = 2, limit_state = "far" }
[[study.factor]]
key = "item.brakes"
values = [false, true]
[[study.limit_state]]
name = "far"
demand = "peak_displacement"
above = 0.1
unit = "mm"
)";

TEST(Stages, UnitsAreThoseOfTheFirstOnceMore) {
  const SmallStudy study(small_job(kAdaptive));
  EXPECT_EQ(study.plan.stages(), 3u);
  EXPECT_EQ(study.plan.tasks_of_stage(), 8u);
  EXPECT_EQ(study.plan.tasks(), 24u);
  EXPECT_EQ(study.plan.runs(), 8u * (2 + 2 + 2));
  for (std::size_t i = 0; i < 24; ++i) {
    EXPECT_EQ(study.plan.task(i).stage, i / 8);
    EXPECT_EQ(study.plan.task(i).angle, study.plan.task(i % 8).angle);
    EXPECT_EQ(study.plan.task(i).configuration, study.plan.task(i % 8).configuration);
  }
}

TEST(Stages, LevelsRestOnTheOutcomesOfAllUnitsBefore) {
  const SmallStudy study(small_job(kAdaptive));
  StageLevels levels(study.batch);
  EXPECT_THAT(levels.of(study.plan.task(0)), ElementsAre(0.1 * 9.80665, 2 * 9.80665));
  const auto go_on = [] { return true; };
  std::vector<TaskResult> results;
  for (std::size_t stage = 0; stage < 2; ++stage) {
    for (std::size_t i = 0; i < 8; ++i) {
      const std::size_t index = 8 * stage + i;
      const std::vector<double> of = levels.of(study.plan.task(index));
      results.push_back(run_task(study.batch, index, go_on, {}, &of));
      ASSERT_EQ(results.back().runs.size(), 2u);
      for (std::size_t run = 0; run < 2; ++run) {
        const StudyRun& made = results.back().runs[run];
        EXPECT_EQ(made.intensity, of[run]);
        EXPECT_EQ(made.until, made.response.items[0].demands.peak_displacement > 0.0001);
      }
    }
    // Each configuration by its own: counted here once more from the responses.
    std::vector<std::map<double, statistics::Stripe>> counted(2);
    for (const TaskResult& task : results)
      for (const StudyRun& run : task.runs) {
        statistics::Stripe& stripe =
            counted[study.plan.task(task.task).configuration][run.intensity];
        stripe.im = run.intensity;
        ++stripe.runs;
        stripe.exceeded += run.response.items[0].demands.peak_displacement > 0.0001;
      }
    levels.advance([&](std::size_t task) { return results.at(task); });
    for (std::size_t configuration : {0, 1}) {
      std::vector<statistics::Stripe> stripes;
      for (const auto& [im, stripe] : counted[configuration]) stripes.push_back(stripe);
      EXPECT_EQ(stripes.size(), 2 * (stage + 1));
      EXPECT_EQ(levels.of({.configuration = configuration}), next_levels(stripes, 9.80665));
    }
  }
  EXPECT_NE(levels.of({.configuration = 0}), levels.of({.configuration = 1})) << "brakes hold";
}

}  // namespace
}  // namespace gurney::study
