#include "studies/report/explanation_report.h"

#include <fmt/format.h>

#include <cmath>

#include "studies/explanation/events.h"
#include "studies/explanation/words.h"
#include "studies/report/formats.h"

namespace gurney::report {
namespace {

using explanation::Event;
using explanation::EventKind;
using explanation::Explanation;
using explanation::Finding;
using explanation::GripMargin;
using explanation::ItemFacts;
using explanation::Stage;
using explanation::TiltMargin;
using explanation::VariantOutcome;
using explanation::WhatIf;
using findings::Cell;
using findings::Section;
using findings::Table;
using findings::Texts;
using findings::Value;
using study::UnitSystem;

Value time_of(double time) { return time < 0 ? Value() : Value(time); }
Value text_of(const std::string& text) { return text.empty() ? Value() : Value(text); }

// Events.

/// Events that people read of: of the item, and the worst of others.
bool belongs(const Event& event, const Explanation& of) {
  return event.item.empty() || event.item == of.item().name ||
         event.kind == EventKind::kOverturned || event.kind == EventKind::kToppled ||
         event.kind == EventKind::kImpact;
}

/// Remark on the uplifts that the events leave out; empty: none.
std::string uplifts_text(const ItemFacts& item) {
  if (item.uplifts <= explanation::kStatedLifts) return {};
  return fmt::format("There were {} uplifts{}; the events have the first{} of the others.",
                     item.uplifts, lies(item.finding) ? " until it overturned" : "",
                     lies(item.finding) ? ", the last, and the longest" : " and the two longest");
}

void add_events(const Explanation& of, Section& all) {
  constexpr std::size_t kMost = 40;
  Table events{"events", "",
               json_columns({"time_s", "kind", "item", "part", "value", "resolution_s",
                             "uplift.casters", "uplift.most_at_once", "uplift.together_s",
                             "uplift.longest_of_one_s", "uplift.longest_of", "text"})};
  findings::List lines{"", "What happened", {}, kMost, true};
  for (const Event& event : of.events) {
    const std::string words = explanation::sentence(event, of.units);
    std::vector<Cell> row{event.time,          name_of(event.kind),
                          text_of(event.item), text_of(event.part),
                          event.value,         event.sampled ? Value(of.resolution) : Value()};
    if (const auto& up = event.uplift)
      row.insert(row.end(), {up->casters, up->most, up->together, up->longest, up->longest_of});
    else
      row.insert(row.end(), 5, Value());
    row.emplace_back(words);
    events.add(std::move(row));
    if (!of.failed && belongs(event, of))
      lines.lines.push_back(
          fmt::format("{:8.3f} s  {}{}", event.time,
                      of.items.size() > 1 && !event.item.empty() ? event.item + ": " : "", words));
  }
  all.add(std::move(events)).add(std::move(lines));
  if (!of.failed) all.say(uplifts_text(of.item()));
  if (of.resolution > 0)
    all.say(fmt::format(
        "Moving off, brakes, lift-off, landing and tipping are found in samples {:g} ms apart; "
        "other times are those of the time steps.",
        1000 * of.resolution));
}

std::string pulse_text(const Explanation& of) {
  if (of.record.empty()) return "The floor is at rest: the item was pushed, or set in motion.";
  if (!of.pulse)
    return "The floor's velocity against the motion did not rise before it: no single pulse of the "
           "floor drove it.";
  return explanation::sentence(*of.pulse, of.units);
}

// How near it was to worse.

std::string tilt_text(const ItemFacts& item, const UnitSystem& units) {
  using explanation::angle;
  const TiltMargin& tilt = item.tilt;
  const std::string side = explanation::side_of(tilt.direction);
  if (tilt.tilt <= 0) return "It hardly tilted (less than 0.1 deg).";
  if (lies(item.finding) && tilt.time_passed >= 0)
    return fmt::format(
        "Its tilt passed the critical angle at {:.2f} s, leaning to its {}: there its centre of "
        "mass, {} up, is above the edge of its support.",
        tilt.time_passed, side, units.fixed(item.height_of_center_of_mass, "m", 2));
  return fmt::format(
      "Tilt: nearest to the edge at {:.2f} s, {} to its {} of a critical {}: {:.0f} % of it.{}",
      tilt.time, angle(tilt.tilt, units), side, angle(tilt.critical, units), 100 * tilt.ratio(),
      tilt.time_passed >= 0 ? " It was past the edge and the floor brought it back." : "");
}

/// Restraint of an item on the floor.
std::string grip_words(const ItemFacts& item) {
  if (!item.has_casters) return "friction on the floor";
  if (!item.grip.braked) return "the rolling resistance of its casters (no brake is on)";
  return item.grip.rolls ? "its brakes and the rolling resistance of its free casters"
                         : "its brakes, which are on at every caster,";
}

std::string grip_text(const ItemFacts& item, const UnitSystem& units) {
  const auto force = [&](double newtons) { return units.fixed(newtons, "N", 0); };
  const GripMargin& grip = item.grip;
  std::string what = grip_words(item);
  if (grip.time_exceeded < 0)
    return fmt::format(
        "Grip: holding it on the moving floor took {} at most, and {} could always give more; the "
        "margin was smallest at {:.2f} s ({} of {}).",
        force(grip.peak_demand), what, grip.time, force(grip.demand), force(grip.grip));
  what[0] = static_cast<char>(std::toupper(what[0]));
  return fmt::format(
      "Grip: holding it on the moving floor takes its mass ({}{}) times the floor's acceleration. "
      "{} first could not give that at {:.2f} s; worst at {:.2f} s, {} against {}.",
      units.fixed(item.mass, "kg", 0), item.carries ? " with all that it carries" : "", what,
      grip.time_exceeded, grip.time, force(grip.demand), force(grip.grip));
}

Section margins(const Explanation& of) {
  const ItemFacts& item = of.item();
  Section all("", "Margins");
  if (!item.is_part) all.say(tilt_text(item, of.units));
  if (!of.record.empty() && item.on_floor) all.say(grip_text(item, of.units));
  if (!item.first_lifted.empty())
    all.say(fmt::format("First caster off the floor: {}, at {:.3f} s.", item.first_lifted,
                        item.time_of_lift));
  if (!item.first_skidded.empty())
    all.say(fmt::format("First braked caster to skid: {}, at {:.3f} s.", item.first_skidded,
                        item.time_of_skid));
  return all;
}

Table items_table(const Explanation& of) {
  Table table{"items", "", {}};
  for (const ItemFacts& item : of.items) {
    const auto tilt = [&](const Value& value) { return item.tilt.tilt > 0 ? value : Value(); };
    const auto of_grip = [&](const Value& value) { return item.on_floor ? value : Value(); };
    const GripMargin& grip = item.grip;
    add_row(table, {{"name", item.name},
                    {"finding", name_of(item.finding)},
                    {"mass_kg", item.mass},
                    {"height_of_center_of_mass_m", item.height_of_center_of_mass},
                    {"peak_displacement_m", item.peak_displacement},
                    {"time_of_peak_displacement_s", item.time_of_peak_displacement},
                    {"residual_displacement_m", item.residual_displacement},
                    {"peak_velocity_m_per_s", item.peak_velocity},
                    {"tilt.tilt_rad", tilt(item.tilt.tilt)},
                    {"tilt.critical_rad", tilt(item.tilt.critical)},
                    {"tilt.ratio", tilt(item.tilt.ratio())},
                    {"tilt.time_s", tilt(item.tilt.time)},
                    {"tilt.direction_rad", tilt(item.tilt.direction)},
                    {"tilt.time_passed_s", tilt(time_of(item.tilt.time_passed))},
                    {"grip.demand_n", of_grip(grip.demand)},
                    {"grip.grip_n", of_grip(grip.grip)},
                    {"grip.time_s", of_grip(grip.time)},
                    {"grip.time_exceeded_s", of_grip(time_of(grip.time_exceeded))},
                    {"grip.peak_demand_n", of_grip(grip.peak_demand)},
                    {"grip.braked", of_grip(grip.braked)},
                    {"first_caster_lifted", text_of(item.first_lifted)},
                    {"time_of_lift_s", time_of(item.time_of_lift)},
                    {"first_braked_caster_skidded", text_of(item.first_skidded)},
                    {"time_of_skid_s", time_of(item.time_of_skid)}});
  }
  return table;
}

// Where the energy went.

Table energy_table(const Explanation& of) {
  findings::Format energy = format_of(of.units.of("J"), 1, ".2f");
  Table table{
      "energy", of.failed ? "" : fmt::format("Energy of {} since the start", of.item().name), {}};
  for (const Stage& s : of.stages)
    add_row(table, {{{"stage", "stage"}, s.name},
                    {{"time_s", "time", {".2f", "s"}}, s.time},
                    {{"work_of_floor_j", "floor", energy}, s.floor_work},
                    {{"work_of_others_j", "loads", energy}, s.other_work},
                    {{"kinetic_j", "kinetic", energy}, s.kinetic},
                    {{"potential_j", "height", energy}, s.potential},
                    {{"friction_j", "friction", energy}, s.friction},
                    {{"rolling_j", "rolling", energy}, s.rolling},
                    {{"impacts_j", "impacts", energy}, s.impacts},
                    {"elastic_j", s.elastic},
                    {"other_loss_j", s.other_loss},
                    {{"", "other", energy}, s.elastic + s.other_loss}});
  return table;
}

constexpr const char* kEnergyKey =
    "floor: work of the floor's motion on the item; loads: work of pushes, falling weights, cords "
    "and neighbours; "
    "height: weight times the rise of the centre of mass; friction: sliding and damping of the "
    "treads; rolling: rolling resistance, bearings and brakes; other: springs, dampers, weights "
    "that land. Floor "
    "and loads together are the sum of the other columns.";

Section other_items(const Explanation& of) {
  Section all("", "The other items");
  for (std::size_t i = 0; i < of.items.size(); ++i) {
    const ItemFacts& item = of.items[i];
    if (i == of.subject) continue;
    all.say(item.finding == Finding::kStill
                ? explanation::stayed(item, of.units)
                : fmt::format("{}: {}; moved up to {}{}.", item.name, name_of(item.finding),
                              explanation::length(item.peak_displacement, of.units),
                              item.is_part || lies(item.finding)
                                  ? ""
                                  : fmt::format(", tilt up to {:.0f} % of critical",
                                                100 * item.tilt.ratio())));
  }
  return all;
}

// Preventing variants.

Table variants_table(const UnitSystem& units) {
  return {"variants",
          "",
          {{"name", "variant"},
           {"reason", ""},
           {"peak_displacement_m", "farthest", format_of(units.of("m"), 1, ".3f")},
           {"tilt_ratio", ""},
           {"", "tilt [% of crit.]"},
           {"hardest_impact_m_per_s", ""},
           {"", "impact", format_of(units.of("m/s"), 1, ".2f")},
           {"runs", ""},
           {"failed", ""},
           {"overturned", ""},
           {"", "overturned"},
           {"happened", ""}}};
}

std::vector<Cell> variant_row(const VariantOutcome& of, bool replicas) {
  if (!of.reason.empty()) {
    std::vector<Cell> row(variants_table({}).columns.size(), Value());
    row[0] = of.name;
    row[1] = of.reason;
    return row;
  }
  const bool fell = of.tilt_ratio > 1 && 2 * of.overturned > of.runs;
  return {of.name,
          Value(),
          of.peak_displacement,
          of.tilt_ratio,
          fell ? ">100" : fmt::format("{:.0f}", 100 * of.tilt_ratio),
          of.hardest_impact,
          of.hardest_impact > 0 ? Value(of.hardest_impact) : Value(),
          of.runs,
          of.failed,
          of.overturned,
          replicas            ? fmt::format("{} of {}", of.overturned, of.runs)
          : of.overturned > 0 ? "yes"
                              : "no",
          of.happened};
}

Section what_if_section(const WhatIf& what, const Explanation& of) {
  const bool replicas = what.replicas > 1;
  Table all = variants_table(of.units), tried = all, as_it_was = all;
  as_it_was.add(variant_row(what.as_it_was, replicas));
  tried.key = "";
  tried.rows = as_it_was.rows;
  Texts without;
  for (const VariantOutcome& each : what.variants) {
    all.add(variant_row(each, replicas));
    if (each.reason.empty())
      tried.add(all.rows.back());
    else
      without.push_back(each.name + ": " + each.reason);
  }
  Section section("what_if", "What if (each variant was run)");
  section.json("replicas", what.replicas);
  if (replicas)
    section.say(fmt::format("{} replicas of each, whose masses differ by up to 1e-6; medians",
                            what.replicas));
  Section baseline("as_it_was");
  for (std::size_t i = 0; i < as_it_was.columns.size(); ++i)
    if (const auto& key = as_it_was.columns[i].key; !key.empty())
      baseline.json(key, as_it_was.rows.front()[i].value);
  for (findings::Column& column : all.columns) column.label.clear();
  section.add(std::move(baseline)).add(std::move(all)).add(std::move(tried));
  section.list("", "Not tried", without);
  const std::string conclusion = explanation::conclusion(what, of);
  return std::move(section.json("conclusion", conclusion).say(conclusion));
}

}  // namespace

void add_pulse(const std::string& key, const std::optional<explanation::HalfCycle>& pulse,
               Section& all) {
  if (!pulse) {
    all.json(key, {});
    return;
  }
  Section of(key);
  of.json("direction_rad", std::atan2(pulse->direction.y(), pulse->direction.x()));
  of.json("start_s", pulse->start).json("end_s", pulse->end);
  of.json("duration_s", pulse->end - pulse->start);
  of.json("peak_acceleration_m_per_s2", pulse->peak_acceleration);
  of.json("time_of_peak_s", pulse->time_of_peak);
  of.json("peak_velocity_m_per_s", pulse->peak_velocity);
  all.add(std::move(of.json("velocity_change_m_per_s", pulse->velocity_change)));
}

Section explanation_findings(const Explanation& of, const WhatIf* what) {
  const std::string headline = explanation::headline(of);
  const bool trusted =
      !of.predictability || of.predictability->verdict == Predictability::Verdict::kPredictable;
  Section all;
  all.json("title", of.title).json("record", text_of(of.record)).json("outcome", of.outcome);
  all.json("cause", text_of(of.cause)).json("end_time_s", of.end_time);
  all.json("headline", headline).say(headline).json("resolution_s", of.resolution);
  all.json("item", of.failed ? Value() : Value(of.item().name));
  all.json("finding", of.failed ? Value() : Value(name_of(of.item().finding)));
  all.json("time_s", of.failed ? Value() : Value(of.worst_time));
  all.json("predictability",
           of.predictability ? Value(name_of(of.predictability->verdict)) : Value());
  add_events(of, all);
  add_pulse("pulse", of.pulse, all);
  if (!of.failed && of.item().finding != Finding::kStill)
    all.add(std::move(Section("", "What drove it").say(pulse_text(of))));
  all.add(items_table(of));
  if (!of.failed) all.add(margins(of));
  all.add(energy_table(of));
  if (!of.failed) all.say(kEnergyKey);
  if (of.items.size() > 1) all.add(other_items(of));
  if (!trusted)
    all.add(std::move(
        Section("", "How far to trust it").say(explanation::sentence(*of.predictability) + ".")));
  if (what == nullptr) return std::move(all.json("what_if", {}));
  return std::move(all.add(what_if_section(*what, of)));
}

}  // namespace gurney::report
