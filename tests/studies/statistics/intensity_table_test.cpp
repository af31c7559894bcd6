#include "studies/statistics/intensity_table.h"

#include <gtest/gtest.h>

#include <cmath>

#include "studies/statistics/censored_normal.h"
#include "studies/statistics/special.h"
#include "tests/studies/statistics/synthetic.h"
#include "tests/support/expect_error.h"

namespace gurney::statistics {
namespace {

/// EDP rests on the velocity; the acceleration is the velocity with a factor of its own, which
/// grows with magnitude. Demands of one record correlate by 0.5.
struct World {
  std::vector<CloudPoint> demands;
  NamedValues velocity{"PFV", {}}, acceleration{"PFA", {}};
  NamedValues magnitude{"magnitude", {}}, luck{"luck", {}};

  World(std::size_t runs, std::size_t runs_of_record, std::uint64_t seed, double censored_above) {
    for (std::size_t i = 0; i < runs; ++i) {
      const std::size_t record = i / runs_of_record;
      const double v = std::exp(0.5 * normal_draw(seed, 0, i));
      const double m = 6.5 + 0.5 * normal_draw(seed, 1, record);
      const double own = normal_draw(seed, 2, i), shared = normal_draw(seed, 4, record);
      const double score = runs_of_record == 1 ? own : (own + shared) / std::sqrt(2.0);
      const double edp = 0.2 * std::pow(v, 1.4) * std::exp(0.3 * score);
      velocity.values.push_back(v);
      acceleration.values.push_back(v * std::exp(0.6 * (m - 6.5)));
      magnitude.values.push_back(m);
      luck.values.push_back(normal_draw(seed, 3, record));
      demands.push_back({1, edp, CloudPoint::Known::kExactly, record});
      if (edp > censored_above)
        demands.back() = {1, censored_above, CloudPoint::Known::kAtLeast, record};
    }
  }
  std::vector<IntensityRow> rows() const {
    return compare_intensities(demands, {velocity, acceleration}, {magnitude, luck});
  }
};

TEST(IntensityTable, FindsTheMeasureThatPredicts) {
  for (const double censored_above : {1e9, 0.3}) {
    const auto rows = World(500, 1, 1, censored_above).rows();
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_EQ(rows[0].name, "PFV");
    EXPECT_EQ(rows[0].status, CloudStatus::kFitted);
    // 4.5 standard errors: sigma / sqrt(2 n) and sigma / (0.5 sqrt n), doubled for censored runs
    EXPECT_NEAR(rows[0].efficiency, 0.3, 4.5 * 0.3 / std::sqrt(1000.0) * 2);
    EXPECT_NEAR(rows[0].practicality, 1.4, 4.5 * 0.6 / std::sqrt(500.0) * 2);
    EXPECT_DOUBLE_EQ(rows[0].proficiency, rows[0].efficiency / rows[0].practicality);
    // 1.96 * 0.25 of 0.49 + 0.09
    EXPECT_NEAR(rows[0].r_squared, 0.49 / 0.58, 0.07);
    EXPECT_LT(rows[0].efficiency, rows[1].efficiency);
    EXPECT_GT(rows[0].log_likelihood, rows[1].log_likelihood);
    EXPECT_GT(rows[0].sufficiency[0], 0.001);
    EXPECT_LT(rows[1].sufficiency[0], 1e-6);
    EXPECT_GT(rows[1].sufficiency[1], 0.001);
  }
}

// A property without influence is found to have one in 5 % of the repeats: 50 of 1000, and 4.5
// binomial standard deviations are 31. By run, censored, and with five correlated runs of each of
// 40 records.
TEST(IntensityTable, SufficiencyHoldsItsLevel) {
  struct Case {
    std::size_t runs, of_record;
    double censored_above;
  };
  for (const Case& c : {Case{30, 1, 1e9}, Case{60, 1, 0.3}, Case{200, 5, 1e9}}) {
    int found = 0;
    for (std::uint64_t repeat = 0; repeat < 1000; ++repeat) {
      const World world(c.runs, c.of_record, repeat, c.censored_above);
      found +=
          compare_intensities(world.demands, {world.velocity}, {world.luck})[0].sufficiency[0] <
          0.05;
    }
    EXPECT_NEAR(found, 50, 31) << c.runs << " runs, censored above " << c.censored_above;
  }
}

// The coefficient over its standard error between records is Student's t: 7 records of 5 runs each
// have 6 degrees of freedom.
TEST(IntensityTable, SufficiencyOfFewRecordsHasTheirDegreesOfFreedom) {
  const World world(35, 5, 11, 1e9);
  Eigen::MatrixXd design(35, 3);
  std::vector<CensoredValue> demands;
  std::vector<std::size_t> records;
  for (Eigen::Index i = 0; i < 35; ++i) {
    const auto run = static_cast<std::size_t>(i);
    design.row(i) << 1, std::log(world.velocity.values[run]), world.luck.values[run];
    demands.push_back({std::log(world.demands[run].edp), std::log(world.demands[run].edp)});
    records.push_back(run / 5);
  }
  const CensoredNormalFit fit = fit_censored_normal(design, demands, records);
  const double t = fit.coefficients[2] / std::sqrt(fit.cluster_covariance(2, 2));
  EXPECT_NEAR(world.rows()[0].sufficiency[1], 2 * student_survival(std::abs(t), 6), 1e-9);
}

TEST(IntensityTable, LeavesOutWhatIsUnknown) {
  World world(50, 1, 3, 1e9);
  world.velocity.values[0] = std::nan("");
  world.velocity.values[1] = 0;
  world.magnitude.values.assign(50, std::nan(""));
  world.luck.values.assign(50, 7);
  const auto rows = world.rows();
  EXPECT_EQ(rows[0].runs, 48);
  EXPECT_EQ(rows[0].left_out, 2);
  EXPECT_TRUE(std::isnan(rows[0].sufficiency[0]));
  EXPECT_TRUE(std::isnan(rows[0].sufficiency[1]));
  world.luck.values.pop_back();
  EXPECT_ERROR(world.rows(), "luck has 49 values for 50 runs");
}

}  // namespace
}  // namespace gurney::statistics
