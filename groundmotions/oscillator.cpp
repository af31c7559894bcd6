#include "groundmotions/oscillator.h"

#include <cassert>
#include <cmath>

namespace gurney {

Oscillator::Oscillator(double omega, double damping, double time_step, double displacement,
                       double velocity)
    : omega_(omega),
      damping_(damping),
      time_step_(time_step),
      damped_omega_(omega * std::sqrt(1 - damping * damping)),
      decay_(std::exp(-damping * omega * time_step)),
      cosine_(std::cos(damped_omega_ * time_step)),
      sine_(std::sin(damped_omega_ * time_step)),
      u_(displacement),
      v_(velocity) {
  assert(omega > 0 && damping >= 0 && damping < 1 && time_step > 0);
}

void Oscillator::step(double p0, double p1) {
  // u = offset + slope t + exp(-zeta omega t) (c cos(omega_d t) + s sin(omega_d t))
  const double slope = (p1 - p0) / time_step_ / (omega_ * omega_);
  const double offset = p0 / (omega_ * omega_) - 2 * damping_ / omega_ * slope;
  const double c = u_ - offset;
  const double s = (v_ - slope + damping_ * omega_ * c) / damped_omega_;
  const double swing = decay_ * (c * cosine_ + s * sine_);
  u_ = offset + slope * time_step_ + swing;
  v_ = slope - damping_ * omega_ * swing + decay_ * damped_omega_ * (s * cosine_ - c * sine_);
}

}  // namespace gurney
