#include "equipment/catalogue/item_sheet.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "engine/base/polygon.h"
#include "engine/base/units.h"
#include "equipment/catalogue/support.h"

namespace gurney::equipment {
namespace {

constexpr int kDegreesApart = 15;

Vector3 size_of(const EquipmentModel& item) {
  Vector3 low = Vector3::Constant(1e300), high = -low;
  const auto include = [&](const Vector3& corner, const Vector3& other) {
    low = low.cwiseMin(corner);
    high = high.cwiseMax(other);
  };
  for (const BodyShape& box : item.shape)
    include(box.center - box.size / 2, box.center + box.size / 2);
  for (const Caster& caster : item.casters)
    include({caster.mount.x(), caster.mount.y(), 0}, caster.mount);
  return high - low;
}

std::vector<TiltTowards> tilts_of(const EquipmentModel& item, const Vector3& center) {
  const auto placed = supports_of(item, Swivels::kAsPlaced);
  const auto anywhere = supports_of(item, Swivels::kAnywhere);
  std::vector<TiltTowards> tilts;
  for (int degrees = 0; degrees < 360; degrees += kDegreesApart) {
    const double direction = degrees * kRadiansPerDegree;
    const auto tilt = [&](const std::vector<Support>& supports) {
      return std::atan2(reach_towards(supports, center.head<2>(), direction), center.z());
    };
    tilts.push_back({direction, tilt(placed), tilt(anywhere)});
  }
  return tilts;
}

}  // namespace

ItemSheet item_sheet(const EquipmentModel& item, const ContactConstants& floor) {
  ItemSheet sheet;
  sheet.whole = whole_item(item);
  sheet.principal_inertia =
      Eigen::SelfAdjointEigenSolver<Matrix3>(sheet.whole.inertia, Eigen::EigenvaluesOnly)
          .eigenvalues();
  sheet.size = size_of(item);
  sheet.stability = stability_of(item);
  sheet.tilts = tilts_of(item, sheet.whole.center_of_mass);
  const auto contacts = supports_of(item, Swivels::kAsPlaced);
  std::vector<Vector2> centers;
  for (const Support& contact : contacts) centers.push_back(contact.center);
  sheet.support_polygon = convex_polygon(std::move(centers));

  const double weight = sheet.whole.mass * kStandardGravity;
  double sliding = 0, holding = 0;
  for (std::size_t i = 0; i < item.casters.size(); ++i) {
    const Caster& caster = item.casters[i];
    const double load = sheet.stability.wheel_loads[i];
    sheet.wheels.push_back(
        {caster.name, contacts[i].center, load, load / caster.tread.normal_stiffness});
    const double rolling =
        (caster.tread.rolling_friction_length * load + caster.axle.coulomb) / caster.wheel_radius;
    const double grip = caster.tread.static_friction * load;
    sheet.rolling_resistance_force += rolling;
    sliding += grip;
    holding += std::min(grip, rolling + caster.brake_torque / caster.wheel_radius);
  }
  if (item.casters.empty()) sliding = holding = floor.friction * weight;
  sheet.rolling_resistance_coefficient = sheet.rolling_resistance_force / weight;
  sheet.sliding_share = sliding / weight;
  sheet.holding_share = holding / weight;
  sheet.tipping_share = std::tan(sheet.stability.tilt_as_placed);
  return sheet;
}

}  // namespace gurney::equipment
