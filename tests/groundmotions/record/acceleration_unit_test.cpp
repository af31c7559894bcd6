#include "groundmotions/record/acceleration_unit.h"

#include <gtest/gtest.h>

#include "engine/base/units.h"

namespace gurney::groundmotions {
namespace {

TEST(AccelerationUnit, KnowsEverySpelling) {
  for (const char* spelling : {"cm/s2",
                               "CM/S/S",
                               "cm/s^2",
                               "cm/s**2",
                               "CM/SEC**2",
                               "cm/sec^2",
                               "cm/sec2",
                               "cm/sec/sec",
                               "cm/s\xc2\xb2",
                               "cm/s\xb2",
                               "cm s-2",
                               "cm s^-2",
                               "cm\xc2\xb7s\xe2\x81\xbb\xc2\xb2",
                               "cm.s-2",
                               "cm / s2",
                               "cm/(s^2)",
                               "CMS/SEC/SEC",
                               "cm_per_s2",
                               "cm per sec squared",
                               "[cm/s2].",
                               "gal",
                               "GALS",
                               "Gal"}) {
    const auto unit = acceleration_unit(spelling);
    ASSERT_TRUE(unit) << spelling;
    EXPECT_STREQ(unit->name, "cm/s2") << spelling;
    EXPECT_EQ(unit->to_si, 0.01) << spelling;
  }
  for (const char* spelling : {"g", "G", "g's", "(g)"})
    EXPECT_EQ(acceleration_unit(spelling).value().to_si, kStandardGravity) << spelling;
  EXPECT_EQ(acceleration_unit("m/s\xc2\xb2").value().to_si, 1);
  EXPECT_EQ(acceleration_unit("mm/sec2").value().to_si, 0.001);
  EXPECT_DOUBLE_EQ(acceleration_unit("mg").value().to_si, kStandardGravity / 1000);
  EXPECT_DOUBLE_EQ(acceleration_unit("%g").value().to_si, kStandardGravity / 100);
  EXPECT_DOUBLE_EQ(acceleration_unit("percent g").value().to_si, kStandardGravity / 100);
  EXPECT_DOUBLE_EQ(acceleration_unit("G/10.").value().to_si, kStandardGravity / 10);
  EXPECT_EQ(acceleration_unit("ft/s2").value().to_si, 0.3048);
  EXPECT_EQ(acceleration_unit("in/sec^2").value().to_si, 0.0254);
}

TEST(AccelerationUnit, KnowsNoOther) {
  for (const char* other :
       {"", "gg", "m/s", "cm", "s", "m/s3", "km/s2", "kg", "gs2", "1g", "counts"})
    EXPECT_FALSE(acceleration_unit(other)) << other;
}

// One list for jobs, lists, options and messages.
TEST(AccelerationUnit, NamesOfUsersAreUnits) {
  for (const std::string& name : acceleration_unit_names()) {
    EXPECT_TRUE(acceleration_unit(name)) << name;
    EXPECT_NE(kAccelerationUnits.find(name), std::string::npos) << name;
  }
}

}  // namespace
}  // namespace gurney::groundmotions
