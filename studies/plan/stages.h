#pragma once

#include <vector>

#include "studies/statistics/stripes.h"

namespace gurney::study {

inline constexpr int kLevelsOfAStage = 2;

/// The levels at which a next stage of stripes determines theta and beta best, increasing: with a
/// lognormal curve fitted to the stripes so far those where it is 12.8 and 87.2 %, the D-optimal
/// design of a probit line (Abdelbasit & Plackett 1983, J. American Statistical Association 78,
/// 90-98), but within twice the
/// highest and half the lowest stripe. Where there is no curve:
/// - all or none exceed: 1.5 and 2 times below the lowest, or above the highest;
/// - separated: the thirds of the interval between, on a logarithmic scale;
/// - one stripe only with both outcomes: half of the way to its neighbours;
/// - no rise with intensity: 1.5 times beyond either end.
///
/// Levels have three digits in their unit. One within 1 % of a stripe that was made would be the
/// same runs again, and goes outward in steps of 5 %.
/// @param stripes  im increases, in SI; at least one
/// @param unit     of the levels in SI
std::vector<double> next_levels(const std::vector<statistics::Stripe>& stripes, double unit);

}  // namespace gurney::study
