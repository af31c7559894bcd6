#include "engine/scene/equipment_model.h"

#include <fmt/format.h>

#include <cmath>

#include "engine/scene/problems.h"

namespace gurney {
namespace {

constexpr double kRelativeTolerance = 1e-9;  // of inertias, for rounding
constexpr double kMountTolerance = 1e-9;     // [m]

void check_tread(const Tread& tread, Problems& problems) {
  problems.positive("tread.normal_stiffness", tread.normal_stiffness);
  problems.not_negative("tread.normal_damping", tread.normal_damping);
  problems.positive("tread.tangential_stiffness", tread.tangential_stiffness);
  problems.not_negative("tread.tangential_damping", tread.tangential_damping);
  problems.check(tread.relaxation_length >= 1e-4 && std::isfinite(tread.relaxation_length),
                 "tread.relaxation_length", tread.relaxation_length, ">= 0.0001 m and finite");
  problems.not_negative("tread.patch_width", tread.patch_width);
  problems.not_negative("tread.rolling_friction_length", tread.rolling_friction_length);
  problems.not_negative("tread.kinetic_friction", tread.kinetic_friction);
  problems.check(
      tread.static_friction >= tread.kinetic_friction && std::isfinite(tread.static_friction),
      "tread.static_friction", tread.static_friction, ">= tread.kinetic_friction and finite");
}

void check_caster(const Caster& caster, Problems& problems) {
  problems.finite("mount", caster.mount);
  problems.positive("wheel_radius", caster.wheel_radius);
  problems.check(caster.height > caster.wheel_radius && std::isfinite(caster.height), "height",
                 caster.height, "> wheel_radius and finite");
  problems.check(std::abs(caster.mount.z() - caster.height) <= kMountTolerance, "mount.z",
                 caster.mount.z(), "the height of the caster");
  problems.check(std::isfinite(caster.heading), "heading", caster.heading, "finite");
  problems.not_negative("trail", caster.trail);
  problems.positive("wheel_width", caster.wheel_width);
  problems.positive("wheel_mass", caster.wheel_mass);
  problems.positive("wheel_axial_inertia", caster.wheel_axial_inertia);
  problems.positive("wheel_transverse_inertia", caster.wheel_transverse_inertia);
  problems.check(
      caster.wheel_axial_inertia <= 2 * caster.wheel_transverse_inertia * (1 + kRelativeTolerance),
      "wheel_axial_inertia", caster.wheel_axial_inertia, "<= 2 wheel_transverse_inertia");
  problems.positive("fork_mass", caster.fork_mass);
  problems.finite("fork_center_of_mass", caster.fork_center_of_mass);
  problems.inertia("fork_inertia", caster.fork_inertia, false);
  problems.not_negative("axle.coulomb", caster.axle.coulomb);
  problems.not_negative("axle.viscous", caster.axle.viscous);
  problems.not_negative("swivel.coulomb", caster.swivel.coulomb);
  problems.not_negative("swivel.viscous", caster.swivel.viscous);
  problems.check(caster.brake_torque >= 0, "brake_torque", caster.brake_torque, ">= 0");
  problems.check(caster.brake_sliding_ratio >= 0.1 && caster.brake_sliding_ratio <= 1,
                 "brake_sliding_ratio", caster.brake_sliding_ratio, "0.1 to 1");
  problems.check(caster.swivel_lock_torque >= 0, "swivel_lock_torque", caster.swivel_lock_torque,
                 ">= 0");
  check_tread(caster.tread, problems);
}

void check_shape(const BodyShape& shape, std::size_t i, Problems& problems) {
  problems.finite(fmt::format("shape[{}].center", i), shape.center);
  if (!(shape.size.minCoeff() > 0 && shape.size.allFinite()))
    problems.add(fmt::format("shape[{}].size = ({}, {}, {}): each must be > 0 and finite", i,
                             shape.size.x(), shape.size.y(), shape.size.z()));
  if (const auto* cylinder = std::get_if<SolidCylinder>(&shape.solid)) {
    problems.positive(fmt::format("shape[{}].radius", i), cylinder->radius);
    problems.positive(fmt::format("shape[{}].length", i), cylinder->length);
    problems.check(std::abs(cylinder->axis.norm() - 1) < kRelativeTolerance,
                   fmt::format("norm of shape[{}].axis", i), cylinder->axis.norm(), "1");
  } else if (const auto* hull = std::get_if<SolidHull>(&shape.solid)) {
    problems.check(hull->corners.size() <= SolidHull::kMaxCorners && spans_a_volume(hull->corners),
                   fmt::format("shape[{}]: a hull has 4 to {} points that span a volume", i,
                               SolidHull::kMaxCorners));
  }
}

Matrix3 about_z(double angle) {
  return Eigen::AngleAxisd(angle, Vector3::UnitZ()).toRotationMatrix();
}

}  // namespace

void MassProperties::add(double part_mass, const Vector3& part_center,
                         const Matrix3& part_inertia) {
  const double total = mass + part_mass;
  if (total == 0) return;
  const Vector3 d = part_center - center_of_mass;
  inertia += part_inertia +
             mass * part_mass / total * (d.squaredNorm() * Matrix3::Identity() - d * d.transpose());
  center_of_mass += part_mass / total * d;
  mass = total;
}

MassProperties chassis_with_payloads(const EquipmentModel& item) {
  MassProperties sum;
  sum.add(item.chassis_mass, item.chassis_center_of_mass, item.chassis_inertia);
  for (const Payload& payload : item.payloads)
    sum.add(payload.mass, payload.center_of_mass, payload.inertia);
  return sum;
}

MassProperties whole_item(const EquipmentModel& item) {
  MassProperties sum = chassis_with_payloads(item);
  for (const Caster& caster : item.casters) {
    const Matrix3 turn = about_z(caster.heading);
    sum.add(caster.fork_mass, caster.mount + turn * caster.fork_center_of_mass,
            turn * caster.fork_inertia * turn.transpose());
    const Vector3 wheel(-caster.trail, 0, caster.wheel_radius - caster.height);
    const Vector3 moments(caster.wheel_transverse_inertia, caster.wheel_axial_inertia,
                          caster.wheel_transverse_inertia);
    sum.add(caster.wheel_mass, caster.mount + turn * wheel,
            turn * moments.asDiagonal() * turn.transpose());
  }
  return sum;
}

Matrix3 solid_box_inertia(double mass, const Vector3& size) {
  const Vector3 squares = size.cwiseProduct(size);
  return (mass / 12 * (Vector3::Constant(squares.sum()) - squares)).asDiagonal();
}

void validate(const EquipmentModel& item) {
  Problems problems;
  const std::string owner = item.name.empty() ? "item: " : "item '" + item.name + "': ";
  problems.set_prefix(owner);
  problems.positive("chassis_mass", item.chassis_mass);
  problems.finite("chassis_center_of_mass", item.chassis_center_of_mass);
  problems.inertia("chassis_inertia", item.chassis_inertia, true);
  if (item.shape.empty()) problems.add("shape has no box or other solid: 1 or more are needed");
  for (std::size_t i = 0; i < item.shape.size(); ++i) check_shape(item.shape[i], i, problems);
  const std::size_t casters = item.casters.size();
  if (casters > EquipmentModel::kMaxCasters)
    problems.add(fmt::format("{} casters: must be 0 to {}", casters, EquipmentModel::kMaxCasters));
  for (const Payload& payload : item.payloads) {
    problems.set_prefix(owner + "payload '" + payload.name + "': ");
    problems.positive("mass", payload.mass);
    problems.finite("center_of_mass", payload.center_of_mass);
    problems.inertia("inertia", payload.inertia, false);
  }
  for (std::size_t i = 0; i < casters; ++i) {
    const Caster& caster = item.casters[i];
    problems.set_prefix(owner + "caster '" +
                        (caster.name.empty() ? std::to_string(i) : caster.name) + "': ");
    check_caster(caster, problems);
  }
  for (const MarkedPoint& point : item.marked_points) {
    problems.set_prefix(owner + "marked point '" + point.name + "': ");
    problems.finite("position", point.position);
  }
  problems.finish();
}

}  // namespace gurney
