#include <gmock/gmock.h>

#include "engine/base/units.h"
#include "groundmotions/formats/readers.h"
#include "tests/groundmotions/formats/array_samples.h"
#include "tests/groundmotions/formats/text_file.h"
#include "tests/support/error_text.h"

namespace gurney::groundmotions {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(GeoNet, ReadsThreeComponentsOfEachVolume) {
  for (const bool is_corrected : {false, true}) {
    const auto components = read_text(geonet_file({.is_corrected = is_corrected}));
    ASSERT_EQ(components.size(), 3u);
    for (const Component& component : components) {
      ASSERT_EQ(component.acceleration.size(), 12);
      for (int i = 0; i < 12; ++i)
        EXPECT_NEAR(component.acceleration[i], 1e-3 * kGeonetSamples[static_cast<std::size_t>(i)],
                    1e-15);
      EXPECT_EQ(component.format, "GeoNet");
      EXPECT_EQ(component.time_step, 0.005);
      EXPECT_EQ(component.unit, "mm/s2");
      EXPECT_EQ(component.start_time, 991407937.5);  // date -u -d '2001-06-01 15:05:37.5' +%s.%N
      EXPECT_EQ(fact(component, "also in the file"),
                is_corrected ? "velocity and displacement" : "(none)");
      EXPECT_THAT(component.warnings, IsEmpty());
    }
    EXPECT_EQ(components[0].name, "N28W");
    EXPECT_DOUBLE_EQ(components[0].azimuth.value(), 332 * kRadiansPerDegree);
    EXPECT_DOUBLE_EQ(components[1].azimuth.value(), 242 * kRadiansPerDegree);
    EXPECT_EQ(components[2].direction, Direction::kVertical);
    EXPECT_FALSE(components[2].azimuth || components[0].direction);
  }
}

TEST(GeoNet, SamplesPutBeforeTheRecordStartEarlier) {
  EXPECT_NEAR(*read_text(geonet_file({.prepended = 100}))[0].start_time, 991407937, 1e-6);
  EXPECT_FALSE(read_text(geonet_file({.prepended = -1}))[0].start_time);
}

TEST(GeoNet, ReadsNumbersWithoutTheirPoint) {
  // Large numbers fill their eight columns and leave the point out.
  std::string text = replaced(geonet_file(), "  -980.7\r\n", "");
  text = replaced(geonet_file(), "  -980.7    45.6", "  -11026  -10835");
  text = replaced(text, "-980.7 mm", "-11026.2 mm");
  EXPECT_EQ(read_text(text)[0].acceleration[3], -11.026);
  EXPECT_THAT(read_text(text)[0].warnings, IsEmpty());
}

TEST(GeoNet, TakesTheFactorOfTheUnit) {
  const auto components = read_text(replaced(geonet_file(), "of 1.00 mm", "of 2.00 mm"));
  EXPECT_NEAR(components[0].acceleration[3], -2 * 0.9807, 1e-12);
  EXPECT_THAT(error_text([] { read_text(replaced(geonet_file(), "of 1.00 mm", "of 0.00 mm")); }),
              HasSubstr("f:11:1: a unit of 0 mm/s/s"));
}

TEST(GeoNet, ChecksWhatTheHeaderStatesTwice) {
  EXPECT_THAT(
      error_text([] { read_text(replaced(geonet_file(), "points     12", "points     13")); }),
      HasSubstr("f:20:25: the header states 12 samples here, but 13 in line 10"));
  EXPECT_THAT(error_text([] { read_text(replaced(geonet_file(), "of 0.005 s", "of 0.010 s")); }),
              HasSubstr("f:11:1: the time step is 0.01 s here, but 0.005 s in the real numbers"));
  EXPECT_THAT(error_text([] { read_text(replaced(geonet_file(), "-980.7 mm", "-98.07 mm")); }),
              HasSubstr("the file states a peak of 0.09807 m/s2, but its samples have"));
  EXPECT_THAT(read_text(replaced(geonet_file(), "-980.7 mm", "-990.7 mm"))[0].warnings,
              ElementsAre(HasSubstr("the file states a peak of 0.9907 m/s2")));
}

TEST(GeoNet, RefusesFewerAndMoreThanThreeComponents) {
  const std::string one = geonet_block();
  EXPECT_THAT(error_text([&] { read_text(one + one); }),
              HasSubstr("the file ends after 2 of 3 components"));
  EXPECT_THAT(error_text([&] { read_text(geonet_file() + one); }),
              HasSubstr("f:85:1: more lines follow the 3 components"));
}

TEST(GeoNet, ChecksTheOptions) {
  EXPECT_THAT(error_text([] { read_text(geonet_file(), {.unit = "g"}); }),
              HasSubstr("the file states the unit mm/s2, but unit = \"g\" was given"));
}

}  // namespace
}  // namespace gurney::groundmotions
