#include "groundmotions/measures/response_spectrum.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include "engine/base/error.h"
#include "groundmotions/measures/oscillator_pack.h"

namespace gurney::groundmotions {
namespace {

using Lanes = OscillatorPack::Lanes;
constexpr int kLanes = OscillatorPack::kLanes;
constexpr double kTwoPi = 2 * std::numbers::pi;
constexpr int kStepsPerPeriod = 200;     ///< of PeakAt::kBetweenSamples
constexpr int kMaxSubsteps = 2000;       ///< reached at T = 0.1 dt: what rings is 3 % of Sa there
constexpr int kPeriodsOfFreeTail = 2;    ///< of PeakAt::kBetweenSamples
constexpr double kResolvedSamples = 10;  ///< in a period that needs no warning

struct PackPeaks {
  Lanes displacement, acceleration;
};

/// The peaks of `kLanes` oscillators at the samples or, with `substeps` > 0, on as many parts of
/// each time step and in the free vibration after the last sample.
PackPeaks peaks_of(const Lanes& omega, double damping, double time_step,
                   const Eigen::VectorXd& load, int substeps) {
  const Lanes stiffness = omega * omega, viscosity = 2 * damping * omega;
  Lanes u = Lanes::Zero(), v = u, largest_u = u, largest_a = u;
  const auto step = [&](const OscillatorPack& pack, double p0, double p1) {
    pack.step(p0, p1, u, v);
    largest_u = largest_u.max(u.abs());
    largest_a = largest_a.max((viscosity * v + stiffness * u).abs());
  };

  const int parts = std::max(substeps, 1);
  const double part = 1.0 / parts;
  OscillatorPack forced, free;
  for (int i = 0; i < kLanes; ++i) {
    forced.set(i, oscillator_step(omega[i], damping, time_step / parts));
    free.set(i, oscillator_step(omega[i], damping, kTwoPi / omega[i] / kStepsPerPeriod));
  }
  for (Eigen::Index i = 1; i < load.size(); ++i) {
    const double slope = (load[i] - load[i - 1]) * part;
    for (int k = 0; k + 1 < parts; ++k)
      step(forced, load[i - 1] + k * slope, load[i - 1] + (k + 1) * slope);
    step(forced, load[i - 1] + (parts - 1) * slope, load[i]);
  }
  if (substeps > 0)
    for (int i = 0; i < kPeriodsOfFreeTail * kStepsPerPeriod; ++i) step(free, 0, 0);
  return {largest_u, largest_a};
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
  for (; first < order.size(); first += kLanes) {
    const std::size_t count = std::min<std::size_t>(kLanes, order.size() - first);
    Lanes omega;
    for (std::size_t i = 0; i < kLanes; ++i)
      omega[static_cast<int>(i)] = kTwoPi / periods[order[first + std::min(i, count - 1)]];
    int substeps = 0;
    if (peak_at == PeakAt::kBetweenSamples)
      substeps = static_cast<int>(std::min<double>(
          kMaxSubsteps, std::ceil(time_step * kStepsPerPeriod / periods[order[first]])));
    const PackPeaks peaks = peaks_of(omega, damping, time_step, acceleration, substeps);
    for (std::size_t i = 0; i < count; ++i) {
      const int lane = static_cast<int>(i);
      const Eigen::Index at = order[first + i];
      result.displacement[at] = peaks.displacement[lane];
      result.pseudo_velocity[at] = omega[lane] * peaks.displacement[lane];
      result.pseudo_acceleration[at] = omega[lane] * omega[lane] * peaks.displacement[lane];
      result.absolute_acceleration[at] = peaks.acceleration[lane];
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

}  // namespace gurney::groundmotions
