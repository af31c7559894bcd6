#pragma once

#include "studies/calibration/trials/phases.h"

namespace gurney::calibration {

/// Rolling resistance of the whole item by both phases of one pull [N]; errors are standard errors
/// from those of the averages.
struct Resistance {
  double pulled = 0;    ///< f = F - F_s - (M + J) a_2
  double coasting = 0;  ///< f = (M + J) a_3 - F_s
  double mean = 0;      ///< of both, weighted by their errors; plain where those are not known
  double pulled_error = 0, coasting_error = 0, mean_error = 0;
};

/// The method of Xu, Ma & Kurata (2022, 5th SPONSE workshop, section 3.2 and Figure 5): equilibrium
/// of the trolley with the average accelerations of phases II and III, string potentiometers
/// removed. M is the mass, J = sum I_w / R^2.
Resistance average_method(const TrialAverages& averages);

/// N on all wheels [N]: M g.
double normal_force(const TrialSetup& setup);

/// The averages of a sampled pull: the mean force, and the accelerations of quadratics fitted to
/// the displacement in phases II and III, each with its own place and speed; means of the
/// acceleration where no displacement was measured. What follows a change of force is left out:
/// 0.15 s after the start, 0.1 s on either side of the release, 0.15 s before the stop.
///
/// `slope` is from a cubic in phase III.
/// @throws UnusableTrial where less than 0.2 s or 12 samples are left of a phase
TrialAverages averages_of(const Trial& trial, const Phases& phases);

/// The same with another part of phase II.
TrialAverages averages_of(const Trial& trial, const Phases& phases, const Span& pull);

/// The parts of phases II and III that are used.
Span used_of_pull(const Trial& trial, const Phases& phases);
Span used_of_coast(const Trial& trial, const Phases& phases);

/// As used_of_pull(); of a crosswise pull the second half of phase II, when casters are in line.
Span settled_of_pull(const Trial& trial, const Phases& phases);

}  // namespace gurney::calibration
