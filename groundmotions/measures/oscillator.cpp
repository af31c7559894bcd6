#include "groundmotions/measures/oscillator.h"

#include <cassert>
#include <cmath>
#include <complex>

namespace gurney::groundmotions {
namespace {

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
