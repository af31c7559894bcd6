#pragma once

#include "studies/calibration/trials/polynomial_fit.h"
#include "studies/calibration/trials/trial.h"

namespace gurney::calibration {

/// The four phases of a pulling test (Xu, Ma & Kurata 2022, 5th SPONSE workshop, section 3.2).
struct Phases {
  enum class End { kRested, kEndOfFloor, kRecordEnds };

  double start = 0;    ///< I ends: the trolley is let go [s]
  double release = 0;  ///< II ends: the force falls to half of what it was [s]
  double stop = 0;     ///< III ends: it rests or meets the end of the floor [s]
  End end = End::kRecordEnds;
  Span held, pulled, coasting, stopped;
  double noise = 0;  ///< standard deviation of the noise of one sample of displacement [m]
};

/// Finds the phases from force and displacement, or acceleration where there is no displacement.
///
/// II ends with the last sample whose force (median of five) is above half of its largest. Start
/// and stop follow from two marks near the ends of the path, at distances d and 4 d from rest: a
/// motion x = a t^2 / 2 needs twice the time for the second, so that the rest is at 2 t(d) - t(4
/// d). d is the larger of 8 standard deviations of the noise and 1/2000 of the path. With
/// acceleration only, phases end where the mean of nine samples crosses half of its level.
///
/// @throws UnusableTrial where a phase is missing
Phases find_phases(const Trial& trial);

/// Standard deviation of white noise on a smooth series, from the median of its third differences.
double noise_of(const std::vector<double>& series);

/// Each the median of itself and two neighbours on either side.
std::vector<double> median_of_five(const std::vector<double>& series);

const char* name_of(Phases::End end);

}  // namespace gurney::calibration
