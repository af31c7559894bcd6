#include "groundmotions/synthetic/rezaeian.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <unsupported/Eigen/SpecialFunctions>

#include "engine/base/error.h"
#include "engine/base/random/normal_draw.h"
#include "engine/base/units.h"
#include "groundmotions/synthetic/component.h"
#include "groundmotions/synthetic/end_state.h"

namespace gurney::groundmotions {

namespace {

using std::numbers::pi;

/// The root of an increasing function between low and high.
template <typename Function>
double bisected(double low, double high, const Function& function) {
  for (int i = 0; i < 200 && high - low > 1e-14 * high; ++i) {
    const double middle = (low + high) / 2;
    (function(middle) < 0 ? low : high) = middle;
  }
  return (low + high) / 2;
}

/// Quantile of the gamma distribution with rate 1.
double gamma_quantile(double shape, double probability) {
  const double high = 10 * (shape + 10);
  return bisected(0, high, [&](double x) { return Eigen::numext::igamma(shape, x) - probability; });
}

double frequency_at(const StochasticComponent& c, double time, double time_step) {
  constexpr double kLowest = 0.3;
  return std::clamp(c.frequency + c.frequency_slope * (time - c.middle), kLowest, 0.25 / time_step);
}

/// The filtered noise with unit variance.
Eigen::VectorXd unit_noise(const StochasticComponent& c, Eigen::Index samples, double time_step,
                           std::uint64_t seed, std::uint64_t stream) {
  constexpr double kForgotten = 1e-8;  // of a response, its tail left out
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(samples), variance = sum;
  for (Eigen::Index i = 0; i < samples; ++i) {
    const double draw = normal_draw(seed, stream, static_cast<std::uint64_t>(i));
    const double omega = 2 * pi * frequency_at(c, static_cast<double>(i) * time_step, time_step);
    const double damped = std::sqrt(1 - c.damping * c.damping);
    const std::complex<double> turn =
        std::exp(std::complex<double>(-c.damping, damped) * (omega * time_step));
    std::complex<double> response = omega / damped;
    const double forgotten = kForgotten * std::abs(response);
    for (Eigen::Index j = i + 1; j < samples && std::abs(response) > forgotten; ++j) {
      response *= turn;
      sum[j] += response.imag() * draw;
      variance[j] += response.imag() * response.imag();
    }
  }
  return (variance.array() > 0).select(sum.array() / variance.array().sqrt(), 0);
}

/// z'' of a critically damped oscillator: twice y' + omega y = x', exact for linear x.
void high_pass(double omega, double time_step, Eigen::VectorXd& x) {
  const double keep = std::exp(-omega * time_step), gain = (1 - keep) / (omega * time_step);
  for (int pass = 0; pass < 2; ++pass) {
    double y = x[0], before = x[0];
    for (Eigen::Index i = 1; i < x.size(); ++i) {
      y = keep * y + gain * (x[i] - before);
      before = x[i];
      x[i] = y;
    }
  }
}

Eigen::VectorXd acceleration(const StochasticMotion& motion, const StochasticComponent& c,
                             std::uint64_t stream, double end) {
  const GammaEnvelope envelope = gamma_envelope(c.duration, c.middle);
  const double k = envelope.shape, b = envelope.rate;
  const double log_scale =
      std::log(2 * kStandardGravity * c.arias_intensity / pi) + k * std::log(b) - std::lgamma(k);
  Eigen::VectorXd a = sampled(motion.time_step, end, [&](double t) {
    return t > 0 ? std::exp((log_scale + (k - 1) * std::log(t) - b * t) / 2) : 0;
  });
  a.array() *= unit_noise(c, a.size(), motion.time_step, motion.seed, stream).array();
  high_pass(2 * pi * motion.corner_frequency, motion.time_step, a);
  set_end_state(motion.time_step, a);
  return a;
}

}  // namespace

GammaEnvelope gamma_envelope(double duration, double middle) {
  constexpr double kMaxSpread = 4.5;  // shape 1, a density that is finite at 0, has 4.92
  require(duration < kMaxSpread * middle,
          fmt::format("significant duration {:g} s: must be less than {:g} times the time of the "
                      "middle of strong shaking, {:g} s",
                      duration, kMaxSpread, middle));
  const auto spread = [](double shape) {
    return gamma_quantile(shape, 0.95) - gamma_quantile(shape, 0.05);
  };
  const auto excess = [&](double shape) {
    return duration / middle - spread(shape) / gamma_quantile(shape, 0.45);
  };
  constexpr double kLargestShape = 1e4;
  require(excess(kLargestShape) > 0,
          fmt::format("significant duration {:g} s: is too short for the time of the middle of "
                      "strong shaking, {:g} s",
                      duration, middle));
  const double shape = bisected(1, kLargestShape, excess);
  return {shape, spread(shape) / duration};
}

double gamma_time(const GammaEnvelope& envelope, double probability) {
  return gamma_quantile(envelope.shape, probability) / envelope.rate;
}

Record stochastic_motion(const StochasticMotion& motion) {
  constexpr double kLastEnergy = 0.999;
  double end = 0;
  for (const StochasticComponent& c : motion.components) {
    if (c.arias_intensity == 0) continue;
    require(c.frequency * motion.time_step <= 0.25,
            fmt::format("frequency {:g} Hz at time step {:g} s: must be at most {:g} Hz",
                        c.frequency, motion.time_step, 0.25 / motion.time_step));
    end = std::max(end, gamma_time(gamma_envelope(c.duration, c.middle), kLastEnergy));
  }
  require(end > 0, "a stochastic motion needs a component with an Arias intensity > 0");
  end += 2 / motion.corner_frequency;
  Record record;
  for (const Direction direction : kDirections) {
    const auto index = static_cast<std::size_t>(direction);
    const StochasticComponent& c = motion.components[index];
    if (c.arias_intensity == 0) continue;
    record.components[index] =
        synthetic_component(direction, motion.time_step, acceleration(motion, c, index, end));
  }
  return record;
}

}  // namespace gurney::groundmotions
