#include <gmock/gmock.h>

#include "engine/base/units.h"
#include "groundmotions/formats/readers.h"
#include "tests/groundmotions/formats/text_file.h"
#include "tests/support/error_text.h"

namespace gurney::groundmotions {
namespace {

const std::string kFile =
    "NOWH       090 a title\n"
    "7  5.00000e-03 0 1  -2.50000e-01  3.50000e+01  0.00000e+00  0.00000e+00\n"
    "  1.00000e-01  -2.00000e-01   3.00000e-01  -4.00000e-01   5.00000e-01  -6.00000e-01\n"
    "  7.00000e-01\n";

TEST(Emod3d, ReadsInTheUnitOfTheUser) {
  const Component component = read_text(kFile, {.unit = "cm/s2"}).at(0);
  EXPECT_EQ(component.format, "EMOD3D");
  EXPECT_EQ(component.name, "090");
  EXPECT_EQ(component.azimuth, 90 * kRadiansPerDegree);
  EXPECT_EQ(component.time_step, 0.005);
  ASSERT_EQ(component.acceleration.size(), 7);
  EXPECT_DOUBLE_EQ(component.acceleration[6], 0.007);
  EXPECT_EQ(fact(component, "station"), "NOWH");
  EXPECT_EQ(fact(component, "title"), "a title");
  EXPECT_EQ(fact(component, "first sample after the origin [s]"), "59.75");
  EXPECT_EQ(read_text(replaced(kFile, "090", "ver"), {.unit = "g"})[0].direction,
            Direction::kVertical);
}

TEST(Emod3d, AsksForTheUnitAndChecksTheCount) {
  EXPECT_EQ(error_text([] { read_text(kFile); }),
            "f: the file does not state its unit; state it as unit = \"...\" or gurney records "
            "--unit (g, m/s2, "
            "cm/s2, gal, mm/s2, mg, %g, ft/s2 or in/s2)");
  EXPECT_EQ(error_text([] { read_text(replaced(kFile, "7  5.0", "8  5.0"), {.unit = "g"}); }),
            "f:2:1: npts states 8 samples, but the file holds 7");
  EXPECT_EQ(error_text([] { read_text(replaced(kFile, "5.00000e-03", "5"), {.unit = "g"}); }),
            "f:2:1: dt must be in [1e-05, 1] s, got 5");
}

// A title and rows of eight samples look alike.
TEST(Emod3d, LeavesRowsOfEightSamplesAlone) {
  const std::string rows = " 0.1 0.2 0 0 0.5 0.6 0.7 0.8\n";
  EXPECT_EQ(read_text("El Nowhere 1940\n" + rows + rows,
                      {.unit = "g", .time_step = 0.02, .columns = "samples"})[0]
                .format,
            "plain text");
}

TEST(Emod3d, RefusesEveryTruncation) {
  for (std::size_t length = 0; length + 1 < kFile.size(); ++length)
    EXPECT_NE(error_text([&] { read_text(kFile.substr(0, length), {.unit = "g"}); }), "(no error)")
        << length;
}

}  // namespace
}  // namespace gurney::groundmotions
