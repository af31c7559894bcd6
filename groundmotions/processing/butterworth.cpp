#include "groundmotions/processing/butterworth.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "engine/base/error.h"
#include "groundmotions/processing/trim.h"

namespace gurney::groundmotions {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kMaxPadSamples = 1e7;

enum class Kind { kHighPass, kLowPass };

/// s^2 or 1 over s^2 + damping s + 1, with s the bilinear transform of z over the prewarped corner:
/// two trapezoidal integrators in a loop. Unlike a direct form its coefficients keep their digits
/// when the corner is far below the sampling rate.
template <Kind kKind, typename Samples>
void second_order_section(double corner, double damping, Samples&& x) {
  const double feedback = damping + corner;
  const double scale = 1 / (1 + corner * feedback);
  double s1 = 0, s2 = 0;
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const double high = (x[i] - feedback * s1 - s2) * scale;
    const double step1 = corner * high;
    const double band = step1 + s1;
    s1 = band + step1;
    const double step2 = corner * band;
    const double low = step2 + s2;
    s2 = low + step2;
    x[i] = kKind == Kind::kHighPass ? high : low;
  }
}

/// s or 1 over s + 1.
template <Kind kKind, typename Samples>
void first_order_section(double corner, Samples&& x) {
  double s = 0;
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const double step = (x[i] - s) * corner / (1 + corner);
    const double low = step + s;
    s = low + step;
    x[i] = kKind == Kind::kHighPass ? x[i] - low : low;
  }
}

template <Kind kKind, typename Samples>
void pass(double corner, int order, Samples&& x) {
  for (int k = 1; k <= order / 2; ++k)
    second_order_section<kKind>(corner, 2 * std::sin(kPi * (2 * k - 1) / (2 * order)), x);
  if (order % 2 == 1) first_order_section<kKind>(corner, x);
}

double warped(double frequency, double time_step) { return std::tan(kPi * frequency * time_step); }

template <Kind kKind>
void both_passes(double corner, int order, Eigen::VectorXd& x) {
  pass<kKind>(corner, order, x);
  pass<kKind>(corner, order, x.reverse());
}

void check_corner(const char* which, double corner, double time_step) {
  const double nyquist = 0.5 / time_step;
  require(corner > 0 && corner < nyquist,
          fmt::format("the {} corner must be more than 0 and less than the Nyquist frequency, {:g} "
                      "Hz for a time step of {:g} s, got {:g} Hz",
                      which, nyquist, time_step, corner));
}

}  // namespace

Eigen::Index pad_samples(const Butterworth& filter, double time_step) {
  require(filter.high_pass || filter.low_pass, "a filter needs a corner");
  require(
      filter.order >= 1 && filter.order <= kHighestOrder,
      fmt::format("the order of a filter must be 1 to {}, got {}", kHighestOrder, filter.order));
  if (filter.high_pass) check_corner("high-pass", *filter.high_pass, time_step);
  if (filter.low_pass) check_corner("low-pass", *filter.low_pass, time_step);
  require(
      !filter.high_pass || !filter.low_pass || *filter.high_pass < *filter.low_pass,
      fmt::format("the high-pass corner must be below the low-pass corner, got {:g} and {:g} Hz",
                  filter.high_pass.value_or(0), filter.low_pass.value_or(0)));
  const double lowest = filter.high_pass ? *filter.high_pass : *filter.low_pass;
  const double seconds = 1.5 * filter.order / lowest;
  const double samples = std::ceil(seconds / time_step * (1 - 1e-12));
  require(
      samples <= kMaxPadSamples,
      fmt::format("a corner of {:g} Hz needs {:g} s of zeros at each end, more than {:g} samples "
                  "of {:g} s",
                  lowest, seconds, kMaxPadSamples, time_step));
  return static_cast<Eigen::Index>(samples);
}

Eigen::VectorXd filtered(const Butterworth& filter, double time_step,
                         const Eigen::VectorXd& acceleration) {
  const Eigen::Index pad = pad_samples(filter, time_step), samples = acceleration.size();
  const double duration = time_step * static_cast<double>(samples - 1);
  const double taper = filter.taper.value_or(kFilterTaper * duration);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(samples + 2 * pad);
  x.segment(pad, samples) = tapered(time_step, acceleration, taper, taper);
  if (filter.high_pass)
    both_passes<Kind::kHighPass>(warped(*filter.high_pass, time_step), filter.order, x);
  if (filter.low_pass)
    both_passes<Kind::kLowPass>(warped(*filter.low_pass, time_step), filter.order, x);
  if (filter.keep_pads) return x;
  return x.segment(pad, samples);
}

}  // namespace gurney::groundmotions
