#include <gtest/gtest.h>

#include "tests/system/validation/small_runs.h"

// studies/jobs/validation_long_period.toml, 4 of its 10 records (docs/validation.md).
namespace gurney::study {
namespace {

constexpr std::size_t kRecords = 4;

class ValidationLongPeriod : public testing::TestWithParam<std::string> {
 protected:
  /// Largest displacements with these brakes on the floor with a period of 4 s [m].
  std::vector<double> displacements(const std::string& brakes) const {
    std::vector<double> result;
    for (const StudyRun& run :
         study_.runs({{"period", "4 s"}, {"item", GetParam()}, {"brakes", brakes}}, kRecords)) {
      EXPECT_NEAR(run.intensity, 2.42, 1e-9);
      result.push_back(demands_of(run).peak_displacement);
    }
    EXPECT_EQ(result.size(), kRecords);
    return result;
  }

  SmallRuns study_{"validation_long_period"};
};

INSTANTIATE_TEST_SUITE_P(Items, ValidationLongPeriod,
                         testing::Values("bed", "dialysis", "ultrasound"),
                         [](const auto& item) { return item.param; });

/// Free items travel metres and braked ones do not, in every pair: were both alike, four of four
/// pairs would come with 1/16 for one item and 1/4096 for three.
TEST_P(ValidationLongPeriod, FreeItemsTravelMetresAndBrakedOnesStay) {
  const auto off = displacements("off"), on = displacements("on");
  for (std::size_t i = 0; i < kRecords; ++i) {
    EXPECT_GT(off[i], 1) << i;
    EXPECT_LT(on[i], off[i]) << i;
  }
  EXPECT_GT(*std::ranges::max_element(off), 2.5);
}

}  // namespace
}  // namespace gurney::study
