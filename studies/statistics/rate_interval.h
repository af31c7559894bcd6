#pragma once

#include <Eigen/Core>
#include <vector>

#include "studies/statistics/bands.h"
#include "studies/statistics/hazard.h"

namespace gurney::statistics {

/// Least and largest mean annual rate of the lines (slope, intercept) around the region of a band
/// (FragilityBand::outline). The rate rises with the intercept everywhere, so its extremes are on
/// the outline. Infinite where a line does not rise and the hazard has no lowest intensity.
/// [0, infinity] without an outline.
Interval rate_interval(const std::vector<Eigen::Vector2d>& outline, const HazardCurve& hazard);

}  // namespace gurney::statistics
