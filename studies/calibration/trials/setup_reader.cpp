#include "studies/calibration/trials/setup_reader.h"

#include <fmt/format.h>

#include <cmath>

#include "engine/base/units.h"
#include "engine/scene/equipment_model.h"

namespace gurney::calibration {
namespace {

using config::Range;

double read_added_mass(Facts& facts, const TrialSetup& setup, bool needed) {
  const bool inertia = facts.has("wheel_inertia_kg_m2");
  if (inertia && facts.has("added_mass_kg"))
    facts.errors().note(facts.at("added_mass_kg"),
                        "added_mass_kg: wheel_inertia_kg_m2 says it already; give one");
  if (!inertia && needed && !facts.has("added_mass_kg"))
    facts.errors().note(facts.at("added_mass_kg"),
                        "wheel_inertia_kg_m2 (of one wheel) or added_mass_kg: one must be given");
  const double stated = facts.number("added_mass_kg", Range::not_negative(), 0.0);
  const double of_wheel = facts.number("wheel_inertia_kg_m2", Range::not_negative(), 0.0);
  return inertia ? setup.wheels * of_wheel / (setup.wheel_radius * setup.wheel_radius) : stated;
}

void read_item(Facts& facts, TrialSetup& setup, bool needed) {
  const std::optional<std::string> none = "";
  setup.item = facts.text("item", needed ? std::nullopt : none);
  setup.payload_name = facts.text("payload_name", none);
  setup.payload_count = static_cast<int>(
      facts.number("payload_count", Range::within(0, 100), setup.payload_name.empty() ? 0.0 : 1.0));
  for (const double mm : facts.numbers("pull_point_mm", Range::any()))
    setup.pull_point.push_back(mm / kMillimetersPerMeter);
  if (setup.pull_point.size() != 3 && (needed || !setup.pull_point.empty()))
    facts.errors().note(facts.at("pull_point_mm"),
                        "pull_point_mm: must be three numbers, x y z in item axes");
}

void read_headings(Facts& facts, TrialSetup& setup) {
  for (const double degrees : facts.numbers("headings_deg", Range::within(-360, 360)))
    setup.headings.push_back(degrees * kRadiansPerDegree);
  const std::size_t count = setup.headings.size();
  if (count > 1 && count != static_cast<std::size_t>(setup.wheels))
    facts.errors().note(facts.at("headings_deg"),
                        fmt::format("headings_deg: {} numbers, but one for all or one for each "
                                    "of the {} wheels are needed",
                                    count, setup.wheels));
}

/// One locked axle carries what the cable's moment leaves it.
void read_locked(Facts& facts, TrialSetup& setup) {
  if (facts.has("locked"))
    setup.locked = static_cast<LockedWheels>(facts.choice("locked", names_of_locked()));
  facts.text("locked", "");
  const bool axle = setup.locked != LockedWheels::kAll;
  const auto needed = axle ? std::optional<double>() : std::optional(0.0);
  setup.pull_height =
      facts.number("pull_height_mm", Range::not_negative(), needed) / kMillimetersPerMeter;
  setup.wheelbase = facts.number("wheelbase_mm", Range::positive(), needed) / kMillimetersPerMeter;
  setup.front_share = facts.number("front_share", Range::within(0.05, 0.95), 0.5);
  setup.rolling_ratio = facts.number("rolling_ratio", Range::not_negative(), needed);
}

}  // namespace

const std::vector<std::string>& names_of_locked() {
  static const std::vector<std::string> names = {"all", "front", "rear"};
  return names;
}

const std::vector<std::string>& names_of_kinds() {
  static const std::vector<std::string> names = {"pull", "start_pull", "locked_pull",
                                                 "crosswise_pull", "impact"};
  return names;
}

const std::vector<std::string>& names_of_uses() {
  static const std::vector<std::string> names = {"calibration", "validation"};
  return names;
}

const std::vector<std::string>& names_of_origins() {
  static const std::vector<std::string> names = {"measured", "simulated"};
  return names;
}

TrialSetup read_setup(Facts& facts, TrialKind kind) {
  const bool impact = kind == TrialKind::kImpact;
  const bool rolls = kind == TrialKind::kPull || kind == TrialKind::kCrosswisePull;
  const std::optional<std::string> needed_text, none = "";
  const std::optional<double> needed_number;
  TrialSetup setup;
  setup.use = static_cast<TrialUse>(facts.choice("use", names_of_uses()));
  setup.origin = static_cast<TrialOrigin>(facts.choice("origin", names_of_origins()));
  setup.caster = facts.text("caster", impact ? none : needed_text);
  setup.floor = facts.text("floor", impact ? none : needed_text);
  setup.tread = facts.text("tread", none);
  setup.against = facts.text("against", impact ? needed_text : none);
  const double most = EquipmentModel::kMaxCasters;
  const double wheels = facts.number("wheels", Range::within(1, most), 4.0);
  if (wheels != std::floor(wheels))
    facts.errors().note(facts.at("wheels"), "wheels: must be a whole number");
  setup.wheels = static_cast<int>(wheels);
  setup.wheel_radius = facts.number("wheel_diameter_mm", Range::positive(),
                                    rolls ? needed_number : std::optional(0.0)) /
                       kMillimetersPerMeter / 2;
  setup.mass =
      facts.number("mass_kg", Range::positive(), impact ? std::optional(0.0) : needed_number);
  setup.payload = facts.number("payload_kg", Range::not_negative(), 0.0);
  if (!impact && setup.payload >= setup.mass)
    facts.errors().note(facts.at("payload_kg"),
                        "payload_kg: must be less than mass_kg, which holds it");
  setup.added_mass = read_added_mass(facts, setup, rolls);
  if (facts.number("drop_mass_kg", Range::positive(), 1.0) > 0 && facts.has("drop_mass_kg"))
    setup.drop_mass = facts.number("drop_mass_kg", Range::any());
  setup.string_tension = facts.number("string_tension_n", Range::not_negative(), 0.0);
  read_headings(facts, setup);
  read_item(facts, setup, kind == TrialKind::kCrosswisePull);
  if (kind == TrialKind::kLockedPull) read_locked(facts, setup);
  return setup;
}

}  // namespace gurney::calibration
