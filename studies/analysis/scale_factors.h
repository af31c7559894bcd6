#pragma once

#include <map>
#include <string>

#include "studies/analysis/study_data.h"

namespace gurney::study {

/// Factors on records beyond which a report cautions. An assumption, the literature has no sharp
/// limit: docs/theory/statistics.md, Scale factors.
inline constexpr double kLargestFactor = 5, kSmallestFactor = 0.2;

/// How much records are scaled.
class ScaleFactors {
 public:
  void add(std::size_t record, double factor);

  bool any() const { return !of_record_.empty(); }
  double lowest() const;
  double highest() const;
  std::size_t records() const { return of_record_.size(); }
  std::size_t above() const;  ///< records with a run at more than kLargestFactor
  std::size_t below() const;  ///< records with a run at less than kSmallestFactor

  /// `0.07 to 60.6; 3 of 11 records above 5`
  std::string text() const;

 private:
  std::map<std::size_t, std::pair<double, double>> of_record_;  ///< lowest and highest
};

/// Factors of the runs of a configuration, without those that failed.
ScaleFactors scale_factors(const StudyData& data, std::size_t configuration);

/// Factors of all runs of a study. Configurations may have records of their own.
ScaleFactors scale_factors(const StudyData& data);

}  // namespace gurney::study
