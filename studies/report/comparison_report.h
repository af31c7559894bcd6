#pragma once

#include <string>

#include "studies/analysis/study_comparison.h"
#include "studies/findings/findings.h"

namespace gurney::report {

/// Report of `gurney compare` on two configurations.
struct ComparisonReport {
  study::ConfigurationView a, b;
  std::string name_a, name_b;  ///< to distinguish them
  study::InputDifferences inputs;
  study::StudyComparison found;
  double confidence = 0.95;
  std::string label_a = name_a, label_b = name_b;  ///< short, for columns

  const study::UnitSystem& units() const { return a.data->units(); }
};

/// Sides, inputs that differ, shares, curves, means, medians, and what is significant.
findings::Section comparison_findings(const ComparisonReport& report);

}  // namespace gurney::report
