#include "studies/verification/cases.h"

#include <gtest/gtest.h>

#include <ostream>

#include "studies/verification/verify.h"

// The list of `gurney verify`: every case is a test here.
namespace gurney::verification {

void PrintTo(const CaseRun& run, std::ostream* out) { *out << run.name(); }

namespace {

const std::vector<Family>& families() {
  static const std::vector<Family> all = all_families();
  return all;
}

std::string test_name(const testing::TestParamInfo<CaseRun>& info) {
  std::string name = info.param.name();
  for (char& c : name)
    if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
  return name;
}

class Cases : public testing::TestWithParam<CaseRun> {};

TEST_P(Cases, Pass) {
  CaseRun chosen = GetParam();
  run(chosen, false);
  EXPECT_FALSE(chosen.findings.checks.empty());
  for (const Check& c : chosen.findings.checks)
    EXPECT_TRUE(c.passed()) << c.quantity << ": " << c.computed << " " << c.unit << ", reference "
                            << c.reference << ", tolerance " << c.tolerance << ": " << c.derivation;
}

INSTANTIATE_TEST_SUITE_P(TheList, Cases, testing::ValuesIn(choose(families(), {})), test_name);
INSTANTIATE_TEST_SUITE_P(Fresh, Cases, testing::ValuesIn(choose(families(), {{}, 2026, 1, false})),
                         test_name);

}  // namespace
}  // namespace gurney::verification
