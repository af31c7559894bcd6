#include "studies/report/summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "engine/base/units.h"
#include "studies/results/columns.h"

namespace gurney {
namespace {

constexpr std::size_t kColumns = 100;

/// Breaks a text between words; lines after the first start with `indent` blanks.
std::string wrapped(const std::string& text, std::size_t indent, std::size_t used) {
  std::istringstream words(text);
  std::string result, word;
  std::size_t column = used;
  bool first = true;
  while (words >> word) {
    if (!first && column + 1 + word.size() > kColumns) {
      result.append("\n").append(indent, ' ');
      column = indent;
    } else if (!first) {
      result += " ";
      ++column;
    }
    result += word;
    column += word.size();
    first = false;
  }
  return result;
}

/// For reading: four digits, angles in degrees.
std::string shown(double value, std::string& units, bool whole) {
  if (units == "rad") {
    units = "deg";
    value /= kRadiansPerDegree;
  }
  if (units == "1") units.clear();
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

std::string number_line(const std::string& name, const std::string& value,
                        const std::string& units) {
  return fmt::format("  {:<32}{:>12}{}\n", words_of(name), value, units.empty() ? "" : " " + units);
}

template <class Row>
std::string list(std::span<const Column<Row>> columns, const Row& row) {
  std::string result;
  for (const Column<Row>& column : columns) {
    const double value = column.value(row);
    if (column.missing != 0 && value == column.missing) continue;
    std::string units = column.units;
    const std::string text = shown(value, units, column.whole);
    result += number_line(column.name, text, units);
  }
  return result;
}

/// A column for each quantity, a row for each wheel or point. `prefix` is cut from the names.
template <class Row>
std::string table(const std::string& heading, std::span<const Column<Row>> columns,
                  const std::vector<std::string>& names, const std::vector<Row>& rows,
                  std::size_t prefix) {
  std::size_t width = 18;
  for (const std::string& name : names) width = std::max(width, name.size());
  std::string titles = fmt::format("\n  {:<{}}", heading, width);
  std::string units_line = fmt::format("  {:<{}}", "", width);
  for (const Column<Row>& column : columns) {
    std::string units = column.units;
    shown(0, units, false);
    const std::string words = words_of(column.name + prefix);
    titles += "  " + words;
    units_line += fmt::format("  {:>{}}", units, words.size());
  }
  std::string result = titles + "\n" + units_line + "\n";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    result += fmt::format("  {:<{}}", names.at(i), width);
    for (const Column<Row>& column : columns) {
      std::string units = column.units;
      const std::string text = shown(column.value(rows[i]), units, column.whole);
      result += fmt::format("  {:>{}}", text, words_of(column.name + prefix).size());
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

std::string record_text(const RunFacts& facts) {
  if (!facts.record) return "  floor    at rest\n";
  const RecordFacts& r = *facts.record;
  std::string text = fmt::format("  floor    {}: {:.2f} s, sampled every {:g} s\n", r.name,
                                 r.duration, r.time_step);
  for (const std::string& component : r.components)
    text += fmt::format("           {}\n", wrapped(component, 13, 11));
  for (const std::string& step : r.processing)
    text += fmt::format("           {}\n", wrapped(step, 13, 11));
  text += "\n";
  text += fmt::format("  {:<32}{:>12}{:>12}{:>12}\n", "floor motion", "x", "y", "z");
  const auto row = [&](const char* name, const char* units, const Vector3& value) {
    text += fmt::format("  {:<32}{:>12}{:>12}{:>12} {}\n", name, fmt::format("{:.4f}", value.x()),
                        fmt::format("{:.4f}", value.y()), fmt::format("{:.4f}", value.z()), units);
  };
  row("PGA", "g", r.pga / kStandardGravity);
  row("PGV", "m/s", r.pgv);
  row("PGD", "m", r.pgd);
  row("residual velocity", "m/s", r.residual_velocity);
  row("residual displacement", "m", r.residual_displacement);
  return text;
}

/// "item.toml 32, caster.toml 25"
std::string assumed_by_file(const std::vector<AssumptionFacts>& assumptions) {
  std::vector<std::pair<std::string, int>> counts;
  for (const AssumptionFacts& a : assumptions) {
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

std::string drawn_text(const RunFacts& facts) {
  if (!facts.draw) return "";
  std::string text = fmt::format("\n  {}: {} numbers\n", facts.draw->text(), facts.drawn.size());
  std::size_t width = 0;
  for (const DrawnFacts& each : facts.drawn) width = std::max(width, each.variable.size());
  for (const DrawnFacts& each : facts.drawn)
    text += fmt::format("  {:<{}}  {:>10.5g}{}\n", each.variable, width, each.value,
                        each.unit == "1" ? "" : " " + each.unit);
  return text;
}

std::string notes(const RunFacts& facts) {
  std::string text = drawn_text(facts);
  for (const std::string& warning : facts.warnings)
    text += fmt::format("\nwarning: {}\n", wrapped(warning, 9, 9));
  if (facts.assumptions.empty()) return text;
  const std::string rest = fmt::format(
      "{} of the numbers behind this have no published source and are assumed ({}). Values, ranges "
      "and "
      "reasons: --json, or /assumptions in the results file.",
      facts.assumptions.size(), assumed_by_file(facts.assumptions));
  text += fmt::format("\n{}\n", wrapped(rest, 0, 0));
  return text;
}

}  // namespace

std::string summary(const RunFacts& facts, const Response& response) {
  const EquipmentModel& item = facts.scene.items[0].model;
  std::vector<std::string> casters, points;
  for (const Caster& caster : item.casters) casters.push_back(caster.name);
  for (const MarkedPoint& point : item.marked_points) points.push_back(point.name);
  std::string text = (facts.title.empty() ? facts.job_name : facts.title) + "\n\n";
  text += fmt::format("  item     {}: {:.1f} kg on {} casters\n", item.name, mass_of(item),
                      item.casters.size());
  text += record_text(facts);
  text += fmt::format("\n{}\n\n", wrapped(story(response), 0, 0));
  text += fmt::format("  {:<32}{:>12}\n", "demand", "value");
  text += list(demand_columns(), response.items[0].demands);
  text += table("wheel", wheel_demand_columns(), casters, response.items[0].demands.wheels,
                std::string("wheel_").size());
  if (!response.items[0].demands.points.empty())
    text += table("point", point_demand_columns(), points, response.items[0].demands.points,
                  std::string("point_").size());
  text += fmt::format("\n  {:<32}{:>12}\n", "quality", "value");
  text += list(quality_columns(), response.quality);
  return text + notes(facts);
}

}  // namespace gurney
