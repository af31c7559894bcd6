#include "groundmotions/synthetic/rezaeian.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/math/special_functions/gamma.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <complex>
#include <cstdint>
#include <numbers>
#include <numeric>

#include "engine/base/error.h"
#include "engine/base/random/normal_draw.h"
#include "engine/base/units.h"
#include "groundmotions/synthetic/component.h"

namespace gurney::groundmotions {

namespace {

using std::numbers::pi;

/// Quantile of the gamma distribution with rate 1.
double gamma_quantile(double shape, double probability) {
  using namespace boost::math::policies;
  return boost::math::gamma_p_inv(shape, probability, policy<promote_double<false>>());
}

double frequency_at(const StochasticComponent& c, double time, double time_step) {
  constexpr double kLowest = 0.3;
  return std::clamp(c.frequency + c.frequency_slope * (time - c.middle), kLowest, 0.25 / time_step);
}

/// The filtered noise with unit variance. A response is the imaginary part of a number that turns and
/// shrinks by one factor a sample: kPack successive samples of it are kept side by side, so that the
/// processor turns them all at once.
Eigen::VectorXd unit_noise(const StochasticComponent& c, Eigen::Index samples, double time_step,
                           std::uint64_t seed, std::uint64_t stream) {
  constexpr double kForgotten = 1e-8;  // of a response, its tail left out
  constexpr int kPack = 8;
  using Pack = Eigen::Array<double, kPack, 1>;
  const double damped = std::sqrt(1 - c.damping * c.damping);
  Eigen::ArrayXd sum = Eigen::ArrayXd::Zero(samples + kPack), variance = sum;
  for (Eigen::Index i = 0; i < samples; ++i) {
    const double draw = normal_draw(seed, stream, static_cast<std::uint64_t>(i));
    const double omega = 2 * pi * frequency_at(c, static_cast<double>(i) * time_step, time_step);
    const std::complex<double> rate =
        std::complex<double>(-c.damping, damped) * (omega * time_step);  // of a sample
    const std::complex<double> turn_once = std::exp(rate);
    std::complex<double> turn = 1;
    Pack real, imaginary;
    for (int k = 0; k < kPack; ++k) {
      turn *= turn_once;
      real[k] = omega / damped * turn.real(), imaginary[k] = omega / damped * turn.imag();
    }
    const double kept = std::ceil(std::log(kForgotten) / rate.real());
    const auto end = static_cast<Eigen::Index>(
        std::min(static_cast<double>(samples), static_cast<double>(i) + 1 + kept));
    for (Eigen::Index j = i + 1; j < end; j += kPack) {
      sum.segment<kPack>(j) += draw * imaginary;
      variance.segment<kPack>(j) += imaginary.square();
      const Pack turned = real * turn.real() - imaginary * turn.imag();
      imaginary = real * turn.imag() + imaginary * turn.real();
      real = turned;
    }
  }
  return (variance > 0).select(sum / variance.sqrt(), 0).head(samples);
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
                             const GammaEnvelope& envelope, std::uint64_t stream, double end) {
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
  std::uintmax_t tries = 100;
  const auto bracket = boost::math::tools::toms748_solve(
      excess, 1.0, kLargestShape, boost::math::tools::eps_tolerance<double>(50), tries);
  const double shape = std::midpoint(bracket.first, bracket.second);
  return {shape, spread(shape) / duration};
}

double gamma_time(const GammaEnvelope& envelope, double probability) {
  return gamma_quantile(envelope.shape, probability) / envelope.rate;
}

Record stochastic_motion(const StochasticMotion& motion) {
  constexpr double kLastEnergy = 0.999;
  double end = 0;
  std::array<GammaEnvelope, 3> envelopes;
  for (const Direction direction : kDirections) {
    const auto index = static_cast<std::size_t>(direction);
    const StochasticComponent& c = motion.components[index];
    if (c.arias_intensity == 0) continue;
    require(c.frequency * motion.time_step <= 0.25,
            fmt::format("frequency {:g} Hz at time step {:g} s: must be at most {:g} Hz",
                        c.frequency, motion.time_step, 0.25 / motion.time_step));
    envelopes[index] = gamma_envelope(c.duration, c.middle);
    end = std::max(end, gamma_time(envelopes[index], kLastEnergy));
  }
  require(end > 0, "a stochastic motion needs a component with an Arias intensity > 0");
  end += 2 / motion.corner_frequency;
  Record record;
  for (const Direction direction : kDirections) {
    const auto index = static_cast<std::size_t>(direction);
    const StochasticComponent& c = motion.components[index];
    if (c.arias_intensity == 0) continue;
    record.components[index] = synthetic_component(
        direction, motion.time_step, acceleration(motion, c, envelopes[index], index, end));
  }
  return record;
}

}  // namespace gurney::groundmotions
