#pragma once

#include <optional>
#include <string>
#include <vector>

#include "studies/statistics/bands.h"
#include "studies/trials/average_method.h"

/// Rolling resistance from pulls (docs/calibration.md).
namespace gurney {

/// A constant of several trials: exp of the mean of logarithms, so that its scatter is a share.
struct TrialConstant {
  double value = 0;
  Interval interval;    ///< 95 % of the value; {0, infinity} for a single trial
  double scatter = 0;   ///< standard deviation of the logarithm between trials
  int degrees = 0;      ///< of Student's t
  Interval prediction;  ///< 95 % of another trial with the errors of an average one
  std::vector<std::string> trials;
};

/// @param values, errors  of each trial, with the standard error of its measurement; values > 0
TrialConstant constant_of(const std::vector<double>& values, const std::vector<double>& errors,
                          std::vector<std::string> names);

/// One pull with its resistance.
struct RollingTrial {
  TrialAverages averages;
  Resistance resistance;

  double ratio() const;  ///< f_r / N = Cr / R
  double error() const;  ///< its standard error of measurement
};

struct RollingGroup {
  std::string caster, floor;
  double wheel_radius = 0;          ///< [m]
  std::vector<std::size_t> trials;  ///< of RollingCalibration::trials
  TrialConstant ratio;              ///< Cr / R
};

/// Whether rolling resistance depends on something.
struct RollingTest {
  std::string name;      ///< "load", "speed between trials", "floor polyflor_forest_fx" ...
  std::string quantity;  ///< what is estimated: "n in f_r ~ N^n"
  double estimate = 0;
  Interval interval;                ///< 95 %
  double supposed = 0;              ///< by f_r = (Cr / R) N
  double p = 1;                     ///< two-sided, of `supposed`
  double p_adjusted = 1;            ///< for all tests of a calibration (Holm)
  std::optional<double> p_without;  ///< that it has no influence at all, where `supposed` has one
  int trials = 0;
};

struct Outlier {
  std::string trial, constant;
  double value = 0;
  double p = 1;  ///< adjusted for the number of trials of its group (Bonferroni)
};

struct RollingCalibration {
  std::vector<RollingTrial> trials;  ///< with `use` calibration
  std::vector<RollingGroup> groups;  ///< by caster and floor, in the order of their names
  std::vector<RollingTest> tests;
  std::vector<Outlier> outliers;
};

/// ln(f_r / N) of each trial is the group's constant, a scatter between trials, and an error of
/// measurement: fit_random_effects() for each group.
///
/// @param trials  that passed check_averages()
RollingCalibration calibrate_rolling(const std::vector<TrialAverages>& trials);

/// The tests, adjusted.
std::vector<RollingTest> rolling_tests(const std::vector<RollingTrial>& trials);

/// Units whose p is below 0.05.
std::vector<Outlier> outliers_of(const std::string& constant, const std::vector<double>& values,
                                 const std::vector<double>& errors,
                                 const std::vector<std::string>& names);

}  // namespace gurney
