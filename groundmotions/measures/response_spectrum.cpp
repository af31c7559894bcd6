#include "groundmotions/measures/response_spectrum.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>
#include <vector>

#include "engine/base/error.h"

namespace gurney::groundmotions {
namespace {

constexpr std::size_t kTogether = 2 * kLanes;  ///< one pack alone would wait for its own last step
constexpr double kTwoPi = 2 * std::numbers::pi;
constexpr int kStepsPerPeriod = 200;     ///< of PeakAt::kBetweenSamples
constexpr int kMaxSubsteps = 2000;       ///< reached at T = 0.1 dt: what rings is 3 % of Sa there
constexpr int kPeriodsOfFreeTail = 2;    ///< of PeakAt::kBetweenSamples
constexpr double kResolvedSamples = 10;  ///< in a period that needs no warning

/// The state and the peaks of four oscillators.
struct Swing {
  Lanes stiffness, viscosity;
  Lanes u{}, v{}, largest_u{}, largest_a{};

  void step(const OscillatorPack& pack, double p0, double p1) {
    pack.step(p0, p1, u, v);
    const Lanes now = abs(u), acceleration = abs(viscosity * v + stiffness * u);
    largest_u = select(now > largest_u, now, largest_u);
    largest_a = select(acceleration > largest_a, acceleration, largest_a);
  }
};

/// Swings oscillators of the frequencies `omega` and keeps their peaks at the samples or, with
/// `substeps` > 0, on as many parts of each time step and in the free vibration after the last
/// sample.
std::array<Swing, 2> swung(const std::array<double, kTogether>& omega, double damping,
                           double time_step, const Eigen::VectorXd& load, int substeps) {
  const int parts = std::max(substeps, 1);
  const double part = 1.0 / parts;
  std::array<OscillatorPack, 2> forced, free;
  std::array<Swing, 2> swings;
  for (std::size_t i = 0; i < kTogether; ++i) {
    const std::size_t pack = i / kLanes, lane = i % kLanes;
    forced[pack].set(lane, oscillator_step(omega[i], damping, time_step / parts));
    free[pack].set(lane, oscillator_step(omega[i], damping, kTwoPi / omega[i] / kStepsPerPeriod));
    swings[pack].stiffness[lane] = omega[i] * omega[i];
    swings[pack].viscosity[lane] = 2 * damping * omega[i];
  }
  Swing a = swings[0], b = swings[1];
  const auto step = [&](const std::array<OscillatorPack, 2>& packs, double p0, double p1) {
    a.step(packs[0], p0, p1);
    b.step(packs[1], p0, p1);
  };
  for (Eigen::Index i = 1; i < load.size(); ++i) {
    const double slope = (load[i] - load[i - 1]) * part;
    for (int k = 0; k + 1 < parts; ++k)
      step(forced, load[i - 1] + k * slope, load[i - 1] + (k + 1) * slope);
    step(forced, load[i - 1] + (parts - 1) * slope, load[i]);
  }
  if (substeps > 0)
    for (int i = 0; i < kPeriodsOfFreeTail * kStepsPerPeriod; ++i) step(free, 0, 0);
  return {a, b};
}

using Complex = std::complex<double>;

/// phi1(z) = integral over s in [0, 1] of exp(z (1 - s)), phi2(z) the same of s exp(z (1 - s)).
struct Phi {
  Complex one, two;
};

Phi phi(Complex z) {
  if (std::abs(z) > 1) {
    const Complex one = (std::exp(z) - 1.0) / z;
    return {one, (one - 1.0) / z};
  }
  // Power series, as the closed forms cancel: phi2 = sum of z^k / (k + 2)!. The first term left out
  // is 1 / 21! = 2e-20.
  Complex two = 0;
  for (int k = 18; k >= 0; --k) two = (two * z + 1.0) / (k + 2.0);
  return {1.0 + z * two, two};
}

}  // namespace

ResponseSpectrum response_spectrum(double time_step, const Eigen::VectorXd& acceleration,
                                   const Eigen::VectorXd& periods, double damping, PeakAt peak_at) {
  assert(time_step > 0);
  require(damping >= 0 && damping < 1,
          fmt::format("damping {:g} is out of range: at least 0 and below 1", damping));
  for (const double period : periods)
    require(period >= 0 && std::isfinite(period),
            fmt::format("period {:g} s is out of range: at least 0", period));

  const auto zeros = Eigen::VectorXd::Zero(periods.size());
  ResponseSpectrum result{periods, zeros, zeros, zeros, zeros};
  std::vector<Eigen::Index> order(static_cast<std::size_t>(periods.size()));
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](Eigen::Index a, Eigen::Index b) { return periods[a] < periods[b]; });

  std::size_t first = 0;
  for (; first < order.size() && periods[order[first]] == 0; ++first) {
    const double pga = acceleration.size() ? acceleration.cwiseAbs().maxCoeff() : 0;
    result.pseudo_acceleration[order[first]] = result.absolute_acceleration[order[first]] = pga;
  }
  for (; first < order.size(); first += kTogether) {
    const std::size_t count = std::min(kTogether, order.size() - first);
    std::array<double, kTogether> omega;
    for (std::size_t i = 0; i < kTogether; ++i)
      omega[i] = kTwoPi / periods[order[first + std::min(i, count - 1)]];
    int substeps = 0;
    if (peak_at == PeakAt::kBetweenSamples)
      substeps = static_cast<int>(std::min<double>(
          kMaxSubsteps, std::ceil(time_step * kStepsPerPeriod / periods[order[first]])));
    const std::array<Swing, 2> swings = swung(omega, damping, time_step, acceleration, substeps);
    for (std::size_t i = 0; i < count; ++i) {
      const Swing& swing = swings[i / kLanes];
      const double displacement = swing.largest_u[i % kLanes];
      const Eigen::Index at = order[first + i];
      result.displacement[at] = displacement;
      result.pseudo_velocity[at] = omega[i] * displacement;
      result.pseudo_acceleration[at] = omega[i] * omega[i] * displacement;
      result.absolute_acceleration[at] = swing.largest_a[i % kLanes];
    }
  }
  return result;
}

