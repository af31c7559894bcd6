#include <gmock/gmock.h>

#include "groundmotions/formats/readers.h"
#include "tests/groundmotions/formats/text_file.h"
#include "tests/support/error_text.h"

namespace gurney::groundmotions {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

const std::string kFile =
    "Event Date & Time             : 2001-02-03 04:05:06\n"
    "Station Code / Name           : 12 / Nowhere\n"
    "Network                       : ABC\n"
    "Orientation                   : NS\n"
    "Filter Cut-off Frequency (Hz) : 0.050 - 65.000\n"
    "Time Increment (s)            : 0.005\n"
    "Number of Data                : 7\n"
    "PGA (m/s/s)                   : 6.0000000E-01\n"
    "Accelaration time series in m/s/s\n"
    " 1.0000000E-01-2.0000000E-01 3.0000000E-01-4.0000000E-01-5.0000000E-01\n"
    "-6.0000000E-01 5.0000000E-02\n";

TEST(Simbad, ReadsPackedNumbers) {
  const Component component = read_one(kFile);
  EXPECT_EQ(component.format, "SIMBAD");
  EXPECT_EQ(component.name, "NS");
  EXPECT_EQ(component.azimuth, 0);
  EXPECT_EQ(component.unit, "m/s2");
  EXPECT_EQ(component.time_step, 0.005);
  Eigen::VectorXd expected(7);
  expected << 0.1, -0.2, 0.3, -0.4, -0.5, -0.6, 0.05;
  EXPECT_EQ(component.acceleration, expected);
  EXPECT_EQ(fact(component, "filter corners [Hz]"), "0.050 - 65.000");
  EXPECT_THAT(component.warnings, IsEmpty());
  EXPECT_EQ(read_text(kFile.substr(0, kFile.size() - 1))[0].acceleration, expected);
  EXPECT_EQ(read_text(replaced(kFile, ": NS", ": UP"))[0].direction, Direction::kVertical);
}

TEST(Simbad, RefusesWhatDoesNotFit) {
  EXPECT_EQ(error_text([] {
              read_text(replaced(kFile, "Accelaration time series in m/s/s",
                                 "Velocity time series in m/s"));
            }),
            "f:9:1: a record must be acceleration, but this is a velocity file ('Velocity time "
            "series in m/s'); take the .cor.acc file of this component");
  EXPECT_EQ(error_text([] { read_text(replaced(kFile, ": 7", ": 8")); }),
            "f:7:1: Number of Data states 8 samples, but the file holds 7");
  EXPECT_EQ(error_text([] { read_text(replaced(kFile, ": 6.0000000E-01", ": 6.0")); }),
            "f:8:1: the file states a peak of 6.0 m/s2, but its samples have 0.6 m/s2");
  EXPECT_THAT(error_text([] { read_text(replaced(kFile, " in m/s/s", "")); }),
              HasSubstr("f:9:1: the header must end in a line such as"));
  EXPECT_THAT(error_text([] { read_text(kFile, {.unit = "g"}); }),
              HasSubstr("f:9:1: the file states the unit m/s2, but unit = \"g\" was given"));
}

TEST(Simbad, RefusesEveryTruncation) {
  for (std::size_t length = 0; length + 1 < kFile.size(); ++length)
    EXPECT_NE(error_text([&] { read_text(kFile.substr(0, length)); }), "(no error)") << length;
}

}  // namespace
}  // namespace gurney::groundmotions
