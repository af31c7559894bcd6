#include "studies/statistics/fragility.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>

#include "engine/base/error.h"
#include "engine/base/random/normal_draw.h"
#include "studies/statistics/bands.h"
#include "studies/statistics/special.h"

namespace gurney::statistics {

StripeTable::StripeTable(const std::vector<Observation>& observations) {
  std::map<double, std::size_t> number_of_im;
  std::map<std::size_t, std::map<double, Stripe>> counts;
  for (const Observation& seen : observations) {
    if (!(seen.im > 0 && std::isfinite(seen.im)))
      throw Error(fmt::format("im = {:g} must be > 0", seen.im));
    number_of_im[seen.im] = 0;
    Stripe& stripe = counts[seen.group][seen.im];
    stripe.runs += 1;
    stripe.exceeded += seen.exceeded ? 1 : 0;
  }
  for (auto& [im, number] : number_of_im) {
    number = stripes_.size();
    stripes_.push_back({im, 0, 0});
  }
  for (const auto& [group, of_im] : counts) {
    of_group_.emplace_back();
    for (const auto& [im, stripe] : of_im)
      of_group_.back().push_back({number_of_im[im], stripe.runs, stripe.exceeded});
  }
  stripes_ = resampled(std::vector<int>(groups(), 1));
}

std::vector<Stripe> StripeTable::resampled(const std::vector<int>& times) const {
  std::vector<Stripe> stripes = stripes_;
  for (Stripe& stripe : stripes) stripe.runs = stripe.exceeded = 0;
  for (std::size_t group = 0; group < of_group_.size(); ++group) {
    if (times[group] == 0) continue;
    for (const GroupCounts& share : of_group_[group]) {
      stripes[share.stripe].runs += times[group] * share.runs;
      stripes[share.stripe].exceeded += times[group] * share.exceeded;
    }
  }
  return stripes;
}

bool StripeTable::repeats_groups() const {
  return std::ranges::any_of(of_group_, [](const std::vector<GroupCounts>& shares) {
    return std::ranges::any_of(shares, [](const GroupCounts& share) { return share.runs > 1; });
  });
}

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNoRise = 1e-9;  // of the score within a standard deviation of ln im: rounding

/// Where the outcomes lie: the extremes of im of each.
struct Extremes {
  double lowest_hit = kInfinity, highest_hit = 0;
  double lowest_miss = kInfinity, highest_miss = 0;

  explicit Extremes(const std::vector<Stripe>& stripes) {
    for (const Stripe& stripe : stripes) {
      if (stripe.exceeded > 0) {
        lowest_hit = std::min(lowest_hit, stripe.im);
        highest_hit = std::max(highest_hit, stripe.im);
      }
      if (stripe.exceeded < stripe.runs) {
        lowest_miss = std::min(lowest_miss, stripe.im);
        highest_miss = std::max(highest_miss, stripe.im);
      }
    }
  }
};

/// ln of the likelihood of k successes in n at the one im of a quasi-separated fit.
double best_log_likelihood_at(double im, const std::vector<Stripe>& stripes) {
  for (const Stripe& stripe : stripes) {
    if (stripe.im != im || stripe.exceeded == 0 || stripe.exceeded == stripe.runs) continue;
    return stripe.exceeded * std::log(stripe.fraction()) +
           (stripe.runs - stripe.exceeded) * std::log1p(-stripe.fraction());
  }
  return 0;
}

constexpr double kRidge = 1e-9;

std::vector<Stripe> stripes_of(const StripeTable& table, std::size_t group) {
  std::vector<Stripe> stripes;
  for (const StripeTable::GroupCounts& share : table.of_group(group))
    stripes.push_back({table.stripes()[share.stripe].im, share.runs, share.exceeded});
  return stripes;
}

/// Fisher's, which depends on the intensities of the runs and not on their outcomes.
Eigen::Matrix2d expected_information(const ProbitFit& fit, const std::vector<Stripe>& stripes) {
  Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
  for (const Stripe& stripe : stripes) {
    const double z = fit.score(stripe.im);
    const Eigen::Vector2d x(std::log(stripe.im), 1);
    sum += stripe.runs * normal_hazard_below(z) * normal_hazard_below(-z) * (x * x.transpose());
  }
  return sum;
}

/// Covariance of a group's score if one capacity decides all its runs: those of P_i <= P_j exceed
/// together, cov(y_i, y_j) = P_i (1 - P_j).
Eigen::Matrix2d spread_of_one_capacity(const ProbitFit& fit, const std::vector<Stripe>& stripes) {
  Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
  Eigen::Vector2d below = Eigen::Vector2d::Zero();  // sum of n phi / (1 - P) x of lower P
  for (const Stripe& stripe : stripes) {
    const double z = fit.score(stripe.im);
    const Eigen::Vector2d x(std::log(stripe.im), 1);
    const Eigen::Vector2d risk = stripe.runs * normal_hazard_below(z) * x;   // n phi / P x
    const Eigen::Vector2d safe = stripe.runs * normal_hazard_below(-z) * x;  // n phi / (1 - P) x
    // The score of a run is phi / (P (1 - P)) (y - P) x, so a pair i < j gives risk_j safe_i'.
    sum += safe * risk.transpose() + below * risk.transpose() + risk * below.transpose();
    below += safe;
  }
  return sum;
}

ProbitFit without_line(FragilityStatus status, double low, double high, double log_likelihood = 0) {
  ProbitFit fit;
  fit.status = status;
  fit.low = low;
  fit.high = high;
  fit.log_likelihood = log_likelihood;
  return fit;
}

}  // namespace

