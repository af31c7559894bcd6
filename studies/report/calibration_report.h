#pragma once

#include <string>
#include <vector>

#include "studies/calibration/fit/calibration.h"
#include "studies/calibration/fit/caster_file.h"
#include "studies/findings/findings.h"

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

}  // namespace gurney::report
