#pragma once

#include <string>

#include "groundmotions/record/record.h"
#include "groundmotions/scaling/suite_scaling.h"
#include "groundmotions/scaling/target_spectrum.h"
#include "groundmotions/selection/selection.h"

namespace gurney::figures {

/// Acceleration, velocity and displacement of each component from rest, what they leave at the end,
/// and the response spectra (5 % damping) of the components and of RotD50.
std::string record_figure(const groundmotions::Record& record);

/// The scaled spectra of a suite, their mean and the target.
/// @param spectra  before scaling, one row for each record [m/s2]
std::string suite_figure(const groundmotions::TargetSpectrum& target,
                         const Eigen::VectorXd& periods, const Eigen::MatrixXd& spectra,
                         const groundmotions::SuiteScaling& scaling);

/// The spectra of selected records and the target: median, 2.5 and 97.5 % fractiles; below them the
/// standard deviations of ln Sa.
std::string selection_figure(const groundmotions::SelectionTarget& target,
                             const groundmotions::Selection& selection);

}  // namespace gurney::figures
