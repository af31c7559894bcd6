#include "studies/statistics/bands.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/base/error.h"
#include "engine/base/random/normal_draw.h"
#include "studies/statistics/quantiles.h"
#include "studies/statistics/special.h"

namespace gurney::statistics {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kLeastFitted = 0.9;  // share of the resamples bootstrap-t needs
constexpr double kFarthest = 1000;    // of an end of theta, in standard errors of ln theta
constexpr int kHalvings = 40;         // 1e-12 of the bracket

/// How often each group is drawn in one resample of as many groups.
std::vector<int> drawn_times(std::size_t groups, std::uint64_t seed, std::uint64_t resample) {
  std::vector<int> times(groups, 0);
  for (std::size_t i = 0; i < groups; ++i) {
    const double u = uniform_draw(seed, resample, i);
    ++times[std::min(groups - 1, static_cast<std::size_t>(u * static_cast<double>(groups)))];
  }
  return times;
}

Interval percentiles(const std::vector<double>& values, double confidence) {
  if (values.empty()) return {0, kInfinity};
  return {quantile_of(values, (1 - confidence) / 2), quantile_of(values, (1 + confidence) / 2)};
}

/// One number that is estimated with a standard error, and its resamples.
struct Studentized {
  double estimate, error;
  std::vector<double> t;

  void add(double resampled, double resampled_error) {
    if (resampled_error > 0) t.push_back((resampled - estimate) / resampled_error);
  }
  Interval interval(double confidence, double degrees, bool with_bootstrap) const {
    const double student = student_quantile((1 + confidence) / 2, degrees);
    Interval ends{-student, student};
    if (with_bootstrap && !t.empty()) {
      const Interval drawn = percentiles(t, confidence);
      ends = {std::min(ends.low, drawn.low), std::max(ends.high, drawn.high)};
    }
    return {estimate - ends.high * error, estimate - ends.low * error};
  }
};

/// Where a resample without a line has its step from 0 to 1. Between `low` and `high` the data say
/// nothing, so it lies anywhere, even in ln im.
double step_of(const ProbitFit& fit, double u) {
  if (fit.status == FragilityStatus::kAllExceed) return 0;
  if (fit.status == FragilityStatus::kNoneExceeds) return kInfinity;
  return fit.low * std::pow(fit.high / fit.low, u);
}

double error_at(const Eigen::Matrix2d& covariance, double im) {
  const Eigen::Vector2d x(std::log(im), 1);
  return std::sqrt(x.dot(covariance * x));
}

/// A line with its covariance for groups.
struct Line {
  Eigen::Vector2d line;
  Eigen::Matrix2d covariance;

  double score(double im) const { return line[0] * std::log(im) + line[1]; }
  double error(double im) const { return error_at(covariance, im); }
};

/// Intervals of the score at any intensity.
struct Scores {
  Line fit;
  std::vector<Line> drawn;  ///< of the resamples that have a line
  double confidence, degrees;
  bool with_bootstrap = false;

  Interval at(double im) const {
    Studentized score{fit.score(im), fit.error(im), {}};
    for (const Line& each : drawn) score.add(each.score(im), each.error(im));
    return score.interval(confidence, degrees, with_bootstrap);
  }
};

/// The intensity nearest to theta, upwards or downwards, at which the interval of the score leaves
/// 0; 0 or infinity if it has not within 1000 standard errors of ln theta.
double end_of_theta(const Scores& scores, double theta, double step) {
  const auto outside = [&](double distance) {
    const Interval z = scores.at(theta * std::exp(distance));
    return step > 0 ? z.low > 0 : z.high < 0;
  };
  double inner = 0, outer = step;
  while (!outside(outer)) {
    inner = outer;
    outer *= 2;
    if (std::abs(outer) > kFarthest * std::abs(step)) return step > 0 ? kInfinity : 0;
  }
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = (inner + outer) / 2;
    (outside(middle) ? outer : inner) = middle;
  }
  return theta * std::exp((inner + outer) / 2);
}

struct Collector {
  std::vector<Line> lines;
  std::vector<std::vector<double>> probabilities;  // at each im
  Studentized log_beta;
  std::vector<double> thetas, betas;
};

void add_degenerate(const ProbitFit& fit, double u, const std::vector<double>& im,
                    Collector& collected, FragilityBand& band) {
  if (fit.status == FragilityStatus::kNotIncreasing) {
    ++band.not_increasing;
    return;
  }
  const bool one_sided =
      fit.status == FragilityStatus::kAllExceed || fit.status == FragilityStatus::kNoneExceeds;
  ++(one_sided ? band.one_sided : band.separated);
  const double step = step_of(fit, u);
  collected.thetas.push_back(step);
  if (!one_sided) collected.betas.push_back(0);
  for (std::size_t i = 0; i < im.size(); ++i)
    collected.probabilities[i].push_back(im[i] >= step ? 1 : 0);
}

