#include "groundmotions/formats/stated.h"

#include <gmock/gmock.h>

#include "tests/support/error_text.h"

namespace gurney {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

struct Verdict {
  std::vector<std::string> warnings;
  std::string error;
};

/// The peak that a header states against samples of 0.02 m/s2.
Verdict peak(std::string_view stated, const AccelerationUnit& unit = {"cm/s2", 0.01}) {
  Component component;
  component.acceleration = Eigen::Vector2d(0.01, -0.02);
  Mistakes mistakes("f");
  check_peak(stated, unit, 7, component, mistakes);
  return {component.warnings, error_text([&] { mistakes.throw_if_any(); })};
}

// Samples have 2 cm/s2; allowed are half of the last digit and 0.1 % of the samples' peak.
TEST(Stated, ComparesPeaksToTheirLastDigit) {
  for (const char* good : {"2", "2.4", "-2.0", "2.0019", "2.000E+00", "0.2e1", "1.5"}) {
    const bool coarse = std::string_view(good) == "2.4" || std::string_view(good) == "1.5";
    EXPECT_EQ(peak(good).warnings.empty(), !coarse) << good;
    EXPECT_EQ(peak(good).error, "(no error)") << good;
  }
  EXPECT_THAT(peak("0.020", {"m/s2", 1}).warnings, IsEmpty());
  EXPECT_THAT(peak("2.003").warnings,
              ElementsAre("the file states a peak of 2.003 cm/s2, but its samples have 2 cm/s2"));
}

TEST(Stated, RefusesPeaksOffByMoreThanHalf) {
  EXPECT_EQ(peak("2.99").error, "(no error)");
  EXPECT_EQ(peak("3.01").error,
            "f:7:1: the file states a peak of 3.01 cm/s2, but its samples have 2 cm/s2");
  EXPECT_NE(peak("1.33").error, "(no error)");
  EXPECT_EQ(peak("1.34").error, "(no error)");
  EXPECT_EQ(peak("").error, "f:7:1: the peak must be a number, got ''");
  EXPECT_NE(peak("0.0").error, "(no error)");
}

TEST(Stated, KnowsUnitsOfOtherQuantities) {
  EXPECT_EQ(other_quantity("cm/s"), "velocity");
  EXPECT_EQ(other_quantity(" M/SEC "), "velocity");
  EXPECT_EQ(other_quantity("cm"), "displacement");
  for (const char* other : {"cm/s2", "cm/s/s", "g", "", "counts"})
    EXPECT_FALSE(other_quantity(other)) << other;
}

}  // namespace
}  // namespace gurney
