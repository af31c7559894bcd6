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

}  // namespace gurney
