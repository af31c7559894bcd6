#include <gmock/gmock.h>

#include <cctype>

#include "engine/base/units.h"
#include "groundmotions/formats/readers.h"
#include "tests/groundmotions/formats/text_file.h"
#include "tests/support/error_text.h"

namespace gurney::groundmotions {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

// 10 samples of 0.1 s: counts 100 +- 40 (mean 100), one count is 2 gal / 400.
const std::string kFile =
    "Origin Time       2001/02/03 04:05:00\n"
    "Lat.              35.1\n"
    "Long.             136.2\n"
    "Depth. (km)       12\n"
    "Mag.              5.5\n"
    "Station Code      XYZ001\n"
    "Station Lat.      35.3\n"
    "Station Long.     136.4\n"
    "Station Height(m) 7\n"
    "Record Time       2001/02/03 04:05:20\n"
    "Sampling Freq(Hz) 10Hz\n"
    "Duration Time(s)  1\n"
    "Dir.              E-W\n"
    "Scale Factor      2(gal)/400\n"
    "Max. Acc. (gal)   0.200\n"
    "Last Correction   2001/02/03 04:00:00\n"
    "Memo.             \n"
    "      100      110       90      140       60       95      105      100 \n"
    "      120       80 \n";

TEST(Knet, ScalesCountsAndRemovesTheMean) {
  const Component component = read_one(kFile);
  EXPECT_EQ(component.format, "K-NET");
  EXPECT_EQ(component.unit, "cm/s2");
  EXPECT_EQ(component.time_step, 0.1);
  Eigen::VectorXd counts(10);
  counts << 0, 10, -10, 40, -40, -5, 5, 0, 20, -20;
  EXPECT_TRUE(component.acceleration.isApprox(counts * 2 / 400 * 0.01, 1e-12));
  EXPECT_EQ(fact(component, "offset removed"), "the mean of the whole record, 0.005 m/s2");
  EXPECT_EQ(fact(component, "station"), "XYZ001");
  EXPECT_EQ(fact(component, "magnitude"), "5.5");
  EXPECT_EQ(fact(component, "published peak"), "0.200 cm/s2");
  EXPECT_THAT(component.warnings, IsEmpty());
}

// 2001-02-03 04:05:20 in Japan is 2001-02-02 19:05:20 UTC, less 15 s of trigger delay; `date -d`
// makes 981140705 s of 2001-02-02 19:05:05 UTC.
TEST(Knet, StartsBeforeTheRecordTime) { EXPECT_EQ(read_text(kFile)[0].start_time, 981140705); }

TEST(Knet, KnowsTheDirectionsOfBothNetworks) {
  const auto with = [](const char* dir) { return read_text(replaced(kFile, "E-W", dir))[0]; };
  for (const char* north : {"N-S", "1", "4"}) EXPECT_EQ(with(north).azimuth, 0) << north;
  for (const char* east : {"E-W", "2", "5"})
    EXPECT_EQ(with(east).azimuth, 90 * kRadiansPerDegree) << east;
  for (const char* up : {"U-D", "3", "6"}) {
    EXPECT_EQ(with(up).direction, Direction::kVertical) << up;
    EXPECT_FALSE(with(up).azimuth);
  }
  EXPECT_EQ(with("N-S").name, "NS");
  EXPECT_EQ(with("5").name, "EW2");
  EXPECT_EQ(fact(with("5"), "sensor"), "surface");
  EXPECT_EQ(error_text([&] { with("7"); }),
            "f:13:1: Dir. must be N-S, E-W, U-D or 1 to 6, got '7'");
}

TEST(Knet, MarksBoreholes) {
  const Component component = read_text(replaced(kFile, "E-W", "2"))[0];
  EXPECT_EQ(fact(component, "sensor"), "borehole");
  EXPECT_THAT(component.warnings,
              ElementsAre("EW1 is a borehole sensor of KiK-net, not a motion of the surface; the "
                          "surface files end in NS2, EW2 and UD2"));
}

// As NIED's own page spells it.
TEST(Knet, ReadsTheOtherSpellings) {
  const std::string text = replaced(replaced(kFile, "Max. Acc.", "Max Acc."), "Long.", "Lon.");
  EXPECT_EQ(fact(read_text(text)[0], "epicentre longitude"), "136.2");
  EXPECT_EQ(fact(read_text(text)[0], "published peak"), "0.200 cm/s2");
  EXPECT_EQ(read_text(replaced(kFile, "\n", "\r\n"))[0].acceleration.size(), 10);
}

// Its mean and its peak are of these very samples.
TEST(Knet, ChecksThePeakOfTheHeader) {
  EXPECT_THAT(read_text(replaced(kFile, "0.200", "0.203"))[0].warnings,
              ElementsAre("the file states a peak of 0.203 cm/s2, but its samples have 0.2 cm/s2"));
  for (const std::string stated : {"0.210", "0.190"})
    EXPECT_EQ(error_text([&] { read_text(replaced(kFile, "0.200", stated)); }),
              "f:15:1: the file states a peak of " + stated +
                  " gal, but its samples have 0.2 gal: one of them is damaged");
}

TEST(Knet, ReadsTheHeaderByItsKeys) {
  const auto expect_same = [](const std::string& text) {
    const Component component = read_one(text), whole = read_one(kFile);
    EXPECT_EQ(component.format, "K-NET") << text;
    EXPECT_EQ(component.acceleration, whole.acceleration) << text;
    EXPECT_EQ(component.azimuth, whole.azimuth) << text;
    EXPECT_EQ(component.name, whole.name) << text;
  };
  expect_same(replaced(kFile, "Memo.", "Remark            one more line\nMemo."));
  expect_same(replaced(kFile, "Station Height(m) 7\n", ""));
  expect_same(replaced(kFile, "Memo.\n", ""));
  expect_same(replaced(kFile, "2(gal)/400", "2 (gal) / 400"));
  expect_same(replaced(kFile, "2(gal)/400", "2(GAL)/400"));
  std::string text = kFile;
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  expect_same(text);
  for (const char* dir : {"EW", "e-w", "ew", "E-W"}) expect_same(replaced(kFile, "E-W", dir));
}

TEST(Knet, SeesThatTheLastNumberWasCut) {
  const auto cut = [](std::size_t lost) { return kFile.substr(0, kFile.size() - lost); };
  EXPECT_EQ(read_one(cut(2)).acceleration, read_one(kFile).acceleration);  // a blank and the end
  EXPECT_THAT(error_text([&] { read_text(cut(3)); }),
              HasSubstr("f:19:17: the file ends within a line and its last number ends left of its "
                        "column: the file seems to be cut"));
}

TEST(Knet, RefusesWhatDoesNotFit) {
  EXPECT_EQ(error_text([] { read_text(replaced(kFile, "  1\n", "  2\n")); }),
            "f:12:1: Duration Time times Sampling Freq states 20 samples, but the file holds 10");
  EXPECT_EQ(error_text([] { read_text(replaced(kFile, "2(gal)/400", "2/400")); }),
            "f:14:1: Scale Factor must be like 3920(gal)/6182761, got '2/400'");
  EXPECT_EQ(error_text([] { read_text(replaced(kFile, "Scale Factor", "Factor")); }),
            "f: the header has no line 'Scale Factor': the samples are raw counts without it");
  EXPECT_EQ(error_text([] { read_text(replaced(kFile, "10Hz", "10kHz")); }),
            "f:11:1: Sampling Freq(Hz) must be a number, got '10kHz'");
  EXPECT_EQ(error_text([] { read_text(replaced(kFile, "03 04:05:20", "33 04:05:20")); }),
            "f:10:1: Record Time must be a date and a time, got '2001/02/33 04:05:20'");
  EXPECT_EQ(error_text([] { read_text(replaced(kFile, "140", "14O")); }),
            "f:18:34: '14O' is not a finite number");
}

TEST(Knet, ChecksTheOptions) {
  EXPECT_EQ(read_text(kFile, {.unit = "gal", .time_step = 0.1}).size(), 1u);
  EXPECT_EQ(error_text([] { read_text(kFile, {.unit = "g", .si_per_count = 1}); }),
            "f: count_m_per_s2 = 1 was given, but the file does not hold raw counts\n"
            "f:14:1: the file states the unit cm/s2, but unit = \"g\" was given");
  EXPECT_THAT(error_text([] { read_text(kFile, {.time_step = 0.01}); }),
              HasSubstr("f:11:1: the file states a time step of 0.1 s, but time_step_s = 0.01"));
}

// Only the blank and the line end at the end may go.
TEST(Knet, RefusesEveryTruncation) {
  for (std::size_t length = 0; length + 2 < kFile.size(); ++length)
    EXPECT_NE(error_text([&] { read_text(kFile.substr(0, length)); }), "(no error)") << length;
}

}  // namespace
}  // namespace gurney::groundmotions
