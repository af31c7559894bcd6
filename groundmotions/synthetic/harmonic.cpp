#include "groundmotions/synthetic/harmonic.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/base/error.h"
#include "groundmotions/synthetic/component.h"
#include "groundmotions/synthetic/end_state.h"
#include "groundmotions/synthetic/taper.h"

namespace gurney {

namespace {

using std::numbers::pi;

void check(double time_step, double frequency, double duration, double taper) {
  constexpr double kFewestSamples = 5;  // a crest is then at most 20 % off a sample
  require(
      frequency * time_step * kFewestSamples <= 1,
      fmt::format("frequency {:g} Hz at time step {:g} s: must be at most {:g} Hz ({:g} samples "
                  "in a period); take a smaller time step",
                  frequency, time_step, 1 / (kFewestSamples * time_step), kFewestSamples));
  require(
      2 * taper <= duration,
      fmt::format("taper {:g} s: must be at most half the duration, {:g} s", taper, duration / 2));
}

Record finished(double time_step, Eigen::VectorXd acceleration, double peak) {
  set_end_state(time_step, acceleration);
  acceleration *= peak / acceleration.cwiseAbs().maxCoeff();
  return single_component(time_step, std::move(acceleration));
}

}  // namespace

Record harmonic(double time_step, const Harmonic& m) {
  check(time_step, m.frequency, m.duration, m.taper);
  return finished(time_step,
                  sampled(time_step, m.duration,
                          [&](double t) {
                            return trapezoid_taper(t, m.duration, m.taper) *
                                   std::sin(2 * pi * m.frequency * t);
                          }),
                  m.peak_acceleration);
}

Record sweep(double time_step, const Sweep& m) {
  check(time_step, std::max(m.first_frequency, m.last_frequency), m.duration, m.taper);
  const double ratio = m.last_frequency / m.first_frequency;
  require(!m.logarithmic || ratio != 1, "a logarithmic sweep needs two different frequencies");
  const auto phase = [&](double t) {
    if (m.logarithmic)
      return 2 * pi * m.first_frequency * m.duration / std::log(ratio) *
             (std::pow(ratio, t / m.duration) - 1);
    return 2 * pi * t *
           (m.first_frequency + (m.last_frequency - m.first_frequency) * t / (2 * m.duration));
  };
  return finished(time_step,
                  sampled(time_step, m.duration,
                          [&](double t) {
                            return trapezoid_taper(t, m.duration, m.taper) * std::sin(phase(t));
                          }),
                  m.peak_acceleration);
}

}  // namespace gurney
