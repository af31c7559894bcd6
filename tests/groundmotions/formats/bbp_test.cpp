#include <gmock/gmock.h>

#include "engine/base/units.h"
#include "groundmotions/formats/readers.h"
#include "tests/groundmotions/formats/text_file.h"
#include "tests/support/error_text.h"

namespace gurney::groundmotions {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const std::string kRows =
    "0.000000e+00\t1.000000e+00\t-2.000000e+00\t3.000000e+00\n"
    "2.000000e-02\t4.000000e+00\t5.000000e+00\t6.000000e+00\n"
    "4.000000e-02\t7.000000e+00\t8.000000e+00\t-9.000000e+00\n";
const std::string kFile =
    "# Sim stat=XYZ\n#    time(sec)      N-S(cm/s/s)      E-W(cm/s/s)      U-D(cm/s/s)\n" + kRows;
const std::string kLong =
    "# Station: XYZ\n#\n# Column 1: Time (s)\n"
    "# Column 2: North-south acceleration (cm/s/s) (+ is northward)\n"
    "# Column 3: East-west acceleration (cm/s/s) (+ is eastward)\n"
    "# Column 4: Up-down acceleration (cm/s/s) (+ is upward)\n#\n" +
    kRows;
const std::string kOrientation =
    "#     Station= XYZ\n#       units= cm/s^2\n# orientation= 30.0,120.0,up\n#\n"
    "# Column 1: Time (s)\n# Column 2: H1 component ground acceleration (+ is 30.0)\n" +
    kRows;

void expect_the_motion(const std::vector<Component>& components) {
  ASSERT_EQ(components.size(), 3u);
  for (const Component& component : components) {
    EXPECT_EQ(component.format, "BBP");
    EXPECT_EQ(component.unit, "cm/s2");
    EXPECT_EQ(component.time_step, 0.02);
    EXPECT_THAT(component.warnings, testing::IsEmpty());
  }
  EXPECT_TRUE(components[0].acceleration.isApprox(Eigen::Vector3d(0.01, 0.04, 0.07)));
  EXPECT_TRUE(components[1].acceleration.isApprox(Eigen::Vector3d(-0.02, 0.05, 0.08)));
  EXPECT_TRUE(components[2].acceleration.isApprox(Eigen::Vector3d(0.03, 0.06, -0.09)));
  EXPECT_EQ(components[2].direction, Direction::kVertical);
}

TEST(Bbp, ReadsTheHeadersOfThePlatform) {
  for (const std::string& text : {kFile, kLong}) {
    const auto components = read_text(text);
    expect_the_motion(components);
    EXPECT_EQ(components[0].name, "N-S");
    EXPECT_EQ(components[0].azimuth, 0);
    EXPECT_EQ(components[1].azimuth, 90 * kRadiansPerDegree);
  }
  EXPECT_EQ(fact(read_text(kLong)[0], "Station"), "XYZ");
}

TEST(Bbp, KeepsTheUsualNamesWhereTheColumnsHaveOnlyUnits) {
  const auto components =
      read_text(replaced(replaced(replaced(kFile, "N-S(", "("), "E-W(", "("), "U-D(", "("));
  expect_the_motion(components);
  EXPECT_EQ(components[0].name, "N-S");
  EXPECT_EQ(components[2].name, "U-D");
}

TEST(Bbp, TakesOrientationsAndOrdersOfTheComments) {
  const auto components = read_text(kOrientation);
  expect_the_motion(components);
  EXPECT_EQ(components[0].name, "30.0");
  EXPECT_DOUBLE_EQ(*components[1].azimuth, 120 * kRadiansPerDegree);
  const auto swapped =
      read_text(replaced(replaced(replaced(kFile, "N-S", "X"), "E-W", "N-S"), "X(", "E-W("));
  EXPECT_EQ(swapped[0].azimuth, 90 * kRadiansPerDegree);
  EXPECT_EQ(swapped[1].azimuth, 0);
}

TEST(Bbp, TakesAxesAndSensesOfTheColumns) {
  const std::string swapped =
      replaced(replaced(kLong, "Column 2: North-south", "Column 2: East-west"),
               "Column 3: East-west", "Column 3: North-south");
  const auto exchanged = read_text(replaced(replaced(swapped, "(+ is northward)", "(+ is X)"),
                                            "(+ is eastward)", "(+ is northward)"));
  EXPECT_EQ(exchanged[0].name, "E-W");
  EXPECT_EQ(exchanged[0].azimuth, 90 * kRadiansPerDegree);
  EXPECT_EQ(exchanged[1].azimuth, 0);

  const auto turned =
      read_text(replaced(replaced(kLong, "upward", "downward"), "eastward", "westward"));
  EXPECT_DOUBLE_EQ(turned[0].acceleration[0], 0.01);
  EXPECT_DOUBLE_EQ(turned[1].acceleration[0], 0.02);
  EXPECT_DOUBLE_EQ(turned[2].acceleration[0], -0.03);
  EXPECT_EQ(turned[1].azimuth, 90 * kRadiansPerDegree);
  EXPECT_THAT(turned[2].warnings, ElementsAre("the comments say that + is to the south, west or "
                                              "down in U-D: its sign was turned"));
  EXPECT_THAT(
      error_text([] {
        read_text(replaced(replaced(kLong, "East-west", "North-south"), "eastward", "northward"));
      }),
      HasSubstr("f:1:1: the comments name the columns"));
  EXPECT_THAT(
      error_text([] {
        read_text(replaced(kLong, "East-west acceleration (cm/s/s)", "East-west acceleration (g)"));
      }),
      HasSubstr("f:5:1: this column has another unit than line 4; one unit is allowed"));
  EXPECT_DOUBLE_EQ(read_text(replaced(kLong, "Time (s)", "Time (ms)"), {})[0].time_step, 2e-5);
}

TEST(Bbp, RefusesVelocityAndDisplacement) {
  EXPECT_EQ(error_text([] { read_text(replaced(kFile, "cm/s/s", "cm/s")); }),
            "f:2:1: a record must be acceleration, but this is a velocity file (cm/s); take the "
            ".acc.bbp file of this station");
  EXPECT_THAT(error_text([] { read_text(replaced(kLong, "cm/s/s", "cm")); }),
              HasSubstr("f:4:1: a record must be acceleration, but this is a displacement file"));
}

TEST(Bbp, ReportsWhatIsWrong) {
  EXPECT_EQ(error_text([] { read_text(replaced(kFile, "\t6.000000e+00", "")); }),
            "f:4:1: 3 numbers on a line, time and three components are 4");
  EXPECT_THAT(
      error_text([] { read_text(replaced(kFile, "4.000000e-02", "5.500000e-02")); }),
      HasSubstr("f:4:1: time 0.02 s is off the even grid (0.0275 s, step 0.0275 s) by 0.273 of"));
  EXPECT_THAT(error_text([] { read_text(replaced(kOrientation, "units", "scale")); }),
              HasSubstr("f: the file does not state its unit"));
  EXPECT_THAT(error_text([] { read_text(kFile, {.unit = "g", .time_step = 0.01}); }),
              testing::AllOf(HasSubstr("f:2:1: the file states the unit cm/s2"),
                             testing::Not(HasSubstr("time_step_s"))));
  EXPECT_EQ(error_text([] { read_text(kFile.substr(0, kFile.size() - 7)); }),
            "f:5:46: the file ends within a line and its last number is shorter than all others: "
            "the file seems to be cut");
}

TEST(Bbp, WarnsOfCopiesAndLateStarts) {
  std::string text = replaced(kFile, "3.000000e+00\n", "1.000000e+00\n");
  text = replaced(replaced(text, "6.000000e+00\n", "4.000000e+00\n"), "-9.0", "7.0");
  EXPECT_THAT(read_text(text)[2].warnings,
              ElementsAre("component U-D has exactly the samples of N-S: one of them seems to be "
                          "a copy"));
  text = replaced(replaced(kFile, "4.000000e-02", "6.000000e-02"), "2.000000e-02", "4.000000e-02");
  EXPECT_THAT(read_text(replaced(text, "0.000000e+00\t", "2.000000e-02\t"))[0].warnings,
              ElementsAre("the first time is 0.02 s; the motion starts there, at 0 s of the run"));
}

}  // namespace
}  // namespace gurney::groundmotions
