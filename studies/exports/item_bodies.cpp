#include "studies/exports/item_bodies.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "studies/exports/export.h"

namespace gurney::study {
namespace {

Hinge hinge_of(const BearingFriction& bearing, double brake, bool turns) {
  if (!turns || std::isinf(brake)) return {false, 0, 0};
  return {true, bearing.coulomb + brake, bearing.viscous};
}

/// An identifier that is not among `taken`, which then has it.
std::string own_name(const std::string& name, const std::string& otherwise,
                     std::vector<std::string>& taken) {
  const std::string plain = plain_identifier(name, otherwise);
  std::string own = plain;
  for (int i = 2; std::ranges::find(taken, own) != taken.end(); ++i)
    own = fmt::format("{}_{}", plain, i);
  taken.push_back(own);
  return own;
}

}  // namespace

ItemBodies item_bodies(const EquipmentModel& item) {
  ItemBodies bodies{plain_identifier(item.name, "item"),
                    chassis_with_payloads(item),
                    item.shape,
                    {},
                    item.marked_points};
  std::vector<std::string> taken{"floor", "chassis"};
  for (const Caster& caster : item.casters) {
    const std::string name = own_name(caster.name, "caster", taken);
    bodies.casters.push_back({own_name(name + "_fork", "fork", taken),
                              own_name(name + "_wheel", "wheel", taken), caster,
                              hinge_of(caster.swivel, caster.swivel_lock_torque, caster.swivels),
                              hinge_of(caster.axle, caster.brake_torque, true)});
  }
  std::vector<std::string> points;
  for (MarkedPoint& point : bodies.points) point.name = own_name(point.name, "point", points);
  return bodies;
}

Matrix3 wheel_inertia(const Caster& caster) {
  return Vector3(caster.wheel_transverse_inertia, caster.wheel_axial_inertia,
                 caster.wheel_transverse_inertia)
      .asDiagonal();
}

std::string numbers_text(const Vector3& vector) {
  return fmt::format("{} {} {}", vector.x(), vector.y(), vector.z());
}

}  // namespace gurney::study
