#include "engine/solver/floor_stage.h"

#include "engine/solver/quadrature.h"

namespace gurney {
namespace {

/// StageMeans of a vector.
template <typename Integral>
std::array<Vector3, 2> means(double time, double duration, const Integral& integral) {
  const double tau = kSdirkGamma * duration;
  const Vector3 v0 = integral(time), v1 = integral(time + 2 * tau), v2 = integral(time + duration);
  const Vector3 first = (v1 - v0) / (2 * tau);
  return {first, ((v2 - v0) / duration - (1 - kSdirkGamma) * first) / kSdirkGamma};
}

}  // namespace

std::array<FloorStage, 2> floor_stages(const FloorMotion& floor, const Vector3& gravity,
                                       double time, double duration) {
  std::array<FloorStage, 2> stages;
  if (floor.at_rest() || time >= floor.duration()) return stages;
  const auto translation =
      means(time, duration, [&](double t) -> Vector3 { return floor.velocity_at(t); });
  for (std::size_t i = 0; i < 2; ++i)
    stages[i].acceleration = stages[i].translation = translation[i];
  if (!floor.rotates()) return stages;
  const auto angle =
      means(time, duration, [&](double t) -> Vector3 { return floor.integral_of_angle_at(t); });
  const auto angular =
      means(time, duration, [&](double t) -> Vector3 { return floor.angular_velocity_at(t); });
  for (std::size_t i = 0; i < 2; ++i) {
    stages[i].acceleration += angle[i].cross(gravity);
    stages[i].angular_acceleration = angular[i];
    stages[i].rotates = true;
  }
  return stages;
}

Vector3 apparent_floor_velocity(const FloorMotion& floor, const Vector3& gravity, double time) {
  const Vector3 velocity = floor.velocity_at(time);
  if (!floor.rotates()) return velocity;
  return velocity + floor.integral_of_angle_at(time).cross(gravity);
}

}  // namespace gurney
