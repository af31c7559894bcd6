#include "studies/plan/undrawn_ranges.h"

#include <gmock/gmock.h>

#include "studies/run/declared_ranges.h"
#include "tests/studies/small_study.h"

namespace gurney::study {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

TEST(UndrawnRanges, AreListedByFileOnceForAllIndicesAndAxes) {
  UndrawnRanges ranges;
  EXPECT_TRUE(ranges.lines().empty());
  EXPECT_EQ(ranges.parameters(), 0);
  ranges.add("cart.toml", "shape[0].size_mm.x");
  ranges.add("R100.toml", "wheel_mass_kg");
  ranges.add("cart.toml", "shape[11].size_mm.z");
  ranges.add("cart.toml", "chassis.mass_kg");
  EXPECT_EQ(ranges.lines(), (std::vector<std::string>{"cart.toml: shape[].size_mm, chassis.mass_kg",
                                                      "R100.toml: wheel_mass_kg"}));
  EXPECT_EQ(ranges.parameters(), 3);
}

SmallStudy study_of(const std::string& keys, const std::string& floor = "") {
  return SmallStudy(small_job(keys + "[[study.factor]]\nkey = \"item.brakes\"\nvalues = [true]\n") +
                    floor);
}

TEST(UndrawnRanges, OfAStudyAreThoseThatNoDrawChanges) {
  const SmallStudy drawn = study_of("draws = 1\n");
  const auto lines = undrawn_ranges(drawn.batch).lines();
  EXPECT_THAT(lines, Contains(AllOf(StartsWith("R100.toml: "), HasSubstr("wheel_mass_kg"),
                                    Not(HasSubstr("brake_torque")), Not(HasSubstr("trail")))));
  EXPECT_THAT(lines, Not(Contains(StartsWith("levelness.toml"))));
  const SmallStudy fixed = study_of("");
  EXPECT_THAT(undrawn_ranges(fixed.batch).lines(),
              AllOf(Contains(AllOf(StartsWith("R100.toml: "), HasSubstr("brake_torque_n_m"),
                                   HasSubstr("trail_mm"))),
                    Contains("levelness.toml: slope, cross_slope")));
}

}  // namespace
}  // namespace gurney::study
