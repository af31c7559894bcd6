#include "engine/solver/floor_stage.h"

#include "engine/solver/quadrature.h"

namespace gurney {
std::array<FloorStage, 2> floor_stages(const FloorMotion& floor, const Vector3& gravity,
                                       double time, double duration) {
  std::array<FloorStage, 2> stages;
  if (floor.at_rest() || time >= floor.duration()) return stages;
  const auto means = [&](Vector3 (FloorMotion::*integral)(double) const) {
    const auto of = stage_means(time, duration, [&](double t) { return (floor.*integral)(t); });
    return std::array{of.first, of.second};
  };
  const auto translation = means(&FloorMotion::velocity_at);
  for (std::size_t i = 0; i < 2; ++i)
    stages[i].acceleration = stages[i].translation = translation[i];
  if (!floor.rotates()) return stages;
  const auto angle = means(&FloorMotion::integral_of_angle_at),
             angular = means(&FloorMotion::angular_velocity_at);
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
