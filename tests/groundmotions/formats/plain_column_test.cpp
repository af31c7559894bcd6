#include "groundmotions/formats/plain_column.h"

#include <gmock/gmock.h>

#include "tests/support/error_text.h"

namespace gurney {
namespace {

using testing::HasSubstr;

std::vector<Component> read(const std::string& text, const ReadOptions& options) {
  return read_components(SourceFile("f.txt", text), options);
}

TEST(PlainColumn, ReadsWithTheUnitAndStepOfTheUser) {
  const auto components =
      read("# a comment\n 100\n-.5304E+02\r\n\n25.5\n", {.unit = "gal", .time_step = 0.01});
  ASSERT_EQ(components.size(), 1u);
  EXPECT_TRUE(components[0].acceleration.isApprox(Eigen::Vector3d(1, -0.5304, 0.255)));
  EXPECT_EQ(components[0].time_step, 0.01);
  EXPECT_EQ(components[0].unit, "cm/s2");
}

TEST(PlainColumn, AsksForTheUnitAndTheStep) {
  EXPECT_EQ(error_text([] { read("1\n2\n", {}); }),
            "f.txt: a plain column of numbers does not state its unit; state it as unit = \"...\" "
            "(g, m/s2, cm/s2 (gal) or mm/s2)\n"
            "f.txt: a plain column of numbers does not state its time step; state it as "
            "time_step_s");
}

TEST(PlainColumn, RefusesTextAndSeveralNumbersOnALine) {
  EXPECT_THAT(error_text([] { read("1\nend\n3\n", {.unit = "g", .time_step = 0.01}); }),
              HasSubstr("f.txt:2:1: 'end' is not a finite number"));
  EXPECT_THAT(error_text([] { read("0 1\n", {.unit = "g", .time_step = 0.01}); }),
              HasSubstr("f.txt:1:1: 2 numbers on a line, 1 is allowed"));
  EXPECT_EQ(error_text([] { read("1\n", {.unit = "g", .time_step = 0.01}); }),
            "f.txt: 1 samples are no record (2 at least)");
}

TEST(PlainColumn, RefusesOptionsOutsideTheirRanges) {
  EXPECT_EQ(error_text([] { read("1\n2\n", {.unit = "ft/s2", .time_step = 0.01}); }),
            "'ft/s2' is not a unit of acceleration: g, m/s2, cm/s2 (gal) or mm/s2 are allowed");
  EXPECT_EQ(error_text([] { read("1\n2\n", {.unit = "g", .time_step = -0.01}); }),
            "the time step of a record must be in (0, 1] s, got -0.01");
}

}  // namespace
}  // namespace gurney
