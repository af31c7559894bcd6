#include <gmock/gmock.h>

#include "engine/base/units.h"
#include "tests/groundmotions/formats/page_example.h"
#include "tests/groundmotions/formats/text_file.h"
#include "tests/support/error_text.h"

namespace gurney::groundmotions {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string kFile = page_example("## CSMNC");

std::string error(const std::string& from, const std::string& to) {
  return error_text([&] { read_text(replaced(kFile, from, to)); });
}

TEST(Csmnc, ReadsTheSamples) {
  const Component component = read_one(kFile);
  EXPECT_EQ(component.format, "CSMNC");
  EXPECT_EQ(component.name, "EW");
  EXPECT_EQ(component.azimuth, 90 * kRadiansPerDegree);
  EXPECT_EQ(component.unit, "cm/s2");
  EXPECT_EQ(component.time_step, 0.005);
  ASSERT_EQ(component.acceleration.size(), 11);
  EXPECT_DOUBLE_EQ(component.acceleration[2], -0.165);
  EXPECT_DOUBLE_EQ(component.acceleration[8], -0.004);
  EXPECT_EQ(fact(component, "station"), "99XYZ 39.700N 77.500E");
  EXPECT_EQ(fact(component, "event"), "NOWHERE EARTHQUAKE, NOWHERE,CHN");
  EXPECT_THAT(component.warnings, IsEmpty());
}

TEST(Csmnc, KnowsDirections) {
  EXPECT_EQ(read_one(replaced(kFile, "COMP. EW", "COMP. NS")).azimuth, 0);
  EXPECT_EQ(read_one(replaced(kFile, "COMP. EW", "COMPONENT: UD")).direction, Direction::kVertical);
}

TEST(Csmnc, ChecksTheHeader) {
  EXPECT_THAT(error("POINTS:  11", "POINTS:  12"),
              HasSubstr("f:12:1: NO. OF POINTS states 12 samples, but the file holds 11"));
  EXPECT_THAT(error("OF:  0.005", "OF:  5.0"), HasSubstr("must be in [1e-05, 1] s, got 5"));
  EXPECT_THAT(error("-16.500", "-165.00"), HasSubstr("f:13:1: the file states a peak of -165.00"));
  EXPECT_THAT(read_one(replaced(kFile, "-16.500", "-16.900")).warnings,
              ElementsAre(HasSubstr("the file states a peak of -16.900 cm/s2")));
  EXPECT_THAT(error("DURATION:  0.055", "DURATION:  0.55"), HasSubstr("a length of 0.55 s"));
  EXPECT_THAT(error("UNIT: CM/SEC/SEC", "UNIT: CM/SEC"),
              HasSubstr("f:11:1: a record must be acceleration, but this is a velocity file"));
  EXPECT_THAT(error_text([] { read_text(kFile, {.unit = "g"}); }),
              HasSubstr("f:11:1: the file states the unit cm/s2, but unit = \"g\" was given"));
}

}  // namespace
}  // namespace gurney::groundmotions
