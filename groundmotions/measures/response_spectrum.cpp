#include "groundmotions/measures/response_spectrum.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>

#include "engine/base/error.h"
#include "groundmotions/oscillator.h"

namespace gurney {

namespace {

constexpr int kLanes = 8;           ///< oscillators that are stepped together
constexpr double kPerPeriod = 200;  ///< looks in a period between samples
constexpr double kFreePeriods = 2;  ///< of vibration after the record

using Lanes = Eigen::Array<double, kLanes, 1>;

/// The exact step of the state (u, v) under loads p0 at its begin and p1 at its end, for eight
/// oscillators.
struct Steps {
  Lanes uu, uv, u0, u1;
  Lanes vu, vv, v0, v1;

  void set(int lane, double omega, double damping, double time_step) {
    const auto column = [&](double u, double v, double p0, double p1) {
      Oscillator oscillator(omega, damping, time_step, u, v);
      oscillator.step(p0, p1);
      return std::pair(oscillator.displacement(), oscillator.velocity());
    };
    std::tie(uu[lane], vu[lane]) = column(1, 0, 0, 0);
    std::tie(uv[lane], vv[lane]) = column(0, 1, 0, 0);
    std::tie(u0[lane], v0[lane]) = column(0, 0, 1, 0);
    std::tie(u1[lane], v1[lane]) = column(0, 0, 0, 1);
  }
};

struct Peak {
  Lanes displacement = Lanes::Zero(), acceleration = Lanes::Zero();
};

/// Peaks at the samples of `ground`, a step of time apart.
Peak peaks_at_samples(const Eigen::VectorXd& ground, const Steps& s, const Lanes& omega,
                      double damping) {
  const Lanes stiffness = omega.square(), viscosity = 2 * damping * omega;
  Lanes u = Lanes::Zero(), v = Lanes::Zero();
  Peak peak;
  for (Eigen::Index i = 1; i < ground.size(); ++i) {
    const double p0 = -ground[i - 1], p1 = -ground[i];
    const Lanes next = s.uu * u + s.uv * v + s.u0 * p0 + s.u1 * p1;
    v = s.vu * u + s.vv * v + s.v0 * p0 + s.v1 * p1;
    u = next;
    peak.displacement = peak.displacement.max(u.abs());
    peak.acceleration = peak.acceleration.max((stiffness * u + viscosity * v).abs());
  }
  return peak;
}

/// The record on a grid `parts` times finer, and at rest afterwards.
Eigen::VectorXd refined(const Eigen::VectorXd& samples, Eigen::Index parts, Eigen::Index after) {
  const Eigen::Index n = samples.size();
  Eigen::VectorXd fine = Eigen::VectorXd::Zero((n - 1) * parts + 1 + after);
  for (Eigen::Index i = 0; i + 1 < n; ++i)
    for (Eigen::Index k = 0; k < parts; ++k)
      fine[i * parts + k] = samples[i] + (samples[i + 1] - samples[i]) * static_cast<double>(k) /
                                             static_cast<double>(parts);
  fine[(n - 1) * parts] = samples[n - 1];
  return fine;
}

/// Peaks of one oscillator on a fine grid; the jump from the last sample to rest is a step of zero
/// length, so the free vibration starts with the state at the last sample.
Peak peaks_between_samples(double time_step, const Eigen::VectorXd& ground, double omega,
                           double damping) {
  const double period = 2 * std::numbers::pi / omega;
  const auto parts =
      static_cast<Eigen::Index>(std::max(1.0, std::ceil(time_step * kPerPeriod / period)));
  const double step = time_step / static_cast<double>(parts);
  Oscillator oscillator(omega, damping, step);
  Peak peak;
  const auto look = [&] {
    const double u = oscillator.displacement(), v = oscillator.velocity();
    peak.displacement[0] = std::max(peak.displacement[0], std::abs(u));
    peak.acceleration[0] =
        std::max(peak.acceleration[0], std::abs(omega * omega * u + 2 * damping * omega * v));
  };
  const Eigen::VectorXd fine = refined(ground, parts, 0);
  for (Eigen::Index i = 1; i < fine.size(); ++i) {
    oscillator.step(-fine[i - 1], -fine[i]);
    look();
  }
  Oscillator free(omega, damping, period / kPerPeriod, oscillator.displacement(),
                  oscillator.velocity());
  std::swap(oscillator, free);
  for (int i = 0; i < static_cast<int>(kFreePeriods * kPerPeriod); ++i) {
    oscillator.step(0, 0);
    look();
  }
  return peak;
}

void check(double time_step, const Eigen::VectorXd& periods, double damping) {
  require(time_step > 0 && damping >= 0 && damping < 1,
          fmt::format("a response spectrum needs a time step > 0 and a damping in [0, 1), got {} s "
                      "and {}",
                      time_step, damping));
  for (const double period : periods)
    require(
        period >= 0 && std::isfinite(period),
        fmt::format("the period of a response spectrum must be finite and >= 0, got {}", period));
}

}  // namespace

ResponseSpectrum response_spectrum(double time_step, const Eigen::VectorXd& acceleration,
                                   const Eigen::VectorXd& periods, double damping, PeakAt peak_at) {
  check(time_step, periods, damping);
  const Eigen::Index count = periods.size();
  ResponseSpectrum result{periods, Eigen::VectorXd::Zero(count), Eigen::VectorXd::Zero(count),
                          Eigen::VectorXd::Zero(count)};
  if (acceleration.size() == 0) return result;
  const double rigid = acceleration.cwiseAbs().maxCoeff();
  for (Eigen::Index first = 0; first < count; first += kLanes) {
    const int lanes = static_cast<int>(std::min<Eigen::Index>(kLanes, count - first));
    Steps steps;
    Lanes omega;
    for (int lane = 0; lane < kLanes; ++lane) {
      const double period = periods[first + std::min(lane, lanes - 1)];
      omega[lane] = 2 * std::numbers::pi / (period > 0 ? period : 1);
      steps.set(lane, omega[lane], damping, time_step);
    }
    Peak peak = peaks_at_samples(acceleration, steps, omega, damping);
    for (int lane = 0; lane < lanes; ++lane) {
      if (peak_at == PeakAt::kBetweenSamples && periods[first + lane] > 0) {
        const Peak fine = peaks_between_samples(time_step, acceleration, omega[lane], damping);
        peak.displacement[lane] = std::max(peak.displacement[lane], fine.displacement[0]);
        peak.acceleration[lane] = std::max(peak.acceleration[lane], fine.acceleration[0]);
      }
      const bool stiff = periods[first + lane] == 0;
      const double w2 = omega[lane] * omega[lane];
      result.displacement[first + lane] = stiff ? 0 : peak.displacement[lane];
      result.pseudo_acceleration[first + lane] = stiff ? rigid : w2 * peak.displacement[lane];
      result.absolute_acceleration[first + lane] = stiff ? rigid : peak.acceleration[lane];
    }
  }
  return result;
}

Eigen::VectorXd oscillator_displacement(double time_step, const Eigen::VectorXd& acceleration,
                                        double period, double damping) {
  check(time_step, Eigen::VectorXd::Constant(1, period), damping);
  require(period > 0, "an oscillator needs a period > 0");
  Oscillator oscillator(2 * std::numbers::pi / period, damping, time_step);
  Eigen::VectorXd displacement = Eigen::VectorXd::Zero(acceleration.size());
  for (Eigen::Index i = 1; i < acceleration.size(); ++i) {
    oscillator.step(-acceleration[i - 1], -acceleration[i]);
    displacement[i] = oscillator.displacement();
  }
  return displacement;
}

}  // namespace gurney
