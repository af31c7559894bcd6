#include "studies/statistics/bands.h"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <ranges>

#include "engine/base/error.h"
#include "engine/base/random/normal_draw.h"
#include "studies/statistics/profile.h"
#include "studies/statistics/special.h"

namespace gurney::statistics {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kPlaces = 10;    // tried for an end of theta: 1, 2, ... 512 standard errors away
constexpr int kHalvings = 40;  // 1e-12 of the bracket
constexpr int kOutline = 128;

/// Intervals of the score and of other numbers of the line.
struct Lines {
  LineEstimate of;
  double quantile;

  /// The half-width of what changes by `gradient` with the line, by the largest of its variances.
  double half_width(const Eigen::Vector2d& gradient) const {
    double variance = 0;
    for (const Eigen::Matrix2d& each : of.covariances)
      variance = std::max(variance, gradient.dot(each * gradient));
    return quantile * std::sqrt(variance);
  }
  Interval score(double im) const {
    const double z = of.line[0] * std::log(im) + of.line[1];
    const double half = half_width({std::log(im), 1});
    return {z - half, z + half};
  }
  /// ln beta = -ln slope
  Interval beta() const {
    const double half = half_width({1 / of.line[0], 0});
    return {std::exp(-half) / of.line[0], std::exp(half) / of.line[0]};
  }
};

/// The intensity nearest to theta, upwards or downwards, at which the interval of the score leaves
/// 0; 0 or infinity if it has not within 512 standard errors of ln theta.
double end_of_theta(const Lines& lines, double theta, double step) {
  const auto outside = [&](double distance) {
    const Interval z = lines.score(theta * std::exp(distance));
    return step > 0 ? z.low > 0 : z.high < 0;
  };
  double inner = 0, outer = step;
  for (int place = 1; !outside(outer); ++place) {
    if (place == kPlaces) return step > 0 ? kInfinity : 0;
    inner = outer;
    outer *= 2;
  }
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = (inner + outer) / 2;
    (outside(middle) ? outer : inner) = middle;
  }
  return theta * std::exp((inner + outer) / 2);
}

}  // namespace

Interval bounded(const Interval& interval, double low, double high) {
  return {interval.low < low / kFarthestEnd ? 0 : interval.low,
          interval.high > high * kFarthestEnd ? kInfinity : interval.high};
}

