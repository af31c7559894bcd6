#pragma once

#include <optional>
#include <string>
#include <vector>

#include "studies/calibration/fit/constants.h"
#include "studies/calibration/trials/average_method.h"

/// Rolling resistance from pulls (docs/calibration.md).
namespace gurney::calibration {

/// One pull with its resistance.
struct RollingTrial {
  TrialAverages averages;
  Resistance resistance;

  double ratio() const;  ///< f_r / N = Cr / R
  double error() const;  ///< its standard error of measurement
};

TrialValue value_of(const RollingTrial& trial);

/// Whether rolling resistance depends on something.
struct RollingTest {
  std::string name;      ///< "load", "speed between trials", "floor polyflor_forest_fx" ...
  std::string quantity;  ///< what is estimated: "n in f_r ~ N^n"
  double estimate = 0;
  statistics::Interval interval;    ///< 95 %
  double supposed = 0;              ///< by f_r = (Cr / R) N
  double p = 1;                     ///< two-sided, of `supposed`
  double p_adjusted = 1;            ///< for all tests of a calibration (Holm)
  std::optional<double> p_without;  ///< that it has no influence at all, where `supposed` has one
  int trials = 0;
};

/// The tests that the trials allow: fit_random_effects() of ln(f_r / N) of all trials, with a level
/// for each caster and floor (load, speed), for each caster (floors) or each tread (diameter).
/// @param trials  with `use` calibration, that passed check_averages()
std::vector<RollingTest> rolling_tests(const std::vector<RollingTrial>& trials);

}  // namespace gurney::calibration
