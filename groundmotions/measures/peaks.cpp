#include "groundmotions/measures/peaks.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace gurney {
namespace {

/// Peaks of vectors of `Size` components; `acceleration(i)` is the vector at sample i.
template <int Size, class Acceleration>
Peaks largest_magnitudes(double time_step, Eigen::Index samples, Acceleration acceleration) {
  using Vector = Eigen::Matrix<double, Size, 1>;
  Peaks squares;
  Vector velocity = Vector::Zero(), displacement = velocity, last = velocity;
  for (Eigen::Index i = 0; i < samples; ++i) {
    const Vector now = acceleration(i);
    if (i > 0) {
      displacement += time_step * velocity + time_step * time_step / 6 * (2 * last + now);
      velocity += time_step / 2 * (last + now);
    }
    if (now.squaredNorm() > squares.acceleration) {
      squares.acceleration = now.squaredNorm();
      squares.time_of_acceleration = static_cast<double>(i) * time_step;
    }
    squares.velocity = std::max(squares.velocity, velocity.squaredNorm());
    squares.displacement = std::max(squares.displacement, displacement.squaredNorm());
    last = now;
  }
  return {std::sqrt(squares.acceleration), std::sqrt(squares.velocity),
          std::sqrt(squares.displacement), squares.time_of_acceleration};
}

}  // namespace

Peaks peaks(double time_step, const Eigen::VectorXd& a) {
  using Vector1 = Eigen::Matrix<double, 1, 1>;
  return largest_magnitudes<1>(time_step, a.size(),
                               [&](Eigen::Index i) { return Vector1::Constant(a[i]); });
}

Peaks peaks(double time_step, const Eigen::VectorXd& h1, const Eigen::VectorXd& h2) {
  assert(h1.size() == h2.size());
  return largest_magnitudes<2>(time_step, h1.size(),
                               [&](Eigen::Index i) { return Eigen::Vector2d(h1[i], h2[i]); });
}

}  // namespace gurney
