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

TEST(Unam, ReadsTheColumnsInTheOrderOfTheHeader) {
  const auto components = read_text(unam_file());
  ASSERT_EQ(components.size(), 3u);
  EXPECT_TRUE(
      components[0].acceleration.isApprox(Eigen::Vector4d(0.0046, -0.0528, -0.0145, 0.01), 1e-14));
  EXPECT_TRUE(
      components[2].acceleration.isApprox(Eigen::Vector4d(-0.0064, 0.0032, 0.0032, 0.0798), 1e-14));
  for (const Component& component : components) {
    EXPECT_EQ(component.format, "UNAM");
    EXPECT_EQ(component.time_step, 0.01);
    EXPECT_EQ(component.unit, "cm/s2");
    EXPECT_EQ(fact(component, "station"), "NINGUNA");
    EXPECT_EQ(fact(component, "quality"), "DUDOSO");
    EXPECT_THAT(component.warnings, IsEmpty());
  }
  EXPECT_EQ(components[0].direction, Direction::kVertical);
  EXPECT_DOUBLE_EQ(components[1].azimuth.value(), 90 * kRadiansPerDegree);
  EXPECT_EQ(components[2].azimuth, 0);
  EXPECT_EQ(components[2].name, "N00E");
  EXPECT_EQ(read_text(unam_file("N00E/V/S45W"))[1].direction, Direction::kVertical);
}

// The date is that of the earthquake at 23:59:50; the first sample is of the next day.
TEST(Unam, StartsOnTheNextDayAfterMidnight) {
  EXPECT_EQ(read_text(unam_file())[0].start_time, 991440001.5);  // 2001-06-02 00:00:01.5 UTC
  EXPECT_EQ(read_text(replaced(unam_file(), "23:59:50.0", "00:00:00.0"))[0].start_time,
            991353601.5);
}

TEST(Unam, TakesMoreRowsThanStatedWithAWarning) {
  const auto components = read_text(unam_file("V/N90E/N00E", 3));
  EXPECT_EQ(components[0].acceleration.size(), 4);
  EXPECT_THAT(components[0].warnings,
              ElementsAre("the header states 3 samples, but the file has 4 rows; all were taken"));
}

TEST(Unam, RefusesFewerRowsThanStated) {
  EXPECT_THAT(error_text([] { read_text(unam_file("V/N90E/N00E", 5)); }),
              HasSubstr("f:18:1: the header states 5 samples, but the file has 4 rows: it seems to "
                        "be cut"));
}

TEST(Unam, ChecksTheHeader) {
  EXPECT_THAT(error_text([] { read_text(replaced(unam_file(), "      N90E", "      N80E")); }),
              HasSubstr("the columns are V N80E N00E here, but V N90E N00E in line 10"));
  EXPECT_THAT(error_text([] { read_text(replaced(unam_file(), "/0.01/0.01/0.01", "/0.02")); }),
              HasSubstr("a time step of 0.02 s is not that of 100 samples in a second"));
  EXPECT_THAT(error_text([] { read_text(replaced(unam_file(), "3F10.2", "6F10.2")); }),
              HasSubstr("'6F10.2' is no format of 3 numbers in a row"));
  EXPECT_THAT(error_text([] { read_text(replaced(unam_file(), "Gal (cm/s/s)", "cm/s")); }),
              HasSubstr("'cm/s' names no unit of acceleration"));
  EXPECT_THAT(error_text([] { read_text(replaced(unam_file(), "/11.90", "/1.190")); }),
              HasSubstr("the file states a peak of 0.0119 m/s2, but its samples have"));
  EXPECT_THAT(error_text([] { read_text(replaced(unam_file(), "NUM. TOTAL", "TOTAL")); }),
              HasSubstr("the header lacks 'NUM. TOTAL DE MUESTRAS'"));
}

TEST(Unam, ChecksTheOptions) {
  EXPECT_THAT(error_text([] { read_text(unam_file(), {.unit = "g"}); }),
              HasSubstr("the file states the unit cm/s2, but unit = \"g\" was given"));
}

}  // namespace
}  // namespace gurney::groundmotions
