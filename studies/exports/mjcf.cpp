#include <fmt/format.h>

#include <utility>

#include "studies/exports/item_bodies.h"

namespace gurney::study {
namespace {

std::string inertial(double mass, const Vector3& center, const Matrix3& inertia) {
  return fmt::format("<inertial mass=\"{}\" pos=\"{}\" fullinertia=\"{} {} {} {} {} {}\"/>\n", mass,
                     numbers_text(center), inertia(0, 0), inertia(1, 1), inertia(2, 2),
                     inertia(0, 1), inertia(0, 2), inertia(1, 2));
}

std::string joint(const std::string& name, const char* axis, const Hinge& hinge) {
  if (!hinge.turns) return {};
  return fmt::format(
      "<joint name=\"{}\" type=\"hinge\" axis=\"{}\" frictionloss=\"{}\" damping=\"{}\"/>\n", name,
      axis, hinge.dry, hinge.viscous);
}

/// The wheel's own friction counts (priority). MuJoCo's coefficients are sliding [-], twisting [m] and
/// rolling [m]: mu; mu w / 4, the most that a patch of width w resists (docs/theory/tread.md); Cr.
std::string wheel_geom(const CasterBodies& bodies) {
  const Caster& c = bodies.caster;
  const double mu = c.tread.kinetic_friction;
  return fmt::format(
      "<geom class=\"item\" type=\"cylinder\" fromto=\"0 {} 0 0 {} 0\" size=\"{}\" priority=\"1\" "
      "condim=\"6\" friction=\"{} {} {}\"/>\n",
      -c.wheel_width / 2, c.wheel_width / 2, c.wheel_radius, mu, mu * c.tread.patch_width / 4,
      c.tread.rolling_friction_length);
}

std::string caster_text(const CasterBodies& bodies) {
  const Caster& c = bodies.caster;
  return fmt::format("      <body name=\"{}\" pos=\"{}\" euler=\"0 0 {}\">\n        ", bodies.fork,
                     numbers_text(c.mount), c.heading) +
         joint(bodies.fork + "_swivel", "0 0 1", bodies.swivel) + "        " +
         inertial(c.fork_mass, c.fork_center_of_mass, c.fork_inertia) +
         fmt::format("        <body name=\"{}\" pos=\"{}\">\n          ", bodies.wheel,
                     numbers_text({-c.trail, 0, c.wheel_radius - c.height})) +
         joint(bodies.wheel + "_axle", "0 1 0", bodies.axle) + "          " +
         inertial(c.wheel_mass, Vector3::Zero(), wheel_inertia(c)) + "          " +
         wheel_geom(bodies) + "        </body>\n      </body>\n";
}

}  // namespace

std::string mjcf_text(const ItemBodies& item) {
  std::string text = fmt::format(
      "<mujoco model=\"{}\">\n"
      "  <compiler angle=\"radian\" inertiafromgeom=\"false\" boundmass=\"0\" boundinertia=\"0\" "
      "balanceinertia=\"false\"/>\n"
      "  <option cone=\"elliptic\"/>\n"
      "  <default>\n    <default class=\"item\"><geom contype=\"0\" conaffinity=\"1\"/></default>\n"
      "  </default>\n"
      "  <worldbody>\n    <geom name=\"floor\" type=\"plane\" size=\"0 0 1\"/>\n"
      "    <body name=\"chassis\">\n      <freejoint/>\n      {}",
      item.name, inertial(item.chassis.mass, item.chassis.center_of_mass, item.chassis.inertia));
  for (const Box& box : item.shape)
    text += fmt::format("      <geom class=\"item\" type=\"box\" pos=\"{}\" size=\"{}\"/>\n",
                        numbers_text(box.center), numbers_text(box.size / 2));
  for (const MarkedPoint& point : item.points)
    text += fmt::format("      <site name=\"{}\" pos=\"{}\"/>\n", point.name,
                        numbers_text(point.position));
  for (const CasterBodies& each : item.casters) text += caster_text(each);
  return text + "    </body>\n  </worldbody>\n</mujoco>\n";
}

}  // namespace gurney::study
