#pragma once

#include <Eigen/Core>

namespace gurney::groundmotions {

/// How the angles of RotD are counted: 0, 1, ..., 179 degrees (Boore 2010, BSSA 100(4), 1830-1835).
inline constexpr int kRotationAngles = 180;

/// The values of a measure over these angles.
using RotatedValues = Eigen::Array<double, kRotationAngles, 1>;

/// Cosine and sine of angle `index`.
Eigen::Vector2d rotation_direction(int index);

/// The percentile of the values over the angles, linear between ordered values: 0 gives the
/// smallest (RotD00), 50 the median (RotD50), 100 the largest (RotD100).
/// @param percent  in [0, 100]
double percentile(const RotatedValues& values, double percent);

/// The largest magnitude over time of x cos(theta) + y sin(theta) for each angle.
/// @param x, y  of one length
RotatedValues rotated_peaks(const Eigen::Ref<const Eigen::VectorXd>& x,
                            const Eigen::Ref<const Eigen::VectorXd>& y);

/// Pseudo-acceleration spectra of two horizontal components that do not depend on how the sensor
/// was turned.
struct RotatedSpectrum {
  Eigen::VectorXd period;                   ///< [s]
  Eigen::VectorXd rotd00, rotd50, rotd100;  ///< PSA [m/s2]
};

/// RotD00, RotD50 and RotD100 of PSA: at each period by itself, over angles by 1 degree, peaks at
/// the samples.
/// @param time_step  > 0 [s]
/// @param h1, h2     horizontal accelerations at right angles, of one length [m/s2]
/// @throws Error as response_spectrum() does.
RotatedSpectrum rotated_spectrum(double time_step, const Eigen::VectorXd& h1,
                                 const Eigen::VectorXd& h2, const Eigen::VectorXd& periods,
                                 double damping = 0.05);

}  // namespace gurney::groundmotions
