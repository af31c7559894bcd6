#include <gmock/gmock.h>

#include "engine/base/units.h"
#include "groundmotions/formats/readers.h"
#include "tests/groundmotions/formats/text_file.h"
#include "tests/support/error_text.h"

namespace gurney::groundmotions {
namespace {

using testing::HasSubstr;

constexpr double kG = kStandardGravity;

std::vector<Component> read(const std::string& text, const ReadOptions& options = {}) {
  return read_components(SourceFile("f.AT2", text), options);
}

std::string file_with(const std::string& count_and_step) {
  return "PEER NGA STRONG MOTION DATABASE RECORD\n"
         "Nowhere-01, 1/2/2003, Some Station, 228\n"
         "ACCELERATION TIME SERIES IN UNITS OF G\n" +
         count_and_step +
         "\n"
         "   .1000000E+00  -.2000000E+00   .3000000E+00\n"
         "  -.4000000E+00   .5000000E-01\n";
}

void expect_the_motion(const std::vector<Component>& components, double time_step = 0.02) {
  ASSERT_EQ(components.size(), 1u);
  const Component& component = components[0];
  EXPECT_EQ(component.format, "PEER AT2");
  EXPECT_EQ(component.unit, "g");
  EXPECT_EQ(component.time_step, time_step);
  ASSERT_EQ(component.acceleration.size(), 5);
  const double expected[] = {0.1, -0.2, 0.3, -0.4, 0.05};
  for (int i = 0; i < 5; ++i) EXPECT_DOUBLE_EQ(component.acceleration[i], expected[i] * kG);
}

TEST(PeerAt2, ReadsEverySpellingOfCountAndStep) {
  for (const char* spelling :
       {"NPTS=   5, DT=   .0200 SEC", "NPTS=   5, DT=   .0200 SEC,", "NPTS=  5, DT= .02000 SEC   ",
        "NPTS=   5, dt=  .02000", "5    0.0200    NPTS, DT", "   5   .0200   NPTS, DT",
        "NPTS=5,DT=.02SEC", "NPTS=   5, DT=   .0200 SEC,   0 POLE @    30.0 HZ,  -5 POLE @   .05",
        "NPTS= 5 , DT= .02 SEC,", "NPTS=    5DT=  .0200 SEC", "5 0.02", "NPTS= 5\nDT= 0.02 SEC",
        "NPTS: 5  DT: 2.0E-02", "NPTS=  5, DT=    0.02 SEC",
        "FILTER POINTS: HP=0.12 Hz LP=25.0 Hz\nNPTS=  5, DT= .02000 SEC"})
    expect_the_motion(read(file_with(spelling)));
}

TEST(PeerAt2, ReadsEveryKindOfLineEnd) {
  const std::string text = file_with("NPTS=   5, DT=   .0200 SEC");
  for (const char* end : {"\r\n", "\r\r\n", "\r"})
    expect_the_motion(read(replaced_once(text, "\n", end)));
  expect_the_motion(read(text.substr(0, text.size() - 1)));
}

TEST(PeerAt2, ReadsOldAndEasternTitles) {
  const std::string text = file_with("NPTS=   5, DT=   .0200 SEC");
  expect_the_motion(
      read(replaced_once(text, "SERIES IN UNITS OF G", "HISTORY IN UNITS OF G. FILTER")));
  expect_the_motion(
      read(replaced_once(text, "ACCELERATION TIME SERIES IN UNITS OF G", "The units are (g)")));
  expect_the_motion(read(replaced_once(text, "PEER NGA STRONG MOTION DATABASE RECORD",
                                       "PACIFIC ENGINEERING AND ANALYSIS STRONG-MOTION DATA   ")));
}

TEST(PeerAt2, ReadsGluedAndWideNumbers) {
  const std::string head =
      file_with("NPTS= 5, DT= .02 SEC").substr(0, file_with("NPTS= 5, DT= .02 SEC").find("   .1"));
  expect_the_motion(read(head + ".1000000E+00-.2000000E+00 .3000000E+00\n-.4000000E+00+.5E-01\n"));
  expect_the_motion(read(head + "  1.0000000E-01 -2.0000000E-01  3.0000000E-01\n"
                                " -4.0000000E-01  5.0000000E-02\n"));
  expect_the_motion(read(head + "   0.10000  -0.20000   0.30000  -0.40000   0.05000\n"));
}

TEST(PeerAt2, TakesAllNumbersAndWarnsWithoutNpts) {
  const auto components = read(file_with("DT= .0200 SEC"));
  expect_the_motion(components);
  EXPECT_THAT(components[0].warnings,
              testing::ElementsAre("the header states no NPTS: all 5 numbers were taken"));
}

// Four header lines, of which the last says nothing: the user states the step.
TEST(PeerAt2, SkipsTextBeforeTheNumbers) {
  const auto components = read(file_with("LOW CUT 0.1 HZ"), {.time_step = 0.02});
  expect_the_motion(components);
  EXPECT_THAT(components[0].warnings,
              testing::ElementsAre("a line of text after the header, skipped: 'LOW CUT 0.1 HZ'",
                                   "the header states no NPTS: all 5 numbers were taken"));
}

TEST(PeerAt2, TurnsDownToUp) {
  const Component component =
      read(replaced_once(file_with("NPTS= 5, DT= .02 SEC"), "228", "DWN"))[0];
  EXPECT_EQ(component.direction, Direction::kVertical);
  EXPECT_DOUBLE_EQ(component.acceleration[0], -0.1 * kG);
  EXPECT_THAT(
      component.warnings,
      testing::ElementsAre("the component points down (DWN): its sign was turned, up is positive"));
}

TEST(PeerAt2, RefusesOptionsForOtherFiles) {
  EXPECT_EQ(error_text([] {
              read(file_with("NPTS= 5, DT= .02 SEC"), {.si_per_count = 1, .columns = "time,h1"});
            }),
            "f.AT2: count_m_per_s2 = 1 was given, but the file does not hold raw counts\n"
            "f.AT2: columns = \"time,h1\" was given, but the layout of this file is known");
}

TEST(PeerAt2, KnowsTheComponentAndItsAzimuth) {
  const std::string text = file_with("NPTS= 5, DT= .02 SEC");
  const auto with = [&](const char* name) { return read(replaced_once(text, "228", name))[0]; };
  EXPECT_EQ(with("228").name, "228");
  EXPECT_DOUBLE_EQ(*with("228").azimuth, 228 * kRadiansPerDegree);
  EXPECT_DOUBLE_EQ(*with("360 (CDMG STATION 24461)").azimuth, 360 * kRadiansPerDegree);
  EXPECT_DOUBLE_EQ(*with("E").azimuth, 90 * kRadiansPerDegree);
  EXPECT_EQ(with("UP").name, "UP");
  EXPECT_FALSE(with("UP").azimuth);
  EXPECT_EQ(with("UP").direction, Direction::kVertical);
  EXPECT_EQ(with("BHZ00").direction, Direction::kVertical);
  EXPECT_FALSE(with("BH100").azimuth || with("BH100").direction);
  EXPECT_FALSE(with("8 points across").azimuth);
  EXPECT_EQ(with("228").sha256, SourceFile("f", text).sha256());
}

TEST(PeerAt2, KnowsBearingsAndNoChannelNumbers) {
  const std::string text = file_with("NPTS= 5, DT= .02 SEC");
  for (const auto& [name, degrees] :
       {std::pair{"N38E", 38}, {"S38W", 218}, {"45 DEG", 45}, {"W", 270}, {"S", 180}})
    EXPECT_NEAR(read(replaced_once(text, "228", name))[0].azimuth.value_or(-1),
                degrees * kRadiansPerDegree, 1e-12)
        << name;
  for (const char* name : {"1", "2", "3", "ENE"})
    EXPECT_FALSE(read(replaced_once(text, "228", name))[0].azimuth) << name;
}

TEST(PeerAt2, ReadsOtherWaysToStateQuantityAndUnit) {
  const std::string text = file_with("NPTS= 5, DT= .02 SEC");
  const auto with = [&](const char* line) {
    return replaced_once(text, "ACCELERATION TIME SERIES IN UNITS OF G", line);
  };
  for (const char* line : {"ACCELERATION (G)", "ACCELERATION IN G", "ACCELERATION HISTORY [g]"})
    expect_the_motion(read(with(line)));
  for (const char* line : {"ACCELERATION (CM/SEC**2)", "ACCELERATION IN GALS",
                           "ACCELERATION TIME SERIES IN UNITS OF CM / SEC^2, PEAK= 0.4"})
    EXPECT_DOUBLE_EQ(read(with(line))[0].acceleration[0], 0.1 * 0.01) << line;
  for (const char* line : {"VELOCITY (CM/S)", "VELOCITY HISTORY", "Velocity in cm/s",
                           "VELOCITY TIME SERIES (FROM ACCELERATION)"})
    EXPECT_THAT(error_text([&] { read(with(line), {.unit = "g"}); }),
                HasSubstr("f.AT2:3:1: a record must be acceleration, but this is a velocity file "
                          "('" +
                          std::string(line) + "'); take the .AT2"));
}

TEST(PeerAt2, LeavesTablesWithTimesToPlainText) {
  const std::string title = "ACCELERATION TIME SERIES IN UNITS OF G\n";
  const Component table = read(title + "0 .1\n.02 .2\n.04 .3\n")[0];
  EXPECT_EQ(table.format, "plain text");
  EXPECT_EQ(table.time_step, 0.02);
  EXPECT_EQ(read(title + ".1 .2\n.3 .1\n", {.time_step = 0.02})[0].format, "PEER AT2");
  const std::string two = title + "0 .1 .2\n.02 .2 .1\n.04 .3 .2\n";
  EXPECT_EQ(read(two, {.columns = "time,h1,h2"})[1].format, "plain text");
}

TEST(PeerAt2, LeavesTablesBelowCountAndStepToPlainText) {
  const std::string title = "ACCELERATION TIME SERIES IN UNITS OF G\nNPTS= 4, DT= .02 SEC\n";
  const Component table = read(title + "0 .1\n.02 .2\n.04 .3\n.06 -.1\n")[0];
  EXPECT_EQ(table.format, "plain text");
  EXPECT_EQ(table.unit, "g");
  EXPECT_EQ(table.acceleration.size(), 4);
  EXPECT_EQ(read(title + ".1 .2\n.3 .1\n")[0].format, "PEER AT2");
}

// FN and FP of one motion name the components before the rotation above their own azimuth.
TEST(PeerAt2, TakesTheAzimuthAfterARotation) {
  const std::string file =
      "PEER NGA Rotated Accelerogram (v1.1)\n"
      "H1 for rotation: NOWHERE 11/24/87 1316, SOMEWHERE, 090 (STATION 5)\n"
      "H2 for rotation: NOWHERE 11/24/87 1316, SOMEWHERE, 000 (STATION 5)\n"
      "rotation angle - clockwise  40.0\nFN component, azimuth =   310.0\nAccelerations in g\n"
      "5 0.005000 NPTS, DT\n.1 .2 -.1\n.3 .1\n";
  const Component normal = read(file)[0];
  EXPECT_EQ(normal.name, "FN");
  EXPECT_DOUBLE_EQ(*normal.azimuth, 310 * kRadiansPerDegree);
  const Component parallel = read(
      replaced_once(file, "FN component, azimuth =   310.0", "FP component, azimuth =   40.0"))[0];
  EXPECT_DOUBLE_EQ(*parallel.azimuth, 40 * kRadiansPerDegree);
}

TEST(PeerAt2, ReadsMillisecondsAndExponentsOfFortran) {
  expect_the_motion(read(file_with("NPTS=   5, DT=20 MSEC")));
  expect_the_motion(read(file_with("NPTS=   5, DT= 20.0 ms")));
  expect_the_motion(read(file_with("NPTS= 5, DT= .2D-01 SEC")));
  expect_the_motion(read(replaced_once(file_with("NPTS= 5, DT= .02 SEC"), "E+00", "D+00")));
}

TEST(PeerAt2, FindsTheComponentBelowBlankLines) {
  const std::string text = file_with("NPTS= 5, DT= .02 SEC");
  for (const std::string& other :
       {"\n\n" + text, replaced_once(text, "PEER NGA STRONG MOTION DATABASE RECORD", ""),
        replaced_once(text, "RECORD\n", "RECORD\n\n")}) {
    expect_the_motion(read(other));
    EXPECT_EQ(read(other)[0].name, "228") << other;
  }
  EXPECT_THAT(error_text([&] { read("\n" + replaced_once(text, ".1000000E+00", ".1x00000E+00")); }),
              HasSubstr("f.AT2:6:4: '.1x00000E+00' is not a finite number"));
}

TEST(PeerAt2, RefusesVelocityAndDisplacement) {
  const std::string text = file_with("NPTS= 5, DT= .02 SEC");
  EXPECT_EQ(error_text([&] {
              read(replaced_once(text, "ACCELERATION TIME SERIES IN UNITS OF G",
                                 "VELOCITY TIME SERIES IN UNITS OF CM/S"));
            }),
            "f.AT2:3:1: a record must be acceleration, but this is a velocity file ('VELOCITY TIME "
            "SERIES IN UNITS OF CM/S'); take the .AT2 file of this component");
  EXPECT_THAT(
      error_text([&] {
        read(replaced_once(text, "ACCELERATION TIME SERIES IN UNITS OF G",
                           "DISPLACEMENT TIME HISTORY IN UNITS OF CM. FILTER POINTS"));
      }),
      HasSubstr("f.AT2:3:1: a record must be acceleration, but this is a displacement file"));
  EXPECT_THAT(error_text([&] { read(replaced_once(text, "UNITS OF G", "UNITS OF CM/S")); }),
              HasSubstr("f.AT2:3:1: 'CM/S' is not a unit of acceleration: g, m/s2"));
}

TEST(PeerAt2, RefusesACountThatDoesNotMatch) {
  EXPECT_EQ(error_text([] { read(file_with("NPTS= 6, DT= .02 SEC")); }),
            "f.AT2:4:1: NPTS states 6 samples, but the file holds 5");
  EXPECT_EQ(error_text([] { read(file_with("NPTS= 4, DT= .02 SEC")); }),
            "f.AT2:4:1: NPTS states 4 samples, but the file holds 5");
  EXPECT_EQ(error_text([] { read(file_with("NPTS= -5, DT= .02 SEC")); }),
            "f.AT2:4:1: NPTS must be a whole number above 1, got -5");
}

TEST(PeerAt2, ReportsAllBadNumbersAtOnce) {
  const std::string text = file_with("NPTS= 5, DT= .02 SEC");
  EXPECT_EQ(
      error_text([&] {
        read(replaced_once(replaced_once(text, "-.2000000E+00", "NaN"), "-.4000000E+00", "******"));
      }),
      "f.AT2:5:18: 'NaN' is not a finite number\nf.AT2:6:3: '******' is not a finite number");
}

TEST(PeerAt2, ChecksTheStepAndTheUnitAgainstTheUser) {
  const std::string text = file_with("NPTS= 5, DT= .02 SEC");
  expect_the_motion(read(text, {.unit = "g", .time_step = 0.02}));
  EXPECT_EQ(error_text([&] { read(text, {.unit = "cm/s2", .time_step = 0.01}); }),
            "f.AT2:4:1: the file states a time step of 0.02 s, but time_step_s = 0.01 was given\n"
            "f.AT2:3:1: the file states the unit g, but unit = \"cm/s2\" was given");
  EXPECT_EQ(error_text([&] { read(replaced_once(text, "DT= .02", "DT= 0.0")); }),
            "f.AT2:4:1: DT must be in [1e-05, 1] s, got 0");
  EXPECT_EQ(error_text([&] { read(replaced_once(text, ", DT= .02 SEC", "")); }),
            "f.AT2: the file does not state its time step; state it as time_step_s or gurney "
            "records --time-step");
  expect_the_motion(
      read(replaced_once(text, ", DT= .02 SEC", ""), {.unit = "", .time_step = 0.02}));
}

// Whatever is cut off or changed must be reported; only the last line end may go.
TEST(PeerAt2, RefusesEveryTruncation) {
  const std::string text = file_with("NPTS=   5, DT=   .0200 SEC");
  for (std::size_t length = 0; length + 1 < text.size(); ++length)
    EXPECT_NE(error_text([&] { read(text.substr(0, length)); }), "") << length;
}

}  // namespace
}  // namespace gurney::groundmotions
