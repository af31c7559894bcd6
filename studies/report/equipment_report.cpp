#include "studies/report/equipment_report.h"

#include <fmt/format.h>

#include "engine/base/units.h"

namespace gurney::report {
namespace {

constexpr double kTransportTilt = 10, kOtherTilt = 5;  ///< of IEC 60601-1 [deg]

double degrees(double radians) { return radians / kRadiansPerDegree; }

std::string body_text(const EquipmentFacts& facts) {
  const equipment::ItemSheet& sheet = facts.sheet;
  const Vector3& center = sheet.whole.center_of_mass;
  const Matrix3& inertia = sheet.whole.inertia;
  std::string text = fmt::format("  {:<28} {:.1f} kg\n", "mass", sheet.whole.mass);
  text += fmt::format("  {:<28} {:.0f} x {:.0f} x {:.0f} mm\n", "length, width, height",
                      sheet.size.x() * kMillimetersPerMeter, sheet.size.y() * kMillimetersPerMeter,
                      sheet.size.z() * kMillimetersPerMeter);
  text += fmt::format("  {:<28} ({:.0f}, {:.0f}, {:.0f}) mm\n", "centre of mass",
                      center.x() * kMillimetersPerMeter, center.y() * kMillimetersPerMeter,
                      center.z() * kMillimetersPerMeter);
  text += fmt::format("  {:<28} {:.4g}, {:.4g}, {:.4g} kg m2; principal {:.4g}, {:.4g}, {:.4g}\n",
                      "inertia about x, y, z", inertia(0, 0), inertia(1, 1), inertia(2, 2),
                      sheet.principal_inertia.x(), sheet.principal_inertia.y(),
                      sheet.principal_inertia.z());
  if (!facts.variants.empty())
    text += fmt::format("  {:<28} {}\n", "variants", fmt::join(facts.variants, ", "));
  return text;
}

std::string stability_text(const EquipmentFacts& facts) {
  const equipment::ItemSheet& sheet = facts.sheet;
  const equipment::Stability& stability = sheet.stability;
  const double tilt = degrees(stability.tilt);
  std::string text = "\nstability\n";
  if (facts.model.casters.empty()) {
    text += fmt::format("  {:<28} {:.2f}; slenderness h / b {:.1f}\n", "b / h", sheet.tipping_share,
                        1 / sheet.tipping_share);
    text += fmt::format("  {:<28} {:.1f} deg towards {:.0f} deg\n", "overturns at a tilt of", tilt,
                        degrees(stability.direction));
    text += fmt::format("  {:<28} 5 deg of what is not mobile: {}\n", "IEC 60601-1",
                        tilt >= kOtherTilt ? "met" : "not met");
  } else {
    text += fmt::format("  {:<28} {:.2f}, wheels as placed; {:.2f}, swivels at their worst\n",
                        "b / h", sheet.tipping_share, stability.base / stability.height);
    text += fmt::format("  {:<28} {:.1f} deg, wheels as placed\n", "overturns at a tilt of",
                        degrees(stability.tilt_as_placed));
    text += fmt::format("  {:<28} {:.1f} deg towards {:.0f} deg, swivels at their worst\n", "",
                        tilt, degrees(stability.direction));
    text += fmt::format("  {:<28} 10 deg in transport: {}; 5 deg otherwise: {}\n", "IEC 60601-1",
                        tilt >= kTransportTilt ? "met" : "not met",
                        tilt >= kOtherTilt ? "met" : "not met");
  }
  const bool rolls = !facts.model.casters.empty();
  text += rolls ? "\n  tilt towards     as placed   at worst      towards   as placed   at worst\n"
                : "\n  tilt towards      overturns      towards   overturns\n";
  const std::size_t half = sheet.tilts.size() / 2;
  const auto cells = [&](const equipment::TiltTowards& t) {
    if (!rolls)
      return fmt::format("{:>8.0f} deg {:>7.1f} deg", degrees(t.direction), degrees(t.as_placed));
    return fmt::format("{:>8.0f} deg {:>7.1f} deg {:>6.1f} deg", degrees(t.direction),
                       degrees(t.as_placed), degrees(t.worst));
  };
  for (std::size_t i = 0; i < half; ++i)
    text += fmt::format("  {}  {}\n", cells(sheet.tilts[i]), cells(sheet.tilts[half + i]));
  text += "  0 deg is forward (x), 90 deg to the left (y)\n";
  return text;
}

std::string feet_text(const EquipmentFacts& facts) {
  const ContactConstants& floor = facts.floor;
  std::string text = "\nstands without casters\n";
  for (const Vector2& corner : facts.sheet.support_polygon)
    text += fmt::format("  {:<28} ({:.0f}, {:.0f}) mm\n", "corner of the support",
                        corner.x() * kMillimetersPerMeter, corner.y() * kMillimetersPerMeter);
  const std::string rebound =
      floor.kind == ContactConstants::Kind::kRestitution
          ? fmt::format("restitution {:.2g}", floor.restitution)
          : fmt::format("compliant, {:.3g} N/m and {:.3g} N s/m", floor.stiffness, floor.damping);
  return text + fmt::format("  {:<28} {}; friction {:.2g}, {}\n", "material on the floor",
                            facts.model.material, floor.friction, rebound);
}

std::string wheels_text(const EquipmentFacts& facts) {
  std::string text = fmt::format("\nwheels at rest\n  {:<24} {:>10} {:>10} {:>9} {:>9}  {}\n", "",
                                 "x [mm]", "y [mm]", "load [N]", "sink [mm]", "state");
  for (std::size_t i = 0; i < facts.sheet.wheels.size(); ++i) {
    const equipment::WheelAtRest& wheel = facts.sheet.wheels[i];
    const Caster& caster = facts.model.casters[i];
    std::string state = caster.swivels ? "swivels" : "rigid";
    if (caster.brake_torque > 0) state += ", braked";
    if (caster.swivel_lock_torque > 0) state += ", swivel locked";
    text += fmt::format("  {:<24} {:>10.0f} {:>10.0f} {:>9.1f} {:>9.2f}  {}\n", wheel.caster,
                        wheel.contact.x() * kMillimetersPerMeter,
                        wheel.contact.y() * kMillimetersPerMeter, wheel.load,
                        wheel.sink * kMillimetersPerMeter, state);
  }
  return text;
}

std::string motion_text(const EquipmentFacts& facts) {
  const equipment::ItemSheet& sheet = facts.sheet;
  const bool rolls = !facts.model.casters.empty();
  std::string text = "\nunder a slowly increasing acceleration of the floor\n";
  if (rolls) {
    text += fmt::format("  {:<36} {:.3f} g ({:.1f} N); a slope of {:.1f} %\n",
                        "brakes off, straight, rolls from", sheet.rolling_resistance_coefficient,
                        sheet.rolling_resistance_force, 100 * sheet.rolling_resistance_coefficient);
    text +=
        fmt::format("  {:<36} {:.3f} g\n", "brakes as configured, moves from", sheet.holding_share);
  }
  text += fmt::format("  {:<36} {:.2f} g\n",
                      rolls ? "wheels that cannot turn slide from" : "slides from",
                      sheet.sliding_share);
  text += fmt::format("  {:<36} {:.2f} g, if it does not slide or roll before\n", "tips from",
                      sheet.tipping_share);
  if (!rolls)
    text += sheet.tipping_share < sheet.sliding_share ? "  so it rocks before it slides\n"
                                                      : "  so it slides before it rocks\n";
  return text;
}

std::string assumption_text(const equipment::Assumption& a) {
  const std::string value = a.choice.empty() ? fmt::format("{:g}", a.value) : a.choice;
  const std::string range = a.choice.empty() ? fmt::format(" ({:g} to {:g})", a.low, a.high) : "";
  return fmt::format("  {} = {}{}\n      {}\n", a.key, value, range, a.reason);
}

}  // namespace

std::string equipment_report(const EquipmentFacts& facts, bool with_assumptions) {
  std::string text = facts.model.name + "\n";
  if (!facts.description.empty()) text += facts.description + "\n";
  text += "\n" + body_text(facts) + stability_text(facts) +
          (facts.model.casters.empty() ? feet_text(facts) : wheels_text(facts)) +
          motion_text(facts);
  text += fmt::format("\n{} of the parameters in use are assumptions{}\n", facts.assumptions.size(),
                      with_assumptions ? ":" : " (--assumptions lists them)");
  if (with_assumptions)
    for (const equipment::Assumption& assumption : facts.assumptions)
      text += assumption_text(assumption);
  if (!facts.warnings.empty()) text += "\nwarnings\n";
  for (const std::string& warning : facts.warnings) text += "  " + warning + "\n";
  return text;
}

}  // namespace gurney::report
