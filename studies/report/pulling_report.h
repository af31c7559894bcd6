#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "studies/calibration/pulling/measured_trial.h"
#include "studies/calibration/pulling/method_check.h"
#include "studies/findings/findings.h"

/// The pulling tests of a study as the figures of Xu, Ma & Kurata 2022 (docs/pulling_tests.md).
namespace gurney::report {

struct PullingReport {
  std::string file, title;
  std::vector<calibration::SimulatedTrial> trials;   ///< 1 or more
  std::vector<calibration::MeasuredTrial> measured;  ///< none unless the user gives them
  std::size_t shown = 0;                             ///< the trial of Figures 4 and 11
  std::optional<std::uint64_t> noise;                ///< seed of that in the simulated signals
};

/// "synthetic noise of 0.1 mm and 0.5 N (standard deviations), seed 1"; empty: none.
std::string noise_words(const PullingReport& report);

/// Bias of the method, fitted Cr / R, error against the closed form.
findings::Section pulling_findings(const PullingReport& report);

}  // namespace gurney::report