std::vector<Eigen::Vector2d> outline_of(const Eigen::Vector2d& line,
                                        const Eigen::Matrix2d& covariance, double quantile) {
  const Eigen::Matrix2d root = covariance.llt().matrixL();
  std::vector<Eigen::Vector2d> outline;
  for (int i = 0; i < kOutline; ++i) {
    const double angle = 2 * std::numbers::pi * i / kOutline;
    outline.push_back(line + quantile * root * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
  }
  return outline;
}

FragilityBand band_of(const LineEstimate& estimate, const std::vector<double>& im,
                      double confidence) {
  FragilityBand band;
  band.status = FragilityStatus::kFitted;
  band.theta = band.beta = {0, kInfinity};
  band.effective = estimate.effective;
  band.too_few = estimate.effective < kFewestGroups * (1 - 1e-9);
  if (band.too_few) return band;
  const Lines lines{estimate, student_quantile((1 + confidence) / 2, estimate.effective - 1)};
  for (const double x : im) {
    const Interval z = lines.score(x);
    band.of_curve.push_back({normal_cdf(z.low), normal_cdf(z.high)});
  }
  const double theta = std::exp(-estimate.line[1] / estimate.line[0]), beta = 1 / estimate.line[0];
  const double step =
      std::sqrt(covariance_of_curve(estimate.line, estimate.covariances.front())(0, 0));
  band.theta = bounded({end_of_theta(lines, theta, -step), end_of_theta(lines, theta, step)},
                       estimate.lowest, estimate.highest);
  band.beta = bounded(lines.beta(), beta, beta);
  for (const Eigen::Matrix2d& covariance : estimate.covariances)
    for (const Eigen::Vector2d& point : outline_of(estimate.line, covariance, lines.quantile))
      band.outline.push_back(point);
  return band;
}

FragilityBand fragility_band(const StripeTable& table, const std::vector<double>& im,
                             double confidence) {
  require(confidence > 0 && confidence < 1,
          fmt::format("confidence = {:g} must be in (0, 1)", confidence));
  for (const double x : im) require(x > 0, fmt::format("im = {:g} must be > 0", x));

  const ProbitFit fit = fit_probit(table.stripes());
  FragilityBand band;
  band.status = fit.status;
  band.theta = band.beta = {0, kInfinity};
  if (fit.status != FragilityStatus::kFitted) {
    band.of_curve = distribution_free_band(table, im, confidence);
    return band;
  }
  return band_of({fit.line, line_covariances(fit, table), effective_groups(fit, table),
                  table.stripes().front().im, table.stripes().back().im},
                 im, confidence);
}

Interval proportion_interval(int successes, int trials, double confidence) {
  const double tail = (1 - confidence) / 2;
  return {beta_quantile(tail, successes, trials - successes + 1.0),
          beta_quantile(1 - tail, successes + 1.0, trials - successes)};
}

std::vector<Interval> distribution_free_band(const StripeTable& table,
                                             const std::vector<double>& im, double confidence) {
  std::vector<Interval> band;
  for (const double x : im) {
    double hits_above = 0, runs_above = 0, hits_below = 0, runs_below = 0;
    for (std::size_t group = 0; group < table.groups(); ++group) {
      const auto& shares = table.of_group(group);  // im increases
      const auto above = std::find_if(shares.begin(), shares.end(), [&](const auto& share) {
        return table.stripes()[share.stripe].im >= x;
      });
      if (above != shares.end()) {
        // Several runs of the group there: the share of a run drawn from them.
        runs_above += 1;
        hits_above += above->exceeded / above->runs;
      }
      const auto below = std::find_if(shares.rbegin(), shares.rend(), [&](const auto& share) {
        return table.stripes()[share.stripe].im <= x;
      });
      if (below != shares.rend()) {
        runs_below += 1;
        hits_below += below->exceeded / below->runs;
      }
    }
    // Fractions of a hit are rounded to the wider side; the rounding of their sum is no fraction.
    constexpr double kRounding = 1e-9;
    const auto upper = proportion_interval(static_cast<int>(std::ceil(hits_above - kRounding)),
                                           static_cast<int>(runs_above), confidence);
    const auto lower = proportion_interval(static_cast<int>(std::floor(hits_below + kRounding)),
                                           static_cast<int>(runs_below), confidence);
    band.push_back({lower.low, upper.high});
  }
  return band;
}

MedianBounds median_bounds(const StripeTable& table, double confidence) {
  const auto band_at = [&](double im) {
    return distribution_free_band(table, {im}, confidence).front();
  };
  MedianBounds bounds;
  for (const Stripe& stripe : table.stripes()) {
    if (!(band_at(stripe.im).high < 0.5)) break;
    bounds.low = stripe.im;
  }
  for (const Stripe& stripe : std::views::reverse(table.stripes())) {
    if (!(band_at(stripe.im).low > 0.5)) break;
    bounds.high = stripe.im;
  }
  return bounds.low < bounds.high ? bounds : MedianBounds{};  // else the probability falls
}

std::optional<ProfileIntervals> profile_intervals(const StripeTable& table, double confidence,
                                                  bool by_group) {
  const std::vector<Stripe>& stripes = table.stripes();
  const ProbitFit fit = fit_probit(stripes);
  if (fit.status != FragilityStatus::kFitted || (by_group && table.groups() < 2)) return {};
  const Eigen::Matrix2d plain = covariance_of_curve(fit.line, fit.information.inverse());
  Eigen::Vector2d inflation(1, 1);
  double quantile = chi_squared_quantile(confidence, 1);
  if (by_group) {
    const Eigen::Matrix2d of_groups = cluster_covariance(fit, table);
    const auto grouped = covariance_of_curve(fit.line, of_groups);
    // The mean over both parameters varies less with few groups than that of one.
    const double mean = (of_groups * fit.information).trace() / 2;
    inflation = grouped.diagonal().cwiseQuotient(plain.diagonal()).cwiseMax(std::max(1.0, mean));
    const double degrees = std::max(1.0, effective_groups(fit, table) - 1);
    quantile = std::pow(student_quantile((1 + confidence) / 2, degrees), 2);
  }
  const double log_theta = std::log(fit.curve().theta);
  // theta fixed: slope (ln im - ln theta) with any slope; beta fixed: slope fixed, any intercept.
  const auto drop_on = [&](const Eigen::Vector2d& point, const Eigen::Vector2d& along) {
    const auto likelihood = [&](const Eigen::Vector2d& line) {
      return binomial_likelihood(stripes, line);
    };
    return 2 * (fit.log_likelihood - largest_on_line(likelihood, point, along, 0));
  };
  const auto drop_theta = [&](double d) {
    const Eigen::Vector2d along(1, -(log_theta + d));
    return drop_on(fit.line[0] * along, along);
  };
  const auto drop_beta = [&](double d) { return drop_on(fit.line * std::exp(-d), {0, 1}); };
  const auto interval = [&](const auto& drop, int parameter, double center) {
    const double limit = quantile * inflation[parameter];
    const double step = std::sqrt(plain(parameter, parameter) * inflation[parameter]);
    return Interval{center * std::exp(crossing(drop, limit, -step)),
                    center * std::exp(crossing(drop, limit, step))};
  };
  return ProfileIntervals{interval(drop_theta, 0, fit.curve().theta),
                          interval(drop_beta, 1, fit.curve().beta)};
}

}  // namespace gurney::statistics
