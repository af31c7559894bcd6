#include "studies/exports/item_bodies.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/base/error.h"
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

ItemBodies item_bodies(const EquipmentModel& item, std::vector<PartBody> parts) {
  ItemBodies bodies{plain_identifier(item.name, "item"),
                    chassis_with_payloads(item),
                    item.shape,
                    {},
                    item.marked_points,
                    std::move(parts)};
  std::vector<std::string> taken{"floor", "chassis"};
  const auto bodies_of = [&taken](const Caster& caster) -> CasterBodies {
    const std::string name = own_name(caster.name, "caster", taken);
    return {own_name(name + "_fork", "fork", taken), own_name(name + "_wheel", "wheel", taken),
            caster, hinge_of(caster.swivel, caster.swivel_lock_torque, caster.swivels),
            hinge_of(caster.axle, caster.brake_torque, true)};
  };
  for (const Caster& caster : item.casters) bodies.casters.push_back(bodies_of(caster));
  for (PartBody& part : bodies.parts) {
    part.name = own_name(part.name, "part", taken);
    for (CasterBodies& each : part.casters) each = bodies_of(each.caster);
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

namespace {

std::string mjcf_inertial(double mass, const Vector3& center, const Matrix3& inertia) {
  return fmt::format("<inertial mass=\"{}\" pos=\"{}\" fullinertia=\"{} {} {} {} {} {}\"/>\n", mass,
                     numbers_text(center), inertia(0, 0), inertia(1, 1), inertia(2, 2),
                     inertia(0, 1), inertia(0, 2), inertia(1, 2));
}

std::string mjcf_joint(const std::string& name, const char* axis, const Hinge& hinge) {
  if (!hinge.turns) return {};
  return fmt::format(
      "<joint name=\"{}\" type=\"hinge\" axis=\"{}\" frictionloss=\"{}\" damping=\"{}\"/>\n", name,
      axis, hinge.dry, hinge.viscous);
}

/// The wheel's own friction counts (priority). MuJoCo's coefficients are sliding [-], twisting [m]
/// and rolling [m]: mu; mu w / 4, the most that a patch of width w resists (docs/theory/tread.md);
/// Cr.
std::string wheel_geom(const CasterBodies& bodies) {
  const Caster& c = bodies.caster;
  const double mu = c.tread.kinetic_friction;
  return fmt::format(
      "<geom class=\"item\" type=\"cylinder\" fromto=\"0 {} 0 0 {} 0\" size=\"{}\" priority=\"1\" "
      "condim=\"6\" friction=\"{} {} {}\"/>\n",
      -c.wheel_width / 2, c.wheel_width / 2, c.wheel_radius, mu, mu * c.tread.patch_width / 4,
      c.tread.rolling_friction_length);
}

std::string mjcf_caster(const CasterBodies& bodies) {
  const Caster& c = bodies.caster;
  return fmt::format("      <body name=\"{}\" pos=\"{}\" euler=\"0 0 {}\">\n        ", bodies.fork,
                     numbers_text(c.mount), c.heading) +
         mjcf_joint(bodies.fork + "_swivel", "0 0 1", bodies.swivel) + "        " +
         mjcf_inertial(c.fork_mass, c.fork_center_of_mass, c.fork_inertia) +
         fmt::format("        <body name=\"{}\" pos=\"{}\">\n          ", bodies.wheel,
                     numbers_text({-c.trail, 0, c.wheel_radius - c.height})) +
         mjcf_joint(bodies.wheel + "_axle", "0 1 0", bodies.axle) + "          " +
         mjcf_inertial(c.wheel_mass, Vector3::Zero(), wheel_inertia(c)) + "          " +
         wheel_geom(bodies) + "        </body>\n      </body>\n";
}

/// MuJoCo's own solids; of a hull the mesh that mjcf_meshes has described.
std::string mjcf_solid(const BodyShape& shape, const std::string& mesh) {
  const std::string place = fmt::format("pos=\"{}\"", numbers_text(shape.center));
  if (const auto* cylinder = std::get_if<SolidCylinder>(&shape.solid))
    return fmt::format("type=\"cylinder\" {} zaxis=\"{}\" size=\"{} {}\"", place,
                       numbers_text(cylinder->axis), cylinder->radius, cylinder->length / 2);
  if (const auto* sphere = std::get_if<SolidSphere>(&shape.solid))
    return fmt::format("type=\"sphere\" {} size=\"{}\"", place, sphere->radius);
  if (shape.is_box())
    return fmt::format("type=\"box\" {} size=\"{}\"", place, numbers_text(shape.size / 2));
  return fmt::format("type=\"mesh\" mesh=\"{}\"", mesh);
}

std::string mesh_name(const std::string& body, std::size_t index) {
  return fmt::format("{}_hull_{}", body, index + 1);
}

/// @param body  its name, before those of its meshes
std::string mjcf_shape(const std::vector<BodyShape>& shapes, const std::string& body,
                       const std::string& more) {
  std::string text;
  for (std::size_t i = 0; i < shapes.size(); ++i)
    text += fmt::format("      <geom class=\"item\" {}{}/>\n",
                        mjcf_solid(shapes[i], mesh_name(body, i)), more);
  return text;
}

/// MuJoCo moves a mesh to its centre of volume and the geom back to where its vertices say.
std::string mjcf_meshes(const std::vector<BodyShape>& shapes, const std::string& body) {
  std::string text;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    if (!std::holds_alternative<SolidHull>(shapes[i].solid)) continue;
    std::string points;
    for (const Vector3& point : outline_points(shapes[i]))
      points += (points.empty() ? "" : "  ") + numbers_text(point);
    text += fmt::format("    <mesh name=\"{}\" vertex=\"{}\"/>\n", mesh_name(body, i), points);
  }
  return text;
}

/// The joint of a part; nothing where it holds.
std::string mjcf_part_joint(const PartBody& part) {
  const Joint& joint = *part.joint;
  const auto element = [&](const std::string& suffix, const char* type, const Vector3& axis) {
    std::string text = fmt::format(
        "      <joint name=\"{}{}\" type=\"{}\" pos=\"{}\" axis=\"{}\" stiffness=\"{}\" "
        "damping=\"{}\"",
        part.name, suffix, type, numbers_text(joint.point), numbers_text(axis), joint.stiffness,
        joint.damping);
    if (joint.friction > 0) text += fmt::format(" frictionloss=\"{}\"", joint.friction);
    if (joint.rest != 0) text += fmt::format(" springref=\"{}\"", joint.rest);
    if (std::isfinite(joint.lower) || std::isfinite(joint.upper)) {
      const auto end = [](double value) {
        return std::isfinite(value) ? value : std::copysign(1e6, value);
      };
      text += fmt::format(" limited=\"true\" range=\"{} {}\"", end(joint.lower), end(joint.upper));
    }
    return text + "/>\n";
  };
  if (std::isinf(joint.latch)) return {};
  switch (joint.kind) {
    case Joint::Kind::kFixed:
      return {};
    case Joint::Kind::kHinge:
      return element("_joint", "hinge", joint.axis);
    case Joint::Kind::kSlider:
      return element("_joint", "slide", joint.axis);
    case Joint::Kind::kBall:
      return element("_joint", "ball", joint.axis);
    case Joint::Kind::kFlexible:
      break;
  }
  const Vector3 across = joint.axis.unitOrthogonal();
  return element("_bend_1", "hinge", across) +
         element("_bend_2", "hinge", joint.axis.cross(across));
}

/// The parts that hang on the chassis (0) or on part i (i + 1), each with those on it.
std::string mjcf_parts(const ItemBodies& item, std::size_t base) {
  std::string text;
  for (std::size_t i = 0; i < item.parts.size(); ++i) {
    const PartBody& part = item.parts[i];
    if (!part.joint || part.joint->base != base) continue;
    text += fmt::format("      <body name=\"{}\">\n", part.name) + mjcf_part_joint(part) +
            "      " + mjcf_inertial(part.body.mass, part.body.center_of_mass, part.body.inertia) +
            mjcf_shape(part.shape, part.name, "");
    for (const CasterBodies& each : part.casters) text += mjcf_caster(each);
    text += mjcf_parts(item, i + 1) + "      </body>\n";
  }
  return text;
}

bool rolls(const PartBody& content) {
  return std::ranges::any_of(content.shape, [](const BodyShape& shape) {
    return std::holds_alternative<SolidCylinder>(shape.solid) ||
           std::holds_alternative<SolidSphere>(shape.solid);
  });
}

std::string mjcf_contents(const ItemBodies& item) {
  std::string text;
  for (const PartBody& content : item.parts) {
    if (content.joint) continue;
    text += fmt::format(
                "    <body name=\"{}\" pos=\"{}\" euler=\"0 0 {}\">\n      <freejoint/>\n      ",
                content.name, numbers_text(content.origin), content.yaw) +
            mjcf_inertial(content.body.mass, content.body.center_of_mass, content.body.inertia) +
            mjcf_shape(content.shape, content.name,
                       rolls(content)
                           ? fmt::format(" contype=\"1\" condim=\"6\" friction=\"{} 0 {}\"",
                                         content.friction, content.rolling_resistance)
                           : fmt::format(" contype=\"1\" friction=\"{} 0 0\"", content.friction)) +
            "    </body>\n";
  }
  return text;
}

}  // namespace

std::string mjcf_text(const ItemBodies& item) {
  std::string meshes = mjcf_meshes(item.shape, "chassis");
  for (const PartBody& part : item.parts) meshes += mjcf_meshes(part.shape, part.name);
  std::string text = fmt::format(
      "<mujoco model=\"{}\">\n"
      "  <compiler angle=\"radian\" inertiafromgeom=\"false\" boundmass=\"0\" boundinertia=\"0\" "
      "balanceinertia=\"false\"/>\n"
      "  <option cone=\"elliptic\"/>\n"
      "  <default>\n    <default class=\"item\"><geom contype=\"0\" conaffinity=\"1\"/></default>\n"
      "  </default>\n"
      "{}  <worldbody>\n    <geom name=\"floor\" type=\"plane\" size=\"0 0 1\"/>\n"
      "    <body name=\"chassis\">\n      <freejoint/>\n      {}",
      item.name, meshes.empty() ? "" : "  <asset>\n" + meshes + "  </asset>\n",
      mjcf_inertial(item.chassis.mass, item.chassis.center_of_mass, item.chassis.inertia));
  text += mjcf_shape(item.shape, "chassis", "");
  for (const MarkedPoint& point : item.points)
    text += fmt::format("      <site name=\"{}\" pos=\"{}\"/>\n", point.name,
                        numbers_text(point.position));
  for (const CasterBodies& each : item.casters) text += mjcf_caster(each);
  text += mjcf_parts(item, 0);
  return text + "    </body>\n" + mjcf_contents(item) + "  </worldbody>\n</mujoco>\n";
}

namespace {

std::string urdf_inertial(double mass, const Vector3& center, const Matrix3& inertia) {
  return fmt::format(
      "    <inertial>\n      <origin xyz=\"{}\" rpy=\"0 0 0\"/>\n      <mass value=\"{}\"/>\n"
      "      <inertia ixx=\"{}\" ixy=\"{}\" ixz=\"{}\" iyy=\"{}\" iyz=\"{}\" izz=\"{}\"/>\n"
      "    </inertial>\n",
      numbers_text(center), mass, inertia(0, 0), inertia(0, 1), inertia(0, 2), inertia(1, 1),
      inertia(1, 2), inertia(2, 2));
}

/// Shape that is seen, and that collides.
std::string shape(const Vector3& center, const char* rpy, const std::string& geometry) {
  std::string text;
  for (const char* element : {"visual", "collision"})
    text += fmt::format(
        "    <{0}>\n      <origin xyz=\"{1}\" rpy=\"{2}\"/>\n      <geometry>{3}</geometry>\n"
        "    </{0}>\n",
        element, numbers_text(center), rpy, geometry);
  return text;
}

std::string urdf_solid(const BodyShape& solid) {
  if (solid.is_box())
    return shape(solid.center, "0 0 0",
                 fmt::format("<box size=\"{}\"/>", numbers_text(solid.size)));
  if (const auto* sphere = std::get_if<SolidSphere>(&solid.solid))
    return shape(solid.center, "0 0 0", fmt::format("<sphere radius=\"{}\"/>", sphere->radius));
  const auto* cylinder = std::get_if<SolidCylinder>(&solid.solid);
  require(cylinder != nullptr,
          "a hull would need a mesh file of its own in URDF; --to mjcf exports it");
  const Vector3& axis = cylinder->axis;  // pitch, then yaw turn z there
  const std::string turn = fmt::format("0 {} {}", std::atan2(axis.head<2>().norm(), axis.z()),
                                       std::atan2(axis.y(), axis.x()));
  return shape(
      solid.center, turn.c_str(),
      fmt::format("<cylinder radius=\"{}\" length=\"{}\"/>", cylinder->radius, cylinder->length));
}

std::string urdf_joint(const std::string& parent, const std::string& child, const Vector3& origin,
                       double heading, const char* axis, const Hinge& hinge) {
  const std::string moves = hinge.turns
                                ? fmt::format(
                                      "    <axis xyz=\"{}\"/>\n    <dynamics damping=\"{}\" "
                                      "friction=\"{}\"/>\n",
                                      axis, hinge.viscous, hinge.dry)
                                : "";
  return fmt::format(
      "  <joint name=\"{1}_joint\" type=\"{2}\">\n    <parent link=\"{0}\"/>\n"
      "    <child link=\"{1}\"/>\n    <origin xyz=\"{3}\" rpy=\"0 0 {4}\"/>\n{5}  </joint>\n",
      parent, child, hinge.turns ? "continuous" : "fixed", numbers_text(origin), heading, moves);
}

std::string urdf_caster(const CasterBodies& bodies) {
  const Caster& c = bodies.caster;
  const std::string cylinder =
      fmt::format("<cylinder radius=\"{}\" length=\"{}\"/>", c.wheel_radius, c.wheel_width);
  return fmt::format("  <link name=\"{}\">\n", bodies.fork) +
         urdf_inertial(c.fork_mass, c.fork_center_of_mass, c.fork_inertia) + "  </link>\n" +
         urdf_joint("chassis", bodies.fork, c.mount, c.heading, "0 0 1", bodies.swivel) +
         fmt::format("  <link name=\"{}\">\n", bodies.wheel) +
         urdf_inertial(c.wheel_mass, Vector3::Zero(), wheel_inertia(c)) +
         shape(Vector3::Zero(), "1.5707963267948966 0 0", cylinder) + "  </link>\n" +
         urdf_joint(bodies.fork, bodies.wheel, {-c.trail, 0, c.wheel_radius - c.height}, 0, "0 1 0",
                    bodies.axle);
}

}  // namespace

std::string urdf_text(const ItemBodies& item) {
  require(item.parts.empty(),
          item.name +
              " has parts or contents, for which URDF has no friction, stops or "
              "loose bodies; --to mjcf exports them");
  std::string text = fmt::format(
      "<?xml version=\"1.0\"?>\n<robot name=\"{}\">\n  <link name=\"chassis\">\n{}", item.name,
      urdf_inertial(item.chassis.mass, item.chassis.center_of_mass, item.chassis.inertia));
  for (const BodyShape& each : item.shape) text += urdf_solid(each);
  text += "  </link>\n";
  for (const CasterBodies& each : item.casters) text += urdf_caster(each);
  return text + "</robot>\n";
}

}  // namespace gurney::study
