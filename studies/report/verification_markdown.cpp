#include <fmt/format.h>

#include <algorithm>

#include "studies/render/render.h"
#include "studies/report/verification_report.h"

namespace gurney::report {
namespace {

using findings::Table;
using verification::CaseRun;
using verification::Check;
using verification::StockRun;

/// The check of one quantity that used most of its tolerance, among all cases of a family.
struct Row {
  std::string quantity;
  const CaseRun* run;
  const Check* check;
};

std::vector<Row> rows_of(const std::vector<CaseRun>& runs, const verification::Family* family) {
  std::vector<Row> rows;
  for (const CaseRun& run : runs) {
    if (run.family != family) continue;
    for (const Check& check : run.findings.checks) {
      const auto at = std::ranges::find(rows, check.quantity, &Row::quantity);
      if (at == rows.end())
        rows.push_back({check.quantity, &run, &check});
      else if (check.used() > at->check->used())
        *at = {check.quantity, &run, &check};
    }
  }
  return rows;
}

std::vector<const verification::Family*> families_of(const std::vector<CaseRun>& runs) {
  std::vector<const verification::Family*> families;
  for (const CaseRun& run : runs)
    if (families.empty() || families.back() != run.family) families.push_back(run.family);
  return families;
}

/// Error of a quantity on a stock solver.
std::string stock_error(const StockRun& stock, const std::string& quantity) {
  const auto at = std::ranges::find(stock.findings.checks, quantity, &Check::quantity);
  return at == stock.findings.checks.end() ? "" : fmt::format("{:.1e}", at->error());
}

std::string code(const std::string& name) { return "`" + name + "`"; }

std::string with_unit(const Check& check) {
  return check.unit.empty() ? check.quantity : check.quantity + " [" + check.unit + "]";
}

/// A derivation that the row above has as well.
const std::string kAsAbove = "as above";

}  // namespace

std::string verification_markdown(const std::vector<CaseRun>& runs) {
  Table statements{"",
                   "",
                   {{"", "closed form"},
                    {"", "what happens"},
                    {"", "reference"},
                    {"", "source"},
                    {"", "cases"}}};
  Table checks{"",
               "",
               {{"", "closed form"},
                {"", "quantity"},
                {"", "worst case"},
                {"", "reference", {".5g"}},
                {"", "error", {".1e"}},
                {"", "tolerance", {".1e"}},
                {"", "how the tolerance follows"}}};
  Table stock{"",
              "",
              {{"", "case"},
               {"", "quantity"},
               {"", "reference", {".5g"}},
               {"", "error of gurney", {".1e"}},
               {"", "of bullet"},
               {"", "of bullet-dantzig"}}};
  for (const verification::Family* family : families_of(runs)) {
    const verification::Statement& s = family->statement;
    statements.add({code(s.name), s.title, s.equation, s.source,
                    std::ranges::count(runs, family, &CaseRun::family)});
    std::string last;
    for (const Row& row : rows_of(runs, family)) {
      const Check& check = *row.check;
      checks.add({code(s.name), with_unit(check), row.run->set.name, check.reference, check.error(),
                  check.tolerance, check.derivation == last ? kAsAbove : check.derivation});
      last = check.derivation;
    }
  }
  for (const CaseRun& run : runs) {
    if (run.stock.size() != 2) continue;
    for (const Check& c : run.findings.checks) {
      const std::string bullet = stock_error(run.stock[0], c.quantity);
      if (!bullet.empty())
        stock.add({code(run.name()), with_unit(c), c.reference, c.error(), bullet,
                   stock_error(run.stock[1], c.quantity)});
    }
  }
  return std::string(R"(# Closed forms

Written by `gurney verify --markdown`; [verification](verification.md) explains how to read and repeat it.

## What is compared

)") + render::markdown(statements) +
         R"(
## Worst case of each quantity

For each quantity the case that uses most of its tolerance. The computed value is reference + error; `gurney verify
--json` prints it for every case.

)" + render::markdown(checks) +
         R"(
## Stock Bullet on the same cases

`bullet` is its iterated contact solver (50 iterations), `bullet-dantzig` its direct one, with the same steps. Cases
with fixtures or drop weights are omitted, which stock Bullet does not support. Its friction cone is a pyramid: hence
the error of `isotropy_free`.

)" + render::markdown(stock);
}

}  // namespace gurney::report
