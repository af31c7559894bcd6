#include <gtest/gtest.h>

#include "tests/system/validation/small_runs.h"

// studies/jobs/validation_isolation.toml, 1 of its 10 records (docs/validation.md).
namespace gurney::study {
namespace {

/// Braked items stay nearer in each of two pairs on either isolation, of the dialysis machine and
/// of the ultrasound machine: were braking without effect, 8 pairs would come so with 0.004.
TEST(ValidationIsolation, BrakedItemsStayNearerOnIsolators) {
  const SmallRuns study("validation_isolation");
  for (const char* building : {"lead rubber", "friction pendulum"})
    for (const char* item : {"dialysis", "ultrasound"}) {
      const auto made = [&](const std::string& brakes) {
        return study.runs({{"building", building}, {"item", item}, {"brakes", brakes}});
      };
      const auto off = made("off"), on = made("on");
      ASSERT_EQ(off.size(), 2u);
      for (std::size_t i = 0; i < off.size(); ++i)
        EXPECT_LT(demands_of(on[i]).peak_displacement, demands_of(off[i]).peak_displacement)
            << building << ", " << item << ", pair " << i;
    }
}

}  // namespace
}  // namespace gurney::study
