#pragma once

#include <functional>
#include <vector>

#include "studies/calibration/fit/constants.h"
#include "tests/studies/calibration/fit/virtual_pulls.h"

/// Coverage of the intervals of studies/calibration/fit: how often they hold the truth when a
/// laboratory repeats its trials.
namespace gurney::calibration {

inline constexpr int kRepeats = 200;

/// Both ends of what a count of successes in `repeats` may be, in 99.9 % of the cases.
statistics::Interval acceptance(double probability, int repeats = kRepeats);

/// `size` values of ln-normal scatter: its quantiles at (i + 1/2) / size, in an order of their own
/// for each `variable`, so that two variables are not correlated. Drawing among them is drawing the
/// constant, with the variance of the scatter but for 100 / size % or so.
std::vector<double> scattered(double median, double scatter, int size, int variable);

/// What `value` reads from each trial under `noises` draws of the instruments' noise.
std::vector<TrialValue> read_all(const std::vector<Trial>& trials, int noises,
                                 const std::function<TrialValue(const Trial&)>& value);

struct Coverage {
  int interval = 0;    ///< of kRepeats whose interval holds the truth
  int prediction = 0;  ///< whose prediction interval holds one more trial
  double bias = 0;     ///< mean of ln(value / truth)
  double width = 0;    ///< mean of half the interval over its lower end
};

/// Laboratories that draw `trials` of the values each.
Coverage coverage(const std::vector<TrialValue>& values, double truth, int trials);

}  // namespace gurney::calibration
