#include "groundmotions/assembly/read_record.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <unistd.h>

#include <cmath>
#include <fstream>

#include "engine/base/units.h"
#include "groundmotions/assembly/site.h"
#include "groundmotions/formats/format.h"
#include "tests/support/error_text.h"

namespace gurney::groundmotions {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A folder of small files that goes with the test.
class ReadRecord : public testing::Test {
 protected:
  ReadRecord() {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::temp_directory_path() /
              fmt::format("gurney_{}_{}", test->name(), getpid());
    std::filesystem::create_directories(folder_);
  }
  ~ReadRecord() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path file(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return folder_ / name;
  }

  /// An AT2 file of `values` in g.
  std::filesystem::path at2(const std::string& component, const std::vector<double>& values,
                            double time_step = 0.01) const {
    std::string text = fmt::format(
        "PEER NGA STRONG MOTION DATABASE RECORD\nX, 1/2/2003, Y, {}\n"
        "ACCELERATION TIME SERIES IN UNITS OF G\nNPTS= {}, DT= {} SEC\n",
        component, values.size(), time_step);
    for (const double value : values) text += fmt::format(" {:f}", value);
    return file(component + ".AT2", text + "\n");
  }

  std::filesystem::path folder_;
};

TEST_F(ReadRecord, PutsThreeFilesTogether) {
  const Record record = read_record({{at2("090", {0.1, 0.2}), Direction::kH1},
                                     {at2("000", {0.3, 0.4}), Direction::kH2},
                                     {at2("UP", {0.5, 0.6}), Direction::kVertical}});
  EXPECT_EQ(record.name, "090 + 000 + UP");
  EXPECT_EQ(record.time_step(), 0.01);
  EXPECT_EQ(record.samples(), 2);
  EXPECT_THAT(record.warnings, IsEmpty());
  EXPECT_DOUBLE_EQ(record[Direction::kH2]->acceleration[1], 0.4 * kStandardGravity);
  EXPECT_EQ(record[Direction::kVertical]->name, "UP");
  EXPECT_EQ(record[Direction::kVertical]->direction, Direction::kVertical);
}

TEST_F(ReadRecord, IsNamedByWhatItsFilesHaveInCommon) {
  const auto file_of = [&](const char* name, const char* component) {
    const auto path = folder_ / (std::string(name) + ".AT2");
    std::filesystem::rename(at2(component, {0.1, 0.2}), path);
    return RecordFile{path};
  };
  EXPECT_EQ(read_record({file_of("RSN1_RRS228", "228"), file_of("RSN1_RRS318", "318"),
                         file_of("RSN1_RRS-UP", "UP")})
                .name,
            "RSN1_RRS");
  EXPECT_EQ(read_record({file_of("AB1", "000"), file_of("AB2", "270")}).name, "AB1 + AB2");
}

TEST_F(ReadRecord, TakesPlacesFromTheColumnsOfACsv) {
  const Record record =
      read_record({{file("r.csv", "time_s,y_g,z_g\n0,0.1,0.2\n0.1,0.3,0.4\n"), {}}});
  EXPECT_FALSE(record[Direction::kH1]);
  EXPECT_TRUE(record[Direction::kH2] && record[Direction::kVertical]);
  EXPECT_EQ(record.name, "r");
}

TEST_F(ReadRecord, FillsShorterComponentsWithZerosAndSaysSo) {
  const auto h1 = at2("090", {0.1, 0.2});
  const Record record =
      read_record({{h1, Direction::kH1}, {at2("000", {0.1, 0.2, 0.3, 0.4}), Direction::kH2}});
  EXPECT_EQ(record.samples(), 4);
  EXPECT_EQ(record[Direction::kH1]->acceleration.tail(2), Eigen::Vector2d::Zero());
  EXPECT_DOUBLE_EQ(record[Direction::kH1]->acceleration[1], 0.2 * kStandardGravity);
  EXPECT_THAT(record.warnings,
              ElementsAre(h1.string() +
                          ": 2 samples, the longest component has 4: 2 zeros added at the end"));
}

// Both sines are within the band of either step; away from the ends, where the kernel meets the
// zeros outside, resampling keeps the gain to 1e-5 (processing/resample.h), and AT2 text to 1e-6.
// The kernel spans 33 old samples; its tails of 100 dB (1e-5) reach no further.
TEST_F(ReadRecord, ResamplesToTheSmallestTimeStep) {
  std::vector<double> fine(801), coarse(401);
  for (std::size_t i = 0; i < fine.size(); ++i) fine[i] = std::sin(3 * 0.01 * double(i));
  for (std::size_t i = 0; i < coarse.size(); ++i) coarse[i] = std::sin(3 * 0.02 * double(i));
  const auto h1 = at2("090", fine, 0.01), h2 = at2("000", coarse, 0.02);
  const Record record = read_record({{h1, Direction::kH1}, {h2, Direction::kH2}});
  EXPECT_EQ(record.time_step(), 0.01);
  EXPECT_EQ(record[Direction::kH2]->acceleration.size(), 801);
  const Eigen::VectorXd difference =
      record[Direction::kH1]->acceleration - record[Direction::kH2]->acceleration;
  EXPECT_LT(difference.segment(100, 600).cwiseAbs().maxCoeff(), 3e-5 * kStandardGravity);
  EXPECT_THAT(record.warnings,
              ElementsAre(h2.string() + ": a time step of 0.02 s, resampled to 0.01 s as the other "
                                        "components have"));
}

// A motion of (e, n) = (1, 2) and then (-1, 1) g: along azimuth 90 it is e, along azimuth 30 it is
// e / 2 + n sqrt(3) / 2. The text has six digits behind the point.
TEST_F(ReadRecord, ResolvesHorizontalsThatAreNotAtARightAngle) {
  const double root = std::sqrt(3) / 2;
  const Record record =
      read_record({{at2("090", {1, -1})}, {at2("030", {0.5 + 2 * root, -0.5 + root})}});
  EXPECT_NEAR(record[Direction::kH2]->acceleration[0], 2 * kStandardGravity, 1e-5);
  EXPECT_NEAR(record[Direction::kH2]->acceleration[1], 1 * kStandardGravity, 1e-5);
  EXPECT_THAT(record.warnings, ElementsAre(HasSubstr("h2 resolved at a right angle to h1")));
}

TEST_F(ReadRecord, RefusesNoPlaceTwoPlacesAndWrongPlaces) {
  const auto a = at2("090", {0.1, 0.2}), b = at2("000", {0.1, 0.2});
  const auto csv = file("r.csv", "time_s,x_g,y_g\n0,0.1,0.2\n0.1,0.3,0.4\n");
  const auto one = file("one.csv", "time_s,x_g\n0,0.1\n0.1,0.3\n");
  EXPECT_EQ(error_text([] { read_record({}); }),
            "a record needs at least one component: h1, h2 or vertical");
  EXPECT_EQ(error_text([&] {
              read_record({{a, Direction::kH1}, {b}});
            }),
            b.string() + ": the file does not say whether it is h1, h2 or vertical; state it");
  EXPECT_EQ(error_text([&] {
              read_record({{a, Direction::kH1}, {b, Direction::kH1}});
            }),
            b.string() + ": a second h1 component, after " + a.string());
  EXPECT_EQ(error_text([&] {
              read_record({{csv, Direction::kH1}});
            }),
            csv.string() + ": given as h1, but the file holds 2 components");
  EXPECT_EQ(error_text([&] {
              read_record({{one, Direction::kVertical}});
            }),
            one.string() + ": given as vertical, but its component x_g is h1");
}

TEST_F(ReadRecord, ReportsTheErrorsOfAllFiles) {
  const auto bad = file("bad.AT2", "nonsense\n");
  EXPECT_EQ(error_text([&] {
              read_record({{folder_ / "none.AT2", Direction::kH1}, {bad, Direction::kH2}});
            }),
            (folder_ / "none.AT2").string() + ": no such file\n" + bad.string() +
                ":1:1: not a record in a known format (see docs/records.md): 1 line of text, 9 "
                "bytes");
}

TEST_F(ReadRecord, RefusesARecordThatIsAllZero) {
  EXPECT_EQ(error_text([&] {
              read_record({{at2("090", {0, 0, 0}), Direction::kH1}});
            }),
            "090: all accelerations of the record are zero");
}

TEST_F(ReadRecord, WarnsOfPlacesAndAngles) {
  EXPECT_THAT(error_text([&] {
                read_record({{at2("UP", {0.1, 0.2}), Direction::kH1}});
              }),
              HasSubstr("given as h1, but its component UP is vertical"));
  EXPECT_THAT(read_record({{at2("090", {0.1, 0.2}), Direction::kVertical}}).warnings,
              ElementsAre(HasSubstr("calls this component '090', it is used as vertical")));
  EXPECT_THAT(read_record({{at2("090", {0.1, 0.2}), Direction::kH1},
                           {at2("060", {0.1, 0.3}), Direction::kH2}})
                  .warnings,
              ElementsAre(HasSubstr("azimuths of 90 and 60 degrees, which is no right angle")));
}

TEST_F(ReadRecord, PlacesFilesByTheirAzimuths) {
  const auto east = at2("090", {0.1, 0.2}), north = at2("000", {0.3, 0.4}),
             up = at2("UP", {0.5, 0.6});
  for (const std::vector<RecordFile>& files :
       {std::vector<RecordFile>{{east}, {north}, {up}}, {{up}, {north}, {east}}}) {
    const Record record = read_record(files);
    EXPECT_EQ(record[Direction::kH1]->name, "090");
    EXPECT_EQ(record[Direction::kH2]->name, "000");
    EXPECT_EQ(record[Direction::kVertical]->name, "UP");
    EXPECT_THAT(record.warnings, IsEmpty());
  }
  // 318 degrees is clockwise from 228, so 318 is h1 and 228 lies counter-clockwise from it.
  const Record oblique = read_record({{at2("228", {0.1, 0.2})}, {at2("318", {0.3, 0.4})}});
  EXPECT_EQ(oblique[Direction::kH1]->name, "318");
  EXPECT_EQ(oblique[Direction::kH2]->name, "228");
  // Across north: 010 lies clockwise from 280.
  const Record across = read_record({{at2("280", {0.1, 0.2})}, {at2("010", {0.3, 0.4})}});
  EXPECT_EQ(across[Direction::kH1]->name, "010");
}

TEST_F(ReadRecord, WarnsOfAMirrorImageAndOfUnknownDirections) {
  EXPECT_THAT(read_record({{at2("228", {0.1, 0.2}), Direction::kH1},
                           {at2("318", {0.3, 0.4}), Direction::kH2}})
                  .warnings,
              ElementsAre(HasSubstr("azimuths of 228 and 318 degrees (clockwise from north), but "
                                    "h2 lies 90 degrees counter-clockwise from h1")));
  EXPECT_THAT(
      read_record({{at2("L", {0.1, 0.2})}, {at2("T", {0.3, 0.4})}}).warnings,
      ElementsAre(HasSubstr("the directions of 'L' and 'T' are not known; they are taken as h1")));
}

TEST_F(ReadRecord, RefusesThreeHorizontalsNearlyParallelOnesAndAbsentChannels) {
  const auto a = at2("090", {0.1, 0.2}), b = at2("000", {0.1, 0.3}), c = at2("060", {0.1, 0.4});
  EXPECT_THAT(error_text([&] {
                read_record({{a}, {b}, {c}});
              }),
              HasSubstr("3 horizontal components ('090', '000', '060'); a record has two"));
  EXPECT_THAT(error_text([&] {
                read_record({{a}, {at2("075", {0.1, 0.5})}});
              }),
              HasSubstr("the horizontals have azimuths of 090 and 075 degrees, less than 30"));
  EXPECT_EQ(error_text([&] {
              read_record({{a, Direction::kH1, 2}});
            }),
            a.string() + ": channel 2 was asked for, the file has 1 to 1");
}

TEST_F(ReadRecord, TakesChannelsOfOneFile) {
  const auto csv = file("r.csv", "time_s,x_g,y_g\n0,0.1,0.2\n0.1,0.3,0.5\n");
  const Record record = read_record({{csv, {}, 2}});
  EXPECT_FALSE(record[Direction::kH1]);
  EXPECT_DOUBLE_EQ(record[Direction::kH2]->acceleration[1], 0.5 * kStandardGravity);
}

TEST_F(ReadRecord, KeepsTheWarningsOfTheFiles) {
  const auto csv = file("r.csv", "time_s,x_g\n0.1,0.1\n0.2,0.3\n");
  EXPECT_THAT(read_record({{csv, {}}}).warnings, ElementsAre(HasSubstr("the first time is 0.1 s")));
}

TEST(Structures, AreKnownByThePlaceOfTheirSensor) {
  const auto structure = [](const char* name, const char* value) {
    Component component;
    component.header.emplace_back(name, value);
    return structure_of(component);
  };
  EXPECT_EQ(structure("location", "Roof - N wall"), "Roof - N wall");
  EXPECT_EQ(structure("location", "a building, floor 12"), "a building, floor 12");
  EXPECT_EQ(structure("location", "Bent 4: North Column, Grnd Level"),
            "Bent 4: North Column, Grnd Level");
  EXPECT_EQ(structure("structure", "a bridge"), "a bridge");
  EXPECT_EQ(structure("station", "Sylmar - 6-story Hospital Bldg"),
            "Sylmar - 6-story Hospital Bldg");
  for (const char* ground : {"Free Field", "FF - near the bridge", "Ground level"})
    EXPECT_EQ(structure("location", ground), "") << ground;
  for (const char* ground : {"Pacoima Dam - Downstream", "Sylmar - 6-story Bldg FF"})
    EXPECT_EQ(structure("station", ground), "") << ground;
}

TEST_F(ReadRecord, WarnsOfAMotionOfAStructure) {
  // Two lines of the header of a synthetic component of CSMNC name what is needed.
  const auto path = file("a.txt",
                         "SYNTHETIC\nSTATION: 7 story Bldg\nCOMP. EW\nUNIT: CM/SEC/SEC\n"
                         "NO. OF POINTS: 4  EQUALLY SPACED INTERVALS OF: 0.01\n1.0 -2.0 1.0 2.0\n");
  EXPECT_THAT(read_record(std::vector{RecordFile{.path = path}}).warnings,
              Contains("the sensor is in a structure ('7 story Bldg'): a motion of the structure, "
                       "not of the ground"));
}

}  // namespace
}  // namespace gurney::groundmotions
