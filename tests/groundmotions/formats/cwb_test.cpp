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

TEST(Cwb, ReadsUpNorthEast) {
  const auto components = read_text(cwb_file());
  ASSERT_EQ(components.size(), 3u);
  EXPECT_TRUE(
      components[0].acceleration.isApprox(Eigen::Vector4d(0.01, -0.025, 0.005, 0.0025), 1e-14));
  EXPECT_TRUE(
      components[2].acceleration.isApprox(Eigen::Vector4d(0.00125, 0.06, -0.03, 0.01), 1e-14));
  for (const Component& component : components) {
    EXPECT_EQ(component.format, "CWB");
    EXPECT_EQ(component.time_step, 0.5);
    EXPECT_EQ(component.unit, "cm/s2");
    // 23:05:37.5 in Taiwan: date -u -d '2001-06-01 15:05:37.5' +%s.%N
    EXPECT_EQ(component.start_time, 991407937.5);
    EXPECT_EQ(fact(component, "station"), "Nowhere");
    EXPECT_THAT(component.warnings, IsEmpty());
  }
  EXPECT_EQ(components[0].direction, Direction::kVertical);
  EXPECT_EQ(components[1].azimuth, 0);
  EXPECT_DOUBLE_EQ(components[2].azimuth.value(), 90 * kRadiansPerDegree);
}

TEST(Cwb, TakesTheSequenceAndSignsOfTheHeader) {
  const std::string text = replaced(cwb_file("E(+); N(-); U(-)"), "MAX. U", "MAX. ?");
  const auto components =
      read_text(replaced(replaced(text, "MAX. E", "MAX. U"), "MAX. ?", "MAX. E"));
  EXPECT_DOUBLE_EQ(components[0].azimuth.value(), 90 * kRadiansPerDegree);
  EXPECT_NEAR(components[1].acceleration[1], 0.05, 1e-15);
  EXPECT_THAT(components[1].warnings, ElementsAre("N(-): the sign was turned, north is positive"));
  EXPECT_NEAR(components[2].acceleration[1], -0.06, 1e-15);
  EXPECT_EQ(components[2].direction, Direction::kVertical);
  EXPECT_THAT(error_text([] { read_text(cwb_file("U(+); N(+); N(+)")); }),
              HasSubstr("is no sequence of Time and U, N, E with their signs"));
}

TEST(Cwb, ChecksTimesAndLength) {
  EXPECT_THAT(error_text([] {
                read_text(replaced(cwb_file(), "     1.000     0.5", "     1.100     0.5"));
              }),
              HasSubstr("f:18:1: time 1.1 s where the sampling rate gives 1 s"));
  EXPECT_THAT(error_text([] { read_text(replaced(cwb_file(), "(sec): 2", "(sec): 4")); }),
              HasSubstr("the header states a length of 4 s, but 4 rows at 0.5 s have 2 s"));
  for (const Component& component : read_text(replaced(cwb_file(), "(sec): 2", "(sec): 3")))
    EXPECT_THAT(component.warnings,
                ElementsAre("the header states a length of 3 s, but 4 rows at 0.5 s have 2 s"));
}

TEST(Cwb, ChecksTheHeader) {
  EXPECT_THAT(error_text([] { read_text(replaced(cwb_file(), "#SampleRate", "#Rate")); }),
              HasSubstr("the header lacks '#SampleRate'"));
  EXPECT_THAT(error_text([] { read_text(replaced(cwb_file(), "4F10.3", "3F10.3")); }),
              HasSubstr("'3F10.3' is no format of a time and 3 samples"));
  EXPECT_THAT(error_text([] { read_text(replaced(cwb_file(), "-2.500\r\n#", "-25.00\r\n#")); }),
              HasSubstr("the file states a peak of 0.25 m/s2, but its samples have 0.025 m/s2"));
  EXPECT_THAT(error_text([] { read_text(cwb_file(), {.unit = "g"}); }),
              HasSubstr("the file states the unit cm/s2, but unit = \"g\" was given"));
}

}  // namespace
}  // namespace gurney::groundmotions
