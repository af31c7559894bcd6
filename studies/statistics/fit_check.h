#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "studies/statistics/fragility.h"

namespace gurney::statistics {

/// How well the fitted curve describes the stripes.
struct FitCheck {
  double pearson = 0;   ///< sum (k - n p)^2 / (n p (1 - p))
  double deviance = 0;  ///< likelihood ratio against a probability of its own for each stripe
  int degrees = 0;      ///< stripes - 2
  double p_pearson = 1, p_deviance = 1;  ///< of chi-squared; true where counts are large
  double p_simulated = 1;  ///< of the deviance, from counts drawn with the fitted curve
};

/// Pearson's and the likelihood-ratio statistic (McCullagh & Nelder 1989, Generalized linear
/// models, chapter 4), and the parametric bootstrap of the second (Davison & Hinkley 1997,
/// section 4.2), p = (1 + number of resamples with at least the deviance) / (1 + resamples), for
/// small counts. All suppose independent runs: where runs of one record are alike p is too small or
/// too large. None unless the fit is kFitted on three stripes or more.
std::optional<FitCheck> check_fit(const std::vector<Stripe>& stripes, int resamples = 999,
                                  std::uint64_t seed = 1);

/// The nondecreasing values nearest to `values` in weighted squares, by pooling adjacent violators
/// (Ayer et al. 1955, Annals of Mathematical Statistics 26(4), 641-647).
/// @throws Error unless there is a weight > 0 for each value.
std::vector<double> isotonic(const std::vector<double>& values, const std::vector<double>& weights);

/// The curve without a form: the most likely probability at each stripe that never falls with im.
/// Stripes without runs are not allowed.
std::vector<double> isotonic_curve(const std::vector<Stripe>& stripes);

}  // namespace gurney::statistics
