#pragma once

#include <Eigen/Core>
#include <array>

#include "groundmotions/record.h"

namespace gurney {

/// Peaks over all directions: RotD00, RotD50 and RotD100 are the least, the median and the largest
/// of the 180 peaks at angles of 0, 1 ... 179 degrees (Boore 2010, BSSA 100(4), 1830-1835).
struct RotD {
  double d00 = 0, d50 = 0, d100 = 0;
};

/// From peaks at equal angles. @param peaks  at least one
RotD rot_d(std::vector<double> peaks);

/// Largest |x cos(angle) + y sin(angle)| at samples, for each angle.
/// @param x, y  of equal length
RotD rot_d_of_histories(const Eigen::VectorXd& x, const Eigen::VectorXd& y);

/// Spectra of pseudo-acceleration (at samples) over the horizontals of a record.
struct RotDSpectrum {
  Eigen::VectorXd period;          ///< [s]
  Eigen::VectorXd d00, d50, d100;  ///< [m/s2]
};

/// @param periods  >= 0; 0 gives the peak accelerations [s]
/// @throws Error without both horizontals
RotDSpectrum rot_d_spectrum(const Record& record, const Eigen::VectorXd& periods,
                            double damping = 0.05);

}  // namespace gurney
