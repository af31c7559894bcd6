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
  const Vector3& center = mechanism.chassis.center_of_mass;
  for (std::size_t k = 0; k < model.shape.size(); ++k) {
    const BodyShape& shape = model.shape[k];
    if (mechanism.surfaces[k].radius > 0) {
      rounds_.push_back({static_cast<int>(k), body_form(shape, center)});
      continue;
    }
    for (const Vector3& corner : outline_points(shape)) corners_.push_back(corner - center);
  }
}

void FloorPoints::add_points(const Round& round, const Matrix3& rotation,
                             std::vector<BodyContact::Side>& sides) const {
  const Vector3 down = -rotation.row(2).transpose();  // chassis axes
  const auto add_lowest = [&](const Vector3& local) {
    sides.push_back({item_, -1, local, -Vector3::UnitZ(), round.shape});
  };
  if (const auto* sphere = std::get_if<Sphere>(&round.form))
    return add_lowest(sphere->center + sphere->radius * down);
  const auto& cylinder = std::get<Cylinder>(round.form);
  const Vector3 out = cylinder.across(down);
  const double tilt = out.norm();
  for (const int end : {-1, 1}) {
    if (tilt < Cylinder::kFlat && end * cylinder.axis.dot(down) > 0)
      for (const Vector3& point : cylinder.rim_points(end)) sides.push_back({item_, -1, point});
    if (tilt >= Cylinder::kTilted)
      add_lowest(cylinder.center + end * cylinder.half_height * cylinder.axis +
                 (cylinder.radius / tilt) * out);
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
    if (!rounds_.empty()) {
      const Matrix3 rotation = state.rotation.toRotationMatrix();
      std::vector<BodyContact::Side> sides;
      for (const Round& round : rounds_) {
        add_points(round, rotation, sides);
        lowest = std::min(lowest, state.position.z() + gurney::lowest(round.form, rotation.row(2)));
      }
      for (const BodyContact::Side& side : sides) add_if_low(side);
    }
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
