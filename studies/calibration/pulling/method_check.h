#pragma once

#include <string>
#include <vector>

#include "studies/calibration/pulling/simulated_trial.h"

/// Result of the paper's method on simulated trials, against their inputs (docs/pulling_tests.md).
namespace gurney::calibration {

struct MeanAndScatter {
  double mean = 0, deviation = 0;  ///< standard deviation over trials; NaN of fewer than 2
};

/// Bias of f_r as a fraction of the f_r that went in, over the trials of one alignment.
struct AlignmentBias {
  Alignment alignment = Alignment::kAligned;
  std::size_t trials = 0;
  MeanAndScatter pulled, coasting, mean;
};

/// One entry for each alignment of trials with averages.
std::vector<AlignmentBias> bias_by_alignment(const std::vector<SimulatedTrial>& trials);

/// The paper's Figure 6: f_r = (Cr / R) N through the origin, by least squares over the aligned
/// trials of a caster: sum f N / sum N^2.
struct CasterFit {
  std::string caster;
  double wheel_radius = 0;  ///< [m]
  std::size_t trials = 0;
  double found = 0, known = 0;  ///< Cr / R [-]
};
std::vector<CasterFit> fits_by_caster(const std::vector<SimulatedTrial>& trials);

/// Cr / R where trials of these alignments are pooled: bias of the fit through the
/// origin, sum f N / sum N^2, over all casters, as a fraction of the input.
struct PooledBias {
  std::string trials_of;  ///< "aligned, reversed"
  std::size_t trials = 0;
  double both = 0;      ///< by the mean of both phases
  double coasting = 0;  ///< by phase III alone
};
/// Aligned trials alone, with each other alignment that there is, and all.
std::vector<PooledBias> pooled_biases(const std::vector<SimulatedTrial>& trials);

/// Simulated against closed-form displacement, as fractions of the latter.
struct TheoryError {
  double release = 0;  ///< at the time at which the pull ends in theory
  double rest = 0;     ///< at the end; NaN where the trial left the flooring
};
TheoryError theory_error(const SimulatedTrial& trial);

}  // namespace gurney::calibration
