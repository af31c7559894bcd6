#pragma once

#include <string>

#include "studies/report/pulling_report.h"

namespace gurney::figures {

/// Displacement, velocity, acceleration and cable force of the shown trial, with its phases.
std::string pulling_figure_4(const report::PullingReport& report);

/// f_r of the aligned trials by the paper's method against N, with a fitted line for each caster.
std::string pulling_figure_6(const report::PullingReport& report);

/// f_r of the aligned trials against wheel diameter and floor, and against speed.
std::string pulling_figure_7(const report::PullingReport& report);

/// Displacement and velocity of the shown trial against the closed form, and a measured trial like
/// it; work of the pull, loss to rolling resistance, kinetic energy.
std::string pulling_figure_11(const report::PullingReport& report);

}  // namespace gurney::figures
