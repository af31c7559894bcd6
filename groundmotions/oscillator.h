#pragma once

namespace gurney {

/// A damped linear oscillator u'' + 2 zeta omega u' + omega^2 u = p(t), with
/// p linear over each step: the state after a step is exact (Nigam & Jennings 1969, BSSA 59(2),
/// 909-922).
class Oscillator {
 public:
  /// @param omega      natural angular frequency > 0 [rad/s]
  /// @param damping    zeta in [0, 1)
  /// @param time_step  > 0 [s]
  /// @param displacement, velocity  at the start
  Oscillator(double omega, double damping, double time_step, double displacement = 0,
             double velocity = 0);

  /// @param p0, p1  load at the begin and the end of the step
  void step(double p0, double p1);

  double displacement() const { return u_; }
  double velocity() const { return v_; }

 private:
  double omega_, damping_, time_step_;
  double damped_omega_, decay_, cosine_, sine_;
  double u_, v_;
};

}  // namespace gurney
