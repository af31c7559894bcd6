#pragma once

#include <string>
#include <vector>

#include "studies/calibration/fit/calibration.h"
#include "studies/figures/chart.h"
#include "studies/report/calibration_report.h"

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

/// I held, II pulled, III coasting, IV stopped or end of the floor: their spans in a signal.
std::vector<Span> phase_spans(const calibration::Phases& phases, const std::vector<double>& time);

/// Room in a panel above its curves, for the names of phases.
void leave_room_for_names(Panel& panel);

/// Resistance against load with fitted lines and bands of 95 %, and the phases of one pull.
std::string calibration_figure(const calibration::Calibration& calibration);

/// Resistance that is proportional to the load, with the pulls that it was found from.
struct LoadLine {
  std::string label;
  double ratio = 0;                      ///< f_r / N
  Range interval = {}, prediction = {};  ///< 95 %, of the ratio; not finite: none
  std::vector<double> load, resistance;  ///< of the pulls [N]
};

std::string load_figure(const PlotPage& page, const std::vector<LoadLine>& lines);

/// Values of single trials over the constant that was fitted to them.
struct ResidualRow {
  std::string label;
  struct Trial {
    double ratio = 1, error = 0;  ///< value and standard error, over the constant
    bool validation = false;
  };
  std::vector<Trial> trials;
  Range interval = {}, prediction = {};  ///< 95 %, over the constant; not finite: none
};

std::string residual_figure(const PlotPage& page, const std::vector<ResidualRow>& rows);

}  // namespace gurney::figures
