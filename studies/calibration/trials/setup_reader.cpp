#include "studies/calibration/trials/setup_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "engine/base/number_text.h"
#include "engine/base/units.h"
#include "engine/config/nearest_name.h"
#include "engine/config/unit_limit.h"
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
  const double center = facts.number("center_of_mass_height_mm", Range::not_negative(), 0.0);
  if (facts.has("center_of_mass_height_mm")) setup.center_height = center / kMillimetersPerMeter;
}

}  // namespace

std::string not_a_number(const std::string& key, const std::string& text) {
  return fmt::format("{} = \"{}\": must be a number{}", key, text,
                     text.find(';') != std::string::npos
                         ? "; cells are apart by commas and the decimal mark is a point"
                         : "");
}

void Facts::add(const std::string& key, const TextCell& value) {
  if (!value.text.empty()) values_.insert_or_assign(key, value);
}

const TextCell* Facts::find(const std::string& key, bool needed) {
  asked_.insert(key);
  const auto found = values_.find(key);
  if (found != values_.end()) return &found->second;
  if (needed) errors_->note(at_, key + ": missing");
  return nullptr;
}

const TextCell& Facts::at(const std::string& key) const {
  const auto found = values_.find(key);
  return found != values_.end() ? found->second : at_;
}

std::string Facts::text(const std::string& key, std::optional<std::string> fallback) {
  const TextCell* cell = find(key, !fallback);
  return cell != nullptr ? cell->text : fallback.value_or("");
}

double Facts::number(const std::string& key, const config::Range& range,
                     std::optional<double> fallback) {
  const TextCell* cell = find(key, !fallback);
  if (cell == nullptr) return fallback.value_or(1);
  const std::optional<double> value = gurney::number(cell->text);
  if (!value)
    errors_->note(*cell, not_a_number(key, cell->text));
  else
    note_outside(*cell, key, range, cell->text, *value);
  return value.value_or(1);
}

void Facts::note_outside(const TextCell& cell, const std::string& key, const config::Range& range,
                         const std::string& text, double value) {
  const std::string allowed =
      range.contains(value) ? config::beyond_unit(key, range, value) : range.text();
  if (!allowed.empty()) errors_->note(cell, fmt::format("{} = {}: must be {}", key, text, allowed));
}

std::size_t Facts::choice(const std::string& key, const std::vector<std::string>& allowed) {
  const TextCell* cell = find(key, true);
  if (cell == nullptr) return 0;
  const auto found = std::ranges::find(allowed, cell->text);
  if (found != allowed.end()) return static_cast<std::size_t>(found - allowed.begin());
  errors_->note(*cell, fmt::format("{} = \"{}\": unknown{}", key, cell->text,
                                   config::suggestion(cell->text, allowed)));
  return 0;
}

std::vector<double> Facts::numbers(const std::string& key, const config::Range& range) {
  const TextCell* cell = find(key, false);
  std::vector<double> values;
  if (cell == nullptr) return values;
  std::istringstream words(cell->text);
  for (std::string word; words >> word;) {
    const std::optional<double> value = gurney::number(word);
    if (!value)
      errors_->note(*cell, not_a_number(key, word));
    else
      note_outside(*cell, key, range, word, *value);
    values.push_back(value.value_or(1));
  }
  return values;
}

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
    facts.errors().note(facts.at("wheels"), fmt::format("wheels = {}: must be a whole number",
                                                        facts.at("wheels").text));
  setup.wheels = static_cast<int>(wheels);
  setup.wheel_radius = facts.number("wheel_diameter_mm", Range::positive(),
                                    rolls ? needed_number : std::optional(0.0)) /
                       kMillimetersPerMeter / 2;
  const std::size_t before = facts.errors().count();
  setup.mass =
      facts.number("mass_kg", Range::positive(), impact ? std::optional(0.0) : needed_number);
  setup.payload = facts.number("payload_kg", Range::not_negative(), 0.0);
  if (!impact && facts.errors().count() == before && setup.payload >= setup.mass)
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