void add_line(const ProbitFit& fit, const Eigen::Matrix2d& covariance,
              const std::vector<double>& im, Collector& collected, FragilityBand& band) {
  collected.lines.push_back({fit.line, covariance});
  for (std::size_t i = 0; i < im.size(); ++i)
    collected.probabilities[i].push_back(normal_cdf(fit.score(im[i])));
  if (fit.status != FragilityStatus::kFitted) {
    ++band.not_increasing;
    return;
  }
  const Eigen::Matrix2d of_curve = covariance_of_curve(fit.line, covariance);
  const LognormalCurve curve = fit.curve();
  collected.log_beta.add(std::log(curve.beta), std::sqrt(of_curve(1, 1)));
  collected.thetas.push_back(curve.theta);
  collected.betas.push_back(curve.beta);
  band.curves.push_back(curve);
}

Interval exponential(const Interval& interval) {
  return {std::exp(interval.low), std::exp(interval.high)};
}

}  // namespace

FragilityBand fragility_band(const StripeTable& table, const std::vector<double>& im,
                             const BandOptions& options) {
  require(options.confidence > 0 && options.confidence < 1,
          fmt::format("confidence = {:g} must be in (0, 1)", options.confidence));
  require(options.resamples >= 1, fmt::format("resamples = {} must be >= 1", options.resamples));
  for (const double x : im) require(x > 0, fmt::format("im = {:g} must be > 0", x));

  const ProbitFit fit = fit_probit(table.stripes());
  FragilityBand band;
  band.status = fit.status;
  band.theta = band.beta = band.percentile_theta = band.percentile_beta = {0, kInfinity};
  band.of_curve = distribution_free_band(table, im, options.confidence);
  band.percentile_of_curve.assign(im.size(), {0, 1});
  if (fit.status != FragilityStatus::kFitted || table.groups() < 2) return band;

  const Eigen::Matrix2d covariance = cluster_covariance(fit, table);
  const Eigen::Matrix2d of_curve = covariance_of_curve(fit.line, covariance);
  Collector collected;
  collected.log_beta = {std::log(fit.curve().beta), std::sqrt(of_curve(1, 1)), {}};
  collected.probabilities.resize(im.size());
  for (int i = 0; i < options.resamples; ++i) {
    const auto stream = static_cast<std::uint64_t>(i);
    const std::vector<int> times = drawn_times(table.groups(), options.seed, stream);
    const ProbitFit drawn = fit_probit(table.resampled(times));
    if (drawn.has_line()) {
      add_line(drawn, cluster_covariance(drawn, table, times), im, collected, band);
    } else {
      const double u = uniform_draw(options.seed, stream, table.groups());
      add_degenerate(drawn, u, im, collected, band);
    }
  }

  const double degrees = static_cast<double>(table.groups() - 1);
  const auto enough = [&](std::size_t fitted) {
    return static_cast<double>(fitted) >= kLeastFitted * options.resamples;
  };
  const Scores scores{{fit.line, covariance},
                      collected.lines,
                      options.confidence,
                      degrees,
                      enough(collected.lines.size())};
  for (std::size_t i = 0; i < im.size(); ++i) {
    const Interval z = scores.at(im[i]);
    band.of_curve[i] = {normal_cdf(z.low), normal_cdf(z.high)};
    band.percentile_of_curve[i] = percentiles(collected.probabilities[i], options.confidence);
  }
  const double theta = fit.curve().theta, step = std::sqrt(of_curve(0, 0));
  band.theta = {end_of_theta(scores, theta, -step), end_of_theta(scores, theta, step)};
  band.beta = exponential(collected.log_beta.interval(options.confidence, degrees,
                                                      enough(collected.log_beta.t.size())));
  band.percentile_theta = percentiles(collected.thetas, options.confidence);
  band.percentile_beta = percentiles(collected.betas, options.confidence);
  return band;
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
    // Fractions of a hit are rounded to the wider side.
    const auto upper = proportion_interval(static_cast<int>(std::ceil(hits_above)),
                                           static_cast<int>(runs_above), confidence);
    const auto lower = proportion_interval(static_cast<int>(std::floor(hits_below)),
                                           static_cast<int>(runs_below), confidence);
    band.push_back({lower.low, upper.high});
  }
  return band;
}

}  // namespace gurney::statistics
