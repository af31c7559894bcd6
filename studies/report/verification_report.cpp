#include "studies/report/verification_report.h"

#include <fmt/format.h>

namespace gurney::report {
namespace {

using verification::CaseRun;
using verification::Check;

std::string values_text(const CaseRun& run) {
  std::string text;
  for (std::size_t i = 0; i < run.set.values.size(); ++i) {
    const verification::Parameter& p = run.family->parameters[i];
    text += fmt::format("{}{} {:.6g} {}", i == 0 ? "" : ", ", p.name, run.set.values[i], p.unit);
  }
  return text;
}

std::string with_unit(double value, const std::string& unit) {
  return unit.empty() ? fmt::format("{:.7g}", value) : fmt::format("{:.7g} {}", value, unit);
}

std::string check_text(const Check& c) {
  return fmt::format(
      "    {} {}\n         computed {}, reference {}, error {:.2g}, tolerance {:.2g} ({:.0f} % "
      "used)\n         tolerance: {}\n",
      c.passed() ? "ok  " : "FAIL",
      c.where.empty() ? c.quantity : c.quantity + ", worst at " + c.where,
      with_unit(c.computed, c.unit), with_unit(c.reference, c.unit), c.error(), c.tolerance,
      100 * c.used(), c.derivation);
}

/// The largest error of a stock solver over that of ours would be unfair where ours is tiny: the
/// errors stand beside each other.
std::string stock_text(const CaseRun& run) {
  std::string text;
  for (const verification::StockRun& stock : run.stock)
    for (const Check& c : stock.findings.checks)
      text +=
          fmt::format("    {}: {}: error {:.2g} {}\n", stock.solver, c.quantity, c.error(), c.unit);
  return text;
}

}  // namespace

std::string verification_text(const CaseRun& run, bool in_full) {
  const verification::Findings& f = run.findings;
  std::string text =
      f.checks.empty()
          ? fmt::format("FAIL {:<36} checks nothing\n", run.name())
          : fmt::format("{} {:<36} {:2} checks, {:5.1f} % of a tolerance used, {:.2f} s\n",
                        f.passed() ? "ok  " : "FAIL", run.name(), f.checks.size(),
                        100 * f.worst().used(), run.seconds);
  if (in_full || !f.passed())
    text += fmt::format("    {}\n    {}\n    {}\n", run.family->statement.title,
                        run.family->statement.equation, values_text(run));
  for (const Check& c : f.checks)
    if (in_full || !c.passed()) text += check_text(c);
  if (in_full) text += stock_text(run);
  return text;
}

std::string verification_summary(const std::vector<CaseRun>& runs) {
  std::size_t checks = 0;
  std::vector<std::string> failed;
  double seconds = 0;
  for (const CaseRun& run : runs) {
    checks += run.findings.checks.size();
    seconds += run.seconds;
    if (!run.findings.passed()) failed.push_back(run.name());
  }
  if (failed.empty())
    return fmt::format("{} cases with {} checks: all passed ({:.1f} s of computing)\n", runs.size(),
                       checks, seconds);
  return fmt::format("{} of {} cases failed: {}\n", failed.size(), runs.size(),
                     fmt::join(failed, ", "));
}

}  // namespace gurney::report
