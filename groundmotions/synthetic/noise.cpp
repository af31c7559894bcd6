#include "groundmotions/synthetic/noise.h"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <numbers>
#include <unsupported/Eigen/FFT>

#include "engine/base/error.h"
#include "engine/base/random/normal_draw.h"
#include "groundmotions/synthetic/component.h"

namespace gurney::groundmotions {

FourierNoise::FourierNoise(std::uint64_t seed, std::uint64_t stream, Eigen::Index samples,
                           double time_step)
    : samples_(samples), time_step_(time_step) {
  const std::size_t n = std::bit_ceil(static_cast<std::size_t>(samples));
  draws_ = Eigen::VectorXcd::Zero(static_cast<Eigen::Index>(n / 2 + 1));
  for (Eigen::Index k = 1; k < draws_.size() - 1; ++k) {
    const auto index = 2 * static_cast<std::uint64_t>(k);
    draws_[k] = {normal_draw(seed, stream, index), -normal_draw(seed, stream, index + 1)};
  }
}

Eigen::VectorXd FourierNoise::shaped(const std::function<double(double)>& amplitude) const {
  const Eigen::Index n = 2 * (draws_.size() - 1);
  Eigen::VectorXcd spectrum = draws_;
  for (Eigen::Index k = 1; k < spectrum.size() - 1; ++k)
    spectrum[k] *= amplitude(static_cast<double>(k) / (static_cast<double>(n) * time_step_)) *
                   static_cast<double>(n) / 2;
  Eigen::FFT<double> fft;
  fft.SetFlag(Eigen::FFT<double>::HalfSpectrum);
  Eigen::VectorXd noise(n);
  fft.inv(noise, spectrum, n);
  return noise.head(samples_);
}

Eigen::VectorXd FourierNoise::acceleration(const std::function<double(double)>& amplitude,
                                           const Eigen::VectorXd& envelope) const {
  const Eigen::VectorXd displacement = shaped([&](double frequency) {
    return amplitude(frequency) / std::pow(2 * std::numbers::pi * frequency, 2);
  });
  return acceleration_of(time_step_, displacement.cwiseProduct(envelope));
}

Record white_noise(double time_step, const WhiteNoise& m) {
  constexpr double kBand = 0.4;
  require(m.lowest_frequency < m.highest_frequency && m.highest_frequency * time_step <= kBand,
          fmt::format("noise from {:g} to {:g} Hz at time step {:g} s: must be an interval below "
                      "{:g} Hz",
                      m.lowest_frequency, m.highest_frequency, time_step, kBand / time_step));
  require(m.taper > 0 && 2 * m.taper <= m.duration,
          fmt::format("taper {:g} s: must be > 0 and at most half the duration, {:g} s", m.taper,
                      m.duration / 2));
  const Eigen::VectorXd envelope = sampled(
      time_step, m.duration, [&](double t) { return trapezoid_taper(t, m.duration, m.taper); });
  Record record;
  for (const Direction direction : kDirections) {
    const auto index = static_cast<std::size_t>(direction);
    if (m.peak_acceleration[index] == 0) continue;
    const FourierNoise source(m.seed, index, envelope.size(), time_step);
    Eigen::VectorXd a = source.acceleration(
        [&](double frequency) {
          return frequency >= m.lowest_frequency && frequency <= m.highest_frequency ? 1. : 0.;
        },
        envelope);
    a *= m.peak_acceleration[index] / a.cwiseAbs().maxCoeff();
    record.components[index] = synthetic_component(direction, time_step, std::move(a));
  }
  require(record.samples() > 0, "noise without a component: at least one peak must be > 0");
  return record;
}

}  // namespace gurney::groundmotions
