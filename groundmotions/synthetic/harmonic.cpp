#include "groundmotions/synthetic/harmonic.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "engine/base/error.h"
#include "groundmotions/synthetic/component.h"

namespace gurney::groundmotions {

namespace {

using std::numbers::pi;

void check(double time_step, double frequency, double duration, double taper) {
  constexpr double kFewestSamples = 5;  // a crest is then at most 20 % off a sample
  require(
      frequency * time_step * kFewestSamples <= 1,
      fmt::format("frequency {:g} Hz at time step {:g} s: must be at most {:g} Hz ({:g} samples "
                  "in a period); take a smaller time step",
                  frequency, time_step, 1 / (kFewestSamples * time_step), kFewestSamples));
  require(2 * taper <= duration,
          fmt::format("taper {:g} s: must be > 0 and at most half the duration, {:g} s", taper,
                      duration / 2));
}

/// @param phase  returns phi and phi' at a time
template <typename Phase>
Record finished(double time_step, double duration, double taper, double peak, const Phase& phase) {
  const Eigen::VectorXd displacement = sampled(time_step, duration, [&](double t) {
    const auto [phi, rate] = phase(t);
    return -trapezoid_taper(t, duration, taper) * std::sin(phi) / (rate * rate);
  });
  Eigen::VectorXd a = acceleration_of(time_step, displacement);
  a *= peak / a.cwiseAbs().maxCoeff();
  return single_component(time_step, std::move(a));
}

}  // namespace

Record harmonic(double time_step, const Harmonic& m) {
  check(time_step, m.frequency, m.duration, m.taper);
  const double omega = 2 * pi * m.frequency;
  return finished(time_step, m.duration, m.taper, m.peak_acceleration,
                  [&](double t) { return std::pair(omega * t, omega); });
}

Record sweep(double time_step, const Sweep& m) {
  check(time_step, std::max(m.first_frequency, m.last_frequency), m.duration, m.taper);
  const double first = 2 * pi * m.first_frequency, last = 2 * pi * m.last_frequency;
  const double growth = std::log(last / first) / m.duration;
  require(!m.logarithmic || growth != 0, "a logarithmic sweep needs two different frequencies");
  return finished(time_step, m.duration, m.taper, m.peak_acceleration, [&](double t) {
    if (m.logarithmic)
      return std::pair(first / growth * std::expm1(growth * t), first * std::exp(growth * t));
    const double change = (last - first) / m.duration;
    return std::pair((first + change * t / 2) * t, first + change * t);
  });
}

}  // namespace gurney::groundmotions
