#include <gmock/gmock.h>

#include "engine/base/units.h"
#include "tests/groundmotions/formats/text_file.h"
#include "tests/support/error_text.h"

/// Titles in one or two rows: which columns are accelerations, and in which unit.
namespace gurney::groundmotions {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

/// Four rows of times and `columns` that are 1, 2, 3... in every row, with alternating signs.
std::string rows(std::size_t columns, const std::string& mark) {
  std::string text;
  for (int i = 0; i < 4; ++i) {
    text += std::to_string(0.01 * i);
    for (std::size_t k = 1; k <= columns; ++k)
      text += mark + (i % 2 == 0 ? "" : "-") + std::to_string(k);
    text += "\n";
  }
  return text;
}

std::string error(const std::string& text, const ReadOptions& options = {}) {
  return error_text([&] { read_text(text, options); });
}

void expect_first_column(const Component& component, double unit) {
  EXPECT_DOUBLE_EQ(component.acceleration[0], unit);
  EXPECT_DOUBLE_EQ(component.acceleration[1], -unit);
  EXPECT_DOUBLE_EQ(component.time_step, 0.01);
}

TEST(TableTitles, AVelocityBelowARowOfUnitsIsNoHorizontal) {
  const std::pair<const char*, const char*> titles[] = {
      {"Time\tAcceleration\tVelocity\n[sec]\t[g]\t[m/sec]\n", "\t"},
      {"time,accel,disp\n(s),(g),(cm)\n", ","},
      {"Time;Acceleration;Velocity\ns;g;m/s\n", ";"},
      {"SeismoSignal\n  Time   Acceleration   Velocity\n  [sec]    [g]   [cm/sec]\n", "  "},
      {"\"Time\",\"Acc\",\"Force\"\n\"s\",\"g\",\"kN\"\n", ","},
      {"Time\tA1\tV1\n[s]\t[g]\t[m/s]\n----\t----\t----\n", "\t"},
      {"s,g,cm/s\nTime,A,B\n", ","},
      {"Time (s),Acc (g),Vel (cm/s)\n", ","},
      {"Time, s, Acc, g, Vel, cm/s\n", ","},
      {"Time (s),Acc (g),Voltage (V)\n", ","}};
  for (const auto& [title, mark] : titles) {
    SCOPED_TRACE(title);
    const auto components = read_text(title + rows(2, mark));
    ASSERT_EQ(components.size(), 1u);
    expect_first_column(components[0], kStandardGravity);
    EXPECT_EQ(components[0].unit, "g");
    EXPECT_THAT(components[0].warnings,
                Contains(HasSubstr("columns that are no accelerations, skipped: '")));
    EXPECT_THAT(error(title + rows(2, mark), {.unit = "m/s2"}),
                HasSubstr("the file states the unit g, but unit = \"m/s2\" was given"));
  }
}

TEST(TableTitles, AllFourColumnsOfSeismoSignalAreUnderstood) {
  const auto components = read_text(
      "Time\tAcceleration\tVelocity\tDisplacement\n[sec]\t[g]\t[cm/sec]\t[cm]\n" + rows(3, "\t"));
  ASSERT_EQ(components.size(), 1u);
  EXPECT_EQ(components[0].name, "Acceleration");
  EXPECT_THAT(components[0].warnings,
              Contains("columns that are no accelerations, skipped: 'Velocity [cm/sec]' "
                       "(velocity), 'Displacement [cm]' (displacement)"));
}

TEST(TableTitles, ChannelsKeepTheirNamesAboveUnits) {
  const auto components = read_text("Time,AC1,AC2,LVDT1\nsec,g,m/s2,in\n" + rows(3, ","));
  ASSERT_EQ(components.size(), 2u);
  EXPECT_EQ(components[0].name, "AC1");
  EXPECT_EQ(components[1].name, "AC2");
  EXPECT_EQ(components[1].unit, "m/s2");
  EXPECT_EQ(components[1].acceleration[0], 2);
}

TEST(TableTitles, ARowOfUnitsAloneIsEnough) {
  expect_first_column(read_one("s,g\n" + rows(1, ",")), kStandardGravity);
  expect_first_column(read_one("[sec] [cm/s2]\n" + rows(1, " ")), 0.01);
  EXPECT_THAT(error("s,g\n" + rows(1, ","), {.unit = "gal"}), HasSubstr("f:1:1: the file states"));
}

TEST(TableTitles, OtherQuantitiesAreErrorsWhereNoColumnIsSurelyAnAcceleration) {
  EXPECT_THAT(error("Time Vel Disp\n[s] [cm/s] [cm]\n" + rows(2, " "), {.unit = "g"}),
              HasSubstr("the column 'Vel [cm/s]' is a velocity; name the columns"));
  EXPECT_THAT(error("Time (s),CH1 (V)\n" + rows(1, ","), {.unit = "g"}),
              HasSubstr("the column 'CH1 (V)' is a voltage"));
  EXPECT_THAT(error("Time,Voltage (V),X\n" + rows(2, ","), {.unit = "g"}),
              HasSubstr("the column 'Voltage (V)' is a voltage"));
  EXPECT_THAT(error("Time (s),Acc (g),Probe\n" + rows(2, ","), {.unit = "g"}),
              HasSubstr("f:1:1: the column 'Probe' states no unit, but others do"));
  EXPECT_THAT(error("Time Ground Acceleration Ground Velocity\n" + rows(2, " "), {.unit = "g"}),
              HasSubstr("f:1:1: the text speaks of velocity"));
  EXPECT_EQ(read_text("Time Vel Acc\n" + rows(2, " "), {.unit = "g", .columns = "time,skip,h1"})[0]
                .acceleration[0],
            2 * kStandardGravity);
}

TEST(TableTitles, OneErrorOfTheUnitForAllColumns) {
  const std::string missing = error("Time,C1,C2,C3\n" + rows(3, ","));
  EXPECT_EQ(missing.find("does not state its unit"), missing.rfind("does not state its unit"));
  const std::string wrong = error("Time,C1,C2\ns,g,g\n" + rows(2, ","), {.unit = "gal"});
  EXPECT_EQ(wrong.find("but unit ="), wrong.rfind("but unit ="));
}

TEST(TableTitles, StatementsAreNoTitles) {
  const std::pair<const char*, double> lines[] = {{"Units: g", kStandardGravity},
                                                  {"cm/s2; dt=0.01", 0.01},
                                                  {"Acc m/s2", 1},
                                                  {"Acceleration g", kStandardGravity},
                                                  {"unit=cm/s/s sampling=uniform", 0.01}};
  for (const auto& [line, unit] : lines) {
    SCOPED_TRACE(line);
    const Component component = read_one(std::string(line) + "\n" + rows(1, " "));
    expect_first_column(component, unit);
    EXPECT_EQ(component.name, "column 2");
    EXPECT_THAT(error(std::string(line) + "\n" + rows(1, " "), {.unit = "mg"}),
                HasSubstr("f:1:1: the file states the unit"));
  }
  EXPECT_EQ(read_text("Acceleration in g\n" + rows(2, " "), {.columns = "time,h1,h2"})[0].unit,
            "g");
}

TEST(TableTitles, UnitsStandInWordsToo) {
  for (const char* title : {"Time,Acceleration in m/s2", "Time;Acceleration, m/s\xc2\xb2",
                            "Time s;Acc m/s2", "t [s], NS m/s^2", "Time Acc m/s2",
                            "time_s\tacc_m/s2", "Time,Acc [meters per second squared]"}) {
    SCOPED_TRACE(title);
    expect_first_column(read_one(std::string(title) + "\n" + rows(1, "\t")), 1);
  }
}

TEST(TableTitles, AFactorBehindAUnitIsNotIgnored) {
  for (const char* title : {"t (s),Acc (g) x 10", "t (s),Acc (g)*1000", "t (s),Acc [g] \xc3\x97 10",
                            "t (s),Acc (g) / 10"})
    EXPECT_THAT(error(std::string(title) + "\n" + rows(1, ",")),
                HasSubstr("has a factor behind its unit"))
        << title;
  EXPECT_THAT(error("Acceleration (g) x 10\n1\n2\n", {.time_step = 0.01}),
              HasSubstr("f:1:16: a factor behind the unit ('g x 10')"));
}

TEST(TableTitles, TheTitleOfATimeFindsIt) {
  const auto components =
      read_text("No,Time (s),NS (g),EW (g),UD (g)\n1,0,1,2,3\n2,0.01,1,2,3\n3,0.02,1,2,3\n");
  ASSERT_EQ(components.size(), 3u);
  EXPECT_DOUBLE_EQ(components[0].time_step, 0.01);
  EXPECT_THAT(components[0].warnings, Contains("the first column, 'No', counts the rows: skipped"));
  EXPECT_THAT(components[0].warnings, Not(Contains(HasSubstr("state which is which"))));
}

TEST(TableTitles, ComponentsWithoutTimesAreNamedByTitleOrText) {
  for (const char* header : {"NS (g),EW (g),UD (g)\ndt = 0.01\n",
                             "units: g\nsampling frequency: 100 Hz\nnpts: 3\n---***---\n"
                             "   components: N E Z\n---***---\n\n"}) {
    const auto components = read_text(std::string(header) + "1.,2.,3.\n-1.,2.,3.\n1.,2.,3.\n");
    ASSERT_EQ(components.size(), 3u) << header;
    EXPECT_EQ(components[0].azimuth, 0);
    EXPECT_EQ(components[2].direction, Direction::kVertical);
    EXPECT_DOUBLE_EQ(components[1].acceleration[0], 2 * kStandardGravity);
    EXPECT_DOUBLE_EQ(components[1].time_step, 0.01);
  }
}

}  // namespace
}  // namespace gurney::groundmotions
