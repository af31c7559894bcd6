#include <gtest/gtest.h>

#include <ostream>
#include <set>

#include "studies/report/verification_report.h"
#include "studies/verification/family.h"
#include "studies/verification/verify.h"
#include "tests/support/verification_page.h"

// The list of `gurney verify`: every case is a test here.
namespace gurney::verification {

void PrintTo(const CaseRun& run, std::ostream* out) { *out << run.name(); }

namespace {

const std::vector<Family>& families() {
  static const std::vector<Family> all = all_families();
  return all;
}

CaseRun expect_to_pass(CaseRun chosen) {
  run(chosen, false);
  EXPECT_FALSE(chosen.findings.checks.empty());
  for (const Check& c : chosen.findings.checks)
    EXPECT_TRUE(c.passed()) << c.quantity << ": " << c.computed << " " << c.unit << ", reference "
                            << c.reference << ", tolerance " << c.tolerance << ": " << c.derivation;
  return chosen;
}

std::string test_name(std::string name) {
  for (char& c : name)
    if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
  return name;
}

class Cases : public testing::TestWithParam<CaseRun> {};

TEST_P(Cases, PassAndAreOnThePage) {
  const CaseRun run = expect_to_pass(GetParam());
  static const std::set<std::string> page = words_of_checks(shipped_verification_page());
  for (const auto& words : words_of_checks(verification_page(report::verification_markdown({run}))))
    EXPECT_TRUE(page.contains(words)) << "not in docs/verification_tables.md: " << words;
}

INSTANTIATE_TEST_SUITE_P(TheList, Cases, testing::ValuesIn(choose(families(), {})),
                         [](const auto& test) { return test_name(test.param.name()); });

std::vector<std::string> drawn_families() {
  std::vector<std::string> names;
  for (const Family& family : families())
    if (family.drawn) names.push_back(family.statement.name);
  return names;
}

/// Cases of each family with values drawn in the test, since some take long to draw. Flights are
/// cheap, and a landing in four once missed its balance.
class DrawnCases : public testing::TestWithParam<std::string> {};

TEST_P(DrawnCases, Pass) {
  const int draws = GetParam() == "flight" ? 40 : 3;
  const std::vector<CaseRun> drawn = choose(families(), {{GetParam()}, 2026, draws, false});
  ASSERT_EQ(std::ssize(drawn), draws);
  for (const CaseRun& each : drawn) {
    SCOPED_TRACE(each.name());
    expect_to_pass(each);
  }
}

INSTANTIATE_TEST_SUITE_P(Fresh, DrawnCases, testing::ValuesIn(drawn_families()),
                         [](const auto& test) { return test_name(test.param); });

}  // namespace
}  // namespace gurney::verification
