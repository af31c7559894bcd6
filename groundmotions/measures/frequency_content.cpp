#include "groundmotions/measures/frequency_content.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <complex>
#include <unsupported/Eigen/FFT>
#include <vector>

#include "groundmotions/measures/response_spectrum.h"

namespace gurney::groundmotions {
namespace {

constexpr double kLowestFrequency = 0.25, kHighestFrequency = 20;  // [Hz]
constexpr double kLargestFrequencyStep = 0.05;                     // [Hz]
constexpr double kShortestPeriod = 0.02, kLongestPeriod = 10;      // [s]
constexpr int kPeriods = 400;

}  // namespace

double mean_period(double time_step, const Eigen::VectorXd& acceleration) {
  assert(time_step > 0);
  const double least = std::ceil(1 / (kLargestFrequencyStep * time_step));
  const std::size_t length = std::bit_ceil(
      std::max(2 * static_cast<std::size_t>(acceleration.size()), static_cast<std::size_t>(least)));
  std::vector<double> padded(length, 0.0);
  std::copy(acceleration.begin(), acceleration.end(), padded.begin());
  Eigen::FFT<double> fft;
  fft.SetFlag(Eigen::FFT<double>::HalfSpectrum);
  std::vector<std::complex<double>> amplitudes;
  fft.fwd(amplitudes, padded);

  const double frequency_step = 1 / (static_cast<double>(length) * time_step);
  double power = 0, weighted = 0;
  for (std::size_t i = 1; i < amplitudes.size(); ++i) {
    const double frequency = static_cast<double>(i) * frequency_step;
    if (frequency < kLowestFrequency || frequency > kHighestFrequency) continue;
    power += std::norm(amplitudes[i]);
    weighted += std::norm(amplitudes[i]) / frequency;
  }
  return power > 0 ? weighted / power : 0;
}

double predominant_period(double time_step, const Eigen::VectorXd& acceleration) {
  const auto periods = logarithmic_periods(kShortestPeriod, kLongestPeriod, kPeriods);
  const auto spectrum = response_spectrum(time_step, acceleration, periods);
  Eigen::Index largest = 0;
  return spectrum.pseudo_acceleration.maxCoeff(&largest) > 0 ? periods[largest] : 0;
}

}  // namespace gurney::groundmotions
