#include "groundmotions/processing/resample.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/base/error.h"

namespace gurney::groundmotions {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kStopBand = 100;                     // [dB]
constexpr double kBeta = 0.1102 * (kStopBand - 8.7);  // Kaiser 1974, for more than 50 dB
constexpr double kPassBand = 0.9;                     // of the Nyquist frequency
constexpr double kMaxSamples = 1e7;
constexpr double kSameTime = 1e-9;  // of a step

/// Steps to each side that Kaiser's formula asks for a transition band of `width` cycles per step.
double half_length(double width) { return std::ceil((kStopBand - 7.95) / (14.36 * width) / 2); }

/// I0(beta sqrt(x)) for x in [0, 1]: its power series, up to the last term above rounding.
Eigen::ArrayXd bessel(const Eigen::ArrayXd& x) {
  constexpr int kTerms = 30;
  Eigen::ArrayXd sum = Eigen::ArrayXd::Ones(x.size());
  for (int k = kTerms; k > 0; --k) sum = 1 + sum * x * (kBeta * kBeta / 4 / (k * k));
  return sum;
}

/// The windowed sinc at `offsets` [old steps], its sum 1.
/// @param cut   corner over the old Nyquist frequency
/// @param half  where the window ends [old steps]
Eigen::VectorXd kernel(const Eigen::ArrayXd& offsets, double cut, double half) {
  const Eigen::ArrayXd sinc = offsets.unaryExpr([&](double u) {
    return std::abs(u) < kSameTime ? cut : std::sin(kPi * cut * u) / (kPi * u);
  });
  const Eigen::ArrayXd weights = sinc * bessel((1 - (offsets / half).square()).max(0));
  return weights / weights.sum();
}

/// After how many steps new samples fall on old ones again.
struct Period {
  Eigen::Index new_steps = 0;
  Eigen::Index old_steps = 0;
};

/// Period of the ratio of a new step to an old one; all `samples` if there is no short one.
Period period_of(double ratio, Eigen::Index samples) {
  constexpr Eigen::Index kLongest = 1000;
  for (Eigen::Index steps = 1; steps < std::min(kLongest, samples); ++steps) {
    const double old_steps = ratio * static_cast<double>(steps);
    if (std::abs(old_steps - std::round(old_steps)) < 1e-12)
      return {steps, static_cast<Eigen::Index>(std::round(old_steps))};
  }
  return {samples, 0};
}

}  // namespace

Eigen::VectorXd resampled(double time_step, const Eigen::VectorXd& acceleration,
                          double new_time_step) {
  const Eigen::Index old_samples = acceleration.size();
  const double ratio = new_time_step / time_step;
  const double steps = std::floor(static_cast<double>(old_samples - 1) / ratio + kSameTime);
  require(
      new_time_step > 0 && steps >= 1 && steps < kMaxSamples,
      fmt::format("the new time step must be > 0 and give 2 to {:g} samples for {:g} s, got {:g} "
                  "s",
                  kMaxSamples, time_step * static_cast<double>(old_samples - 1), new_time_step));
  if (std::abs(ratio - 1) < 1e-12) return acceleration;
  const bool finer = ratio < 1;
  const double cut = finer ? 1 : (1 + kPassBand) / 2 / ratio;
  const double half = finer ? half_length(1 - kPassBand) : half_length((1 - kPassBand) / 2) * ratio;

  Eigen::VectorXd result(static_cast<Eigen::Index>(steps) + 1);
  const Period period = period_of(ratio, result.size());
  for (Eigen::Index phase = 0; phase < period.new_steps; ++phase) {
    double time = ratio * static_cast<double>(phase);
    if (std::abs(time - std::round(time)) < kSameTime) time = std::round(time);
    auto first = static_cast<Eigen::Index>(std::ceil(time - half));
    const auto last = static_cast<Eigen::Index>(std::floor(time + half));
    const Eigen::VectorXd weights =
        kernel(Eigen::ArrayXd::LinSpaced(last - first + 1, static_cast<double>(first) - time,
                                         static_cast<double>(last) - time),
               cut, half);
    for (Eigen::Index j = phase; j < result.size(); j += period.new_steps) {
      const Eigen::Index from = std::max<Eigen::Index>(first, 0);
      const Eigen::Index count = std::min(first + weights.size(), old_samples) - from;
      result[j] = weights.segment(from - first, count).dot(acceleration.segment(from, count));
      first += period.old_steps;
    }
  }
  return result;
}

}  // namespace gurney::groundmotions
