#include "studies/statistics/capacity.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <set>

#include "engine/base/error.h"
#include "engine/base/random/normal_draw.h"
#include "studies/statistics/censored_normal.h"
#include "studies/statistics/profile.h"
#include "studies/statistics/special.h"

namespace gurney::statistics {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

FragilityStatus status_without_fit(double highest_low, double lowest_high) {
  if (lowest_high == kInfinity) return FragilityStatus::kNoneExceeds;
  if (highest_low == 0) return FragilityStatus::kAllExceed;
  return highest_low < lowest_high ? FragilityStatus::kSeparated : FragilityStatus::kQuasiSeparated;
}

/// The ln likelihood of a step at `im`, where all brackets end or begin.
double log_likelihood_of_step(double im, const std::vector<Capacity>& capacities) {
  double all = 0, below = 0;
  for (const Capacity& each : capacities) {
    all += each.weight;
    below += each.high <= im ? each.weight : 0;
  }
  const auto share = [&](double of) { return of > 0 ? of * std::log(of / all) : 0; };
  return share(below) + share(all - below);
}

}  // namespace

std::vector<Capacity> ida_capacities(const std::vector<Observation>& observations) {
  using Case = std::pair<std::size_t, std::size_t>;  // of a group
  std::map<Case, std::vector<Observation>> of_case;
  std::map<std::size_t, int> cases;
  for (const Observation& seen : observations) {
    if (!(seen.im > 0 && std::isfinite(seen.im)))
      throw Error(fmt::format("im = {:g} must be > 0", seen.im));
    auto& runs = of_case[{seen.group, seen.analysis_case}];
    if (runs.empty()) ++cases[seen.group];
    runs.push_back(seen);
  }
  std::vector<Capacity> capacities;
  for (const auto& [place, runs] : of_case) {
    const auto [group, analysis_case] = place;
    Capacity capacity{
        group, 0, kInfinity, 0, static_cast<int>(runs.size()), 1.0 / cases[group], analysis_case};
    for (const Observation& run : runs)
      if (run.exceeded) capacity.high = std::min(capacity.high, run.im);
    for (const Observation& run : runs) {
      if (run.exceeded) continue;
      if (run.im < capacity.high)
        capacity.low = std::max(capacity.low, run.im);
      else
        ++capacity.resurrections;
    }
    capacities.push_back(capacity);
  }
  return capacities;
}

std::vector<Stripe> stripes_of(const std::vector<Capacity>& capacities) {
  std::set<double> ends;
  for (const Capacity& each : capacities)
    for (const double end : {each.low, each.high})
      if (end > 0 && std::isfinite(end)) ends.insert(end);
  std::vector<Stripe> stripes;
  for (const double im : ends) {
    Stripe stripe{im};
    for (const Capacity& each : capacities) {
      const bool exceeds = each.high <= im;
      if (!exceeds && each.low < im) continue;
      stripe.runs += each.weight;
      stripe.exceeded += exceeds ? each.weight : 0;
    }
    stripes.push_back(stripe);
  }
  return stripes;
}

std::vector<CensoredValue> log_capacities(const std::vector<Capacity>& capacities) {
  std::vector<CensoredValue> values;
  for (const Capacity& capacity : capacities) {
    if (!(capacity.low >= 0 && capacity.low <= capacity.high && capacity.high > 0))
      throw Error(
          fmt::format("a capacity within {:g} to {:g} is none", capacity.low, capacity.high));
    if (capacity.low > 0 || capacity.high < kInfinity)
      values.push_back({std::log(capacity.low), std::log(capacity.high), capacity.weight});
  }
  return values;
}

CapacityFit fit_capacities(const std::vector<Capacity>& capacities) {
  CapacityFit fit;
  if (capacities.empty()) return fit;
  const std::vector<CensoredValue> values = log_capacities(capacities);
  double highest_low = 0, lowest_high = kInfinity;
  for (const Capacity& capacity : capacities) {
    fit.censored += capacity.high == kInfinity ? 1 : 0;
    fit.resurrections += capacity.resurrections;
    highest_low = std::max(highest_low, capacity.low);
    lowest_high = std::min(lowest_high, capacity.high);
  }
  if (highest_low <= lowest_high) {
    fit.status = status_without_fit(highest_low, lowest_high);
    fit.low = highest_low;
    fit.high = lowest_high;
    if (fit.status == FragilityStatus::kQuasiSeparated)
      fit.log_likelihood = log_likelihood_of_step(highest_low, capacities);
    return fit;
  }
  const auto n = static_cast<Eigen::Index>(values.size());
  const CensoredNormalFit normal = fit_censored_normal(Eigen::MatrixXd::Ones(n, 1), values);
  fit.status = normal.found ? FragilityStatus::kFitted : FragilityStatus::kNotIncreasing;
  if (!normal.found) return fit;
  fit.curve = LognormalCurve{std::exp(normal.coefficients[0]), normal.sigma};
  fit.covariance = normal.covariance;
  fit.log_likelihood = normal.log_likelihood;
  return fit;
}

