#include "studies/statistics/fit_check.h"

#include <fmt/format.h>

#include <cmath>

#include "engine/base/error.h"
#include "engine/base/random/normal_draw.h"
#include "studies/statistics/special.h"

namespace gurney::statistics {
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

std::optional<FitCheck> check_fit(const std::vector<Stripe>& stripes, int resamples,
                                  std::uint64_t seed) {
  const ProbitFit fit = fit_probit(stripes);
  if (fit.status != FragilityStatus::kFitted || stripes.size() < 3) return {};
  FitCheck check;
  check.degrees = static_cast<int>(stripes.size()) - 2;
  for (const Stripe& stripe : stripes) {
    const double z = fit.score(stripe.im);
    const double variance = stripe.runs * normal_cdf(z) * normal_cdf(-z);
    const double away = stripe.exceeded - stripe.runs * normal_cdf(z);
    if (away != 0) check.pearson += away * away / variance;
  }
  check.deviance = deviance_of(fit, stripes);
  check.p_pearson = chi_squared_survival(check.pearson, check.degrees);
  check.p_deviance = chi_squared_survival(check.deviance, check.degrees);

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
    if (deviance_of(again, drawn) >= check.deviance * (1 - 1e-9)) ++as_large;
  }
  check.p_simulated = (1.0 + as_large) / (1.0 + fitted);
  return check;
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
