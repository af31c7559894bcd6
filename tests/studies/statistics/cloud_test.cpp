#include "studies/statistics/cloud.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <string>

#include "studies/statistics/special.h"
#include "tests/studies/statistics/synthetic.h"
#include "tests/support/expect_error.h"

namespace gurney::statistics {
namespace {

using Known = CloudPoint::Known;

/// ln EDP = ln 0.1 + 1.5 ln IM + 0.4 z
std::vector<CloudPoint> synthetic_cloud(std::size_t n, std::uint64_t seed) {
  std::vector<CloudPoint> points;
  for (std::size_t i = 0; i < n; ++i) {
    const double im = std::exp(0.6 * normal_draw(seed, 0, i));
    points.push_back({im, 0.1 * std::pow(im, 1.5) * std::exp(0.4 * normal_draw(seed, 1, i)),
                      Known::kExactly, i});
  }
  return points;
}

// By hand: x = ln im = -1, 0, 1; y = 0, 3, 3 gives b = 1.5, a = 2, residuals -0.5, 1, -0.5, so
// sigma^2 = 1.5 / (3 - 2) and R2 = 1 - 1.5 / 6.
TEST(Cloud, IsLeastSquaresForExactDemands) {
  const double e = std::exp(1.0);
  const CloudFit fit = fit_cloud({{1 / e, 1, Known::kExactly, 0},
                                  {1, e * e * e, Known::kExactly, 1},
                                  {e, e * e * e, Known::kExactly, 2}});
  ASSERT_EQ(fit.status, CloudStatus::kFitted);
  EXPECT_NEAR(fit.a, 2, 1e-9);
  EXPECT_NEAR(fit.b, 1.5, 1e-9);
  EXPECT_NEAR(fit.sigma, std::sqrt(1.5), 1e-9);
  EXPECT_NEAR(fit.r_squared, 0.75, 1e-9);
  // sigma^2 / n and sigma^2 / sum x^2
  EXPECT_NEAR(fit.covariance(0, 0), 0.5, 1e-8);
  EXPECT_NEAR(fit.covariance(1, 1), 0.75, 1e-8);
}

// Overturned above 0.2, at rest below 0.04: half of the runs. An estimate may miss by 4.5 of its
// own standard errors.
TEST(Cloud, RecoversTheLineFromCensoredDemands) {
  std::vector<CloudPoint> points = synthetic_cloud(2000, 1), wrong;
  for (CloudPoint& point : points) {
    if (point.edp > 0.2) point = {point.im, 0.2, Known::kAtLeast, point.group};
    if (point.edp < 0.04) point = {point.im, 0.04, Known::kAtMost, point.group};
    wrong.push_back({point.im, point.edp, Known::kExactly, point.group});
  }
  const CloudFit fit = fit_cloud(points);
  ASSERT_EQ(fit.status, CloudStatus::kFitted);
  EXPECT_EQ(fit.exact + fit.at_least + fit.at_most, 2000);
  EXPECT_GT(fit.at_least, 300);
  EXPECT_GT(fit.at_most, 300);
  EXPECT_NEAR(fit.a, std::log(0.1), 4.5 * std::sqrt(fit.covariance(0, 0)));
  EXPECT_NEAR(fit.b, 1.5, 4.5 * std::sqrt(fit.covariance(1, 1)));
  EXPECT_NEAR(std::log(fit.sigma / 0.4), 0, 4.5 * std::sqrt(fit.covariance(2, 2)));
  EXPECT_LT(std::sqrt(fit.covariance(1, 1)), 0.05);
  EXPECT_LT(fit_cloud(wrong).b, 1.2);  // the bounds taken for demands flatten the line
  // With each run a group of its own both covariances estimate the same.
  for (int i : {0, 1, 2}) EXPECT_NEAR(fit.cluster_covariance(i, i) / fit.covariance(i, i), 1, 0.2);
}

TEST(Cloud, GivesTheFragilityOfALimit) {
  const CloudFit fit = fit_cloud(synthetic_cloud(2000, 2));
  const auto fragility = cloud_fragility(fit, 0.3);
  ASSERT_TRUE(fragility);
  // 0.1 im^1.5 = 0.3 at 3^(2/3); beta = 0.4 / 1.5
  EXPECT_NEAR(std::log(fragility->curve.theta), std::log(3.0) / 1.5,
              4.5 * std::sqrt(fragility->covariance(0, 0)));
  EXPECT_NEAR(std::log(fragility->curve.beta), std::log(0.4 / 1.5),
              4.5 * std::sqrt(fragility->covariance(1, 1)));
  EXPECT_LT(std::sqrt(fragility->covariance(0, 0)), 0.03);
  EXPECT_ERROR(cloud_fragility(fit, 0), "limit = 0 must be > 0");
}

/// Of 1000 clouds of five runs each of `records` whose scatter they share to `correlation`, how many
/// of the 95 % intervals contain what the demands follow, and the share of the least of them that
/// an interval of 95 % would have at 0.5 %.
void expect_cloud_covers(std::size_t records, double correlation) {
  constexpr int kClouds = 1000, kRuns = 5;
  const LognormalCurve curve{std::pow(3, 1 / 1.5), 0.4 / 1.5};  // 0.1 im^1.5 = 0.3
  const std::vector<double> at{0.05, 0.16, 0.5, 0.84, 0.95};
  std::vector<double> im;
  for (const double p : at) im.push_back(curve.quantile(p));
  int theta = 0, beta = 0;
  std::vector<int> band(at.size());
  for (std::uint64_t seed = 0; seed < kClouds; ++seed) {
    std::vector<CloudPoint> points;
    for (std::size_t i = 0; i < kRuns * records; ++i) {
      const std::size_t record = i / kRuns;
      const double z = std::sqrt(correlation) * normal_draw(seed, 2, record) +
                       std::sqrt(1 - correlation) * normal_draw(seed, 1, i);
      const double x = std::exp(0.6 * normal_draw(seed, 0, i));
      points.push_back({x, 0.1 * std::pow(x, 1.5) * std::exp(0.4 * z), Known::kExactly, record});
    }
    const FragilityBand found = cloud_band(fit_cloud(points), points, 0.3, im);
    ASSERT_FALSE(found.too_few);
    for (std::size_t i = 0; i < at.size(); ++i) band[i] += found.of_curve[i].contains(at[i]);
    theta += found.theta.contains(curve.theta);
    beta += found.beta.contains(curve.beta);
  }
  int least = 0;
  while (binomial_cdf(least, kClouds, 0.95) < 0.005) ++least;
  const std::string where = std::to_string(records) + " records, " + std::to_string(correlation);
  for (const int count : band) EXPECT_GE(count, least) << where;
  EXPECT_GE(theta, least) << where;
  EXPECT_GE(beta, least) << where;
}

TEST(Cloud, IntervalsContainWhatTheDemandsFollow) {
  for (const std::size_t records : {8u, 12u, 40u})
    for (const double correlation : {0.0, 0.5}) expect_cloud_covers(records, correlation);
}

// The band holds one half where the interval of theta ends, to the 2^-40 of a bracket.
TEST(Cloud, HasTheBandThatItsMedianHas) {
  const std::vector<CloudPoint> points = synthetic_cloud(20, 4);
  const CloudFit fit = fit_cloud(points);
  const Interval theta = cloud_band(fit, points, 0.3, {}).theta;
  const auto band = cloud_band(fit, points, 0.3, {theta.low, theta.high}).of_curve;
  EXPECT_NEAR(band[0].high, 0.5, 1e-9);
  EXPECT_NEAR(band[1].low, 0.5, 1e-9);
}

// The three parameters cost degrees of the 20 records, not of the 80 runs: the covariance with records independent,
// carried to the line by central differences of its slope and intercept (rounding of 1e-16 / h), is widened by
// 20 / (20 - 3).
TEST(Cloud, LosesThreeDegreesOfItsRecords) {
  constexpr double kLimit = 0.3, kH = 1e-6;
  std::vector<CloudPoint> points = synthetic_cloud(80, 4);
  for (CloudPoint& point : points) {
    point.group /= 4;
    point.edp *= 1 + 0.5 * static_cast<double>(point.group % 2);
  }
  const CloudFit fit = fit_cloud(points);
  const Eigen::Vector3d at(fit.a, fit.b, std::log(fit.sigma));
  const auto line_at = [&](const Eigen::Vector3d& p) -> Eigen::Vector2d {
    return Eigen::Vector2d(p[1], p[0] - std::log(kLimit)) / std::exp(p[2]);
  };
  Eigen::Matrix<double, 2, 3> jacobian;
  for (int k = 0; k < 3; ++k)
    jacobian.col(k) = (line_at(at + kH * Eigen::Vector3d::Unit(k)) -
                       line_at(at - kH * Eigen::Vector3d::Unit(k))) /
                      (2 * kH);
  const auto carried = [&](const Eigen::Matrix3d& covariance, double factor) -> Eigen::Matrix2d {
    return factor * jacobian * covariance * jacobian.transpose();
  };
  const auto [low, high] = std::ranges::minmax(points, {}, &CloudPoint::im);
  const std::vector<double> im{0.5, 1, 2};
  const FragilityBand found = cloud_band(fit, points, kLimit, im);
  const FragilityBand expected =
      band_of({line_at(at),
               {carried(fit.covariance, 1), carried(fit.cluster_covariance, 20.0 / 17)},
               20,
               low.im,
               high.im},
              im, 0.95);
  ASSERT_FALSE(found.too_few);
  for (std::size_t i = 0; i < im.size(); ++i) {
    EXPECT_NEAR(found.of_curve[i].low, expected.of_curve[i].low, 1e-7);
    EXPECT_NEAR(found.of_curve[i].high, expected.of_curve[i].high, 1e-7);
  }
  EXPECT_NEAR(found.theta.low, expected.theta.low, 1e-7);
}

TEST(Cloud, HasNoIntervalOfFewRecords) {
  const std::vector<CloudPoint> points = synthetic_cloud(7, 4);
  const FragilityBand band = cloud_band(fit_cloud(points), points, 0.3, {1});
  EXPECT_TRUE(band.too_few);
  EXPECT_TRUE(band.of_curve.empty());
}

TEST(Cloud, SaysWhyThereIsNoLine) {
  EXPECT_EQ(fit_cloud({}).status, CloudStatus::kTooFewExact);
  std::vector<CloudPoint> points = synthetic_cloud(10, 3);
  for (CloudPoint& point : points) point.known = Known::kAtLeast;
  EXPECT_EQ(fit_cloud(points).status, CloudStatus::kTooFewExact);
  points = synthetic_cloud(10, 3);
  for (CloudPoint& point : points) point.im = 2;
  EXPECT_EQ(fit_cloud(points).status, CloudStatus::kOneIntensity);
  for (CloudPoint& point : points) {
    point.im = 1.0 + static_cast<double>(point.group);
    point.edp = 2 * point.im;
  }
  EXPECT_EQ(fit_cloud(points).status, CloudStatus::kNoSpread);
  points[0].edp = 0;
  EXPECT_ERROR(fit_cloud(points), "edp = 0 must be > 0");
  EXPECT_NE(text(CloudStatus::kOneIntensity).find("no slope"), std::string::npos);
  CloudFit falling = fit_cloud(synthetic_cloud(10, 3));
  falling.b = -1;
  EXPECT_FALSE(cloud_fragility(falling, 1));
}

}  // namespace
}  // namespace gurney::statistics
