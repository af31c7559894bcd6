#include <gmock/gmock.h>

#include "engine/base/units.h"
#include "groundmotions/formats/readers.h"
#include "tests/groundmotions/formats/network_samples.h"
#include "tests/support/error_text.h"

namespace gurney::groundmotions {
namespace {

using testing::HasSubstr;

std::vector<Component> read(const std::string& text) {
  return read_components(SourceFile("f.044", text));
}

TEST(UscBlocks, ReadsTheAccelerationOfEachComponent) {
  const auto components = read(usc_block("AC") + usc_block("VL") + usc_block("DP") +
                               usc_block("AC", "VERTICAL") + "\r\n\r\n");
  ASSERT_EQ(components.size(), 2u);
  EXPECT_EQ(components[0].format, "USC blocks");
  EXPECT_EQ(components[0].unit, "cm/s2");
  EXPECT_EQ(components[0].time_step, 0.005);
  EXPECT_EQ(components[0].name, "090 DEGREES");
  EXPECT_NEAR(components[0].azimuth.value(), 90 * kRadiansPerDegree, 1e-12);
  ASSERT_EQ(components[0].acceleration.size(), 10);
  for (int i = 0; i < 10; ++i)
    EXPECT_NEAR(components[0].acceleration[i], 10 * kVolumeSamples[static_cast<std::size_t>(i)],
                1e-12);
  EXPECT_EQ(components[1].direction, Direction::kVertical);
  EXPECT_FALSE(components[1].azimuth);
}

TEST(UscBlocks, RefusesVelocitiesAndWrongCounts) {
  EXPECT_EQ(error_text([] { read(usc_block("VL")); }),
            "f.044:1:1: this file holds velocity (VL) or displacement (DP) only; a record must be "
            "acceleration (DATA TYPE=AC)");
  std::string text = usc_block("AC");
  text.replace(text.find("POINTS=    10"), 13, "POINTS=    11");
  EXPECT_EQ(error_text([&] { read(text); }), "f.044:8:1: the file ends after 10 of 11 samples");
  text.replace(text.find("POINTS=    11"), 13, "POINTS=     9");
  EXPECT_THAT(error_text([&] { read(text); }),
              HasSubstr("f.044:8:73: '-1.00' follows the 9 numbers of this line"));
  text.replace(text.find("POINTS=     9"), 13, "POINTS=   nan");
  EXPECT_THAT(error_text([&] { read(text); }),
              HasSubstr("f.044:1:1: no header of a block here: 7 lines with"));
}

}  // namespace
}  // namespace gurney::groundmotions
