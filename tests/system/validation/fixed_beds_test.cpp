#include <gtest/gtest.h>

#include "tests/system/validation/small_runs.h"

// studies/jobs/validation_fixed_beds.toml, 5 of its 20 records (docs/validation.md).
namespace gurney::study {
namespace {

constexpr std::size_t kRecords = 5;

class ValidationFixedBeds : public testing::TestWithParam<std::string> {
 protected:
  /// Largest displacements with these brakes [m].
  std::vector<double> displacements(const std::string& brakes) const {
    std::vector<double> result;
    for (const StudyRun& run : study_.runs({{"item", GetParam()}, {"brakes", brakes}}, kRecords)) {
      EXPECT_NEAR(run.intensity, 0.73, 1e-9);
      result.push_back(demands_of(run).peak_displacement);
    }
    EXPECT_EQ(result.size(), kRecords);
    return result;
  }

  SmallRuns study_{"validation_fixed_beds"};
};

INSTANTIATE_TEST_SUITE_P(Beds, ValidationFixedBeds, testing::Values("ward bed", "ICU bed"),
                         [](const auto& bed) { return bed.param.substr(0, bed.param.find(' ')); });

/// The report is that all beds of the floor moved: none stays within 0.1 m, braked or not.
TEST_P(ValidationFixedBeds, AllMove) {
  for (const char* brakes : {"off", "on"})
    for (const double displacement : displacements(brakes)) EXPECT_GT(displacement, 0.1) << brakes;
}

/// Brakes shorten the way in the mean over the records, though they do not prevent it.
TEST_P(ValidationFixedBeds, BrakedOnesMoveLessInTheMean) {
  double sum = 0;
  const auto off = displacements("off"), on = displacements("on");
  for (std::size_t i = 0; i < kRecords; ++i) sum += on[i] - off[i];
  EXPECT_LT(sum, 0);
}

}  // namespace
}  // namespace gurney::study
