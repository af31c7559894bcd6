#include "studies/report/record_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "engine/base/units.h"
#include "groundmotions/assembly/plausibility.h"
#include "groundmotions/measures/integrate.h"
#include "groundmotions/measures/residual.h"
#include "groundmotions/measures/summary.h"
#include "groundmotions/record/record_motion.h"

namespace gurney::report {
namespace {

using findings::Section;
using findings::Table;
using groundmotions::Direction;

bool has_horizontals(const groundmotions::Record& record) {
  return record[Direction::kH1] && record[Direction::kH2];
}

/// Name and value of each fact of a header.
Section named(std::string key, const std::vector<RecordFact>& facts) {
  Section all{std::move(key)};
  for (const auto& [name, value] : facts) all.json(name, value);
  return all;
}

Section component(Direction direction, const groundmotions::Component& of) {
  const groundmotions::EndMotion end = groundmotions::end_motion(of.time_step, of.acceleration);
  Section all{name_of(direction)};
  all.json("name", of.name).json("file", of.file).json("format", of.format);
  all.json("unit", of.unit).json("sha256", of.sha256);
  all.json("azimuth_deg", of.azimuth, {.json_unit = kRadiansPerDegree});
  all.add(named("header", of.header)).json("residual_velocity_m_per_s", end.velocity);
  return all.json("residual_displacement_m", end.displacement);
}

/// One line for each component, and its hash.
void add_files(Section& to, const groundmotions::Record& record) {
  Section components{"components"};
  for (const Direction direction : groundmotions::kDirections) {
    if (!record[direction]) continue;
    const groundmotions::Component& c = *record[direction];
    components.add(component(direction, c));
    const std::string azimuth =
        c.azimuth ? fmt::format(", azimuth {:.0f}", *c.azimuth / kRadiansPerDegree) : "";
    to.text(name_of(direction),
            fmt::format("{}, '{}'{}, {}, {}", std::filesystem::path(c.file).filename().string(),
                        c.name, azimuth, c.format, c.unit));
    to.text(std::string("SHA-256 of ") + name_of(direction), c.sha256);
  }
  to.add(std::move(components));
}

/// Facts of the headers; those that all components share are stated once.
Section headers(const groundmotions::Record& record) {
  Section all{"", "header"};
  std::vector<RecordFact> stated;
  for (const auto& component : record.components) {
    if (!component) continue;
    for (const RecordFact& fact : component->header) {
      if (std::ranges::find(stated, fact) != stated.end()) continue;
      stated.push_back(fact);
      all.text(fact.first, fact.second);
    }
  }
  return all;
}

/// A column for each component and combination; how it moves at the end, from rest.
void add_measures(Section& to, const groundmotions::Record& record,
                  const groundmotions::Summary& measures) {
  Table table{"measures{}", "", {{"", "measure"}, {"unit", ""}}},
      ends{"", "", {{"", "at the end"}}};
  std::vector<std::string> names;
  for (const Direction direction : groundmotions::kDirections)
    if (record[direction]) names.emplace_back(name_of(direction));
  for (const std::string& name : names) ends.columns.push_back({"", name, {".2g"}});
  if (has_horizontals(record)) names.insert(names.end(), {"RotD50", "RotD100"});
  const std::size_t shown = names.size();
  for (const groundmotions::SummaryRow& row : measures.rows)
    for (const auto& [name, value] : row.values)
      if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  for (std::size_t i = 0; i < names.size(); ++i)
    table.columns.push_back({"values." + names[i], i < shown ? names[i] : ""});
  table.columns.insert(table.columns.end(), {{"", "unit"}, {"definition", "definition"}});
  for (const groundmotions::SummaryRow& row : measures.rows) {
    const groundmotions::DisplayUnit unit = groundmotions::display_unit_of(row.measure);
    table.add({row.name, row.unit});
    for (const std::string& name : names) {
      const auto value =
          std::ranges::find(row.values, name, &std::pair<std::string, double>::first);
      table.rows.back().emplace_back(
          value == row.values.end() ? findings::Value() : findings::Value(value->second),
          findings::Format{".4g", "", unit.in_si});
    }
    table.rows.back().insert(table.rows.back().end(), {unit.name, row.definition});
  }
  ends.columns.push_back({"", "unit"});
  ends.add({"residual velocity, from rest"});
  ends.add({"residual displacement, from rest"});
  for (const auto& component : record.components)
    if (component) {
      const auto end = groundmotions::end_motion(component->time_step, component->acceleration);
      ends.rows[0].emplace_back(end.velocity);
      ends.rows[1].emplace_back(end.displacement);
    }
  ends.rows[0].emplace_back("m/s");
  ends.rows[1].emplace_back("m");
  to.add(std::move(table)).add(std::move(ends));
}

}  // namespace

std::vector<std::string> record_findings(const groundmotions::Record& record) {
  std::vector<std::string> findings = record.warnings;
  const bool h1 = record[groundmotions::Direction::kH1].has_value(),
             h2 = record[groundmotions::Direction::kH2].has_value();
  if (!h1 && !h2)
    findings.push_back("h1 and h2 are missing: the record has no horizontal");
  else if (!h1 || !h2)
    findings.push_back(
        fmt::format("{} is missing: the record has one horizontal", h1 ? "h2" : "h1"));
  for (std::string& finding : implausible(record)) findings.push_back(std::move(finding));
  for (std::string& finding : groundmotions::residual(groundmotions::floor_motion(record)).warnings)
    findings.push_back(std::move(finding));
  return findings;
}

findings::Section record_report(const groundmotions::Record& record,
                                const std::vector<RecordFact>& facts,
                                const std::vector<groundmotions::Measure>& wanted) {
  Section all{"", record.name};
  all.json("name", record.name);
  add_files(all, record);
  all.json("time_step_s", record.time_step());
  all.fact("samples", "samples", record.samples(), {},
           fmt::format("{:g} s apart, {:.2f} s", record.time_step(),
                       static_cast<double>(record.samples() - 1) * record.time_step()));
  all.add(headers(record)).add(named("facts", facts));
  Section suite{"", "from the suite"};
  for (const auto& [name, value] : facts) suite.text(name, value);
  all.add(std::move(suite)).list("processing", "processing", record.processing);
  const groundmotions::Summary measures = summary(record, wanted);
  add_measures(all, record, measures);
  std::vector<std::string> warnings = record_findings(record);
  warnings.insert(warnings.end(), measures.warnings.begin(), measures.warnings.end());
  return all.list("warnings", "warnings", std::move(warnings));
}

}  // namespace gurney::report
