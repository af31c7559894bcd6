#include "equipment/catalogue/implausible.h"

#include <fmt/format.h>

namespace gurney::equipment {
namespace {

// Densities of what equipment is made of, as boxes full of air and as solid metal (assumptions).
constexpr double kLightest = 20, kHeaviest = 3000;  // [kg/m3]

}  // namespace

std::vector<std::string> implausible(const EquipmentModel& item) {
  std::vector<std::string> findings;
  double volume = 0;
  Vector3 low = Vector3::Constant(1e300), high = -low;
  for (const Box& box : item.shape) {
    volume += box.size.prod();
    low = low.cwiseMin(box.center - box.size / 2);
    high = high.cwiseMax(box.center + box.size / 2);
  }
  const MassProperties chassis = chassis_with_payloads(item);
  const double density = chassis.mass / volume;
  if (!(density >= kLightest && density <= kHeaviest))
    findings.push_back(
        fmt::format("{}: {:.4g} kg in shapes of {:.4g} m3 are {:.4g} kg/m3; {:g} to {:g} is usual",
                    item.name, chassis.mass, volume, density, kLightest, kHeaviest));
  const Vector3 center = chassis.center_of_mass;
  if ((center.array() < low.array()).any() || (center.array() > high.array()).any())
    findings.push_back(
        fmt::format("{}: the centre of mass ({:.3g}, {:.3g}, {:.3g}) m lies outside the shapes",
                    item.name, center.x(), center.y(), center.z()));
  for (const Caster& caster : item.casters)
    if (caster.swivels && caster.trail == 0)
      findings.push_back(fmt::format("{}: caster '{}' swivels but has no trail to align it",
                                     item.name, caster.name));
  return findings;
}

std::vector<std::string> implausible(const CasterType& caster) {
  std::vector<std::string> findings;
  const Caster& c = caster.properties;
  if (c.tread.patch_width > c.wheel_width)
    findings.push_back(
        fmt::format("{}: the contact patch ({:g} m) is wider than the wheel ({:g} m)", caster.name,
                    c.tread.patch_width, c.wheel_width));
  if (c.wheel_axial_inertia > c.wheel_mass * c.wheel_radius * c.wheel_radius)
    findings.push_back(caster.name + ": the wheel's inertia is larger than that of a hoop");
  return findings;
}

}  // namespace gurney::equipment
