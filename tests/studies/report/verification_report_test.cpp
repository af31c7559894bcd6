#include "studies/report/verification_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "studies/figures/verification_figures.h"
#include "studies/render/render.h"
#include "studies/verification/family.h"
#include "tests/support/verification_page.h"

namespace gurney::report {
namespace {

using testing::HasSubstr;
using testing::Not;
using verification::CaseRun;
using verification::Check;
using verification::Family;
using verification::Findings;

Family falling() {
  Family family;
  family.statement = {"fall", "falling", "A stone falls", "x = g t^2 / 2", "Galilei 1638"};
  family.parameters = {{"time", "s", 0, 2}};
  family.cases = {{"one_second", {1}}};
  return family;
}

CaseRun run_of(const Family& family, double computed) {
  CaseRun run;
  run.family = &family;
  run.set = family.cases[0];
  run.findings.checks = {{"way", "m", computed, 4.9, 0.1, "dt^2 |g|"}};
  run.findings.series = {{"way", "m", "time [s]", {0, 1}, {0, computed}, {0, 4.9}}};
  return run;
}

TEST(VerificationReport, ReportsWhatPassedInALine) {
  const Family family = falling();
  const std::string text = verification_text(run_of(family, 4.95), false);
  EXPECT_THAT(text, HasSubstr("ok   fall/one_second"));
  EXPECT_THAT(text, HasSubstr(" 1 checks,  50.0 % of a tolerance used"));
  EXPECT_THAT(text, Not(HasSubstr("dt^2")));
  EXPECT_THAT(verification_summary({run_of(family, 4.95)}),
              HasSubstr("1 cases with 1 checks: all passed"));
}

TEST(VerificationReport, ReportsWhatFailedWithTheDerivationOfItsTolerance) {
  const Family family = falling();
  const std::string text = verification_text(run_of(family, 5.1), false);
  EXPECT_THAT(text, HasSubstr("FAIL fall/one_second"));
  EXPECT_THAT(text, HasSubstr("A stone falls"));
  EXPECT_THAT(text, HasSubstr("time 1 s"));
  EXPECT_THAT(text, HasSubstr("computed 5.1 m, reference 4.9 m, error 0.2, tolerance 0.1 (200 %"));
  EXPECT_THAT(text, HasSubstr("tolerance: dt^2 |g|"));
  EXPECT_EQ(verification_summary({run_of(family, 4.95), run_of(family, 5.1)}),
            "1 of 2 cases failed: fall/one_second\n");
}

TEST(VerificationReport, NumbersThatAreNoneFail) {
  const Family family = falling();
  CaseRun run = run_of(family, std::numeric_limits<double>::quiet_NaN());
  EXPECT_THAT(verification_text(run, false), HasSubstr("FAIL"));
  run.findings.checks.clear();
  EXPECT_THAT(verification_text(run, false), HasSubstr("checks nothing"));
  EXPECT_FALSE(run.findings.passed());
}

TEST(VerificationReport, JsonHasEveryCheck) {
  const Family family = falling();
  const auto json = nlohmann::json::parse(render::json(verification_facts({run_of(family, 5.1)})));
  EXPECT_EQ(json["passed"], false);
  const auto& each = json["cases"][0];
  EXPECT_EQ(each["name"], "fall/one_second");
  EXPECT_EQ(each["parameters"]["time"]["highest"], 2);
  EXPECT_EQ(each["checks"][0]["tolerance"], 0.1);
  EXPECT_NEAR(each["checks"][0]["error"].get<double>(), 0.2, 1e-15);
  EXPECT_EQ(each["checks"][0]["passed"], false);
}

TEST(VerificationReport, MarkdownKeepsTheWorstOfEachQuantityAndItsCells) {
  const Family family = falling();
  const std::string page = verification_markdown({run_of(family, 4.95), run_of(family, 4.81)});
  EXPECT_THAT(page, HasSubstr("| `fall` | A stone falls | x = g t^2 / 2 | Galilei 1638 | 2 |"));
  EXPECT_THAT(page, HasSubstr("| `fall` | way [m] | one_second | 4.9 | -9.0e-02 | 1.0e-01 | "
                              "dt^2 \\|g\\| |"));
  EXPECT_THAT(page, Not(HasSubstr("5.0e-02")));  // the error of the other case
}

TEST(VerificationFigure, ShowsComputedOnReference) {
  const Family family = falling();
  CaseRun run = run_of(family, 4.95);
  EXPECT_THAT(figures::verification_figure(run), HasSubstr("computed less reference"));
  run.findings.series.clear();
  EXPECT_EQ(figures::verification_figure(run), "");
}

// The words of that page must be those of the list. That each case writes only what is on
// the page, its own test sees; of each closed form, cases run here until all its rows are written.
TEST(VerificationPage, HasNothingThatTheProgramDoesNotWrite) {
  const VerificationPage page = shipped_verification_page();
  const std::vector<Family> families = verification::all_families();
  std::vector<CaseRun> runs = verification::choose(families, {});
  EXPECT_EQ(page.statements, verification_page(verification_markdown(runs)).statements)
      << "write the tables anew: gurney verify --markdown";
  std::set<std::string> missing = words_of_checks(page);
  for (CaseRun& run : runs) {
    const std::string own = "`" + run.family->statement.name + "` ";
    if (std::ranges::none_of(missing, [&](const auto& words) { return words.starts_with(own); }))
      continue;
    verification::run(run, false);
    for (const auto& words : words_of_checks(verification_page(verification_markdown({run}))))
      missing.erase(words);
  }
  EXPECT_THAT(missing, testing::IsEmpty()) << "write the tables anew: gurney verify --markdown";
}

// Numbers may come from another machine; each error must be within its tolerance, which has as few digits.
TEST(VerificationPage, HasErrorsWithinTolerances) {
  for (const auto& cells : shipped_verification_page().checks) {
    EXPECT_LE(std::abs(std::stod(cells[4])), 1.06 * std::stod(cells[5])) << cells[0] << cells[1];
    EXPECT_NO_THROW(std::stod(cells[3])) << cells[0] << cells[1];
  }
}

}  // namespace
}  // namespace gurney::report
