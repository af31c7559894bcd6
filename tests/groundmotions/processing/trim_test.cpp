#include "groundmotions/processing/trim.h"

#include <gtest/gtest.h>

#include <cmath>

#include "groundmotions/measures/cumulative.h"
#include "tests/support/error_text.h"

namespace gurney::groundmotions {
namespace {

// A constant: the Husid curve is a line over the 10 s.
TEST(Trim, SignificantIntervalOfAConstant) {
  const TimeInterval part = significant_interval(0.1, Eigen::VectorXd::Ones(101), 0.05, 0.95);
  EXPECT_NEAR(part.from, 0.5, 1e-12);
  EXPECT_NEAR(part.to, 9.5, 1e-12);
  const TimeInterval all = significant_interval(0.1, Eigen::VectorXd::Ones(101), 0, 1);
  EXPECT_EQ(all.from, 0);
  EXPECT_NEAR(all.to, 10, 1e-12);
}

// a = t: the integral of a^2 is t^3 / 3, so a share s is reached at 10 s^(1/3); within a step the
// curve is taken as linear, off by less than its curvature 2 t h^2 / 8 over its slope t^2: h^2 / (4
// t). The trapezoid adds h^2 t / 6 to t^3 / 3, which moves a share by less than h^2 / (6 t).
TEST(Trim, SignificantIntervalOfALine) {
  const double h = 0.1;
  const Eigen::VectorXd a = Eigen::VectorXd::LinSpaced(101, 0, 10);
  const TimeInterval part = significant_interval(h, a, 0.05, 0.75);
  EXPECT_NEAR(part.from, 10 * std::cbrt(0.05), h * h * (1 / 4. + 1 / 6.) / 3.6);
  EXPECT_NEAR(part.to, 10 * std::cbrt(0.75), h * h * (1 / 4. + 1 / 6.) / 9);
}

// As D5-95 is printed. With the exact integral of a line the bounds are 0.0003 s off.
TEST(Trim, SignificantIntervalIsTheOneOfTheMeasures) {
  const Eigen::VectorXd a = Eigen::VectorXd::LinSpaced(101, 0, 10);
  const SignificantPart part = significant_part(0.1, a, 0.05, 0.95);
  EXPECT_EQ(significant_interval(0.1, a, 0.05, 0.95).from, part.begin);
  EXPECT_EQ(significant_interval(0.1, a, 0.05, 0.95).to, part.end);
}

TEST(Trim, SilenceBeforeAndAfterIsOutside) {
  Eigen::VectorXd a = Eigen::VectorXd::Zero(301);
  a.segment(100, 101).setOnes();
  const TimeInterval part = significant_interval(0.1, a, 0.05, 0.95);
  EXPECT_NEAR(part.from, 10.5, 0.05);
  EXPECT_NEAR(part.to, 19.5, 0.05);
}

TEST(Trim, SamplesCoverTheInterval) {
  const auto samples = [](double from, double to) {
    const SampleRange range = samples_within({from, to}, 0.1, 101);
    return std::pair(range.first, range.count);
  };
  EXPECT_EQ(samples(0.3, 0.7), std::pair(Eigen::Index(3), Eigen::Index(5)));
  EXPECT_EQ(samples(0.35, 0.65), std::pair(Eigen::Index(3), Eigen::Index(5)));
  EXPECT_EQ(samples(-5, 50), std::pair(Eigen::Index(0), Eigen::Index(101)));
  EXPECT_EQ(samples(9.95, 11), std::pair(Eigen::Index(99), Eigen::Index(2)));
}

TEST(Trim, RefusesWhatCannotBe) {
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(101);
  EXPECT_EQ(error_text([&] { significant_interval(0.1, ones, 0.9, 0.1); }),
            "shares of the Husid curve must be 0 <= from < to <= 1, got 0.9 and 0.1");
  EXPECT_NE(error_text([&] { significant_interval(0.1, ones, std::nan(""), 1); }), "(no error)");
  EXPECT_EQ(error_text([&] { significant_interval(0.1, 0 * ones, 0.05, 0.95); }),
            "a motion that is all zero has no significant duration");
  EXPECT_EQ(error_text([] {
              samples_within({3, 3}, 0.1, 101);
            }),
            "a part of a record must end after it begins, got 3 to 3 s");
  EXPECT_EQ(error_text([] {
              samples_within({12, 15}, 0.1, 101);
            }),
            "the record is from 0 to 10 s long, nothing of it is within 12 to 15 s");
  EXPECT_NE(error_text([] { samples_within({std::nan(""), 15}, 0.1, 101); }), "(no error)");
}

}  // namespace
}  // namespace gurney::groundmotions
