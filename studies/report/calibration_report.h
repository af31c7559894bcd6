#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "studies/calibration/fit/calibration.h"
#include "studies/calibration/fit/caster_file.h"
#include "studies/calibration/pulling/measured_trial.h"
#include "studies/calibration/pulling/method_check.h"
#include "studies/findings/findings.h"

/// The pulling tests of a study as the figures of Xu, Ma & Kurata 2022 (docs/pulling_tests.md).
namespace gurney::report {

/// Findings of a calibration, in SI units, as `gurney calibrate --json` prints it.
/// @param without  why there is no caster file of a caster
findings::Section calibration_facts(const calibration::Calibration& calibration,
                                    const std::vector<calibration::CasterFile>& casters = {},
                                    const std::vector<std::string>& without = {});

/// The same with one row in each table, as a pattern for a reader.
findings::Section example_of_calibration_facts();

/// Facts with what follows from them, for terminal and page: cautions, residuals, results of tests.
findings::Section calibration_findings(findings::Section facts);

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
