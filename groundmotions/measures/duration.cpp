#include "groundmotions/measures/duration.h"

#include <fmt/format.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <unsupported/Eigen/FFT>
#include <vector>

#include "engine/base/error.h"
#include "engine/base/units.h"

namespace gurney {

namespace {

constexpr double kLowestFrequency = 0.25, kHighestFrequency = 20;  // [Hz]
constexpr double kFrequencySpacing = 0.05;                         // [Hz]

/// Trapezoidal rule.
double integral(double step, const Eigen::ArrayXd& values) {
  if (values.size() < 2) return 0;
  return step * (values.sum() - (values[0] + values[values.size() - 1]) / 2);
}

}  // namespace

double arias_intensity(double time_step, const Eigen::VectorXd& acceleration) {
  return std::numbers::pi / (2 * kStandardGravity) *
         integral(time_step, acceleration.array().square());
}

double cumulative_absolute_velocity(double time_step, const Eigen::VectorXd& acceleration) {
  return integral(time_step, acceleration.array().abs());
}

double significant_duration(double time_step, const Eigen::VectorXd& acceleration, double from,
                            double to) {
  require(0 <= from && from < to && to <= 1,
          fmt::format("a significant duration needs shares 0 <= from < to <= 1, got {} and {}",
                      from, to));
  const Eigen::ArrayXd squares = acceleration.array().square();
  const double whole = integral(1, squares);
  if (!(whole > 0)) return 0;
  const auto time_of = [&](double share) {
    double sum = 0;
    for (Eigen::Index i = 1; i < squares.size(); ++i) {
      const double area = (squares[i - 1] + squares[i]) / 2;
      if (area > 0 && sum + area >= share * whole)
        return (static_cast<double>(i - 1) + (share * whole - sum) / area) * time_step;
      sum += area;
    }
    return static_cast<double>(squares.size() - 1) * time_step;
  };
  return time_of(to) - time_of(from);
}

double mean_period(double time_step, const Eigen::VectorXd& acceleration) {
  std::size_t length = 2;
  while (length < static_cast<std::size_t>(acceleration.size()) ||
         static_cast<double>(length) * time_step < 1 / kFrequencySpacing)
    length *= 2;
  std::vector<double> samples(length, 0.0);
  std::copy(acceleration.begin(), acceleration.end(), samples.begin());
  std::vector<std::complex<double>> spectrum;
  Eigen::FFT<double> transform;
  transform.SetFlag(Eigen::FFT<double>::HalfSpectrum);
  transform.fwd(spectrum, samples);
  double weight = 0, sum = 0;
  for (std::size_t k = 1; k < spectrum.size(); ++k) {
    const double frequency = static_cast<double>(k) / (static_cast<double>(length) * time_step);
    if (frequency < kLowestFrequency || frequency > kHighestFrequency) continue;
    weight += std::norm(spectrum[k]);
    sum += std::norm(spectrum[k]) / frequency;
  }
  return weight > 0 ? sum / weight : 0;
}

}  // namespace gurney
