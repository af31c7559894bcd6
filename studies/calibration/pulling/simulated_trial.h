#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "studies/calibration/pulling/pull_theory.h"
#include "studies/calibration/trials/average_method.h"
#include "studies/results/study_reader.h"

namespace gurney::calibration {

/// How the casters stand at the start, by the one that is farthest from trailing.
enum class Alignment { kAligned, kCrosswise, kReversed };  // up to 45, 135, 180 degrees
const char* name_of(Alignment alignment);
Alignment alignment_of(const std::vector<double>& headings);  ///< [rad]; none: aligned

/// A pulling test as a study simulated it: what was measured, and the constants behind it.
struct SimulatedTrial {
  std::size_t run = 0;
  std::string configuration;     ///< levels of its factors
  Trial trial;                   ///< named `trial_00` and so on by its run; ends with the flooring
  std::vector<double> velocity;  ///< in the direction of the pull [m/s]
  std::string accelerometer;     ///< the item's first marked point; empty: not kept
  std::vector<double> accelerometer_signal;  ///< its absolute acceleration along the pull [m/s2]
  std::vector<double> work, rolling_loss, kinetic;  ///< W_F, W_R, E_KT; empty: not kept [J]
  std::string solver;
  double time_step = 0;  ///< [s]
  Alignment alignment = Alignment::kAligned;
  std::string driven_by;       ///< name of the sampled force that pulls: of a trial; empty: none
  bool left_flooring = false;  ///< it came to the zone "end of the flooring"
  PullTheory theory;

  std::optional<Phases> phases;  ///< as found from the signals
  std::optional<TrialAverages> averages;
  std::string fault;  ///< why there are no phases or averages

  /// (f_r by the paper's method - f_r that went in) / f_r; needs averages.
  double bias_pulled() const;
  double bias_coasting() const;
  double bias_mean() const;  ///< of the plain mean of both
};

/// The trials of a results file with histories.
/// @param noise  seed of synthetic noise of the instruments (instrument_noise.h): the velocity is
///               then that of the noisy displacement; none: signals as simulated
/// @throws Error where the file keeps none, or its job is no pulling test
std::vector<SimulatedTrial> simulated_trials(const study::StudyReader& file,
                                             const std::optional<std::uint64_t>& noise = {});

/// Plain mean of the two phases [N].
double mean_resistance(const TrialAverages& averages);

}  // namespace gurney::calibration
