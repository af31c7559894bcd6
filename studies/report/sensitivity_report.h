#pragma once

#include <string>
#include <vector>

#include "studies/study/analysis/study_sensitivity.h"

namespace gurney::report {

/// What `gurney sensitivity` reports of one configuration.
struct SensitivityReport {
  std::string configuration;
  study::StudySensitivity found;
  std::string why_not;  ///< nothing was found; empty: it was
  study::UnitSystem units = {};
};

/// "mass_kg", or "static_friction and 7 equal to it".
std::string name_of(const study::SensitiveInput& input);

std::string sensitivity_text(const std::vector<SensitivityReport>& reports);
/// What the indices mean and how far to trust them, a line each.
std::string sensitivity_remarks(const study::StudySensitivity& found);

std::string sensitivity_json(const std::vector<SensitivityReport>& reports);

}  // namespace gurney::report
