#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/scene/scene.h"
#include "studies/calibration/trials/average_method.h"
#include "studies/results/study_reader.h"

namespace gurney::calibration {

/// Newton's law for a pulling test of an item whose casters are in line with the pull
/// (docs/pulling_tests.md).
///
/// With M the item's mass, J = sum I_w / R^2, f = sum (Cr / R) N, F_s the string potentiometers on
/// the item and F_w that on the weight, m the drop weight and p = I_p / r_p^2 its pulley:
///
///     pulled     a_1 = (m g - F_w - f - F_s) / (M + J + m + p),  T = m (g - a_1) - F_w - p a_1
///            or  a_1 = (F(t) - f - F_s) / (M + J) under a force, constant or measured
///     coasting   a_2 = (f + F_s) / (M + J)
struct PullTheory {
  /// Motion at a sample of the force, which is linear in between.
  struct Knot {
    double time = 0, force = 0;  ///< [s], [N]
    double acceleration = 0, velocity = 0, displacement = 0;
  };

  double mass = 0;            ///< M [kg]
  double added_mass = 0;      ///< J [kg]
  double drop_mass = 0;       ///< m; 0: a force pulls [kg]
  double string_tension = 0;  ///< F_s [N]
  double resistance = 0;      ///< f [N]
  double normal_force = 0;    ///< M g [N]

  double force = 0;         ///< T, or the mean of F over the pull [N]
  double held_force = 0;    ///< before the start: m g - F_w, or 0 [N]
  double acceleration = 0;  ///< a_1, or its mean [m/s2]
  double deceleration = 0;  ///< a_2, > 0 [m/s2]
  double start = 0;         ///< the blocks go, or the force begins [s]
  double release = 0;       ///< the weight lands, or the force ends [s]
  double stop = 0;          ///< [s]
  double release_displacement = 0, release_velocity = 0, rest_displacement = 0;  ///< [m], [m/s]
  std::vector<Knot> pull;  ///< from start to release

  double displacement_at(double time) const;
  double velocity_at(double time) const;
  double acceleration_at(double time) const;
  double force_at(double time) const;

 private:
  Knot pulled_at(double time) const;
};

/// @throws Error unless one drop weight, held by blocks, or one force without a limit of speed
///         pulls the scene's one item on casters along x, hard enough to move it
PullTheory theory_of(const Scene& scene);

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
/// @param noise  seed of synthetic noise of the instruments (trial.h): the velocity is
///               then that of the noisy displacement; none: signals as simulated
/// @throws Error where the file keeps none, or its job is no pulling test
std::vector<SimulatedTrial> simulated_trials(const study::StudyReader& file,
                                             const std::optional<std::uint64_t>& noise = {});

/// Plain mean of the two phases [N].
double mean_resistance(const TrialAverages& averages);

}  // namespace gurney::calibration
