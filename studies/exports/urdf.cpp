#include <fmt/format.h>

#include "studies/exports/item_bodies.h"

namespace gurney::study {
namespace {

std::string inertial(double mass, const Vector3& center, const Matrix3& inertia) {
  return fmt::format(
      "    <inertial>\n      <origin xyz=\"{}\" rpy=\"0 0 0\"/>\n      <mass value=\"{}\"/>\n"
      "      <inertia ixx=\"{}\" ixy=\"{}\" ixz=\"{}\" iyy=\"{}\" iyz=\"{}\" izz=\"{}\"/>\n"
      "    </inertial>\n",
      numbers_text(center), mass, inertia(0, 0), inertia(0, 1), inertia(0, 2), inertia(1, 1),
      inertia(1, 2), inertia(2, 2));
}

/// What is seen, and what collides.
std::string shape(const Vector3& center, const char* rpy, const std::string& geometry) {
  std::string text;
  for (const char* element : {"visual", "collision"})
    text += fmt::format(
        "    <{0}>\n      <origin xyz=\"{1}\" rpy=\"{2}\"/>\n      <geometry>{3}</geometry>\n"
        "    </{0}>\n",
        element, numbers_text(center), rpy, geometry);
  return text;
}

std::string joint(const std::string& parent, const std::string& child, const Vector3& origin,
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

std::string caster_text(const CasterBodies& bodies) {
  const Caster& c = bodies.caster;
  const std::string cylinder =
      fmt::format("<cylinder radius=\"{}\" length=\"{}\"/>", c.wheel_radius, c.wheel_width);
  return fmt::format("  <link name=\"{}\">\n", bodies.fork) +
         inertial(c.fork_mass, c.fork_center_of_mass, c.fork_inertia) + "  </link>\n" +
         joint("chassis", bodies.fork, c.mount, c.heading, "0 0 1", bodies.swivel) +
         fmt::format("  <link name=\"{}\">\n", bodies.wheel) +
         inertial(c.wheel_mass, Vector3::Zero(), wheel_inertia(c)) +
         shape(Vector3::Zero(), "1.5707963267948966 0 0", cylinder) + "  </link>\n" +
         joint(bodies.fork, bodies.wheel, {-c.trail, 0, c.wheel_radius - c.height}, 0, "0 1 0",
               bodies.axle);
}

}  // namespace

std::string urdf_text(const ItemBodies& item) {
  std::string text = fmt::format(
      "<?xml version=\"1.0\"?>\n<robot name=\"{}\">\n  <link name=\"chassis\">\n{}", item.name,
      inertial(item.chassis.mass, item.chassis.center_of_mass, item.chassis.inertia));
  for (const Box& box : item.shape)
    text += shape(box.center, "0 0 0", fmt::format("<box size=\"{}\"/>", numbers_text(box.size)));
  text += "  </link>\n";
  for (const CasterBodies& each : item.casters) text += caster_text(each);
  return text + "</robot>\n";
}

}  // namespace gurney::study
