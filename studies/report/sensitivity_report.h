#pragma once

#include <string>

#include "studies/analysis/study_sensitivity.h"
#include "studies/findings/findings.h"

namespace gurney::report {

/// Report of `gurney sensitivity` on one configuration.
struct SensitivityReport {
  std::string configuration;
  study::StudySensitivity found;
  std::string why_not;  ///< nothing was found; empty: it was
  study::UnitSystem units = {};
};

/// "mass_kg", or "static_friction and 7 equal to it".
std::string name_of(const study::SensitiveInput& input);

/// Indices and tornado of the inputs.
findings::Table sensitive_inputs(const SensitivityReport& report);

/// Meaning of the indices and how far to trust them, a sentence each.
findings::Texts sensitivity_remarks(const study::StudySensitivity& found);

/// "peak_tilt, brakes on: mean 3.2 deg, standard deviation 0.4 deg, 100 runs"
std::string sensitivity_title(const SensitivityReport& report);

/// In SI unless units are chosen.
findings::Section sensitivity_findings(const SensitivityReport& report);

}  // namespace gurney::report
