#include "groundmotions/measures/spectral_averages.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "groundmotions/measures/response_spectrum.h"

namespace gurney::groundmotions {
namespace {

constexpr double kLowFactor = 0.2, kHighFactor = 3, kSpacing = 0.01;  // of SaAvg
constexpr int kFewestPeriods = 10;
constexpr double kShortest = 0.1, kLongest = 2.5;  // of SI [s]
constexpr int kIntervals = 120;

}  // namespace

Eigen::VectorXd average_periods(double period) {
  return average_periods(kLowFactor * period, kHighFactor * period);
}

Eigen::VectorXd average_periods(double from, double to) {
  assert(from > 0 && to > from);
  const int count = static_cast<int>(std::lround((to - from) / kSpacing)) + 1;
  return Eigen::VectorXd::LinSpaced(std::max(count, kFewestPeriods), from, to);
}

double geometric_mean(const Eigen::VectorXd& spectral_accelerations) {
  return std::exp(spectral_accelerations.array().log().mean());
}

double spectrum_intensity(double time_step, const Eigen::VectorXd& acceleration) {
  const Eigen::VectorXd periods = Eigen::VectorXd::LinSpaced(kIntervals + 1, kShortest, kLongest);
  const Eigen::VectorXd psv = response_spectrum(time_step, acceleration, periods).pseudo_velocity;
  const double ends = (psv[0] + psv[kIntervals]) / 2;
  return (kLongest - kShortest) / kIntervals * (psv.sum() - ends);
}

}  // namespace gurney::groundmotions