std::string text(FragilityStatus status) {
  switch (status) {
    case FragilityStatus::kFitted:
      return "fitted";
    case FragilityStatus::kNoRuns:
      return "no runs";
    case FragilityStatus::kAllExceed:
      return "all runs exceed";
    case FragilityStatus::kNoneExceeds:
      return "no run exceeds";
    case FragilityStatus::kSeparated:
      return "complete separation: all runs above an interval of intensity exceed and none below, "
             "so beta cannot be estimated";
    case FragilityStatus::kQuasiSeparated:
      return "quasi-complete separation: only one intensity has both outcomes, so neither median "
             "nor beta can be estimated";
    case FragilityStatus::kNotIncreasing:
      return "exceedance increases hardly or not with intensity: no lognormal curve";
  }
  return {};
}

double ProbitFit::score(double im) const { return line[0] * std::log(im) + line[1]; }

LognormalCurve ProbitFit::curve() const { return {std::exp(-line[1] / line[0]), 1 / line[0]}; }

Quadratic<2> binomial_likelihood(const std::vector<Stripe>& stripes, const Eigen::Vector2d& line) {
  double value = 0, g0 = 0, g1 = 0, c00 = 0, c01 = 0, c11 = 0;
  for (const Stripe& stripe : stripes) {
    const double hits = stripe.exceeded, misses = stripe.runs - hits;
    const double x = std::log(stripe.im), z = line[0] * x + line[1];
    double slope = 0, curvature = 0;
    if (hits > 0) {
      const double hazard = normal_hazard_below(z);
      value += hits * log_normal_cdf(z);
      slope += hits * hazard;
      curvature += hits * hazard * (hazard + z);
    }
    if (misses > 0) {
      const double hazard = normal_hazard_below(-z);
      value += misses * log_normal_cdf(-z);
      slope -= misses * hazard;
      curvature += misses * hazard * (hazard - z);
    }
    g0 += slope * x;
    g1 += slope;
    c00 += curvature * x * x;
    c01 += curvature * x;
    c11 += curvature;
  }
  Quadratic<2> result{value, {g0, g1}, {}};
  result.curvature << c00, c01, c01, c11;
  return result;
}

