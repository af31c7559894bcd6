#include "studies/report/summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

#include "studies/render/wrapped.h"
#include "studies/report/narrative.h"
#include "studies/report/settled.h"
#include "studies/results/columns.h"
#include "studies/results/names.h"

namespace gurney::report {
namespace {

/// What has no meaning for an item without casters.
const std::set<std::string> kDemandsOfWheels = {"peak_normal_force", "lifted_time",
                                                "most_wheels_lifted"};

using study::UnitSystem;

/// For reading: four digits.
std::string shown(double value, const study::ReportUnit& unit, bool whole) {
  value /= unit.in_si;
  if (whole) return fmt::format("{:.0f}", value);
  if (value == 0) return "0";
  const double size = std::abs(value);
  if (!(size >= 1e-4 && size < 1e6)) return fmt::format("{:.2e}", value);
  const int decimals = std::clamp(3 - static_cast<int>(std::floor(std::log10(size))), 0, 6);
  return fmt::format("{:.{}f}", value, decimals);
}

std::string words_of(std::string name) {
  for (char& c : name)
    if (c == '_') c = ' ';
  return name;
}

std::string name_of(const study::ReportUnit& unit) { return unit.name == "1" ? "" : unit.name; }

std::string number_line(const std::string& name, const std::string& value, const std::string& units,
                        const std::string& note) {
  const std::string line =
      fmt::format("  {:<32}{:>12}{}", words_of(name), value, units.empty() ? "" : " " + units);
  return note.empty() ? line + "\n" : fmt::format("{:<52}{:>12}\n", line, note);
}

/// Where the run was repeated, within which fraction the demand is settled.
std::string settled_note(const std::vector<SettledDemand>& settled, const char* name) {
  const SettledDemand* const found = find_settled(settled, DemandNumber::Of::kItem, 0, name);
  return found ? within_text(*found) : "";
}

template <class Row>
std::string list(std::span<const study::TableColumn<Row>> columns, const Row& row,
                 const UnitSystem& units, const std::set<std::string>& without = {},
                 const std::vector<SettledDemand>& settled = {}) {
  std::string result;
  for (const study::TableColumn<Row>& column : columns) {
    const double value = column.value(row);
    if (without.count(column.name) > 0 || column.is_missing(value)) continue;
    const study::ReportUnit unit = units.of(column.units);
    result += number_line(column.name, shown(value, unit, column.whole()), name_of(unit),
                          settled_note(settled, column.name));
  }
  return result;
}

/// A column for each quantity, a row for each wheel or point.
template <class Row>
std::string table(const std::string& heading, std::span<const study::TableColumn<Row>> columns,
                  const std::vector<std::string>& names, const std::vector<Row>& rows,
                  const UnitSystem& units, DemandNumber::Of of,
                  const std::vector<SettledDemand>& settled) {
  std::size_t width = 18;
  for (const std::string& name : names) width = std::max(width, name.size());
  std::string titles = fmt::format("\n  {:<{}}", heading, width);
  std::string units_line = fmt::format("  {:<{}}", "", width);
  for (const study::TableColumn<Row>& column : columns) {
    const std::string words = words_of(column.name);
    titles += "  " + words;
    units_line += fmt::format("  {:>{}}", name_of(units.of(column.units)), words.size());
  }
  std::string result = titles + "\n" + units_line + "\n";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    result += fmt::format("  {:<{}}", names.at(i), width);
    for (const study::TableColumn<Row>& column : columns) {
      const double value = column.value(rows[i]);
      const std::string text =
          column.is_missing(value) ? "none" : shown(value, units.of(column.units), column.whole());
      const SettledDemand* const label = find_settled(settled, of, i, column.name);
      result += fmt::format("  {:>{}}", (label && !label->settled() ? "~" : "") + text,
                            words_of(column.name).size());
    }
    result += "\n";
  }
  return result;
}

double mass_of(const EquipmentModel& item) {
  double mass = item.chassis_mass;
  for (const Payload& payload : item.payloads) mass += payload.mass;
  for (const Caster& caster : item.casters) mass += caster.wheel_mass + caster.fork_mass;
  return mass;
}

std::string item_line(const std::string& name, const EquipmentModel& model,
                      const UnitSystem& units) {
  const std::string kind = name == model.name ? "" : model.name + ", ";
  return fmt::format("  item     {}: {}{} {}\n", name, kind, units.fixed(mass_of(model), "kg", 1),
                     model.casters.empty() ? "without casters"
                                           : fmt::format("on {} casters", model.casters.size()));
}

/// The narrative, its lines broken; what belongs to a heading stays indented.
std::string narrative_text(const study::RunFacts& facts, const Response& response,
                           const UnitSystem& units) {
  std::istringstream lines(narrative(facts, response, units));
  std::string text = "\n";
  for (std::string line; std::getline(lines, line);) {
    const std::size_t indent = line.find_first_not_of(' ');
    text += std::string(indent, ' ') + render::wrapped(line, 2 * indent, indent) + "\n";
  }
  return text + "\n";
}

/// Every number of a single item.
std::string demands_text(const EquipmentModel& model, const ItemResponse& item,
                         const UnitSystem& units) {
  using Of = DemandNumber::Of;
  const Demands& demands = item.demands;
  const std::vector<SettledDemand> settled = settled_demands(item);
  std::string text = number_line("demand", "value", "", settled.empty() ? "" : "settled to");
  const bool rolls = !model.casters.empty();
  text += list(study::demand_columns(), demands, units,
               rolls ? std::set<std::string>{} : kDemandsOfWheels, settled);
  // When wheels lifted before a fall, and numerical accelerations, are reported in words.
  if (rolls)
    text += table("wheel", study::wheel_demand_columns().first(5), study::caster_names(model),
                  demands.wheels, units, Of::kWheel, settled);
  if (!demands.points.empty())
    text += table("point", study::judged_point_columns(), study::point_names(model), demands.points,
                  units, Of::kPoint, settled);
  if (std::ranges::any_of(settled, [](const SettledDemand& each) {
        return each.number.of != Of::kItem && !each.settled();
      }))
    text += "\n  ~ not settled\n";
  return text;
}

/// One row for each of several items.
std::string items_text(const std::vector<std::string>& names,
                       const std::vector<ItemResponse>& items, const UnitSystem& units) {
  const UnitSystem lengths = units.or_else("g-mm");
  const std::string length = lengths.of("m").name, angle = units.of("rad").name;
  constexpr const char* kRow = "  {:<{}}{:>9}{:>9}{:>8}{:>8}{:>9}{:>8}{:>10}{:>12}\n";
  std::size_t width = 24;
  for (const std::string& name : names) width = std::max(width, name.size());
  std::string text = fmt::format(kRow, "item", width, "moved", "at end", "turned", "tilt", "lifted",
                                 "impacts", "fastest", "overturned");
  text += fmt::format(kRow, "", width, length, length, angle, angle, "s", "", units.of("m/s").name,
                      "s");
  for (std::size_t i = 0; i < items.size(); ++i) {
    const Demands& d = items[i].demands;
    text += fmt::format(
        kRow, names.at(i), width, lengths.number(d.peak_displacement, "m", 4),
        lengths.number(d.residual_displacement, "m", 4), units.number(d.peak_yaw, "rad", 1),
        units.number(d.peak_tilt, "rad", 1), fmt::format("{:.2f}", d.lifted_time), d.impacts,
        d.impacts > 0 ? units.number(d.largest_approach_speed, "m/s", 2) : "",
        d.time_of_overturning >= 0 ? fmt::format("{:.2f}", d.time_of_overturning) : "");
  }
  return text + "\n  Wheels, points and impacts one by one: --json, or the results file.\n";
}

/// Accelerations that are none.
std::string numerical_text(const std::vector<ItemResponse>& items, const UnitSystem& units) {
  double largest = 0;
  for (const ItemResponse& item : items)
    for (const PointDemands& point : item.demands.points)
      largest = std::fmax(largest, point.numerical_acceleration);
  if (!(largest > 0)) return "";
  const std::string text = fmt::format(
      "note: accelerations of points leave out impacts that state a restitution and no stiffness; "
      "the numerical ones there reach {}.",
      units.chosen() ? units.text(largest, "m/s2") : fmt::format("{:.3g} m/s2", largest));
  return fmt::format("\n{}\n", render::wrapped(text, 6, 0));
}

std::string record_text(const study::RunFacts& facts, const UnitSystem& units) {
  if (!facts.record) return "  floor    at rest\n";
  const study::RecordFacts& r = *facts.record;
  std::string text = fmt::format("  floor    {}: {:.2f} s, sampled every {:g} s\n", r.name,
                                 r.duration, r.time_step);
  for (const std::string& component : r.components)
    text += fmt::format("           {}\n", render::wrapped(component, 13, 11));
  for (const std::string& step : r.processing)
    text += fmt::format("           {}\n", render::wrapped(step, 13, 11));
  text += "\n";
  text += fmt::format("  {:<32}{:>12}{:>12}{:>12}\n", "floor motion", "x", "y", "z");
  const auto row = [&](const char* name, const char* si, const Vector3& value) {
    const auto number = [&](double component) {
      std::string shown = units.number(component, si, 4);
      // What is shown as zero has no sign.
      const bool nothing = shown.find_first_not_of("-0.") == std::string::npos;
      return nothing && shown.front() == '-' ? shown.substr(1) : shown;
    };
    text += fmt::format("  {:<32}{:>12}{:>12}{:>12} {}\n", name, number(value.x()),
                        number(value.y()), number(value.z()), units.of(si).name);
  };
  row("PGA", "m/s2", r.pga);
  row("PGV", "m/s", r.pgv);
  row("PGD", "m", r.pgd);
  row("residual velocity", "m/s", r.residual_velocity);
  row("residual displacement", "m", r.residual_displacement);
  return text;
}

/// "item.toml 32, caster.toml 25"
std::string assumed_by_file(const std::vector<study::AssumptionFacts>& assumptions) {
  std::vector<std::pair<std::string, int>> counts;
  for (const study::AssumptionFacts& a : assumptions) {
    const auto known = std::find_if(counts.begin(), counts.end(),
                                    [&](const auto& count) { return count.first == a.file; });
    if (known != counts.end()) {
      ++known->second;
    } else {
      counts.emplace_back(a.file, 1);
    }
  }
  std::string text;
  for (const auto& [file, count] : counts)
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", file, count);
  return text;
}

std::string drawn_text(const study::RunFacts& facts) {
  if (!facts.draw) return "";
  std::string text = fmt::format("\n  {}: {} parameters\n", facts.draw->text(), facts.drawn.size());
  std::size_t width = 0;
  for (const study::DrawnFacts& each : facts.drawn) width = std::max(width, each.variable.size());
  for (const study::DrawnFacts& each : facts.drawn)
    text += fmt::format("  {:<{}}  {:>10.5g}{}\n", each.variable, width, each.value,
                        each.unit == "1" ? "" : " " + each.unit);
  return text;
}

std::string notes(const study::RunFacts& facts) {
  std::string text = drawn_text(facts);
  for (const std::string& warning : facts.warnings)
    text += fmt::format("\nwarning: {}\n", render::wrapped(warning, 9, 9));
  if (facts.assumptions.empty()) return text;
  const std::string rest = fmt::format(
      "{} parameters of this run have no published source and are assumed ({}). Values, ranges and "
      "reasons: --json, or /assumptions in the results file.",
      facts.assumptions.size(), assumed_by_file(facts.assumptions));
  text += fmt::format("\n{}\n", render::wrapped(rest, 0, 0));
  return text;
}

}  // namespace

std::string summary(const study::RunFacts& facts, const Response& response,
                    const UnitSystem& units) {
  const UnitSystem of_tables = units.or_else("m");
  const std::vector<std::string> names = study::item_names(facts.scene);
  std::string text = (facts.title.empty() ? facts.job_name : facts.title) + "\n\n";
  for (std::size_t i = 0; i < names.size(); ++i)
    text += item_line(names[i], facts.scene.items[i].model, units);
  text += record_text(facts, units) + narrative_text(facts, response, units);
  text += names.size() == 1 ? demands_text(facts.scene.items[0].model, response.items[0], of_tables)
                            : items_text(names, response.items, units);
  text += numerical_text(response.items, units);
  text += fmt::format("\n  {:<32}{:>12}\n", "quality", "value");
  text += list(study::quality_columns(), response.quality, of_tables);
  return text + notes(facts);
}

}  // namespace gurney::report
