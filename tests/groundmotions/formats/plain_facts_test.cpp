#include "groundmotions/formats/plain_facts.h"

#include <gmock/gmock.h>

#include "engine/base/units.h"
#include "tests/groundmotions/formats/text_file.h"
#include "tests/support/error_text.h"

namespace gurney::groundmotions {
namespace {

using testing::HasSubstr;

std::string error(const std::string& header, const ReadOptions& options = {},
                  const std::string& rows = "1\n2\n3\n") {
  return error_text([&] { read_text(header + rows, options); });
}

TEST(PlainFacts, TextStatesUnitAndStep) {
  const Component component =
      read_one("# Units: cm/s2\nSampling rate 50 Hz\nXYZ, 3 May\n1\n2\n3\n");
  EXPECT_EQ(component.unit, "cm/s2");
  EXPECT_DOUBLE_EQ(component.time_step, 0.02);
  EXPECT_EQ(component.acceleration[2], 0.03);
  EXPECT_EQ(read_one("acceleration in g\n1\n2\n", {.time_step = 0.01}).unit, "g");
}

TEST(PlainFacts, TextIsCheckedAgainstTheUser) {
  EXPECT_EQ(error("XYZ\nUnits: cm/s2\n", {.unit = "g", .time_step = 0.02}),
            "f:2:1: the file states the unit cm/s2, but unit = \"g\" was given");
  EXPECT_EQ(error("dt = 0.02\n", {.unit = "g", .time_step = 0.01}),
            "f:1:1: the text states a time step of 0.02 s, but time_step_s was given as 0.01 s");
  EXPECT_EQ(error("sampling rate: 200 Hz\n", {.unit = "g"}, "0 1\n0.01 2\n0.02 3\n"),
            "f:1:1: the text states a time step of 0.005 s, but the times have 0.01 s");
  EXPECT_EQ(error("dt = 0.02\n", {.unit = "g"}, "3 0.01\n1\n2\n3\n"),
            "f:1:1: the text states a time step of 0.02 s, but the first row 0.01 s");
  EXPECT_EQ(error("Units: cm/s2\nt(s) a(g)\n", {}, "0 1\n0.01 2\n0.02 3\n"),
            "f:2:1: the column 'a(g)' states the unit g, but line 1 states cm/s2");
  EXPECT_EQ(error("Units: g\n", {.time_step = 0.01, .si_per_count = 2}),
            "f:1:1: count_m_per_s2 is for raw counts, but the file states the unit g");
}

TEST(PlainFacts, ABareUnitIsRead) {
  const std::pair<const char*, const char*> lines[] = {
      {"cm/s2; dt=0.005", "cm/s2"},
      {"Acc m/s2", "m/s2"},
      {"Acceleration in g", "g"},
      {"Acceleration, m/s\xc2\xb2", "m/s2"},
      {"Acceleration, g", "g"},
      {"Acc. g", "g"},
      {"g", "g"},
      {"Units g", "g"},
      {"UNITS - CM/S/S", "cm/s2"},
      {"acceleration in fractions of g", "g"},
      {"acc in % g", "%g"},
      {"acceleration in % of g", "%g"},
      {"values in m s-2", "m/s2"},
      {"data in cm / s^2", "cm/s2"},
      {"acceleration (metres per second squared)", "m/s2"},
      {"acceleration in centimeters per second per second", "cm/s2"},
      {"Acceleration (g) NPTS= 3", "g"},
      {"ACC(GAL) of NS", "cm/s2"},
      {"acc_g", "g"},
      {"x_m_per_s2", "m/s2"},
      {"accel[%g]", "%g"}};
  for (const auto& [line, unit] : lines) {
    const ReadOptions options{.time_step = std::string(line).find("dt") == std::string::npos
                                               ? std::optional<double>(0.01)
                                               : std::nullopt};
    EXPECT_EQ(read_one(std::string(line) + "\n1\n-2\n3\n", options).unit, unit) << line;
    EXPECT_THAT(error(std::string(line) + "\n", {.unit = "mg", .time_step = options.time_step}),
                HasSubstr("f:1:1: the file states the unit"))
        << line;
  }
}

TEST(PlainFacts, AValueIsNoUnitOfTheSamples) {
  for (const char* line : {"PGA 0.3 g", "Vs30 (m/s): 379", "PGA (g): 0.3", "scale 2 g",
                           "g = 9.81 m/s2", "Station G", "Peak acceleration, g", "component g"})
    EXPECT_EQ(read_one(std::string(line) + "\n1\n-2\n3\n", {.unit = "gal", .time_step = 0.01}).unit,
              "cm/s2")
        << line;
}

TEST(PlainFacts, ACountThatDiffersIsAWarning) {
  const ReadOptions options{.unit = "g", .time_step = 0.01};
  EXPECT_THAT(read_one("npts: 4\n1\n-2\n3\n", options).warnings,
              testing::Contains("line 1 states 4 samples, but the file holds 3"));
  EXPECT_THAT(read_one("No. of points = 3\n1\n-2\n3\n", options).warnings,
              testing::Not(testing::Contains(HasSubstr("states"))));
  EXPECT_EQ(error("npts: 4\nUnits: g\ndt = 0.01\n"),
            "f:1:1: NPTS states 4 samples, but the file holds 3");
}

TEST(PlainFacts, LinesMustAgree) {
  EXPECT_EQ(error("Units: g\nUnits: gal\ndt = 0.01\nsampling rate 50 Hz\n"),
            "f:2:1: this line states the unit cm/s2, but line 1 states g\n"
            "f:3:1: the text states a time step of 0.01 s, but line 4 0.02 s");
  EXPECT_THAT(error("Units: furlongs\n", {.unit = "g", .time_step = 0.01}),
              HasSubstr("f:1:1: 'furlongs' is not a unit of acceleration: g, m/s2"));
}

// 0.00488281 s printed as 0.0049 s.
TEST(PlainFacts, AStepOfTheTextMayBeRounded) {
  const ReadOptions options{.unit = "g", .time_step = 0.00488281};
  EXPECT_EQ(read_one("dt = 0.0049\n1\n2\n", options).time_step, 0.00488281);
}

TEST(PlainFacts, VelocitiesInWordsAreRefused) {
  const ReadOptions options{.unit = "g", .time_step = 0.01};
  EXPECT_EQ(error("XYZ\nvelocity time history in cm/s\n", options),
            "f:2:1: a record must be acceleration, but the text speaks of velocity ('velocity time "
            "history in cm/s')\n"
            "f:2:1: a record must be acceleration, but the unit 'cm/s' is that of a velocity");
  EXPECT_THAT(error("Displacement trace\n", options), HasSubstr("the text speaks of displacement"));
  EXPECT_THAT(error("Units: cm/s\n", options),
              HasSubstr("f:1:1: a record must be acceleration, but the unit 'cm/s' is that of a "
                        "velocity"));
  EXPECT_EQ(error("Time (s) NS velocity\n", {.unit = "g"}, "0 1\n0.01 2\n0.02 3\n"),
            "f:1:1: a record must be acceleration, but the text speaks of velocity ('Time (s) NS "
            "velocity')");
  for (const char* header : {"shear wave velocity 300 m/s\n", "Vs30 (m/s): 379\n", "PGV 3 cm/s\n",
                             "acceleration from velocity\n"})
    EXPECT_EQ(error(header, options), "(no error)") << header;
}

}  // namespace
}  // namespace gurney::groundmotions
