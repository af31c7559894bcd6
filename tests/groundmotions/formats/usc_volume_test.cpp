#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>

#include "engine/base/units.h"
#include "groundmotions/formats/readers.h"
#include "tests/groundmotions/formats/network_samples.h"
#include "tests/support/error_text.h"

namespace gurney::groundmotions {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr const char* kFirstLine = "FILE     0 OF UNCORRECTED ACCELEROGRAM DATA OF VOLUME I:";

std::vector<Component> read(const std::string& text) {
  return read_components(SourceFile("f.v2", text));
}

/// Volume 1 of USC begins each line of pairs with a blank and has no end mark.
std::string volume1(const std::string& label, int code = 0) {
  std::vector<double> times;
  for (int i = 0; i < 10; ++i) times.push_back(0.005 * i);
  std::string text = pairs_volume1(times, {.label = label, .code = code, .first = kFirstLine});
  text = text.substr(0, text.find(kVolumeEnd));
  const std::string first = "  0.000  0.010";
  const auto at = text.find(first);
  EXPECT_NE(at, std::string::npos);
  std::string pairs = text.substr(at);
  for (auto line = pairs.find('\n'); line + 1 < pairs.size(); line = pairs.find('\n', line + 1))
    pairs.insert(line + 1, " ");
  return text.substr(0, at) + " " + pairs;
}

TEST(UscVolume, ReadsPairsBehindABlank) {
  const auto components = read(volume1("COMP N08W") + volume1("COMP UP"));
  ASSERT_EQ(components.size(), 2u);
  for (int i = 0; i < 10; ++i)
    EXPECT_NEAR(components[0].acceleration[i],
                kStandardGravity * kVolumeSamples[static_cast<std::size_t>(i)], 1e-12);
  EXPECT_EQ(components[0].format, "USC volume");
  EXPECT_EQ(components[0].name, "N08W");
  EXPECT_NEAR(components[0].azimuth.value(), 352 * kRadiansPerDegree, 1e-12);
  EXPECT_EQ(components[0].time_step, 0.005);
  EXPECT_TRUE(components[0].warnings.empty());
  EXPECT_EQ(components[1].direction, Direction::kVertical);
}

TEST(UscVolume, LeavesOutTextBehindTheLastSample) {
  const auto component = read(volume1("COMP UP") + "RUBBISH $\r\r\n\x1a")[0];
  EXPECT_EQ(component.acceleration.size(), 10);
  EXPECT_THAT(component.warnings,
              ElementsAre("the last line of the file is no part of the format and "
                          "was ignored: 'RUBBISH $'"));
  EXPECT_THAT(
      error_text([] { read(volume1("COMP UP") + "  0.050  0.010\r\n"); }),
      HasSubstr("the samples of this channel end here, but neither the next channel nor the "
                "end of the file follows: '0.050  0.010'"));
}

TEST(UscVolume, ReadsBearings) {
  const std::pair<const char*, double> bearings[] = {
      {"COMP N00W", 0}, {"COMP N45E", 45}, {"COMP S65E", 115}, {"COMP S30W", 210}};
  for (const auto& [label, degrees] : bearings)
    EXPECT_NEAR(read(volume1(label))[0].azimuth.value(), degrees * kRadiansPerDegree, 1e-12)
        << label;
}

TEST(UscVolume, ReadsVolume2) {
  std::string text = csmip_volume2("COMP N08W", 352);
  const auto second = text.find("UNCORRECTED");
  text.replace(second, text.find("\r\n", second) - second, kFirstLine);
  const auto component = read(text)[0];
  EXPECT_EQ(component.format, "USC volume");
  EXPECT_EQ(component.unit, "cm/s2");
  EXPECT_NEAR(component.azimuth.value(), 352 * kRadiansPerDegree, 1e-12);
  EXPECT_NEAR(component.acceleration[3], -0.1 * kStandardGravity, 0.5e-5);
}

TEST(UscVolume, SaysWhereANumberOfPointsIsNone) {
  std::string text = volume1("COMP N08W") + volume1("COMP UP");
  const std::string points = "NO. OF POINTS =     10";
  const auto at = text.rfind(points);
  text.replace(at, points.size(), "NO. OF POINTS =      0");
  const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<long>(at), '\n');
  EXPECT_EQ(
      error_text([&] { read(text); }),
      fmt::format("f.v2:{}:1: the number of samples must be a whole number above 1, got 0", line));
}

TEST(UscVolume, RefusesSpectraAndMissingNumbers) {
  EXPECT_EQ(
      error_text([] { read("RESPONSE SPECTRUM FOR\r\n" + std::string(kFirstLine) + "\r\n"); }),
      "f.v2:1:1: this file (volume 3) holds response spectra, not an acceleration history; "
      "take volume 2 of this record");
  const std::string text = volume1("COMP UP");
  EXPECT_THAT(error_text([&] { read(text.substr(0, text.rfind(" ", text.size() - 20))); }),
              HasSubstr("is not a number of the format 1X,10F7.3"));
  EXPECT_THAT(error_text([&] { read(text.substr(0, text.find("    0    0"))); }),
              HasSubstr("no integer header (16I5) within 40 lines of this channel's header"));
}

}  // namespace
}  // namespace gurney::groundmotions
