#include <gmock/gmock.h>

#include <limits>

#include "groundmotions/formats/time_column.h"
#include "tests/support/error_text.h"

namespace gurney::groundmotions {
namespace {

const std::vector<double> kTimes = {1, 1.1, 1.15, 1.15, 1.4};
const std::vector<double> kValues = {0, 2, 3, -1, 4};

TEST(UnevenSamples, InterpolatesAlongStraightLines) {
  const Eigen::VectorXd even = evenly_spaced(kTimes, kValues, 0.05);
  ASSERT_EQ(even.size(), 9);  // 1, 1.05, ..., 1.4 s
  // At 1.15 s the last of two samples counts; then 5 for each 0.25 s.
  const double expected[] = {0, 1, 2, -1, 0, 1, 2, 3, 4};
  for (int i = 0; i < 9; ++i) EXPECT_NEAR(even[i], expected[i], 1e-12) << i;
}

TEST(UnevenSamples, EndsBeforeTheLastTimeIfThatIsNotOnTheGrid) {
  const Eigen::VectorXd even = evenly_spaced({0, 1}, {0, 10}, 0.3);
  ASSERT_EQ(even.size(), 4);
  EXPECT_NEAR(even[3], 9, 1e-12);
}

TEST(UnevenSamples, KeepsEvenSamples) {
  std::vector<double> times, values;
  for (int i = 0; i < 1000; ++i) {
    times.push_back(0.01 * i);
    values.push_back(i % 7);
  }
  const Eigen::VectorXd even = evenly_spaced(times, values, 0.01);
  ASSERT_EQ(even.size(), 1000);
  // A time may round to just before its sample: 1000 * 2^-52 steps of a slope of at most 6.
  for (int i = 0; i < 1000; ++i) EXPECT_NEAR(even[i], i % 7, 1e-11);
}

TEST(UnevenSamples, ReportsTheSpacing) {
  const Spacing spacing = spacing_of(kTimes);
  EXPECT_EQ(spacing.smallest, 0);
  EXPECT_NEAR(spacing.largest, 0.25, 1e-15);
  EXPECT_FALSE(spacing.even(1e-3));
  EXPECT_TRUE(spacing_of({0, 0.005, 0.01, 0.0151}).even(1e-4));
  EXPECT_FALSE(spacing_of({0, 0.005, 0.01, 0.0151}).even(1e-5));
  EXPECT_EQ(uneven_warning({0, 0.001, 0.4}, 0.005),
            "the samples are 0.001 to 0.399 s apart; they were brought to even steps of 0.005 s by "
            "straight lines between them (3 samples before)");
}

TEST(UnevenSamples, RefusesWhatIsNoSeries) {
  EXPECT_EQ(error_text([] {
              evenly_spaced({0, 2, 1}, {0, 0, 0}, 0.1);
            }),
            "time 3 of 3 decreases: 1 s after 2 s");
  EXPECT_THAT(error_text([] {
                evenly_spaced({0, std::numeric_limits<double>::quiet_NaN()}, {0, 0}, 0.1);
              }),
              testing::HasSubstr("time 2 of 2 decreases"));
  EXPECT_EQ(error_text([] {
              evenly_spaced({0, 1}, {0}, 0.1);
            }),
            "2 times and 1 values are no record");
  EXPECT_EQ(error_text([] {
              evenly_spaced({0, 1}, {0, 0}, 2);
            }),
            "samples over 1 s cannot be brought to a time step of 2 s");
  EXPECT_NE(error_text([] { evenly_spaced({0, 1}, {0, 0}, 1e-30); }), "");
  EXPECT_NE(error_text([] { evenly_spaced({1, 1}, {0, 0}, 0.1); }), "");
}

}  // namespace
}  // namespace gurney::groundmotions
