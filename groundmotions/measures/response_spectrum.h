#pragma once

#include <Eigen/Core>
#include <string>

#include "engine/base/lanes.h"

namespace gurney::groundmotions {

/// Where the peak of an oscillator's response is looked for.
enum class PeakAt {
  /// At the samples of the record, as PEER's NGA-West2 spectra are. Misses at most
  /// (pi dt / T)^2 / 2 (PSA + PGA) of PSA.
  kSamples,
  /// On a grid of at most T/200, which misses at most 1.3e-4 (PSA + PGA), and through two periods
  /// of free vibration after the end of the record.
  kBetweenSamples
};

/// Elastic response spectra of one component. "Sa" is the pseudo-acceleration everywhere in Gurney.
struct ResponseSpectrum {
  Eigen::VectorXd period;                 ///< T as asked for [s]
  Eigen::VectorXd displacement;           ///< SD = max |u|, relative to the ground [m]
  Eigen::VectorXd pseudo_velocity;        ///< PSV = (2 pi / T) SD [m/s]
  Eigen::VectorXd pseudo_acceleration;    ///< PSA = (2 pi / T)^2 SD [m/s2]
  Eigen::VectorXd absolute_acceleration;  ///< max |u'' + a| = max |2 zeta omega u' + omega^2 u|
};

/// The largest response of oscillators u'' + 2 zeta omega u' + omega^2 u = -a, omega = 2 pi / T, at
/// rest at the first sample. The solution is exact for an acceleration that is linear between its
/// samples (Nigam & Jennings 1969, BSSA 59(2), 909-922) and stable for any T; T = 0 gives SD = PSV
/// = 0 and PSA = PGA.
///
/// @param time_step     > 0 [s]
/// @param acceleration  [m/s2]; empty: all spectra are zero
/// @param periods       [s], each >= 0, in any order
/// @param damping       zeta in [0, 1)
/// @throws Error for a period or a damping out of range.
ResponseSpectrum response_spectrum(double time_step, const Eigen::VectorXd& acceleration,
                                   const Eigen::VectorXd& periods, double damping = 0.05,
                                   PeakAt peak_at = PeakAt::kSamples);

/// A warning for a period between 0 and 10 dt, where what the motion does between its samples
/// matters; empty for other periods.
std::string short_period_warning(double time_step, double period);

/// `count` periods from `first` to `last`, evenly spaced in their logarithm.
/// @param first  > 0
Eigen::VectorXd logarithmic_periods(double first, double last, int count);

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
