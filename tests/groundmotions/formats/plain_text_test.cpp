#include <gmock/gmock.h>

#include "engine/base/units.h"
#include "groundmotions/formats/readers.h"
#include "tests/groundmotions/formats/text_file.h"
#include "tests/support/error_text.h"

namespace gurney::groundmotions {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const ReadOptions kGal = {.unit = "gal", .time_step = 0.01};

std::vector<double> gal(const Component& component) {
  std::vector<double> values;
  for (const double a : component.acceleration) values.push_back(a / 0.01);
  return values;
}

auto values_are(const std::vector<double>& expected) {
  return testing::Pointwise(testing::DoubleEq(), expected);
}

TEST(PlainText, ReadsOneColumn) {
  const auto components = read_text("# a comment\n 100\n-.5304E+02\r\n\n25.5\n", kGal);
  ASSERT_EQ(components.size(), 1u);
  EXPECT_THAT(gal(components[0]), values_are({100, -53.04, 25.5}));
  EXPECT_EQ(components[0].time_step, 0.01);
  EXPECT_EQ(components[0].unit, "cm/s2");
  EXPECT_EQ(components[0].format, "plain text");
  EXPECT_THAT(components[0].warnings, IsEmpty());
}

TEST(PlainText, AsksForUnitAndStep) {
  EXPECT_EQ(error_text([] { read_text("1\n2\n"); }),
            "f: the file does not state its unit; state it as unit = \"...\" or gurney records "
            "--unit (g, m/s2, "
            "cm/s2, gal, mm/s2, mg, %g, ft/s2 or in/s2)\n"
            "f: the file does not state its time step; state it as time_step_s or gurney records "
            "--time-step");
}

TEST(PlainText, ReadsRowsOfSamplesThatTheUserDeclares) {
  ReadOptions options = kGal;
  options.columns = "samples";
  for (const char* text : {"1 2 3\n4 5 6\n7 8\n", "1.,2.,3.,\n4.,5.,6.\n7.,8.\n",
                           "1.0\t2.0\t3.0\r\n4.0 5.0;6.0\r\n7.0 8.0"})
    EXPECT_THAT(gal(read_text(text, options)[0]), values_are({1, 2, 3, 4, 5, 6, 7, 8})) << text;
  EXPECT_EQ(error_text([&] { read_text("1 2 3\n4 5\n7 8 9\n", options); }),
            "f:2:1: 2 numbers in a row, the first row has 3");
  EXPECT_EQ(error_text([&] { read_text("1 2 3\n4 5 6 7\n", options); }),
            "f:2:1: 4 numbers in a row, the first row has 3");
  EXPECT_THAT(error_text([] { read_text("3 2 1\n4 5 6\n", kGal); }),
              HasSubstr("f:1:1: 3 numbers in a row, and the first is no time that grows from row "
                        "to row; state columns = \"samples\" if they are samples row by row"));
}

TEST(PlainText, ReadsTimesAndValues) {
  const auto components = read_text("0 1\n0.02 -2\n.04 3\n", {.unit = "gal"});
  ASSERT_EQ(components.size(), 1u);
  EXPECT_THAT(gal(components[0]), values_are({1, -2, 3}));
  EXPECT_DOUBLE_EQ(components[0].time_step, 0.02);
  EXPECT_THAT(components[0].warnings, IsEmpty());
  EXPECT_THAT(read_text("0.02\t1\n0.04\t2\n0.06\t3\n", {.unit = "gal"})[0].warnings,
              ElementsAre("the first time is 0.02 s; the motion starts there, at 0 s of the run"));
  EXPECT_THAT(
      error_text([] { read_text("0 1\n0.02 -2\n.04 3\n", {.unit = "gal", .time_step = 0.01}); }),
      HasSubstr("f:1:1: the file states a time step of 0.02 s, but time_step_s = 0.01"));
}

TEST(PlainText, RefusesUnevenTimesWithTheLargestDeviation) {
  EXPECT_EQ(error_text([] {
              read_text("0 1\n0.01 1\n0.021 1\n0.03 1\n0.0425 1\n0.05 1\n", {.unit = "g"});
            }),
            "f:5:1: time 0.0425 s is off the even grid (0.04 s, step 0.01 s) by 0.25 of the step, "
            "0.01 is allowed; no other time is farther off");
  EXPECT_THAT(error_text([] { read_text("0 1\n0.01 1\n0.02 1\n0.05 1\n", {.unit = "g"}); }),
              HasSubstr("f:4:1: the time goes from 0.02 to 0.05 s where the step is 0.01 s"));
}

TEST(PlainText, TakesColumnsByTheirNames) {
  const auto components =
      read_text("0 1 5 2\n0.1 3 5 4\n", {.unit = "gal", .columns = "time, vertical, skip, h1"});
  ASSERT_EQ(components.size(), 2u);
  EXPECT_EQ(components[0].direction, Direction::kVertical);
  EXPECT_THAT(gal(components[0]), values_are({1, 3}));
  EXPECT_EQ(components[1].direction, Direction::kH1);
  EXPECT_THAT(gal(components[1]), values_are({2, 4}));
  EXPECT_EQ(components[1].name, "column 4");
  EXPECT_THAT(components[0].warnings, IsEmpty());

  const auto without_time =
      read_text("1 2\n3 4\n", {.unit = "gal", .time_step = 0.5, .columns = "h2,h1"});
  EXPECT_THAT(gal(without_time[0]), values_are({1, 3}));
  EXPECT_EQ(without_time[0].direction, Direction::kH2);
  EXPECT_EQ(without_time[1].time_step, 0.5);
}

TEST(PlainText, RefusesWrongColumns) {
  const auto reported = [](const char* columns) {
    return error_text([&] { read_text("0 1\n0.1 3\n", {.unit = "g", .columns = columns}); });
  };
  EXPECT_THAT(reported("time,h3"),
              HasSubstr("f: columns = \"time,h3\": unknown name 'h3'; did you mean 'h1'?"));
  EXPECT_THAT(reported("h1,h1"), HasSubstr("f: columns = \"h1,h1\": 'h1' is named twice"));
  EXPECT_THAT(reported("time,skip"),
              HasSubstr("f: columns = \"time,skip\" names no component: h1, h2 or vertical"));
  EXPECT_THAT(reported("time,h1,h2"),
              HasSubstr("f:1:1: columns = \"time,h1,h2\" names 3 columns, but the rows have 2"));
}

TEST(PlainText, ReadsForeignTables) {
  const auto components =
      read_text("Station X\nTime [s];EW [cm/s2];UD [cm/s2]\n0;1;2\n0.5;3;4\n1;5;6\n");
  ASSERT_EQ(components.size(), 2u);
  EXPECT_EQ(components[0].azimuth, 90 * kRadiansPerDegree);
  EXPECT_EQ(components[1].direction, Direction::kVertical);
  EXPECT_EQ(components[0].name, "EW");
  EXPECT_THAT(gal(components[1]), values_are({2, 4, 6}));
  EXPECT_EQ(fact(components[1], "text 1"), "Station X");
  EXPECT_THAT(components[0].warnings,
              ElementsAre("2 lines of text before the numbers, skipped; the last is 'Time [s];EW "
                          "[cm/s2];UD [cm/s2]'"));
  EXPECT_THAT(error_text([] { read_text("Time (s) Acc (g)\n0 1\n1 2\n2 3\n", {.unit = "m/s2"}); }),
              HasSubstr("f:1:1: the file states the unit g, but unit = \"m/s2\" was given"));
}

TEST(PlainText, RefusesDecimalCommas) {
  ReadOptions options = kGal;
  options.columns = "samples";
  for (const char* text : {"0,5\n0,7\n0,6\n", "0,5, 1,5\n0,7, 1,3\n"})
    EXPECT_THAT(error_text([&] { read_text(text, options); }),
                HasSubstr("f:1:1: commas between whole numbers: decimal commas are read only"))
        << text;
}

TEST(PlainText, SaysHowMuchTextItSkips) {
  const auto component =
      read_text("The quake of 3 May\nat XYZ, 090\n1\n2\n3\n\n*** End Data ***\n\t\n", kGal)[0];
  EXPECT_THAT(gal(component), values_are({1, 2, 3}));
  EXPECT_THAT(component.warnings,
              ElementsAre("2 lines of text before the numbers, skipped; the last is 'at XYZ, 090'",
                          "1 line after the numbers, skipped: '*** End Data ***'"));
  EXPECT_EQ(fact(component, "text 1"), "The quake of 3 May");
}

TEST(PlainText, ReadsACountAndAStepBeforeTheNumbers) {
  for (const char* text :
       {"name\n4 0.05\n1\n2\n3\n4\n", "4 0.05\n1 2 3\n4\n", "name\n4 0.05\n1 2\n3 4\n"}) {
    const auto component = read_text(text, {.unit = "gal"})[0];
    EXPECT_EQ(component.time_step, 0.05) << text;
    EXPECT_THAT(gal(component), values_are({1, 2, 3, 4})) << text;
  }
  EXPECT_EQ(error_text([] { read_text("name\n5 0.05\n1\n2\n3\n4\n", {.unit = "g"}); }),
            "f:2:1: the first row states 5 samples, but the file holds 4");
}

TEST(PlainText, RefusesWhatSaysThatItIsNoAcceleration) {
  EXPECT_THAT(error_text([] { read_text("Time (s) Vel (cm/s)\n0 1\n1 2\n2 3\n", {.unit = "g"}); }),
              HasSubstr("a record must be acceleration, but the column 'Vel(cm/s)' is a velocity"));
  EXPECT_THAT(error_text([] { read_text("t (s) d (cm)\n0 1\n1 2\n2 3\n", {.unit = "g"}); }),
              HasSubstr("the column 'd(cm)' is a displacement"));
  EXPECT_THAT(error_text([] { read_text("Some text\nPeriod Sa\n1 1\n2 2\n3 3\n", {.unit = "g"}); }),
              HasSubstr("f:2:1: a record must be a history, but the first column is 'Period'"));
  EXPECT_EQ(error_text([] { read_text("Period PSA\n0.1 1\nx\n0.3 3\n", {.unit = "g"}); }),
            "f: a record must be an acceleration history, but the header speaks of 'psa' ('Period "
            "PSA')");
}

TEST(PlainText, ReadsCounts) {
  const auto component =
      read_text("1,-2\n3,4\n", {.time_step = 0.01, .si_per_count = 2, .columns = "samples"})[0];
  EXPECT_EQ(component.acceleration, Eigen::Vector4d(2, -4, 6, 8));
  EXPECT_EQ(component.unit, "counts");
  EXPECT_THAT(
      error_text([] { read_text("1\n2\n", {.unit = "g", .time_step = 0.01, .si_per_count = 2}); }),
      HasSubstr("f: unit and count_m_per_s2 were both given; one of them is allowed"));
  EXPECT_THAT(error_text([] { read_text("1\n2\n", {.time_step = 0.01, .si_per_count = -2}); }),
              HasSubstr("count_m_per_s2 must be positive and finite, got -2"));
}

// A number that went wrong must not pass as a line of text.
TEST(PlainText, RefusesWhatIsNoNumber) {
  EXPECT_THAT(error_text([] { read_text("1\nend\n3\n", kGal); }),
              HasSubstr("f:2:1: 'end' is not a finite number"));
  EXPECT_THAT(error_text([] { read_text("1\n2\nremark\n", kGal); }),
              HasSubstr("f:3:1: 'remark' is not a finite number"));
  for (const char* word : {"nan", "inf", "****", "1.5x", "E-03", "1e999", "NA"})
    EXPECT_NE(error_text([&] { read_text(std::string(word) + "\n1\n2\n", kGal); }), "(no error)")
        << word;
  EXPECT_THAT(error_text([] { read_text("0,1\n0.1,\n0.2,3\n", {.unit = "g"}); }),
              HasSubstr("f:2:1: 1 numbers in a row, the first row has 2"));
  EXPECT_THAT(error_text([] { read_text("0,1,2\n0.1,,3\n0.2,3,4\n", {.unit = "g"}); }),
              HasSubstr("f:2:5: an empty cell"));
  EXPECT_EQ(error_text([] { read_text("1\n", kGal); }),
            "f: a record needs at least 2 samples, got 1");
}

TEST(PlainText, RefusesOptionsOutsideTheirRanges) {
  EXPECT_EQ(error_text([] { read_text("1\n2\n", {.unit = "km/s2", .time_step = 0.01}); }),
            "'km/s2' is not a unit of acceleration: g, m/s2, cm/s2, gal, mm/s2, mg, %g, ft/s2 or "
            "in/s2 are allowed");
  EXPECT_EQ(error_text([] { read_text("1\n2\n", {.unit = "g", .time_step = -0.01}); }),
            "the time step of a record must be in [1e-05, 1] s, got -0.01");
}

}  // namespace
}  // namespace gurney::groundmotions
