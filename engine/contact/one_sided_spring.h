#pragma once

#include "engine/base/lanes.h"

namespace gurney {

/// k x'^2 of a spring that only pushes, E = k max(x, 0)^2 / 2, whose compression goes from `start` to
/// `end` in a stage of length tau. The stage gives it the energy k max(end, 0) (end - start) and loses
///   k max(end, 0) (end - start) - E(end) + E(start) = tau^2 / 2 times this,
/// so that it has no jump where a stage ends at the touch [W/s].
template <class T>
T one_sided_rates(const T& stiffness, const T& start, const T& end, const T& tau) {
  const T from = select(start > T{}, start, T{}), to = select(end > T{}, end, T{});
  const T rate = (to - from) / tau;
  return stiffness * (rate * rate + 2.0 * to * (from - start) / (tau * tau));
}

/// Compression of a spring that only pushes in one of two stages of length tau.
struct OneSidedStage {
  double start;  ///< where the stage starts
  double
      at_zero_rate;  ///< from where it goes by tau times the rate: bodies that turn bring points closer
  double end;
  double ahead;  ///< of the first: the second starts at start + ahead (end - start); 0: the second
};

/// Rates of a contact of bodies. Both stages together lose
///   tau^2 / 2 (rates of the second - rates of the first),
/// the energy that they give the spring less what it takes,
/// also where it touches or lets go between the two: the first gives ahead times as much as alone. k x'^2 where the
/// spring pushes throughout and nothing turns.
inline double one_sided_rates(double stiffness, const OneSidedStage& x, double tau) {
  const auto energy = [&](double at) { return at > 0 ? 0.5 * stiffness * at * at : 0; };
  const bool first = x.ahead > 0;
  const double given =
      (first ? x.ahead : 1) * stiffness * (x.end > 0 ? x.end : 0) * (x.end - x.at_zero_rate);
  const double taken =
      energy(first ? x.start + x.ahead * (x.end - x.start) : x.end) - energy(x.start);
  return (first ? -2 : 2) * (given - taken) / (tau * tau);
}

}  // namespace gurney
