#include <fmt/format.h>

#include <algorithm>

#include "studies/figures/verification_figures.h"
#include "studies/page/drawing.h"
#include "studies/page/findings_html.h"
#include "studies/page/json_findings.h"
#include "studies/report/verification_report.h"

namespace gurney::page {
namespace {

Section tolerances(const std::vector<figures::ToleranceRow>& rows) {
  const std::string title = "Use of the tolerances";
  if (rows.empty()) return {"tolerances", title, {}};
  return {"tolerances", title,
          html(Drawing{"tolerances", figures::tolerance_figure({.width = 900}, rows),
                       "Error over tolerance of every check, by group.",
                       "One row for each group of closed forms; marks left of the dashed line "
                       "passed. The same numbers are in the tables below."})};
}

}  // namespace

Document verification_document(const findings::Section& facts) {
  const auto cases = report::verified_cases(facts);
  std::vector<figures::ToleranceRow> rows;
  for (const findings::Section* each : cases) {
    const std::string group = text_of(*each, "group");
    auto row = std::ranges::find(rows, group, &figures::ToleranceRow::label);
    if (row == rows.end()) row = rows.insert(rows.end(), {group, {}});
    const auto& checks = *findings::find<findings::Table>(*each, "checks");
    for (std::size_t i = 0; i < checks.rows.size(); ++i)
      row->used.push_back(report::used_of(checks, i));
  }
  const std::string groups = counted(rows.size(), "group");
  for (figures::ToleranceRow& row : rows)
    row.label += fmt::format(" ({})", counted(row.used.size(), "check"));
  const findings::Section of = report::verification_findings(facts);
  Document document{of.title,
                    fmt::format("{} in {}: {}", counted(cases.size(), "case"), groups,
                                text_of(facts, "passed") == "yes" ? "all passed" : "FAILED"),
                    sections_of(of, {"summary", "cases", "forms", "checks", "provenance"}),
                    {}};
  document.sections.insert(document.sections.begin() + 1, tolerances(rows));
  document.sections.at(4).content =
      folded("Every check, parameters, other solvers", document.sections.at(4).content);
  document.sections.back().content += paragraph(
      "The same program on the same class of CPU gives the same numbers, with any number of "
      "threads. gurney verify CASE prints a case in full, --figures draws computed and reference "
      "over time, --draw tries other parameters.");
  return document;
}

}  // namespace gurney::page
