#include <gtest/gtest.h>

#include "engine/base/units.h"
#include "groundmotions/formats/words.h"

namespace gurney::groundmotions {
namespace {

TEST(UnitText, FindsUnits) {
  const auto name = [](const char* line) {
    const auto unit = unit_in(line);
    return std::string(unit ? unit->name : "");
  };
  EXPECT_EQ(name("(UNITS: CM/SEC/SEC)"), "cm/s2");
  EXPECT_EQ(name("UNITS=CM/SEC**2, CM/SEC, AND CM"), "cm/s2");
  EXPECT_EQ(name("in cm/sec2. (8f10.6)"), "cm/s2");
  EXPECT_EQ(name("PEAK ACCELERATION =    -6.869  CMS/SEC/SEC AT"), "cm/s2");
  EXPECT_EQ(name("UNITS ARE SECONDS AND G/10"), "g/10");
  EXPECT_EQ(name("Units of uncor data are sec and g.   Max"), "g");
  EXPECT_EQ(name("acceleration in [Gals]"), "cm/s2");
  EXPECT_EQ(name("VELOC DATA (UNITS: CM/SEC)"), "");
  EXPECT_DOUBLE_EQ(unit_in("SEC AND G/10.")->to_si, kStandardGravity / 10);
}

TEST(UnitText, KnowsUnitsOfOtherQuantities) {
  EXPECT_EQ(other_quantity("cm/s"), "velocity");
  EXPECT_EQ(other_quantity(" M/SEC "), "velocity");
  EXPECT_EQ(other_quantity("cm s^-1"), "velocity");
  EXPECT_EQ(other_quantity("in/second"), "velocity");
  EXPECT_EQ(other_quantity("kine"), "velocity");
  EXPECT_EQ(other_quantity("cm"), "displacement");
  for (const char* other : {"cm/s2", "cm/s/s", "g", "", "counts"})
    EXPECT_FALSE(other_quantity(other)) << other;
}

TEST(UnitText, KnowsUnitsOfTime) {
  for (const char* second : {"s", "Sec", "sec.", "seconds", "[s]"})
    EXPECT_EQ(time_unit(second), 1) << second;
  for (const char* thousandth : {"ms", "MSEC", "milliseconds"})
    EXPECT_EQ(time_unit(thousandth), 1e-3) << thousandth;
  EXPECT_EQ(time_unit("min"), 60);
  for (const char* other : {"", "samples", "#", "hour", "m", "m/s"})
    EXPECT_FALSE(time_unit(other)) << other;
}

}  // namespace
}  // namespace gurney::groundmotions
