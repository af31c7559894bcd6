#include <gmock/gmock.h>

#include "engine/base/units.h"
#include "groundmotions/formats/readers.h"
#include "tests/groundmotions/formats/text_file.h"
#include "tests/support/error_text.h"

namespace gurney::groundmotions {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string kFile =
    "EVENT_NAME: NOWHERE\n"
    "EVENT_DATE_YYYYMMDD: 20010203\n"
    "EVENT_TIME_HHMMSS: 040506\n"
    "MAGNITUDE_W: \n"
    "STATION_CODE: XYZ\n"
    "DATE_TIME_FIRST_SAMPLE_YYYYMMDD_HHMMSS: 20010203_040510.250\n"
    "SAMPLING_INTERVAL_S: 0.005000\n"
    "NDATA: 4\n"
    "STREAM: HNE\n"
    "UNITS: cm/s^2\n"
    "PGA_CM/S^2: -3.250000\n"
    "TIME_PGA_S: 0.010000\n"
    "BASELINE_CORRECTION: BASELINE REMOVED\n"
    "DATA_TYPE: ACCELERATION\n"
    "USER1: a: b\n"
    "0.500000\n"
    "-1.000000\n"
    "-3.250000\n"
    "2.000000\n";

TEST(Esm, ReadsTheNewHeader) {
  const Component component = read_one(kFile);
  EXPECT_EQ(component.format, "ESM");
  EXPECT_EQ(component.name, "HNE");
  EXPECT_EQ(component.unit, "cm/s2");
  EXPECT_EQ(component.time_step, 0.005);
  EXPECT_EQ(component.azimuth, 90 * kRadiansPerDegree);
  EXPECT_TRUE(component.acceleration.isApprox(Eigen::Vector4d(0.005, -0.01, -0.0325, 0.02)));
  // `date -d "2001-02-03 04:05:10 UTC" +%s` is 981173110.
  EXPECT_EQ(component.start_time, 981173110.25);
  EXPECT_EQ(fact(component, "station"), "XYZ");
  EXPECT_EQ(fact(component, "magnitude Mw"), "(none)");
  EXPECT_THAT(component.warnings, IsEmpty());
}

// ITACA before 2011: COMPONENT instead of STREAM, the time of the first sample without its date.
TEST(Esm, ReadsTheOldHeaderOfItaca) {
  std::string text = replaced(kFile, "STREAM: HNE", "COMPONENT: UP");
  text = replaced(text, "DATE_TIME_FIRST_SAMPLE_YYYYMMDD_HHMMSS: 20010203_040510.250",
                  "TIME_FIRST_SAMPLE_S: 040510.250");
  text = replaced(text, ": ACCELERATION", ": PROCESSED ACCELERATION");
  EXPECT_EQ(read_text(text)[0].direction, Direction::kVertical);
  EXPECT_EQ(read_text(text)[0].start_time, 981173110.25);
  // 23:59:58 of the day before the event at 00:00:02: 981158402 - 4 s.
  text = replaced(replaced(text, "040506", "000002"), "040510.250", "235958.000");
  EXPECT_EQ(read_text(text)[0].start_time, 981158398);
  EXPECT_EQ(read_text(replaced(text, "T: UP", "T: WE"))[0].azimuth, 90 * kRadiansPerDegree);
  EXPECT_EQ(read_text(replaced(text, "T: UP", "T: NS"))[0].azimuth, 0);
}

// The dates of AFAD (Turkey).
TEST(Esm, ReadsOtherDatesAndStreams) {
  const std::string text =
      replaced(replaced(kFile, "20010203_040510.250", "2001/02/03 04:05:10.250"), "HNE", "N");
  EXPECT_EQ(read_text(text)[0].start_time, 981173110.25);
  EXPECT_EQ(read_text(text)[0].azimuth, 0);
  EXPECT_FALSE(read_text(replaced(text, ": N\n", ": HN2\n"))[0].azimuth);
}

TEST(Esm, RefusesWhatIsNoAcceleration) {
  EXPECT_EQ(error_text([] { read_text(replaced(kFile, ": ACCELERATION", ": VELOCITY")); }),
            "f:14:1: a record must be acceleration, but DATA_TYPE is 'VELOCITY'; take the "
            "acceleration file of this component (.ACC.ASC)");
  EXPECT_THAT(error_text([] {
                read_text(replaced(kFile, ": ACCELERATION", ": ACCELERATION RESPONSE SPECTRUM"));
              }),
              HasSubstr("DATA_TYPE is 'ACCELERATION RESPONSE SPECTRUM'"));
  EXPECT_EQ(error_text([] { read_text(replaced(kFile, "cm/s^2", "cm/s")); }),
            "f:10:1: a record must be acceleration, but UNITS are 'cm/s': velocity; take the "
            "acceleration file of this component (.ACC.ASC)");
}

TEST(Esm, ChecksTheHeader) {
  EXPECT_EQ(error_text([] { read_text(replaced(kFile, "NDATA: 4", "NDATA: 5")); }),
            "f:8:1: NDATA states 5 samples, but the file holds 4");
  EXPECT_EQ(error_text([] { read_text(replaced(kFile, "0.005000", "0.0O5")); }),
            "f:7:1: SAMPLING_INTERVAL_S must be a number, got '0.0O5'\n"
            "f:7:1: SAMPLING_INTERVAL_S must be in [1e-05, 1] s, got 0");
  EXPECT_THAT(read_text(replaced(kFile, ": -3.250000", ": 3.300000"))[0].warnings,
              ElementsAre("the file states a peak of 3.300000 cm/s2, but its samples have 3.25 "
                          "cm/s2"));
  EXPECT_THAT(error_text([] { read_text(replaced(kFile, ": -3.250000", ": 325")); }),
              HasSubstr("f:11:1: the file states a peak of 325 cm/s2"));
  EXPECT_THAT(error_text([] { read_text(replaced(kFile, "UNITS: cm/s^2", "UNITS: ")); }),
              HasSubstr("f: the file does not state its unit"));
}

// AFAD writes the day first; a date that cannot be read costs the start, not the record.
TEST(Esm, ReadsTheStartInEverySpelling) {
  const Component plain = read_one(kFile);
  for (const char* text : {"03/02/2001 04:05:10.250", "2001/02/03 04:05:10.250"}) {
    const Component component = read_one(replaced(kFile, "20010203_040510.250", text));
    EXPECT_EQ(component.start_time, plain.start_time) << text;
    EXPECT_EQ(component.acceleration, plain.acceleration);
    EXPECT_THAT(component.warnings, IsEmpty());
  }
  const Component wrong = read_one(replaced(kFile, "040510.250", "990510.250"));
  EXPECT_FALSE(wrong.start_time);
  EXPECT_EQ(wrong.acceleration, plain.acceleration);
  EXPECT_THAT(wrong.warnings,
              ElementsAre("the start of the record is not known: "
                          "DATE_TIME_FIRST_SAMPLE_YYYYMMDD_HHMMSS must be a date and a time, got "
                          "'20010203_990510.250'"));
}

TEST(Esm, ChecksTheTimeStepAgainstDurationAndPeak) {
  const std::string text = replaced(kFile, "NDATA: 4\n", "NDATA: 4\nDURATION_S: 0.020\n");
  EXPECT_EQ(read_one(text).time_step, 0.005);
  EXPECT_EQ(read_one(replaced(text, "0.020", "0.015")).time_step, 0.005);
  EXPECT_THAT(
      error_text([&] { read_text(replaced(text, "0.005000", "0.010000")); }),
      HasSubstr("f:9:1: DURATION_S is 0.020, but 4 samples at SAMPLING_INTERVAL_S 0.01 have "
                "0.04 s"));
  EXPECT_EQ(error_text([] { read_text(replaced(kFile, "0.005000", "0.020000")); }),
            "f:12:1: the file states its peak at 0.01 s, its samples have it at 0.04 s: "
            "SAMPLING_INTERVAL_S or TIME_PGA_S is wrong");
  EXPECT_THAT(read_one(replaced(text, ": 0.010000", ": 0.1")).warnings,
              ElementsAre("the file states its peak at 0.1 s, its samples have it at 0.01 s"));
}

TEST(Esm, WarnsOfRawRecordsAndBoreholes) {
  EXPECT_THAT(read_text(replaced(kFile, "BASELINE REMOVED", "BASELINE NOT REMOVED"))[0].warnings,
              ElementsAre("the header says BASELINE NOT REMOVED: this is a raw record"));
  EXPECT_THAT(read_text(replaced(kFile, "STREAM", "SENSOR_DEPTH_M: 30\nSTREAM"))[0].warnings,
              ElementsAre("the sensor is 30 m below the ground: this is not a motion of the "
                          "surface"));
}

TEST(Esm, RefusesEveryTruncation) {
  for (std::size_t length = 0; length + 1 < kFile.size(); ++length)
    EXPECT_NE(error_text([&] { read_text(kFile.substr(0, length)); }), "(no error)") << length;
}

}  // namespace
}  // namespace gurney::groundmotions
