#include "engine/solver/floor_points.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gurney {
namespace {

Vector3 axle_of(const CasterDynamics& caster, const State& state, std::size_t i) {
  const double angle = state.casters[i].swivel_angle;
  return caster.point(state.pose(), angle, Vector3::UnitY()) -
         caster.point(state.pose(), angle, Vector3::Zero());
}

/// Axles are across the chassis' z axis, so that none is steeper than its tilt.
bool some_wheel_may_lie(const State& state) {
  const Vector3 up = state.rotation.conjugate() * Vector3::UnitZ();
  return CasterDynamics::lies(Vector3(0, 0, up.head<2>().norm() + Clearance::kRounding));
}

}  // namespace

FloorPoints::FloorPoints(const EquipmentModel& model, const Mechanism& mechanism, std::size_t item)
    : mechanism_(mechanism), item_(item) {
  for (const Box& box : model.shape)
    for (int k = 0; k < 8; ++k) {
      const Vector3 side(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1);
      corners_.push_back(box.center + 0.5 * side.cwiseProduct(box.size) -
                         mechanism.chassis.center_of_mass);
    }
}

void FloorPoints::collect(const State& state, const Travel& travel, double margin,
                          std::vector<BodyContact>& contacts) {
  const auto add_if_low = [&](const BodyContact::Side& side) {
    const double height = state.position.z() + mechanism_.point(side, state).z();
    if (height < margin) contacts.emplace_back().side = side;
    return height;
  };
  const double travelled = travel.chassis(mechanism_.reach);
  if (!clearance_.exceeds(margin, travelled)) {
    double lowest = std::numeric_limits<double>::infinity();
    for (const Vector3& corner : corners_)
      lowest = std::min(lowest, add_if_low({item_, -1, corner}));
    clearance_.measure(lowest, travelled);
  }
  if (!some_wheel_may_lie(state)) return;
  for (std::size_t i = 0; i < mechanism_.casters.size(); ++i) {
    const CasterDynamics& caster = mechanism_.casters[i];
    if (!CasterDynamics::lies(axle_of(caster, state, i))) continue;
    for (const bool left : {false, true})
      for (const Vector3& point : caster.rim(left)) add_if_low({item_, static_cast<int>(i), point});
  }
}

}  // namespace gurney
