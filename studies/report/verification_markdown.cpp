#include <fmt/format.h>

#include <algorithm>

#include "studies/report/verification_report.h"

namespace gurney {
namespace {

using verification::CaseRun;
using verification::Check;

/// `|` would end a cell.
std::string cell(std::string text) {
  for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2)
    text.insert(at, "\\");
  return text;
}

}  // namespace

std::string verification_markdown(const std::vector<CaseRun>& runs) {
  std::string families =
      "| closed form | reference | source | cases |\n| --- | --- | --- | --- |\n";
  std::string checks =
      "| case | quantity | unit | computed | reference | error | tolerance |\n"
      "| --- | --- | --- | --- | --- | --- | --- |\n";
  const verification::Family* last = nullptr;
  for (const CaseRun& run : runs) {
    const verification::Statement& statement = run.family->statement;
    if (run.family != last)
      families += fmt::format("| {}: {} | {} | {} | {} |\n", statement.name, cell(statement.title),
                              cell(statement.equation), cell(statement.source),
                              std::ranges::count(runs, run.family, &CaseRun::family));
    last = run.family;
    for (const Check& c : run.findings.checks)
      checks +=
          fmt::format("| {} | {} | {} | {:.5g} | {:.5g} | {:.1e} | {:.1e} |\n", run.name(),
                      cell(c.quantity), c.unit, c.computed, c.reference, c.error(), c.tolerance);
  }
  return families + '\n' + checks;
}

}  // namespace gurney
