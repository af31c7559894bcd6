#include <gmock/gmock.h>

#include "engine/base/units.h"
#include "groundmotions/formats/readers.h"
#include "tests/groundmotions/formats/network_samples.h"
#include "tests/support/error_text.h"

namespace gurney::groundmotions {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::vector<Component> read(const std::string& text) {
  return read_components(SourceFile("f.V1", text));
}

TEST(Bhrc, ReadsThreeComponents) {
  const auto components = read(bhrc_channel("L1") + bhrc_channel("V2") + bhrc_channel("T3"));
  ASSERT_EQ(components.size(), 3u);
  for (const Component& component : components) {
    EXPECT_EQ(component.format, "BHRC volume");
    EXPECT_EQ(component.unit, "g/10");
    EXPECT_DOUBLE_EQ(component.time_step, 0.005);
    ASSERT_EQ(component.acceleration.size(), 10);
    for (int i = 0; i < 10; ++i)
      EXPECT_NEAR(component.acceleration[i],
                  kStandardGravity * kVolumeSamples[static_cast<std::size_t>(i)], 1e-12);
    EXPECT_TRUE(component.warnings.empty());
  }
  EXPECT_EQ(components[0].name, "L1");
  EXPECT_NEAR(components[0].azimuth.value(), 50 * kRadiansPerDegree, 1e-12);
  EXPECT_EQ(components[1].direction, Direction::kVertical);
  EXPECT_NEAR(components[2].azimuth.value(), 140 * kRadiansPerDegree, 1e-12);
}

TEST(Bhrc, TakesTheRateFromTheDurationIfBothDisagree) {
  const auto component = read(bhrc_channel("L1", 100))[0];
  EXPECT_DOUBLE_EQ(component.time_step, 0.005);
  EXPECT_THAT(component.warnings, ElementsAre("the header states 100 samples per second, but also "
                                              "10 samples in 0.05 s, which was taken"));
}

TEST(Bhrc, RefusesWhatItMust) {
  std::string text = bhrc_channel("L1");
  text.replace(text.find("VOL1"), 4, "VOL2");
  EXPECT_EQ(error_text([&] { read(text); }), "f.V1:1:1: only volume 1 (VOL1DS) of BHRC is read");
  text = bhrc_channel("L1");
  text.replace(text.find("G/10"), 4, "VOLT");
  EXPECT_THAT(error_text([&] { read(text); }),
              HasSubstr("f.V1:12:1: the file does not state its unit"));
  text = bhrc_channel("L1");
  text.replace(text.find("=     10"), 8, "=     11");
  EXPECT_THAT(error_text([&] { read(text); }),
              HasSubstr("f.V1:29:1: '/&' is not a number of the format 10E13.6"));
}

}  // namespace
}  // namespace gurney::groundmotions
