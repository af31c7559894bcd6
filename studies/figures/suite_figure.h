#pragma once

#include <string>

#include "groundmotions/scaling/suite_scaling.h"
#include "groundmotions/scaling/target_spectrum.h"

namespace gurney::figures {

/// One page of SVG: the scaled spectra of a suite, their mean and the target.
/// @param spectra  before scaling, one row for each record [m/s2]
std::string suite_figure(const groundmotions::TargetSpectrum& target,
                         const Eigen::VectorXd& periods, const Eigen::MatrixXd& spectra,
                         const groundmotions::SuiteScaling& scaling);

}  // namespace gurney::figures
