#pragma once

#include "engine/base/lanes.h"

namespace gurney::groundmotions {

/// One time step of a damped linear oscillator u'' + 2 zeta omega u' + omega^2 u = p(t) with p
/// linear over the step: the state after it is exact (Nigam & Jennings 1969, BSSA 59(2), 909-922).
///
///     u1 = uu u0 + uv v0 + u_p0 p0 + u_p1 p1
///     v1 = vu u0 + vv v0 + v_p0 p0 + v_p1 p1
///
/// Correct to some units in the last place for any step, however short or long against the period.
struct OscillatorStep {
  double uu, uv, u_p0, u_p1;
  double vu, vv, v_p0, v_p1;
};

/// @param omega      natural angular frequency > 0 [rad/s]
/// @param damping    zeta in [0, 1)
/// @param time_step  > 0 [s]
OscillatorStep oscillator_step(double omega, double damping, double time_step);

/// Such an oscillator.
class Oscillator {
 public:
  /// @param displacement, velocity  at the start
  Oscillator(double omega, double damping, double time_step, double displacement = 0,
             double velocity = 0)
      : step_(oscillator_step(omega, damping, time_step)), u_(displacement), v_(velocity) {}

  /// @param p0, p1  load at the begin and the end of the step
  void step(double p0, double p1) {
    const double u = step_.uu * u_ + step_.uv * v_ + step_.u_p0 * p0 + step_.u_p1 * p1;
    v_ = step_.vu * u_ + step_.vv * v_ + step_.v_p0 * p0 + step_.v_p1 * p1;
    u_ = u;
  }

  double displacement() const { return u_; }
  double velocity() const { return v_; }

 private:
  OscillatorStep step_;
  double u_, v_;
};

/// Oscillators of four periods under one load, side by side in SIMD registers.
struct OscillatorPack {
  Lanes uu{}, uv{}, u_p0{}, u_p1{}, vu{}, vv{}, v_p0{}, v_p1{};

  void set(std::size_t lane, const OscillatorStep& s) {
    uu[lane] = s.uu, uv[lane] = s.uv, u_p0[lane] = s.u_p0, u_p1[lane] = s.u_p1;
    vu[lane] = s.vu, vv[lane] = s.vv, v_p0[lane] = s.v_p0, v_p1[lane] = s.v_p1;
  }

  void step(double p0, double p1, Lanes& u, Lanes& v) const {
    const Lanes last = u;
    u = (uu * last + uv * v) + (u_p0 * p0 + u_p1 * p1);
    v = (vu * last + vv * v) + (v_p0 * p0 + v_p1 * p1);
  }
};

}  // namespace gurney::groundmotions
