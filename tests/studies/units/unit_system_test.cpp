#include "studies/units/unit_system.h"

#include <gmock/gmock.h>

#include <vector>

#include "engine/base/error.h"

namespace gurney::study {
namespace {

using testing::HasSubstr;

TEST(UnitSystem, OfTheJobIsInGAndDegrees) {
  const UnitSystem job;
  EXPECT_FALSE(job.chosen());
  EXPECT_EQ(job.of("m/s2").name, "g");
  EXPECT_EQ(job.of("rad/s").name, "deg/s");
  for (const char* si : {"m", "m/s", "N", "N s", "J", "kg", "s", "1", ""}) {
    EXPECT_EQ(job.of(si).name, si);
    EXPECT_EQ(job.of(si).in_si, 1);
  }
}

TEST(UnitSystem, SiChangesNothing) {
  const UnitSystem si("si");
  for (const char* unit :
       {"m", "m/s", "m/s2", "rad", "rad/s", "rad/s2", "N", "N s", "N m", "J", "kg", "s", "1"}) {
    EXPECT_EQ(si.of(unit).name, unit);
    EXPECT_EQ(si.of(unit).in_si, 1) << unit;
  }
}

/// What each system makes of 1 g, 1 m, 1 m/s and 1 degree.
TEST(UnitSystem, ConvertsWhatItsNameSays) {
  struct Case {
    const char *name, *length;
    double meters;
    const char* acceleration;
    double g;
  };
  for (const Case& each : std::vector<Case>{{"g-m", "m", 1, "g", 1},
                                            {"g-cm", "cm", 100, "g", 1},
                                            {"g-mm", "mm", 1000, "g", 1},
                                            {"g-in", "in", 1 / 0.0254, "g", 1},
                                            {"m", "m", 1, "m/s2", 9.80665},
                                            {"cm", "cm", 100, "cm/s2", 980.665}}) {
    const UnitSystem units(each.name);
    EXPECT_EQ(units.of("m").name, each.length);
    EXPECT_DOUBLE_EQ(1 / units.of("m").in_si, each.meters);
    EXPECT_EQ(units.of("m/s").name, each.length + std::string("/s"));
    EXPECT_DOUBLE_EQ(1 / units.of("m/s").in_si, each.meters);
    EXPECT_EQ(units.of("m/s2").name, each.acceleration);
    EXPECT_DOUBLE_EQ(9.80665 / units.of("m/s2").in_si, each.g);
    EXPECT_EQ(units.of("rad").name, "deg");
    EXPECT_EQ(units.of("s").name, "s");
  }
}

/// 1 lbf is the weight of 1 lb; 1 in lbf = 0.112984829 J (NIST SP 811, B.8).
TEST(UnitSystem, InchesComeWithPounds) {
  const UnitSystem us("g-in");
  EXPECT_EQ(us.of("N").name, "lbf");
  EXPECT_NEAR(us.of("N").in_si, 4.448222, 5e-7);
  EXPECT_EQ(us.of("N s").name, "lbf s");
  EXPECT_EQ(us.of("J").name, "lbf in");
  EXPECT_NEAR(us.of("J").in_si, 0.1129848, 5e-8);
  EXPECT_EQ(us.of("N m").name, "lbf in");
  EXPECT_EQ(us.of("kg").name, "lb");
}

TEST(UnitSystem, WritesThreeDigitsAndTheUnit) {
  const UnitSystem cm("g-cm");
  EXPECT_EQ(cm.text(0.12345, "m"), "12.3 cm");
  EXPECT_EQ(cm.text(12.345, "m"), "1234 cm");
  EXPECT_EQ(cm.text(1.2345e-4, "m"), "0.0123 cm");
  EXPECT_EQ(cm.text(-0.5, "m/s"), "-50.0 cm/s");
  EXPECT_EQ(cm.text(0, "m"), "0 cm");
  EXPECT_EQ(cm.text(2, "1"), "2.00");
}

/// A millimetre is the third decimal of a metre and the first of a centimetre.
TEST(UnitSystem, KeepsTheLastDigitOfANumber) {
  EXPECT_EQ(UnitSystem().number(0.1234, "m", 3), "0.123");
  EXPECT_EQ(UnitSystem("g-cm").number(0.1234, "m", 3), "12.3");
  EXPECT_EQ(UnitSystem("g-mm").number(0.1234, "m", 3), "123");
  EXPECT_EQ(UnitSystem("si").number(0.1234, "rad", 2), "0.1234");
  EXPECT_EQ(UnitSystem().number(0.1234, "rad", 2), "7.07");
}

TEST(UnitSystem, RefusesOthersWithTheNearest) {
  try {
    UnitSystem("g-cn");
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "no units 'g-cn'; did you mean 'g-cm'?");
  }
  EXPECT_THROW(UnitSystem(""), Error);
}

}  // namespace
}  // namespace gurney::study
