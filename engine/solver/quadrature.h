#pragma once

namespace gurney {

/// The two-stage, second-order, L-stable, stiffly accurate singly diagonally implicit Runge-Kutta
/// method (Alexander 1977, SIAM J. Numer. Anal. 14:1006): gamma = 1 - 1/sqrt(2), nodes (gamma, 1),
/// weights (1 - gamma, gamma). Each stage is one implicit Euler step of length gamma h from its own
/// start.
inline constexpr double kSdirkGamma = 0.29289321881345247560;

/// Values that the two stages take for a given function of time, so that their weighted sum is the
/// exact mean of the function over the step and linear functions are met at the stage times.
struct StageMeans {
  double first, second;
};

/// @param integral  exact integral of the function, any origin
template <typename Integral>
StageMeans stage_means(double from, double to, const Integral& integral) {
  const double h = to - from;
  const double at_start = integral(from);
  const double first = (integral(from + 2 * kSdirkGamma * h) - at_start) / (2 * kSdirkGamma * h);
  const double mean = (integral(to) - at_start) / h;
  return {first, (mean - (1 - kSdirkGamma) * first) / kSdirkGamma};
}

}  // namespace gurney
