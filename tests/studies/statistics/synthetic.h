#pragma once

#include <cmath>
#include <vector>

#include "engine/base/random/normal_draw.h"
#include "studies/statistics/fragility.h"
#include "studies/statistics/special.h"

namespace gurney::statistics {

/// Outcomes of runs whose capacity is lognormal: each record at each level.
///
/// ln capacity = ln theta + beta (sqrt(r) z_record + sqrt(1 - r) z_run), r the correlation of two
/// runs of one record. The curve of all runs is (theta, beta) whatever r.
struct SyntheticStudy {
  LognormalCurve curve{1, 0.4};
  std::size_t records = 40;
  std::vector<double> levels{0.4, 0.5, 0.63, 0.8, 1.0, 1.25, 1.6, 2.0, 2.5};
  double correlation = 0;

  std::vector<Observation> outcomes(std::uint64_t seed) const {
    std::vector<Observation> all;
    for (std::size_t record = 0; record < records; ++record) {
      const double shared = normal_draw(seed, 0, record);
      for (std::size_t level = 0; level < levels.size(); ++level) {
        const double own = normal_draw(seed, 1, record * levels.size() + level);
        const double score = std::sqrt(correlation) * shared + std::sqrt(1 - correlation) * own;
        const double capacity = curve.theta * std::exp(curve.beta * score);
        all.push_back({levels[level], capacity <= levels[level], record});
      }
    }
    return all;
  }
};

/// Method of moments for exact capacities: exp(mean ln), standard deviation of ln with n - 1 (Porter,
/// Kennedy & Bachman 2007, Earthquake Spectra 23(2), 471-489, method A).
inline LognormalCurve curve_of_moments(const std::vector<double>& capacities) {
  const double n = static_cast<double>(capacities.size());
  double mean = 0, squares = 0;
  for (const double each : capacities) mean += std::log(each) / n;
  for (const double each : capacities) squares += std::pow(std::log(each) - mean, 2);
  return {std::exp(mean), std::sqrt(squares / (n - 1))};
}

}  // namespace gurney::statistics
