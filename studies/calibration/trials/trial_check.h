#pragma once

#include "studies/calibration/trials/average_method.h"

/// Faults that make a trial useless, found from the trial itself. All throw UnusableTrial for them.
namespace gurney::calibration {

/// Cells left empty, steps of time above 0.2 s or below 10 us, times that stand still, run
/// backwards, jump (more than 1.5 steps), are irregular (more than 0.1 step off) or drift (the step
/// of one tenth of the record is 0.5 % off the mean), a force below zero by more than 6 standard
/// deviations of its noise and 1 % of its largest.
void check_samples(const Trial& trial);

/// Newton's law between the two phases: with f_r the same in both, F = (M + J)(a_2 + a_3), whatever
/// f_r is. The ratio of both sides is 1; a factor of 1000, 9.8 or 1e6 is a wrong unit, and more
/// than 15 % off is a wrong mass, force or clock. Then that f_r > 0 in both phases.
/// @param of_displacement  the accelerations are of a measured displacement
void check_averages(const TrialAverages& averages, bool of_displacement);

/// Probable cause of a measured motion that is `ratio` of that which force and mass make: a wrong unit,
/// or a wrong mass, force or clock.
/// @param within  a factor, > 1: as near to the ratio of a unit it may be that unit
/// @param of_displacement  the motion was measured as a displacement, else as an acceleration
std::string cause_of_ratio(double ratio, double within, bool of_displacement);

/// Clocks of load cell and motion: the speeds of phases II and III meet where the force falls,
/// within 0.05 s. With a drop weight: the force that holds it in phase I is its weight within 15 %.
/// Only where displacement was measured.
void check_phases(const Trial& trial, const Phases& phases);

}  // namespace gurney::calibration