ProbitFit fit_probit(const std::vector<Stripe>& stripes) {
  const Extremes at(stripes);
  const bool hits = at.highest_hit > 0, misses = at.highest_miss > 0;
  if (!hits && !misses) return {};
  if (!misses) return without_line(FragilityStatus::kAllExceed, 0, at.lowest_hit);
  if (!hits) return without_line(FragilityStatus::kNoneExceeds, at.highest_miss, kInfinity);
  if (at.highest_miss < at.lowest_hit)
    return without_line(FragilityStatus::kSeparated, at.highest_miss, at.lowest_hit);
  if (at.highest_miss == at.lowest_hit)
    return without_line(FragilityStatus::kQuasiSeparated, at.lowest_hit, at.lowest_hit,
                        best_log_likelihood_at(at.lowest_hit, stripes));
  if (at.highest_hit < at.lowest_miss)
    return without_line(FragilityStatus::kNotIncreasing, 0, kInfinity);
  if (at.highest_hit == at.lowest_miss)
    return without_line(FragilityStatus::kNotIncreasing, 0, kInfinity,
                        best_log_likelihood_at(at.lowest_miss, stripes));

  double runs = 0, sum = 0, squares = 0;
  for (const Stripe& stripe : stripes) {
    runs += stripe.runs;
    sum += stripe.runs * std::log(stripe.im);
  }
  const double middle = sum / runs;
  for (const Stripe& stripe : stripes)
    squares += stripe.runs * std::pow(std::log(stripe.im) - middle, 2);
  const double slope = 1 / std::sqrt(squares / runs);
  const auto likelihood = [&](const Eigen::Vector2d& line) {
    return binomial_likelihood(stripes, line);
  };
  const auto maximum = maximize<2>(likelihood, {slope, -slope * middle});
  if (!maximum.found) return without_line(FragilityStatus::kNotIncreasing, 0, kInfinity);
  ProbitFit fit;
  const bool rises = maximum.point[0] > kNoRise * slope;
  const double theta = std::exp(-maximum.point[1] / maximum.point[0]);
  const bool near_runs =
      theta * kFarthestEnd >= stripes.front().im && theta <= kFarthestEnd * stripes.back().im;
  fit.status = rises && near_runs ? FragilityStatus::kFitted : FragilityStatus::kNotIncreasing;
  fit.line = maximum.point;
  fit.information = maximum.at.curvature;
  fit.log_likelihood = maximum.at.value;
  return fit;
}

Eigen::Matrix2d cluster_covariance(const ProbitFit& fit, const StripeTable& table) {
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  const double groups = static_cast<double>(table.groups());
  for (std::size_t group = 0; group < table.groups(); ++group) {
    const Quadratic<2> of = binomial_likelihood(stripes_of(table, group), fit.line);
    // A group without which there is no slope: its influence is large, but finite.
    const Eigen::Matrix2d others = (1 + kRidge) * fit.information - of.curvature;
    const Eigen::Vector2d influence = others.inverse() * of.gradient;
    spread += influence * influence.transpose();
  }
  return (groups - 1) / groups * spread;
}

std::vector<Eigen::Matrix2d> line_covariances(const ProbitFit& fit, const StripeTable& table) {
  const Eigen::Matrix2d of_runs = fit.information.inverse();
  if (table.groups() < 2) return {of_runs};
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  for (std::size_t group = 0; group < table.groups(); ++group)
    spread += spread_of_one_capacity(fit, stripes_of(table, group));
  const double groups = static_cast<double>(table.groups());
  const Eigen::Matrix2d of_groups = cluster_covariance(fit, table);
  const Eigen::Matrix2d decided = groups / (groups - 1) * of_runs * spread * of_runs;
  const double excess = (fit.information * decided).trace() - 2;
  const double share =
      excess > 0 ? std::clamp(((fit.information * of_groups).trace() - 2) / excess, 0.0, 1.0) : 0;
  return {of_runs, of_groups, share * decided + (1 - share) * of_runs};
}

double effective_groups(const ProbitFit& fit, const StripeTable& table) {
  std::vector<Eigen::Matrix2d> informations;
  Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
  for (std::size_t group = 0; group < table.groups(); ++group) {
    informations.push_back(expected_information(fit, stripes_of(table, group)));
    sum += informations.back();
  }
  const Eigen::Matrix2d inverse = sum.inverse();
  double squares = 0;
  for (const Eigen::Matrix2d& each : informations)
    squares += std::pow((inverse * each).trace() / 2, 2);
  return 1 / squares;
}

Eigen::Matrix2d covariance_of_curve(const Eigen::Vector2d& line,
                                    const Eigen::Matrix2d& covariance) {
  // ln theta = -intercept / slope, ln beta = -ln slope
  Eigen::Matrix2d jacobian;
  jacobian << line[1] / (line[0] * line[0]), -1 / line[0], -1 / line[0], 0;
  return jacobian * covariance * jacobian.transpose();
}

FragilityFit fit_fragility(const std::vector<Observation>& observations) {
  return fit_fragility(StripeTable(observations));
}

