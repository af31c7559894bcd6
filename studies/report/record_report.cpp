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

constexpr int kColumn = 10;  ///< width of the columns of measures

bool has_horizontals(const groundmotions::Record& record) {
  return record[groundmotions::Direction::kH1] && record[groundmotions::Direction::kH2];
}

std::string file_name(const groundmotions::Component& component) {
  return std::filesystem::path(component.file).filename().string();
}

std::string files_text(const groundmotions::Record& record) {
  std::string text;
  for (const groundmotions::Direction direction : groundmotions::kDirections) {
    if (!record[direction]) continue;
    const groundmotions::Component& c = *record[direction];
    const std::string azimuth =
        c.azimuth ? fmt::format(", azimuth {:.0f}", *c.azimuth / kRadiansPerDegree) : "";
    text += fmt::format("  {:<9} {}, '{}'{}, {}, {}\n", name_of(direction), file_name(c), c.name,
                        azimuth, c.format, c.unit);
    if (!c.sha256.empty()) text += fmt::format("  {:<9} SHA-256 {}\n", "", c.sha256);
  }
  return text;
}

/// Facts of the headers; those that all components share are stated once.
std::string header_text(const groundmotions::Record& record) {
  std::string text;
  std::vector<RecordFact> stated;
  for (const auto& component : record.components) {
    if (!component) continue;
    for (const RecordFact& fact : component->header) {
      if (fact.second.empty() || std::ranges::find(stated, fact) != stated.end()) continue;
      stated.push_back(fact);
      text += fmt::format("  {:<28} {}\n", fact.first, fact.second);
    }
  }
  return text;
}

std::string measures_text(const groundmotions::Record& record,
                          const groundmotions::Summary& measures) {
  std::vector<std::string> columns;
  for (const groundmotions::Direction direction : groundmotions::kDirections)
    if (record[direction]) columns.emplace_back(name_of(direction));
  if (has_horizontals(record)) columns.insert(columns.end(), {"RotD50", "RotD100"});
  std::string text = fmt::format("  {:<10}", "measure");
  for (const std::string& column : columns) text += fmt::format("{:>{}}", column, kColumn);
  text += "\n";
  for (const groundmotions::SummaryRow& row : measures.rows) {
    const groundmotions::DisplayUnit unit = groundmotions::display_unit_of(row.measure);
    text += fmt::format("  {:<10}", row.name);
    for (const std::string& column : columns) {
      const auto value =
          std::ranges::find(row.values, column, &std::pair<std::string, double>::first);
      text += fmt::format(
          "{:>{}}",
          value == row.values.end() ? "-" : fmt::format("{:.4g}", value->second / unit.in_si),
          kColumn);
    }
    text += fmt::format("  {:<5} {}\n", unit.name, row.definition);
  }
  return text;
}

std::string end_text(const groundmotions::Record& record) {
  std::string velocity = "  v at end  ", displacement = "  d at end  ";
  for (const auto& component : record.components) {
    if (!component) continue;
    const groundmotions::EndMotion end =
        groundmotions::end_motion(component->time_step, component->acceleration);
    velocity += fmt::format("{:>{}}", fmt::format("{:.2g}", end.velocity), kColumn);
    displacement += fmt::format("{:>{}}", fmt::format("{:.2g}", end.displacement), kColumn);
  }
  const std::string gap(has_horizontals(record) ? 2 * kColumn : 0, ' ');
  return velocity + gap + "  m/s   residual velocity, from rest\n" + displacement + gap +
         "  m     residual displacement, from rest\n";
}

std::string list_text(const char* title, const std::vector<std::string>& lines) {
  if (lines.empty()) return {};
  std::string text = fmt::format("\n{}\n", title);
  for (const std::string& line : lines) text += fmt::format("  {}\n", line);
  return text;
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

std::string record_report(const groundmotions::Record& record, const std::vector<RecordFact>& facts,
                          const std::vector<groundmotions::Measure>& wanted) {
  std::string text = record.name + "\n" + files_text(record);
  text += fmt::format("  {:<9} {} samples, {:g} s apart, {:.2f} s\n", "samples", record.samples(),
                      record.time_step(),
                      static_cast<double>(record.samples() - 1) * record.time_step());
  if (const std::string header = header_text(record); !header.empty())
    text += "\nheader\n" + header;
  if (!facts.empty()) text += "\nfrom the suite\n";
  for (const auto& [name, value] : facts) text += fmt::format("  {:<28} {}\n", name, value);
  text += list_text("processing", record.processing);
  const groundmotions::Summary measures = summary(record, wanted);
  text += "\n" + measures_text(record, measures) + end_text(record);
  std::vector<std::string> findings = record_findings(record);
  findings.insert(findings.end(), measures.warnings.begin(), measures.warnings.end());
  text += list_text("warnings", findings);
  return text;
}

}  // namespace gurney::report
