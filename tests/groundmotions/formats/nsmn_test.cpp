#include <gmock/gmock.h>

#include "engine/base/units.h"
#include "groundmotions/formats/readers.h"
#include "tests/groundmotions/formats/page_example.h"
#include "tests/groundmotions/formats/text_file.h"
#include "tests/support/error_text.h"

namespace gurney::groundmotions {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

const std::string kFile = page_example("## NSMN");

TEST(Nsmn, ReadsThreeColumns) {
  const auto components = read_text(kFile);
  ASSERT_EQ(components.size(), 3u);
  EXPECT_TRUE(components[0].acceleration.isApprox(Eigen::Vector3d(0.001, -0.025, 0.01), 1e-14));
  EXPECT_TRUE(components[1].acceleration.isApprox(Eigen::Vector3d(0.005, 0.01, -0.0075), 1e-14));
  for (const Component& component : components) {
    EXPECT_EQ(component.format, "NSMN");
    EXPECT_EQ(component.time_step, 0.01);
    EXPECT_EQ(component.unit, "cm/s2");
    EXPECT_EQ(component.start_time, 991407937.5);  // date -u -d '2001-06-01 15:05:37.5' +%s.%N
    EXPECT_THAT(component.warnings, IsEmpty());
  }
  EXPECT_EQ(components[0].azimuth, 0);
  EXPECT_DOUBLE_EQ(components[1].azimuth.value(), 90 * kRadiansPerDegree);
  EXPECT_EQ(components[2].direction, Direction::kVertical);
  std::string turned = replaced(kFile, "N-S          E-W", "E-W          N-S");
  EXPECT_THAT(error_text([&] { read_text(turned); }),
              HasSubstr("f:9:1: the file states a peak of 0.01 m/s2, but its samples have"));
  turned = replaced(turned, "(N-S) 2.500000 (E-W) 1.000000", "(N-S) 1.000000 (E-W) 2.500000");
  EXPECT_DOUBLE_EQ(read_text(turned)[0].azimuth.value(), 90 * kRadiansPerDegree);
}

TEST(Nsmn, ReadsTabsAndOldLetters) {
  const auto components =
      read_text(replaced(replaced(kFile, "NOWHERE", "K\xfcT"), "DATA          :", "DATA\t:\t"));
  EXPECT_EQ(fact(components[0], "station"), "K\u00fcT");
}

TEST(Nsmn, ChecksTheHeader) {
  EXPECT_THAT(error_text([] { read_text(replaced(kFile, "DATA          : 3", "DATA : 4")); }),
              HasSubstr("f:7:1: NUMBER OF DATA"));
  EXPECT_THAT(error_text([] { read_text(replaced(kFile, "NUMBER OF DATA", "DATA")); }),
              HasSubstr("the header lacks 'NUMBER OF DATA'"));
  EXPECT_THAT(error_text([] { read_text(replaced(kFile, "U-D\n", "\n")); }),
              HasSubstr("no row that names the columns N-S, E-W and U-D"));
  EXPECT_THAT(error_text([] { read_text(replaced(kFile, "    -0.500000\n", "\n")); }),
              HasSubstr("f:11:1: 2 numbers, the row must have 3"));
  EXPECT_THAT(error_text([] { read_text(replaced(kFile, "2.500000 (", "25.00000 (")); }),
              HasSubstr("the file states a peak of 0.25 m/s2, but its samples have"));
  EXPECT_THAT(error_text([] { read_text(kFile, {.unit = "g"}); }),
              HasSubstr("the file states the unit cm/s2, but unit = \"g\" was given"));
}

}  // namespace
}  // namespace gurney::groundmotions
