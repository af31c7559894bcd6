#pragma once

namespace gurney {

/// The two-stage, second-order, L-stable, stiffly accurate singly diagonally implicit Runge-Kutta
/// method (Alexander 1977, SIAM J. Numer. Anal. 14:1006): gamma = 1 - 1/sqrt(2), nodes (gamma, 1),
/// weights (1 - gamma, gamma). Each stage is one implicit Euler step of length gamma h from its own
/// start.
inline constexpr double kSdirkGamma = 0.29289321881345247560;

/// From the start of a step over the end of its first stage to the start of its second.
inline constexpr double kSdirkExtrapolation = (1 - kSdirkGamma) / kSdirkGamma;

/// Values that the two stages take for a given function of time, so that their weighted sum is the
/// exact mean of the function over the step and linear functions are met at the stage times.
template <typename Value>
struct StageMeans {
  Value first, second;
};

/// @param h         length of the step [s]
/// @param integral  exact integral of the function, any origin: a number or a vector
template <typename Integral>
auto stage_means(double from, double h, const Integral& integral) {
  using Value = decltype(integral(from));
  const Value at_start = integral(from);
  const Value first = (integral(from + 2 * kSdirkGamma * h) - at_start) / (2 * kSdirkGamma * h);
  const Value mean = (integral(from + h) - at_start) / h;
  return StageMeans<Value>{first, (mean - (1 - kSdirkGamma) * first) / kSdirkGamma};
}

}  // namespace gurney