std::string short_period_warning(double time_step, double period) {
  if (!(period > 0 && period < kResolvedSamples * time_step)) return "";
  return fmt::format(
      "Sa({:g} s): the time step of {:g} s gives fewer than {:g} samples in a period; the value "
      "depends on what the motion does between its samples",
      period, time_step, kResolvedSamples);
}

Eigen::VectorXd logarithmic_periods(double first, double last, int count) {
  assert(first > 0 && last >= first && count > 0);
  return Eigen::ArrayXd::LinSpaced(count, std::log(first), std::log(last)).exp();
}

// The response to p is the convolution with h(t) = Im(exp(lambda t)) / omega_d, its velocity that
// with h'(t) = Im(lambda exp(lambda t)) / omega_d.
OscillatorStep oscillator_step(double omega, double damping, double time_step) {
  assert(omega > 0 && damping >= 0 && damping < 1 && time_step > 0);
  const double damped_omega = omega * std::sqrt(1 - damping * damping);
  const Complex lambda(-damping * omega, damped_omega);
  const Phi weights = phi(lambda * time_step);
  const double factor = time_step / damped_omega;
  const double decay = std::exp(-damping * omega * time_step);
  const double cosine = decay * std::cos(damped_omega * time_step);
  const double sine = decay * std::sin(damped_omega * time_step);
  const double skew = damping * omega / damped_omega * sine;

  OscillatorStep step;
  step.uu = cosine + skew;
  step.uv = sine / damped_omega;
  step.u_p0 = factor * (weights.one - weights.two).imag();
  step.u_p1 = factor * weights.two.imag();
  step.vu = -omega * omega * step.uv;
  step.vv = cosine - skew;
  step.v_p0 = factor * (lambda * (weights.one - weights.two)).imag();
  step.v_p1 = factor * (lambda * weights.two).imag();
  return step;
}

}  // namespace gurney::groundmotions
