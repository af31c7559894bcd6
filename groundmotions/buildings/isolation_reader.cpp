#include "groundmotions/buildings/isolation_reader.h"

#include <fmt/format.h>

#include <limits>

#include "engine/base/units.h"

namespace gurney::groundmotions {

namespace {

using config::Range;
using config::Table;

constexpr double kLinerShear = 0.5;  ///< of a sliding surface [mm]; an assumption

double meters(double millimeters) { return millimeters / kMillimetersPerMeter; }

Isolation read_linear(Table& table) {
  const double period = table.number("period_s", Range::positive());
  const double damping = table.number("damping_ratio", Range::not_negative());
  return linear_isolation(period > 0 ? period : 1, damping);
}

Isolation read_lead_rubber(Table& table) {
  const std::size_t before = table.document().errors();
  const double period = table.number("period_s", Range::positive());
  const double strength = table.number("strength_ratio", Range::positive());
  const double yield = meters(table.number("yield_displacement_mm", Range::positive()));
  const double damping = table.number("damping_ratio", Range::not_negative(), 0.0);
  if (table.document().errors() > before) return linear_isolation(1, 0);
  return lead_rubber(period, strength, yield, damping);
}

Isolation read_friction_pendulum(Table& table) {
  const std::size_t before = table.document().errors();
  const double radius = table.number("radius_m", Range::positive());
  const double slow = table.number("friction_slow", Range::within(0, 1));
  const double fast = table.number("friction_fast", Range::within(0, 1));
  const double rate = table.number("friction_rate_s_per_m", Range::not_negative());
  const double yield =
      meters(table.number("yield_displacement_mm", Range::positive(), kLinerShear));
  const bool vertical = table.boolean("vertical_load", true);
  if (!(fast >= slow))
    table.note("friction_fast",
               fmt::format(" = {}: must be at least friction_slow = {}", fast, slow));
  if (table.document().errors() > before) return linear_isolation(1, 0);
  Isolation isolation = friction_pendulum(radius, slow, fast, rate, yield);
  isolation.follows_vertical = vertical;
  return isolation;
}

}  // namespace

Isolation read_isolation(Table& table) {
  Isolation isolation;
  switch (table.choice("kind", {"lead_rubber", "friction_pendulum", "linear"})) {
    case 0:
      isolation = read_lead_rubber(table);
      break;
    case 1:
      isolation = read_friction_pendulum(table);
      break;
    default:
      isolation = read_linear(table);
  }
  isolation.base_mass_ratio = table.number("base_mass_ratio", Range::within(0.01, 0.99));
  isolation.capacity =
      meters(table.number("displacement_capacity_mm", Range::positive().with_infinity(),
                          std::numeric_limits<double>::infinity()));
  return isolation;
}

}  // namespace gurney::groundmotions
