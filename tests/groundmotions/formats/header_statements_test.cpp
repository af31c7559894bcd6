#include "groundmotions/formats/header_statements.h"

#include <gmock/gmock.h>

#include "engine/base/units.h"
#include "tests/support/error_text.h"

namespace gurney {
namespace {

using testing::ElementsAre;

TEST(HeaderStatements, FindsNumbersBehindTheirKeys) {
  EXPECT_EQ(number_after("NO. OF POINTS =  120  LENGTH", "NO. OF POINTS"), 120);
  EXPECT_EQ(number_after("MAX  =  -.105 G", "MAX"), -0.105);
  EXPECT_FALSE(number_after("MAX  =  G", "MAX"));
  EXPECT_FALSE(number_after("MIN  =  1", "MAX"));
}

TEST(HeaderStatements, FindsUnits) {
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
  EXPECT_EQ(name("VELOC DATA (UNITS: CM/SEC)"), "");
  EXPECT_DOUBLE_EQ(unit_in("SEC AND G/10.")->to_si, kStandardGravity / 10);
}

TEST(HeaderStatements, ReadsOrientations) {
  const auto azimuth = [](const char* label) {
    Component component;
    EXPECT_TRUE(orient_by_label(label, component)) << label;
    EXPECT_FALSE(component.direction) << label;
    return component.azimuth.value_or(-1) / kRadiansPerDegree;
  };
  EXPECT_NEAR(azimuth("90 DEG"), 90, 1e-12);
  EXPECT_NEAR(azimuth("360 Deg"), 0, 1e-12);
  EXPECT_NEAR(azimuth("Roof, N wall: 275 deg"), 275, 1e-12);
  EXPECT_NEAR(azimuth("S08E"), 172, 1e-12);
  EXPECT_NEAR(azimuth("E"), 90, 1e-12);
  for (const char* label :
       {"", "L", "T", "Roof", "H1", "-90 DEG", "400 DEG", "N95E", "12 storeys"}) {
    Component component;
    EXPECT_FALSE(orient_by_label(label, component)) << label;
    EXPECT_FALSE(component.azimuth || component.direction) << label;
  }
  for (const char* label : {"UP", "Up", "V", "VERT", "Vertical - 2nd floor"}) {
    Component component;
    EXPECT_TRUE(orient_by_label(label, component)) << label;
    EXPECT_EQ(component.direction, Direction::kVertical) << label;
  }
}

TEST(HeaderStatements, AcceptsThePeakOfSamplesWithoutTheirMean) {
  Component component;
  Mistakes mistakes("f");
  component.acceleration = Eigen::Vector4d(1, 1.2, 0.8, 1);
  check_peak({1.2, 1e-9, 3}, component.acceleration, component, mistakes);
  check_peak({0.2, 1e-9, 3}, component.acceleration, component, mistakes);
  EXPECT_TRUE(component.warnings.empty());
  check_peak({1.25, 1e-9, 3}, component.acceleration, component, mistakes);
  EXPECT_THAT(component.warnings,
              ElementsAre("the header states a peak of 1.25 m/s2, but the samples "
                          "have 1.2 m/s2"));
  EXPECT_FALSE(mistakes.any());
  check_peak({2, 1e-9, 3}, component.acceleration, component, mistakes);
  EXPECT_TRUE(mistakes.any());
}

TEST(HeaderStatements, CountsSecondsSince1970) {
  EXPECT_EQ(utc_seconds(1970, 1, 1, 0, 0, 0), 0);
  EXPECT_EQ(utc_seconds(2000, 3, 1, 12, 30, 1.5), 951913801.5);  // date -u -d ... +%s
  EXPECT_FALSE(utc_seconds(2001, 2, 29, 0, 0, 0));
  EXPECT_FALSE(utc_seconds(2001, 13, 1, 0, 0, 0));
  EXPECT_FALSE(utc_seconds(-999, 1, 1, 0, 0, 0));
  EXPECT_FALSE(utc_seconds(2001, 1, 1, 24, 0, 0));
}

}  // namespace
}  // namespace gurney