namespace {

using Direction = Eigen::Vector2d;

/// The likelihood in m = mu / sigma and h = 1 / sigma, mu = ln theta and sigma = beta.
class Likelihood {
 public:
  Likelihood(const std::vector<Capacity>& capacities, const CapacityFit& fit)
      : values_(log_capacities(capacities)),
        design_(Eigen::MatrixXd::Ones(static_cast<Eigen::Index>(values_.size()), 1)),
        best_(std::log(fit.curve->theta) / fit.curve->beta, 1 / fit.curve->beta),
        highest_(fit.log_likelihood) {}

  const Eigen::Vector2d& best() const { return best_; }

  /// Twice the ln of the likelihood ratio of the best against the best on `point` + c `along`.
  double drop(const Eigen::Vector2d& point, const Direction& along) const {
    const auto likelihood = [&](const Eigen::Vector2d& at) -> Quadratic<2> {
      const auto full = censored_normal_likelihood(design_, values_, at);
      return {full.value, full.gradient, full.curvature};
    };
    const double start = along.dot(best_ - point) / along.squaredNorm();
    return 2 * (highest_ - largest_on_line(likelihood, point, along, start));
  }

  /// With the score h ln im - m held.
  double drop_of_score(double log_im, double score) const { return drop({-score, 0}, {log_im, 1}); }
  /// With both held: slope h and intercept -m.
  double drop_of_line(const Eigen::Vector2d& line) const {
    const Eigen::Vector2d point(-line[1], line[0]);
    return 2 * (highest_ - censored_normal_likelihood(design_, values_, point).value);
  }
  double drop_of_beta(double beta) const { return drop({best_[0], 1 / beta}, {1, 0}); }

 private:
  std::vector<CensoredValue> values_;
  Eigen::MatrixXd design_;
  Eigen::Vector2d best_;
  double highest_;
};

/// The likelihood ratios of n exact capacities at the ends of their exact intervals.
struct Limits {
  double mean, beta_low, beta_high;
};

Limits limits_of_exact(double n, double confidence) {
  const double t = student_quantile((1 + confidence) / 2, n - 1);
  const auto of_beta = [&](double probability) {
    const double w = chi_squared_quantile(probability, n - 1);
    return w - n - n * std::log(w / n);
  };
  return {n * std::log1p(t * t / (n - 1)), of_beta((1 + confidence) / 2),
          of_beta((1 - confidence) / 2)};
}

/// The lines on which the likelihood ratio is at `limit`, in the directions of an ellipse around
/// the best one.
std::vector<Eigen::Vector2d> outline_of(const Likelihood& likelihood, const CapacityFit& fit,
                                        double limit) {
  const Eigen::Vector2d line(likelihood.best()[1], -likelihood.best()[0]);
  Eigen::Matrix2d jacobian;  // of slope and intercept to ln theta and ln beta
  jacobian << 0, -line[0], -line[0], -line[1];
  const Eigen::Matrix2d covariance = jacobian * fit.covariance * jacobian.transpose();
  std::vector<Eigen::Vector2d> outline;
  for (const Eigen::Vector2d& point : statistics::outline_of(line, covariance, 1)) {
    const double length = crossing(
        [&](double d) { return likelihood.drop_of_line(line + d * (point - line)); }, limit, 1);
    if (std::isfinite(length)) outline.push_back(line + length * (point - line));
  }
  return outline;
}

}  // namespace

double effective_capacities(const std::vector<Capacity>& capacities, const CapacityFit& fit) {
  double records = 0;
  for (const Capacity& each : capacities) records += each.weight;
  return std::clamp(0.5 / fit.covariance(1, 1), 2.0, std::max(2.0, records));
}

