#include <gmock/gmock.h>

#include "engine/base/units.h"
#include "groundmotions/formats/format.h"
#include "groundmotions/suites/suite.h"
#include "tests/groundmotions/formats/array_samples.h"
#include "tests/groundmotions/formats/network_samples.h"
#include "tests/groundmotions/formats/text_file.h"
#include "tests/support/error_text.h"

/// What files in use do beside their format, and what no record can be.
namespace gurney::groundmotions {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

std::vector<Component> read(const std::string& text, const ReadOptions& options = {}) {
  return read_components(SourceFile("f", text), options);
}

std::string refused(const std::string& text, const ReadOptions& options = {}) {
  return error_text([&] { read(text, options); });
}

const ReadOptions kGravity = {.unit = "g", .time_step = 0.01};

std::string at2(const std::string& step, const std::string& samples) {
  return "PEER\nX, 1/2/2003, Y, 090\nACCELERATION TIME SERIES IN UNITS OF G\nNPTS= 3, DT= " + step +
         " SEC\n" + samples;
}

TEST(DamagedInputs, EndMarksFollowTheSamples) {
  for (const char* end : {"*** End Data ***", "END", "*** End Data ***\n\n"}) {
    EXPECT_EQ(read(at2(".01", std::string(" .1 -.1 .2\n") + end))[0].acceleration.size(), 3) << end;
    EXPECT_EQ(read(std::string("0.1\n-0.1\n0.2\n") + end, kGravity)[0].acceleration.size(), 3);
    EXPECT_EQ(read(smc_file() + end)[0].acceleration.size(), 10) << end;
  }
  EXPECT_THAT(refused(at2(".01", " .1 -.1 .2\nthe end is near? no: 3\n .1\n")), HasSubstr("f:6:1"));
}

TEST(DamagedInputs, NulsPadTheEndOnly) {
  const Component component = read(smc_file() + std::string(300, '\0'))[0];
  EXPECT_EQ(component.format, "USGS SMC");
  EXPECT_EQ(component.acceleration, read(smc_file())[0].acceleration);
  std::string holed = smc_file();
  holed[holed.size() / 2] = '\0';
  EXPECT_THAT(refused(holed), HasSubstr("a binary file"));
  EXPECT_THAT(refused(std::string(100, '\0')), HasSubstr("a binary file of 100 bytes"));
}

TEST(DamagedInputs, PercentAndSlashesBeginComments) {
  const auto component =
      read("% MATLAB, unit: g\n// dt = 0.01 s\n0.1\n% middle\n-0.1\n0.2\n", kGravity)[0];
  EXPECT_EQ(component.acceleration.size(), 3);
  EXPECT_THAT(component.warnings, IsEmpty());
  EXPECT_EQ(read("% time (s), acc (m/s2)\n0.0, 0.1\n0.1, 0.2\n0.2, 0.1\n")[0].unit, "m/s2");
}

TEST(DamagedInputs, ARowThatWasCutIsAnErrorWithItsLine) {
  EXPECT_EQ(refused("time (s),acc (g)\n0.00,0.1\n0.01,0.2\n0.02,0.1\n0.03\n"),
            "f:5:1: 1 of 2 numbers in the last row: the file seems to be cut");
  EXPECT_THAT(refused("time_s,a_g\n0.00,0.1\n0.01,0.2\n0.02,\n"), HasSubstr("f:4"));
}

TEST(DamagedInputs, AmplitudesHaveALimit) {
  EXPECT_THAT(refused("0.1\n8.7e35\n0.2\n", {.unit = "m/s2", .time_step = 0.01}),
              HasSubstr("a peak of 8.7e+35 m/s2 (8.87e+34 g); at most 980.665 m/s2 (100 g) are "
                        "allowed: check the unit (m/s2)"));
  EXPECT_EQ(read("0.1\n99.9\n0.2\n", kGravity)[0].acceleration.size(), 3);
  EXPECT_THAT(refused("0.1\n100.1\n0.2\n", kGravity), HasSubstr("100 g"));
}

TEST(DamagedInputs, TimeStepsHaveLimits) {
  EXPECT_THAT(refused(at2("1e-38", " .1 -.1 .2\n")),
              HasSubstr("f:4:1: DT must be in [1e-05, 1] s, got 1e-38"));
  EXPECT_THAT(refused(at2("1.5", " .1 -.1 .2\n")), HasSubstr("got 1.5"));
  EXPECT_THAT(refused("0.1\n0.2\n", {.unit = "g", .time_step = 1e-38}),
              HasSubstr("must be in [1e-05, 1] s"));
  EXPECT_THAT(refused("0 0.1\n1e-9 0.2\n2e-9 0.1\n", {.unit = "g"}),
              HasSubstr("time steps must be in [1e-05, 1] s"));
}

// Counts and rates of a header that do not fit the file are errors with a line, whatever their
// size, and take no memory.
TEST(DamagedInputs, AbsurdNumbersOfHeadersAreErrorsOfTheFile) {
  const auto with = [](std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
  };
  for (const char* number : {"2147483647", "4294967295", "99999999999"}) {
    const std::string usc = usc_block("AC");
    EXPECT_THAT(refused(with(usc, "SAMPLES/SEC=200", std::string("SAMPLES/SEC=") + number)),
                HasSubstr("f:6:1: the time step must be in"));
    EXPECT_THAT(refused(with(usc, "NO OF POINTS=    10", std::string("NO OF POINTS=") + number)),
                HasSubstr("f:"));
  }
  EXPECT_THAT(refused(pairs_volume1({0, 0.01, 1e6, 1e6 + 0.01})), Not(HasSubstr("bad_alloc")));
}

TEST(DamagedInputs, WhatIsNoRecordIsNotQuoted) {
  const std::string secret = "root:x:0:0:secret\nuser:y\n";
  EXPECT_EQ(refused(secret),
            "f:1:1: not a record in a known format (see docs/records.md): 2 lines of text, 25 "
            "bytes");
  EXPECT_EQ(refused("one\n"),
            "f:1:1: not a record in a known format (see docs/records.md): 1 line of text, 4 bytes");
}

TEST(DamagedInputs, ThePeerComponentStandsWithEventAndDate) {
  const auto name = [](const std::string& head) {
    return read(head +
                "ACCELERATION TIME SERIES IN UNITS OF G\nNPTS= 3, DT= .01 SEC\n .1 -.1 .2\n")[0];
  };
  const Component first =
      name("Quake, 1/17/1994, Town Hall, 228\nPROCESSED BY X, BUTTERWORTH, 4\n");
  EXPECT_EQ(first.name, "228");
  EXPECT_NEAR(first.azimuth.value(), 228 * kRadiansPerDegree, 1e-12);
  EXPECT_EQ(name("PEER\nBORAH PEAK, 10/28/83, 14:06, ANL (BASEMENT), 196\n").name, "196");
  const Component turned =
      name("PEER\nRSN1044, Clockwise rot. 68.7962 deg. w.r.t. the input NWH090\n");
  EXPECT_EQ(turned.name, "");
  EXPECT_FALSE(turned.azimuth);
}

TEST(DamagedInputs, CosmosKnowsTheVerticalByItsCode) {
  const auto component = [](CosmosSample sample) {
    sample.integers = {{54, -999}};
    return read(cosmos_file(sample))[0];
  };
  EXPECT_EQ(component({.label = "Sta Chan  3: BNZ (Rcrdr Chan  3)"}).direction,
            Direction::kVertical);
  EXPECT_NEAR(component({.label = "Sta Chan  1: HNE (Rcrdr Chan  1)"}).azimuth.value(),
              90 * kRadiansPerDegree, 1e-12);
  std::string text = cosmos_file({.label = "Sta Chan  1:", .integers = {{54, -999}}});
  const std::string comment = "| not a real record";
  text.replace(text.find(comment), comment.size(), "|<SCNL>XX01.BNZ.XX.--");
  EXPECT_EQ(read(text)[0].direction, Direction::kVertical);
  EXPECT_EQ(read(text)[0].name, "BNZ");
}

// North, up, east of RENADIC: east becomes h1 and north h2, not the mirror image.
TEST(DamagedInputs, NorthUpEastIsNotMirrored) {
  std::string text;
  for (const char* label : {"NS", "V", "EW"})
    text += csmip_volume1({.label = std::string("CHAN  1: ") + label, .code = 0});
  const auto components = read(text);
  EXPECT_NEAR(components[0].azimuth.value_or(-1), 0, 1e-12);
  EXPECT_EQ(components[1].direction, Direction::kVertical);
  EXPECT_NEAR(components[2].azimuth.value_or(-1), 90 * kRadiansPerDegree, 1e-12);
}

}  // namespace
}  // namespace gurney::groundmotions
