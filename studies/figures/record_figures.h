#pragma once

#include <string>

#include "groundmotions/record/record.h"
#include "groundmotions/scaling/suite_scaling.h"
#include "groundmotions/scaling/target_spectrum.h"

namespace gurney::figures {

/// Acceleration, velocity and displacement of each component from rest, what they leave at the end,
/// and the response spectra (5 % damping) of the components and of RotD50.
std::string record_figure(const groundmotions::Record& record);

/// The scaled spectra of a suite, their mean and the target.
/// @param spectra  before scaling, one row for each record [m/s2]
std::string suite_figure(const groundmotions::TargetSpectrum& target,
                         const Eigen::VectorXd& periods, const Eigen::MatrixXd& spectra,
                         const groundmotions::SuiteScaling& scaling);

}  // namespace gurney::figures
