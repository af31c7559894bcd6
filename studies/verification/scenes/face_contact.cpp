#include "studies/verification/scenes/face_contact.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace gurney {

FaceContact::FaceContact(const Body& first, const Body& second, const std::vector<double>& points,
                         double stiffness, double damping_number, const TurningFace& turning) {
  using Vector8 = Eigen::Matrix<double, 8, 1>;  // x1, yaw1, x2, yaw2 and their rates
  const auto of_wall = [&](std::size_t i) {
    return !turning.of_wall.empty() && turning.of_wall[i];
  };
  const auto lever = [&](const Vector8& s, std::size_t i) {
    return points[i] - first.y + (of_wall(i) ? 0 : turning.ahead * s[1]);
  };
  const auto force_at = [&](const Vector8& s, std::size_t i) {
    const double y = points[i], bent = (of_wall(i) ? 0.5 : -0.5) * turning.ahead * s[1] * s[1];
    const double depth = s[0] - s[2] - (y - first.y) * s[1] + (y - second.y) * s[3] + bent;
    const double rate = s[4] - s[6] - lever(s, i) * s[5] + (y - second.y) * s[7];
    return stiffness * std::max(0.0, depth) * std::max(0.0, 1 + damping_number * rate);
  };
  const auto rates = [&](const Vector8& s) {
    Vector8 r;
    r << s.tail<4>(), Eigen::Vector4d::Zero();
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double force = force_at(s, i);
      r[4] -= force * first.inverse_mass;
      r[5] += lever(s, i) * force * first.inverse_inertia;
      r[6] += force * second.inverse_mass;
      r[7] -= (points[i] - second.y) * force * second.inverse_inertia;
    }
    return r;
  };
  Vector8 s = Vector8::Zero();
  s[4] = 1;
  const double h = 1e-3 / std::sqrt(stiffness * (first.inverse_mass + second.inverse_mass));
  bool touched = false;
  for (int i = 0; i < 12000; ++i) {
    const Vector8 a = rates(s), b = rates(s + 0.5 * h * a), c = rates(s + 0.5 * h * b);
    const double force = -a[4] / first.inverse_mass;
    peak_force = std::max(peak_force, force);
    if (force > 0) contact = (i + 1) * h;
    touches += force > 0 && !touched;
    touched = force > 0;
    s += h / 6 * (a + 2 * b + 2 * c + rates(s + h * c));
  }
  speed = {s[4], s[6]};
  yaw_rate = {s[5], s[7]};
  parts = std::ranges::all_of(points, [&](double y) {
    return s[4] - s[6] - (y - first.y) * s[5] + (y - second.y) * s[7] < -0.01;
  });
}

double FaceContact::damping_number(double e) {
  double low = 1e-9, high = 1 / e;
  for (int i = 0; i < 100; ++i) {
    const double middle = (low + high) / 2;
    ((1 + e) * middle > std::log((1 + middle) / (1 - e * middle)) ? low : high) = middle;
  }
  return low;
}

}  // namespace gurney
