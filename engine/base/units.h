#pragma once

#include <numbers>

/// The engine works in SI units. This is the only place that converts.
namespace gurney {

inline constexpr double kStandardGravity = 9.80665;  ///< 1 g [m/s2] (CGPM 1901)
inline constexpr double kMillimetersPerMeter = 1000.0;
inline constexpr double kRadiansPerDegree = std::numbers::pi / 180.0;

}  // namespace gurney
