#pragma once

#include <string>
#include <vector>

#include "groundmotions/record/record.h"
#include "groundmotions/scaling/suite_scaling.h"
#include "groundmotions/scaling/target_spectrum.h"
#include "groundmotions/selection/selection.h"
#include "studies/analysis/stored_histories.h"
#include "studies/analysis/suite_spectra.h"
#include "studies/figures/chart.h"

namespace gurney::figures {

inline constexpr double kShortestPeriod = 0.02;  ///< of the spectra of a record [s]

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

/// The spectra of a suite with their median, 16 and 84 % fractiles: of the records as they are, of
/// the records scaled to the level, and of the building's floor under these.
/// @param what  "records", "scaled", "floor"; empty: all there are
/// @throws Error for other words, and for floors of a study without building
std::string spectra_figure(const PlotPage& page, const std::string& title,
                           const std::vector<study::SuiteSpectra>& suites,
                           const std::vector<std::string>& what = {});

std::string floor_spectra_figure(const PlotPage& page, const std::string& title,
                                 const study::FloorSpectra& spectra);

/// A panel over time for each history. More than three wheels, points or items have axes of their
/// own, for their curves would hide each other.
std::string history_figure(const PlotPage& page, const std::string& title, const std::string& note,
                           const std::vector<study::StoredHistory>& histories);

}  // namespace gurney::figures
