#include <gmock/gmock.h>

#include <limits>

#include "engine/base/units.h"
#include "groundmotions/formats/readers.h"
#include "tests/groundmotions/formats/network_samples.h"
#include "tests/groundmotions/formats/text_file.h"
#include "tests/support/error_text.h"

namespace gurney::groundmotions {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::vector<Component> read(const std::string& text, const ReadOptions& options = {}) {
  return read_components(SourceFile("f.V1", text), options);
}

/// @param tolerance  half of the last printed digit [g]
void expect_the_motion(const Component& component, double tolerance, double sign = 1) {
  ASSERT_EQ(component.acceleration.size(), 10);
  for (int i = 0; i < 10; ++i)
    EXPECT_NEAR(component.acceleration[i],
                sign * kStandardGravity * kVolumeSamples[static_cast<std::size_t>(i)],
                kStandardGravity * tolerance);
}

TEST(CsmipVolume, ReadsVolume1) {
  const auto components =
      read(csmip_volume1() + csmip_volume1({.label = "CHAN  2: UP", .code = 500}));
  ASSERT_EQ(components.size(), 2u);
  for (const Component& component : components) {
    expect_the_motion(component, 1e-12);
    EXPECT_EQ(component.time_step, 0.005);
    EXPECT_EQ(component.unit, "g");
    EXPECT_EQ(component.format, "CSMIP volume");
    EXPECT_EQ(component.start_time, 991407937.5);  // date -u -d '2001-06-01 15:05:37.5' +%s.%N
    EXPECT_TRUE(component.warnings.empty());
  }
  EXPECT_EQ(components[0].name, "90 DEG");
  EXPECT_DOUBLE_EQ(components[0].azimuth.value(), 90 * kRadiansPerDegree);
  EXPECT_FALSE(components[0].direction);
  EXPECT_EQ(components[1].direction, Direction::kVertical);
  EXPECT_FALSE(components[1].azimuth);
}

TEST(CsmipVolume, ReadsEverySpellingOfTheLineAboveTheSamples) {
  for (const char* line :
       {" 10 Accelerogram points at 200 pts/sec in units of g.       Format: (8f9.6)  ",
        "   10 points of accel data equally spaced at  .005 sec, in g. (8f9.6)"}) {
    const auto components = read(csmip_volume1({}, line));
    expect_the_motion(components[0], 1e-12);
    EXPECT_EQ(components[0].time_step, 0.005) << line;
    EXPECT_EQ(components[0].unit, "g");
  }
}

TEST(CsmipVolume, TakesTheStepAboveTheSamplesAndSaysWhereTheHeaderHasAnother) {
  EXPECT_TRUE(read(csmip_volume2())[0].warnings.empty());
  const Component other = read(csmip_volume2("CHAN  1:  90 DEG", 90, 0.01))[0];
  EXPECT_EQ(other.time_step, 0.02);
  EXPECT_THAT(other.warnings,
              ElementsAre(HasSubstr("states a time step of 0.01 s, but the line above the samples "
                                    "0.02 s, which was taken")));
}

TEST(CsmipVolume, ReadsEvenPairs) {
  std::vector<double> times;
  for (int i = 0; i < 10; ++i) times.push_back(0.02 * i);
  const auto component = read(pairs_volume1(times))[0];
  expect_the_motion(component, 1e-12);
  EXPECT_DOUBLE_EQ(component.time_step, 0.02);
  EXPECT_EQ(component.unit, "g/10");
  EXPECT_TRUE(component.warnings.empty());
}

TEST(CsmipVolume, BringsUnevenPairsToEvenSteps) {
  const std::vector<double> times = {0, 0.005, 0.01, 0.015, 0.02, 0.025, 0.035, 0.04, 0.045, 0.05};
  const auto component = read(pairs_volume1(times))[0];
  ASSERT_EQ(component.acceleration.size(), 11);
  EXPECT_EQ(component.time_step, 0.005);
  // Between -0.03 g at 0.035 s and 0.02 g at 0.025 s.
  EXPECT_NEAR(component.acceleration[6], -0.005 * kStandardGravity, 1e-12);
  EXPECT_THAT(
      component.warnings,
      ElementsAre("the samples are 0.005 to 0.01 s apart; they were brought to even steps of "
                  "0.005 s by straight lines between them (10 samples before)"));
  EXPECT_EQ(read(pairs_volume1(times), {.time_step = 0.01})[0].acceleration.size(), 6);
}

TEST(CsmipVolume, ReadsTimesAbove100SecondsThatStickToTheValues) {
  std::vector<double> times;
  for (int i = 0; i < 10; ++i) times.push_back(100 + 0.1 * i);
  const auto component = read(pairs_volume1(times))[0];
  expect_the_motion(component, 1e-12);
  EXPECT_NEAR(component.time_step, 0.1, 1e-12);
}

TEST(CsmipVolume, TakesTheUnitOfTheTextAndChecksItByThePeak) {
  std::string text = pairs_volume1({0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9});
  const auto component = read(replaced_once(text, "     0.100", "     1.000"))[0];
  expect_the_motion(component, 1e-12);
  EXPECT_THAT(component.warnings, ElementsAre("the text states the unit g/10, which was taken, but "
                                              "real number 5 of the header 1 g"));
  EXPECT_THAT(error_text([&] { read(replaced_once(text, "G/10", "G   ")); }),
              HasSubstr("f.V1:12:1: the file states a peak of 0.98067 m/s2, but its samples have "
                        "9.3457 m/s2"));
}

TEST(CsmipVolume, RefusesVelocityAlone) {
  EXPECT_THAT(error_text([] {
                read(csmip_volume1({}, "   10 POINTS OF VELOC DATA EQUALLY SPACED AT .005 SEC."));
              }),
              HasSubstr("f.V1:1:1: this channel holds velocity or displacement only; a record must "
                        "be acceleration"));
}

TEST(CsmipVolume, RefusesTimesThatDecrease) {
  EXPECT_THAT(error_text([] {
                read(pairs_volume1({0, 0.005, 0.01, 0.009, 0.02, 0.025, 0.03, 0.035, 0.04, 0.05}));
              }),
              HasSubstr("f.V1:28:1: time 4 of 10 decreases: 0.009 s after 0.01 s"));
}

TEST(CsmipVolume, ReadsTheAccelerationOfVolume2) {
  const auto components = read(csmip_volume2() + csmip_volume2("CHAN  2: DOWN", 600));
  ASSERT_EQ(components.size(), 2u);
  expect_the_motion(components[0], 0.0005 / 980);
  EXPECT_EQ(components[0].time_step, 0.02);
  EXPECT_EQ(components[0].unit, "cm/s2");
  EXPECT_EQ(components[0].name, "90 DEG");
  EXPECT_TRUE(components[0].warnings.empty());
  EXPECT_THAT(components[0].header, testing::Contains(std::pair<std::string, std::string>(
                                        "also in the file", "velocity, displacement")));
  expect_the_motion(components[1], 0.0005 / 980, -1);
  EXPECT_EQ(components[1].direction, Direction::kVertical);
  EXPECT_THAT(components[1].warnings,
              ElementsAre("the component points down (DOWN): its sign was turned, up is positive"));
}

TEST(CsmipVolume, TakesTheAzimuthOfTheIntegerHeaderIfTheTextHasNone) {
  EXPECT_NEAR(read(csmip_volume1({.label = "CHAN  1: ROOF", .code = 45}))[0].azimuth.value(),
              45 * kRadiansPerDegree, 1e-12);
  EXPECT_FALSE(read(csmip_volume1({.label = "CHAN  1: L", .code = 0}))[0].azimuth);
  EXPECT_EQ(read(csmip_volume1({.label = "Chan  1: 90 Deg   Location: Roof"}))[0].name, "90 Deg");
  const auto both = read(csmip_volume1({.code = 45}))[0];
  EXPECT_NEAR(both.azimuth.value(), 90 * kRadiansPerDegree, 1e-12);
  EXPECT_THAT(both.warnings,
              ElementsAre("integer 27 of the header states an azimuth of 45 degrees, "
                          "but the text '90 DEG', which was taken"));
}

TEST(CsmipVolume, ChecksThePeak) {
  const std::string units = "UNITS OF UNCOR ACCEL IS G.                 MAX  =  ";
  EXPECT_THAT(read(csmip_volume1({.units = units + "-.110 G"}))[0].warnings,
              ElementsAre("the file states a peak of 1.0787 m/s2, but its samples have 0.98067 "
                          "m/s2"));
  EXPECT_EQ(error_text([&] { read(csmip_volume1({.units = units + ".200 G"})); }),
            "f.V1:12:1: the file states a peak of 1.9613 m/s2, but its samples have 0.98067 m/s2");
}

TEST(CsmipVolume, ChecksTheLength) {
  EXPECT_EQ(read(csmip_volume1({.length = 0.075}))[0].warnings.size(), 1u);
  EXPECT_EQ(
      error_text([] { read(csmip_volume1({.length = 0.5})); }),
      "f.V1:1:1: the file states a length of 0.5 s, but its 10 samples at 0.005 s have 0.05 s");
}

TEST(CsmipVolume, ChecksCountsUnitsAndSteps) {
  EXPECT_THAT(
      error_text([] { read(replaced_once(csmip_volume1(), "   10 POINTS", "   12 POINTS")); }),
      HasSubstr("f.V1:30:19: '' is not a number of the format 8F9.6"));
  EXPECT_THAT(
      error_text([] { read(replaced_once(csmip_volume1(), "   10 POINTS", "    8 POINTS")); }),
      HasSubstr("f.V1:30:1: the samples of this channel end here, but neither the next "
                "channel nor the end of the file follows: '0.002"));
  EXPECT_THAT(error_text([] { read(csmip_volume1(), {.unit = "cm/s2"}); }),
              HasSubstr("f.V1:28:1: the file states the unit g, but unit = \"cm/s2\" was given"));
  EXPECT_THAT(
      error_text([] { read(csmip_volume1(), {.time_step = 0.01}); }),
      HasSubstr("the file states a time step of 0.005 s, but time_step_s = 0.01 was given"));
  EXPECT_THAT(error_text([] { read(replaced_once(csmip_volume1(), " 0.003000", "****-****")); }),
              HasSubstr("f.V1:29:19: '****-****' is not a number of the format 8F9.6"));
}

TEST(CsmipVolume, RefusesSpectra) {
  EXPECT_EQ(
      error_text([] {
        read("RESPONSE AND FOURIER AMPLITUDE SPECTRA (65 PERIODS)   FOR\r\n" + csmip_volume2());
      }),
      "f.V1:1:1: this file (volume 3) holds response spectra, not an acceleration history; "
      "take the .V2 of this record");
}

// 12 % are more than rounding or the mean explain.
TEST(CsmipVolume, RefusesAPeakThatTheSamplesDoNotHave) {
  VolumeHeader header;
  header.units = "UNITS OF UNCOR ACCEL IS G.                 MAX  =  -.112 G, AT    .015 SEC.";
  EXPECT_THAT(
      error_text([&] { read(csmip_volume1(header)); }),
      testing::HasSubstr("f.V1:12:1: the header states a peak of 1.0983 m/s2, but the samples "
                         "have 0.98067 m/s2: one of them is damaged"));
}

}  // namespace
}  // namespace gurney::groundmotions
