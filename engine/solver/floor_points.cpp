#include "engine/solver/floor_points.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gurney {
namespace {

/// A wheel with a steeper axle may soon lie on its side.
constexpr double kSteepAxle = 0.5;

Vector3 axle_of(const CasterDynamics& caster, const State& state, std::size_t i) {
  const double angle = state.casters[i].swivel_angle;
  return caster.point(state.pose(), angle, Vector3::UnitY()) -
         caster.point(state.pose(), angle, Vector3::Zero());
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

void FloorPoints::collect(const State& state, double margin,
                          std::vector<BodyContact>& contacts) const {
  const auto add_if_low = [&](const BodyContact::Side& side) {
    if (state.position.z() + mechanism_.point(side, state).z() < margin)
      contacts.emplace_back().side = side;
  };
  for (const Vector3& corner : corners_) add_if_low({item_, -1, corner});
  for (std::size_t i = 0; i < mechanism_.casters.size(); ++i) {
    const CasterDynamics& caster = mechanism_.casters[i];
    if (!CasterDynamics::lies(axle_of(caster, state, i))) continue;
    for (const bool left : {false, true})
      for (const Vector3& point : caster.rim(left)) add_if_low({item_, static_cast<int>(i), point});
  }
}

double FloorPoints::clearance(const State& state) const {
  double lowest = std::numeric_limits<double>::infinity();
  for (const Vector3& corner : corners_)
    lowest = std::min(lowest, state.position.z() + (state.rotation * corner).z());
  for (std::size_t i = 0; i < mechanism_.casters.size(); ++i)
    if (std::abs(axle_of(mechanism_.casters[i], state, i).z()) > kSteepAxle)
      lowest = std::min(lowest, 0.0);
  return lowest;
}

}  // namespace gurney
