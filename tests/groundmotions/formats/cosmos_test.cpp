#include <gmock/gmock.h>

#include "engine/base/units.h"
#include "groundmotions/formats/readers.h"
#include "tests/groundmotions/formats/network_samples.h"
#include "tests/support/error_text.h"

namespace gurney::groundmotions {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

std::vector<Component> read(const std::string& text, const ReadOptions& options = {}) {
  return read_components(SourceFile("f.V1c", text), options);
}

/// @param tolerance  half of the last printed digit [m/s2]
void expect_the_motion(const Component& component, double scale, double tolerance) {
  ASSERT_EQ(component.acceleration.size(), 10);
  for (int i = 0; i < 10; ++i)
    EXPECT_NEAR(component.acceleration[i], scale * kVolumeSamples[static_cast<std::size_t>(i)],
                tolerance);
}

TEST(Cosmos, ReadsChannels) {
  const auto components =
      read(cosmos_file() +
           cosmos_file({.label = "Sta Chan  2:  Up  (Rcrdr Chan  2)", .integers = {{54, 400}}}));
  ASSERT_EQ(components.size(), 2u);
  for (const Component& component : components) {
    EXPECT_EQ(component.format, "COSMOS");
    EXPECT_EQ(component.unit, "cm/s2");
    EXPECT_DOUBLE_EQ(component.time_step, 0.01);
    EXPECT_EQ(component.start_time, 991407937.5);  // date -u -d '2001-06-01 15:05:37.5' +%s.%N
    EXPECT_TRUE(component.warnings.empty());
    expect_the_motion(component, kStandardGravity, 0.5e-7);
  }
  EXPECT_EQ(components[0].name, "340 deg");
  EXPECT_NEAR(components[0].azimuth.value(), 340 * kRadiansPerDegree, 1e-12);
  EXPECT_FALSE(components[0].direction);
  EXPECT_EQ(components[1].name, "Up");
  EXPECT_EQ(components[1].direction, Direction::kVertical);
  EXPECT_FALSE(components[1].azimuth);
}

TEST(Cosmos, ReadsEverySpellingOfTheLineAboveTheSamples) {
  struct Spelling {
    const char* line;
    int code;
    double to_si;
  };
  for (const Spelling& s :
       {Spelling{"   10 raw acceleration pts, approx 70 secs, units=g.     (02)Format=(8f10.5)", 2,
                 kStandardGravity},
        Spelling{"   10  acceleration pts, approx   70 secs, units=in/sec2(07),Format=(8F10.5)", 7,
                 0.0254},
        Spelling{"   10 accel. pts, unit=mg (11), Format = (8F10.5)", 11, 1e-3 * kStandardGravity},
        Spelling{"   10 accel. pts, units=micro g (12), Format= (8F10.5)", 12,
                 1e-6 * kStandardGravity}}) {
    SCOPED_TRACE(s.line);
    const auto components =
        read(cosmos_file({.announcement = s.line, .integers = {{3, s.code}}, .scale = 1}));
    expect_the_motion(components[0], s.to_si, 0.5e-5 * s.to_si);
  }
}

TEST(Cosmos, TakesTheTimeStepOfTheseSamplesNotOfTheRawOnes) {
  const auto component = read(cosmos_file({.integers = {}, .reals = {{34, 0.005}}}))[0];
  EXPECT_DOUBLE_EQ(component.time_step, 0.01);
  EXPECT_THAT(component.warnings,
              ElementsAre("the header states two time steps: 0.01 s (real number 62, of these "
                          "samples; taken) and 0.005 s (34, of the raw samples)"));
  const auto only_raw = read(cosmos_file({.integers = {}, .reals = {{62, -999}}}))[0];
  EXPECT_DOUBLE_EQ(only_raw.time_step, 0.01);
  EXPECT_THAT(only_raw.warnings,
              ElementsAre(HasSubstr("real number 62 of the header states no time "
                                    "step")));
  const std::string none = cosmos_file({.integers = {}, .reals = {{62, -999}, {34, -999}}});
  EXPECT_THAT(error_text([&] { read(none); }),
              HasSubstr("the file does not state its time step; state it as time_step_s or gurney "
                        "records --time-step"));
  EXPECT_EQ(read(none, {.time_step = 0.01})[0].time_step, 0.01);
  // Seconds where milliseconds must be: the length shows it.
  EXPECT_THAT(error_text([] {
                read(cosmos_file({.integers = {}, .reals = {{62, 0.01}}}));
              }),
              HasSubstr("the file states a length of 0.1 s, but its 10 samples at 1e-05 s have"));
}

TEST(Cosmos, ReadsOrientations) {
  const auto with = [](int code54, int code55, const std::string& label) {
    return read(cosmos_file({.label = "Sta Chan  1: " + label + " (Rcrdr Chan 1)",
                             .integers = {{54, code54}, {55, code55}}}))[0];
  };
  EXPECT_NEAR(with(360, -999, "360 deg").azimuth.value(), 0, 1e-12);
  const auto down = with(401, -999, "Down");
  EXPECT_EQ(down.direction, Direction::kVertical);
  EXPECT_NEAR(down.acceleration[3], 0.1 * kStandardGravity, 1e-6);
  EXPECT_THAT(down.warnings, ElementsAre(HasSubstr("the component points down (code 401)")));
  const auto radial = with(500, -999, "Radl");
  EXPECT_FALSE(radial.azimuth || radial.direction);
  EXPECT_THAT(radial.header,
              Contains(std::pair<std::string, std::string>("orientation", "radial, inward")));
  const auto relative = with(-999, 90, "90 Deg");
  EXPECT_FALSE(relative.azimuth);
  EXPECT_THAT(
      relative.warnings,
      ElementsAre("the sensor lies 90 degrees from a reference direction (integer 55 of the "
                  "header), not from north: its azimuth is not known"));
  EXPECT_NEAR(with(-999, -999, "90 Deg").azimuth.value(), 90 * kRadiansPerDegree, 1e-12);
  EXPECT_THAT(
      with(340, -999, "90 Deg").warnings,
      ElementsAre("integer 54 of the header states orientation 340, which was taken, but the "
                  "text '90 Deg'"));
}

CosmosSample counts() {
  return {
      .announcement = "   10 raw accel.   pts, approx  0 secs, units= counts(50),Format=(8F10.5)",
      .integers = {{1, 0}, {3, 50}},
      .reals = {{22, 0.5}, {42, 1.25}, {47, 2}},
      .scale = 5000};
}

TEST(Cosmos, ConvertsCountsByTheHeader) {
  CosmosSample sample = counts();
  const auto component = read(cosmos_file(sample))[0];
  // 0.5 microvolts / 1.25 V/g / 2 for each count
  expect_the_motion(component, 5000 * 0.5e-6 / 1.25 / 2 * kStandardGravity, 1e-12);
  EXPECT_EQ(component.unit, "counts");
  EXPECT_THAT(component.warnings,
              ElementsAre(HasSubstr("raw counts (V0) were taken as 1.96133e-06 m/s2 each, from the "
                                    "header: 0.5 microvolts, 1.25 V/g, gain 2")));
  expect_the_motion(read(cosmos_file(sample), {.si_per_count = 2e-6})[0], 0.01, 1e-12);
  EXPECT_THAT(read(cosmos_file(sample), {.si_per_count = 2e-6})[0].warnings,
              ElementsAre(HasSubstr("count_m_per_s2 = 2e-06 was taken, but the header states")));
  EXPECT_THAT(error_text([&] { read(cosmos_file(sample), {.unit = "g"}); }),
              HasSubstr("unit = \"g\" was given, but the samples are raw counts (unit code 50)"));
  sample.reals[1].second = -999;
  EXPECT_THAT(
      error_text([&] { read(cosmos_file(sample)); }),
      HasSubstr("f.V1c:45:1: the samples are raw counts, and the header states no sensitivity "
                "(real numbers 22, 42 and 47); state count_m_per_s2"));
  EXPECT_THAT(error_text([] { read(cosmos_file(), {.si_per_count = 1e-6}); }),
              HasSubstr("count_m_per_s2 was given, but the samples are not counts (unit code 4)"));
}

TEST(Cosmos, RefusesUnitsThatContradict) {
  EXPECT_EQ(
      error_text([] {
        read(cosmos_file({.integers = {{3, 2}}}));
      }),
      "f.V1c:45:1: the line of the samples states the unit code 4, but integer 3 of the header "
      "2");
  EXPECT_THAT(
      error_text([] {
        read(cosmos_file({.announcement = "  10 accel pts, units=none(00),Format=(8f10.5)"}));
      }),
      HasSubstr("f.V1c:45:1: the line of the samples states the unit code 0"));
  EXPECT_THAT(
      read(cosmos_file({.integers = {{3, 25}}}))[0].warnings,
      ElementsAre(HasSubstr("integer 3 of the header 25, which is no unit of acceleration")));
  EXPECT_THAT(error_text([] {
                read(cosmos_file({.announcement = "  10 accel pts, units=volts(51),Format=(8f10.5)",
                                  .integers = {{3, 51}}}));
              }),
              HasSubstr("f.V1c:45:1: unit code 51 is no unit of acceleration"));
  EXPECT_THAT(error_text([] { read(cosmos_file(), {.unit = "g"}); }),
              HasSubstr("the file states the unit cm/s2, but unit = \"g\" was given"));
}

TEST(Cosmos, TakesTheAccelerationAmongOthers) {
  const std::string velocity = cosmos_file(
      {.first = "Corrected velocity  (Format v01.20 with 13 text lines) Src: none",
       .announcement = "      10 velocity pts, approx 0 secs, units=cm/sec (05),Format=(8f10.5)",
       .integers = {{2, 2}, {3, 5}}});
  const auto components = read(cosmos_file() + velocity);
  ASSERT_EQ(components.size(), 1u);
  EXPECT_THAT(components[0].header,
              Contains(std::pair<std::string, std::string>("also in the file", "velocity")));
  EXPECT_EQ(error_text([&] { read(velocity); }),
            "f.V1c:1:1: a record must be acceleration, but this file holds velocity; take the "
            "acceleration file of this record (.V1c, .acc.V2c)");
  EXPECT_THAT(error_text([] {
                read(cosmos_file({.integers = {{2, 10}}}));
              }),
              HasSubstr("this file holds angular acceleration"));
  EXPECT_EQ(
      error_text([] {
        read(cosmos_file(
            {.first = "Response spectra   (Format v01.20 with 13 text lines) Src: none"}));
      }),
      "f.V1c:1:1: this file (V3) holds response spectra, not an acceleration history; take the "
      "V2 of this record");
}

TEST(Cosmos, ChecksCountsPeaksAndHoles) {
  EXPECT_THAT(error_text([] {
                read(cosmos_file({.announcement = "  20 acceleration pts, units=cm/sec2(04),"
                                                  "Format=(8f10.5)"}));
              }),
              HasSubstr("f.V1c:47:21: '' is not a number of the format 8F10.5"));
  EXPECT_EQ(error_text([] {
              read(cosmos_file({.integers = {}, .reals = {{64, 200}}}));
            }),
            "f.V1c:45:1: the file states a peak of 2 m/s2, but its samples have 0.98067 m/s2");
  EXPECT_EQ(read(cosmos_file({.integers = {}, .reals = {{64, 100}}}))[0].warnings.size(), 1u);
  std::string hole = cosmos_file();
  hole.replace(hole.find("  49.03325"), 10, "-999.00000");
  EXPECT_THAT(error_text([&] { read(hole); }),
              HasSubstr("f.V1c:45:1: sample 5 of 10 is -999, which stands for an unknown value"));
  EXPECT_THAT(
      error_text([] {
        const std::string text = cosmos_file();
        read(text.substr(0, text.find("   1 Comment")));
      }),
      HasSubstr("expected 'NNNN acceleration pts, approx NN secs, units=...(NN),Format=(...)', "
                "got the end of the file"));
}

}  // namespace
}  // namespace gurney::groundmotions
