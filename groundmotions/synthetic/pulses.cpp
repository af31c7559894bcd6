#include "groundmotions/synthetic/pulses.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "engine/base/append_all.h"
#include "engine/base/error.h"
#include "groundmotions/synthetic/component.h"

namespace gurney::groundmotions {

namespace {

using std::numbers::pi;

double half_sine_at(double time, double width) {
  return time > 0 && time < width ? std::sin(pi * time / width) : 0;
}

}  // namespace

Record half_sine(double time_step, double peak_acceleration, double period) {
  return single_component(time_step, sampled(time_step, period / 2, [&](double t) {
                            return peak_acceleration * half_sine_at(t, period / 2);
                          }));
}

Record full_sine(double time_step, double peak_acceleration, double period) {
  Eigen::VectorXd a = sampled(time_step, period, [&](double t) {
    return t < period ? peak_acceleration * std::sin(2 * pi * t / period) : 0;
  });
  set_end_state(time_step, a, {0, peak_acceleration * period * period / (2 * pi)});
  return single_component(time_step, std::move(a));
}

Record acceleration_step(double time_step, double peak_acceleration, double rise, double hold) {
  const double end = 2 * rise + hold;
  return single_component(time_step, sampled(time_step, end, [&](double t) {
                            const double ramp = std::min(t, end - t) / rise;
                            return peak_acceleration * std::clamp(ramp, 0., 1.);
                          }));
}

Record double_impulse(double time_step, double velocity, double width, double interval) {
  require(interval >= width,
          fmt::format("interval {:g} s: must be at least the width of an impulse, {:g} s", interval,
                      width));
  const double peak = pi * velocity / (2 * width);
  Eigen::VectorXd a = sampled(time_step, interval + width, [&](double t) {
    return peak * (half_sine_at(t, width) - half_sine_at(t - interval, width));
  });
  set_end_state(time_step, a, {0, velocity * interval});
  return single_component(time_step, std::move(a));
}

Record ricker_wavelet(double time_step, double peak_acceleration, double period) {
  Eigen::VectorXd a = sampled(time_step, 3 * period, [&](double t) {
    const double square = std::pow(pi * (t / period - 1.5), 2);
    return peak_acceleration * (1 - 2 * square) * std::exp(-square);
  });
  set_end_state(time_step, a);
  return single_component(time_step, std::move(a));
}

Record near_fault_pulse(double time_step, const NearFaultPulse& pulse) {
  assert(pulse.amplitude > 0 && pulse.period > 0 && pulse.gamma > 1);
  const double omega = 2 * pi / pulse.period, gamma = pulse.gamma, nu = pulse.phase;
  const double half = gamma * pulse.period / 2;
  Eigen::VectorXd a = sampled(time_step, 2 * half, [&](double t) {
    const double tau = t - half;
    if (tau > half) return 0.;
    const double slow = omega * tau / gamma, fast = omega * tau + nu;
    return -pulse.amplitude * omega / (2 * gamma) *
           (std::sin(slow) * std::cos(fast) + gamma * std::sin(fast) * (1 + std::cos(slow)));
  });
  set_end_state(
      time_step, a,
      {0, pulse.amplitude * std::cos(nu) * std::sin(pi * gamma) / (omega * (1 - gamma * gamma))});
  return single_component(time_step, std::move(a));
}

Record with_pulse(Record record, const NearFaultPulse& pulse, double start) {
  const double step = record.time_step();
  std::optional<Component>& h1 = record.components[static_cast<std::size_t>(Direction::kH1)];
  assert(h1 && start >= 0);
  const Component alone = *near_fault_pulse(step, pulse)[Direction::kH1];
  const Eigen::Index first = std::lround(start / step), length = alone.acceleration.size();
  require(first + length <= record.samples(),
          fmt::format("the pulse ends at {:.6g} s, after the motion, which ends at {:.6g} s",
                      static_cast<double>(first + length - 1) * step, h1->duration()));
  h1->acceleration.segment(first, length) += alone.acceleration;
  append_all(h1->warnings, alone.warnings);
  return record;
}

}  // namespace gurney::groundmotions