CapacityIntervals capacity_intervals(const std::vector<Capacity>& capacities,
                                     const CapacityFit& fit, const std::vector<double>& im,
                                     double confidence) {
  const Likelihood likelihood(capacities, fit);
  const double theta = fit.curve->theta, beta = fit.curve->beta;
  const double n = effective_capacities(capacities, fit);
  const Limits limits = limits_of_exact(n, confidence);
  const auto of_theta = [&](double d) { return likelihood.drop_of_score(std::log(theta) + d, 0); };
  const auto of_beta = [&](double d) { return likelihood.drop_of_beta(beta * std::exp(d)); };
  const double step = std::sqrt(fit.covariance(0, 0)), step_of_beta = std::sqrt(0.5 / n);
  CapacityIntervals intervals;
  intervals.theta = {theta * std::exp(crossing(of_theta, limits.mean, -step)),
                     theta * std::exp(crossing(of_theta, limits.mean, step))};
  intervals.beta = {beta * std::exp(crossing(of_beta, limits.beta_low, -step_of_beta)),
                    beta * std::exp(crossing(of_beta, limits.beta_high, step_of_beta))};
  intervals.outline = outline_of(likelihood, fit, limits.mean);
  for (const double x : im) {
    const double score = std::log(x / theta) / beta;
    const auto of_score = [&](double d) {
      return likelihood.drop_of_score(std::log(x), score + d);
    };
    const double error = std::hypot(step / beta, score * step_of_beta);
    intervals.of_curve.push_back({normal_cdf(score + crossing(of_score, limits.mean, -error)),
                                  normal_cdf(score + crossing(of_score, limits.mean, error))});
  }
  return intervals;
}

namespace {

/// The largest distance of the curve from what the brackets leave open of the empirical
/// distribution, at their ends.
double distance(const std::vector<Capacity>& capacities, const LognormalCurve& curve) {
  std::vector<double> lows, highs;
  for (const Capacity& each : capacities) {
    lows.push_back(each.low);
    highs.push_back(each.high);
  }
  std::ranges::sort(lows);
  std::ranges::sort(highs);
  const auto n = static_cast<double>(capacities.size());
  double largest = 0;
  for (const auto* ends : {&lows, &highs})
    for (const double end : *ends) {
      if (!std::isfinite(end)) continue;
      const auto below = std::ranges::upper_bound(highs, end) - highs.begin();
      const auto begun = std::ranges::lower_bound(lows, end) - lows.begin();
      const double p = curve.probability(end);
      largest = std::max(
          {largest, static_cast<double>(below) / n - p, p - static_cast<double>(begun) / n});
    }
  return largest;
}

/// Capacities of the curve in brackets as wide as those seen, censored where the first one was.
std::vector<Capacity> drawn(const std::vector<Capacity>& seen, const LognormalCurve& curve,
                            std::uint64_t seed, std::uint64_t resample) {
  double censored_at = kInfinity, width = 0;
  for (const Capacity& each : seen)
    if (each.high == kInfinity) censored_at = std::min(censored_at, each.low);
  std::vector<Capacity> all;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (seen[i].high < kInfinity) width = std::log(seen[i].high / seen[i].low);
    const double capacity = curve.quantile(uniform_draw(seed, resample, 2 * i));
    const double place = uniform_draw(seed, resample, 2 * i + 1);
    if (capacity > censored_at)
      all.push_back({i, censored_at, kInfinity});
    else
      all.push_back(
          {i, capacity * std::exp(-place * width), capacity * std::exp((1 - place) * width)});
  }
  return all;
}

}  // namespace

std::optional<double> p_of_lognormal(const std::vector<Capacity>& capacities,
                                     const CapacityFit& fit, int resamples, std::uint64_t seed) {
  if (std::ranges::any_of(capacities, [](const Capacity& each) {
        return each.low == 0 || each.weight != 1;  // a record with several cases has no law here
      }))
    return {};
  const double seen = distance(capacities, *fit.curve);
  int as_far = 0, fitted = 0;
  for (int i = 0; i < resamples; ++i) {
    const auto resample = drawn(capacities, *fit.curve, seed, static_cast<std::uint64_t>(i));
    const CapacityFit again = fit_capacities(resample);
    if (!again.curve) continue;
    ++fitted;
    if (distance(resample, *again.curve) >= seen) ++as_far;
  }
  return (1.0 + as_far) / (1.0 + fitted);
}

}  // namespace gurney::statistics