FragilityFit fit_fragility(const StripeTable& table) {
  const ProbitFit probit = fit_probit(table.stripes());
  FragilityFit fit;
  fit.status = probit.status;
  fit.low = probit.low;
  fit.high = probit.high;
  fit.log_likelihood = probit.log_likelihood;
  fit.covariance.setZero();
  fit.cluster_covariance.setZero();
  fit.groups = table.groups();
  for (const Stripe& stripe : table.stripes()) {
    fit.runs += static_cast<std::size_t>(stripe.runs);
    fit.exceeded += static_cast<std::size_t>(stripe.exceeded);
  }
  if (probit.status != FragilityStatus::kFitted) return fit;
  fit.curve = probit.curve();
  fit.covariance = covariance_of_curve(probit.line, probit.information.inverse());
  fit.effective_groups = effective_groups(probit, table);
  if (table.groups() > 1)
    fit.cluster_covariance = covariance_of_curve(probit.line, cluster_covariance(probit, table));
  return fit;
}

namespace {

/// The most a likelihood of these stripes can be.
double saturated_log_likelihood(const std::vector<Stripe>& stripes) {
  double sum = 0;
  for (const Stripe& stripe : stripes) {
    if (stripe.exceeded > 0) sum += stripe.exceeded * std::log(stripe.fraction());
    if (stripe.exceeded < stripe.runs)
      sum += (stripe.runs - stripe.exceeded) * std::log1p(-stripe.fraction());
  }
  return sum;
}

double deviance_of(const ProbitFit& fit, const std::vector<Stripe>& stripes) {
  return std::max(0.0, 2 * (saturated_log_likelihood(stripes) - fit.log_likelihood));
}

}  // namespace

std::optional<double> p_of_fit(const std::vector<Stripe>& stripes, int resamples,
                               std::uint64_t seed) {
  const ProbitFit fit = fit_probit(stripes);
  if (fit.status != FragilityStatus::kFitted || stripes.size() < 3) return {};
  const double deviance = deviance_of(fit, stripes);
  int as_large = 0, fitted = 0;
  for (int i = 0; i < resamples; ++i) {
    std::vector<Stripe> drawn = stripes;
    std::uint64_t run = 0;
    for (Stripe& stripe : drawn) {
      const double p = normal_cdf(fit.score(stripe.im));
      stripe.exceeded = 0;
      for (int k = 0; k < stripe.runs; ++k)
        stripe.exceeded += uniform_draw(seed, static_cast<std::uint64_t>(i), run++) < p ? 1 : 0;
    }
    const ProbitFit again = fit_probit(drawn);
    if (again.status != FragilityStatus::kFitted) continue;
    ++fitted;
    // Equal counts give deviances that differ by rounding.
    if (deviance_of(again, drawn) >= deviance * (1 - 1e-9)) ++as_large;
  }
  return (1.0 + as_large) / (1.0 + fitted);
}

std::vector<double> isotonic(const std::vector<double>& values,
                             const std::vector<double>& weights) {
  require(values.size() == weights.size(),
          fmt::format("{} values have {} weights: must be one for each", values.size(),
                      weights.size()));
  struct Pool {
    double sum, weight;
    std::size_t size;
    double mean() const { return sum / weight; }
  };
  std::vector<Pool> pools;
  for (std::size_t i = 0; i < values.size(); ++i) {
    require(weights[i] > 0, fmt::format("weights[{}] = {:g} must be > 0", i, weights[i]));
    pools.push_back({values[i] * weights[i], weights[i], 1});
    while (pools.size() > 1 && !(pools[pools.size() - 2].mean() < pools.back().mean())) {
      const Pool last = pools.back();
      pools.pop_back();
      pools.back().sum += last.sum;
      pools.back().weight += last.weight;
      pools.back().size += last.size;
    }
  }
  std::vector<double> fitted;
  for (const Pool& pool : pools) fitted.insert(fitted.end(), pool.size, pool.mean());
  return fitted;
}

std::vector<double> isotonic_curve(const std::vector<Stripe>& stripes) {
  std::vector<double> fractions, runs;
  for (const Stripe& stripe : stripes) {
    fractions.push_back(stripe.fraction());
    runs.push_back(stripe.runs);
  }
  return isotonic(fractions, runs);
}

}  // namespace gurney::statistics
