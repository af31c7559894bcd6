#pragma once

#include <functional>

/// The rigid block that rocks on two edges (Housner 1963), integrated: a reference of verification.
namespace gurney {

struct RockingBlock {
  double alpha = 0;  ///< atan(half width / height of the centre) [rad]
  double p = 0;      ///< sqrt(M g R / I_O) [1/s]
  double eta = 0;    ///< angular velocity after an impact over that before
};

/// With s the sign of theta, on the edge it stands on,
///
///     theta'' = -p^2 (sin(alpha s - theta) + a(t) / g cos(alpha s - theta))
///
/// from uplift, |a| > g tan(alpha), on; theta' is multiplied by eta at theta = 0. Runge-Kutta steps
/// of fourth order; impacts are located.
class RockingReference {
 public:
  explicit RockingReference(const RockingBlock& block) : block_(block) {}

  /// Goes on for `duration` under the floor acceleration a(time since the start) [m/s2], or until
  /// the block falls.
  void advance(const std::function<double(double)>& acceleration, double duration);

  /// The floor's velocity changes at once by `change`: theta' by -p^2 / g cos(alpha s - theta) of
  /// it.
  void jump(double change);

  bool fallen() const;  ///< beyond 1 rad
  int impacts() const { return impacts_; }
  double time() const { return time_; }
  double theta() const { return theta_; }

 private:
  void step(const std::function<double(double)>& acceleration, double h);

  RockingBlock block_;
  double time_ = 0, theta_ = 0, rate_ = 0;
  double sign_ = 0;  ///< of theta; 0: stands on both edges
  int impacts_ = 0;
};

/// Time from rest at theta0 to the floor, from the energy integral [s].
double quarter_period(const RockingBlock& block, double theta0);

/// How a block ends under one cycle of a sine, a(t) = a_p sin(w_p t) (Zhang & Makris 2001).
enum class RockingEnd { kStands, kAfterImpact, kWithoutImpact };

/// With growing strength a_p / (alpha g) the block overturns after one impact from a on, is safe
/// again from b on, and overturns without impact from c on; it falls the other way then. Where w_p
/// / p is large, only c is left and a = b = 0.
struct SineRegions {
  double a = 0, b = 0, c = 0;

  /// @param ratio  w_p / p
  SineRegions(const RockingBlock& block, double ratio);

  static RockingEnd end(const RockingBlock& block, double ratio, double strength);

  /// The strength between `without` and `with` from which on the block ends as `end`.
  static double boundary(const RockingBlock& block, double ratio, RockingEnd end, double without,
                         double with);
};

}  // namespace gurney
