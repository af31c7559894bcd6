#include "groundmotions/suites/grouping.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "groundmotions/suites/folder_suite.h"
#include "groundmotions/suites/suite.h"
#include "tests/groundmotions/formats/array_samples.h"
#include "tests/groundmotions/formats/network_samples.h"
#include "tests/support/error_text.h"
#include "tests/support/temp_folder.h"

namespace gurney::groundmotions {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// @param component  last field of the second line
std::string at2(const std::string& component, const std::string& station = "Y") {
  return fmt::format(
      "PEER NGA STRONG MOTION DATABASE RECORD\nX, 1/2/2003, {}, {}\n"
      "ACCELERATION TIME SERIES IN UNITS OF G\nNPTS= 3, DT= .01 SEC\n .1 -.1 .{}\n",
      station, component, component.size());
}

/// @param dir  as NIED writes it: "E-W" of K-NET, "1" to "6" of KiK-net
std::string knet(const std::string& dir) {
  return "Origin Time       2001/02/03 04:05:00\nLat.              35.1\nLong.             136.2\n"
         "Depth. (km)       12\nMag.              5.5\nStation Code      XYZ001\n"
         "Station Lat.      35.3\nStation Long.     136.4\nStation Height(m) 7\n"
         "Record Time       2001/02/03 04:05:20\nSampling Freq(Hz) 10Hz\nDuration Time(s)  1\n"
         "Dir.              " +
         dir +
         "\nScale Factor      2(gal)/400\nMax. Acc. (gal)   0.200\n"
         "Last Correction   2001/02/03 04:00:00\nMemo.             \n"
         "      100      110       90      140       60       95      105      100 \n"
         "      120       80 \n";
}

/// "name: file file" of each record.
std::vector<std::string> contents(const Suite& suite) {
  std::vector<std::string> result;
  for (const SuiteRecord& record : suite.records) {
    std::string text = record.name + ":";
    for (const RecordFile& file : record.files)
      text += " " + file.path.filename().string() +
              (file.channel ? fmt::format("#{}", *file.channel) : "");
    result.push_back(text);
  }
  return result;
}

class Grouping : public testing::Test {
 protected:
  Suite suite() const { return read_suite({folder_.path()}); }
  const TempFolder folder_;
};

TEST_F(Grouping, KnowsStationsThatEndInDigitsAndWordsThatTouchThem) {
  EXPECT_EQ(name_without_component("RSN30_PARKF_C05085.AT2", "085"), "RSN30_PARKF_C05*.AT2");
  EXPECT_EQ(name_without_component("RSN1_X_STADWN.AT2", "DWN"), "RSN1_X_STA*.AT2");
  EXPECT_EQ(name_of_pattern("RSN30_PARKF_C05*.AT2"), "RSN30_PARKF_C05");
  EXPECT_EQ(name_of_pattern("HI.ARS1.*.ASC"), "HI.ARS1");  // HNE, HNN, HNZ
  for (const auto& [file, component] : {std::pair{"X10050", "50"},
                                        {"X10140", "140"},
                                        {"X10-UP", "UP"},  // digits touch digits
                                        {"B_STA021", "N21E"},
                                        {"B_STA111", "S69E"},
                                        {"B_STADWN", "DWN"}})  // letters, bearings
    folder_.write(file + std::string(".AT2"), at2(component, std::string(file).substr(0, 5)));
  EXPECT_THAT(contents(suite()), ElementsAre("B_STA: B_STA021.AT2 B_STA111.AT2 B_STADWN.AT2",
                                             "X10: X10-UP.AT2 X10050.AT2 X10140.AT2"));
  EXPECT_TRUE(read_record(suite().records[0])[Direction::kVertical]);
}

// Names that do not contain the component, event and station with other blanks and capitals.
TEST_F(Grouping, JoinsTheVerticalByEventAndStation) {
  folder_.write("a1.AT2", at2("090", "Town  Hall"));
  folder_.write("a2.AT2", at2("000", "TOWN HALL"));
  folder_.write("a3.AT2", at2("UP", "Town Hall "));
  EXPECT_THAT(contents(suite()), ElementsAre("a1 + a2 + a3: a1.AT2 a2.AT2 a3.AT2"));
}

// A second copy of one component leaves the pair of like names together.
TEST_F(Grouping, LeavesACopyAlone) {
  folder_.write("RSN6_1.AT2", at2("180"));
  folder_.write("RSN6_2.AT2", at2("270"));
  folder_.write("RSN6_IMPVALL.I_I-ELC180.AT2", at2("180"));
  EXPECT_THAT(contents(suite()),
              ElementsAre("RSN6: RSN6_1.AT2 RSN6_2.AT2",
                          "RSN6_IMPVALL.I_I-ELC180: RSN6_IMPVALL.I_I-ELC180.AT2"));
}

TEST_F(Grouping, PartsBoreholeAndSurfaceOfKikNet) {
  for (const auto& [name, dir] : {std::pair{"NS1", "1"},
                                  {"EW1", "2"},
                                  {"UD1", "3"},
                                  {"NS2", "4"},
                                  {"EW2", "5"},
                                  {"UD2", "6"}})
    folder_.write(std::string("XYZ0010102030405.") + name, knet(dir));
  EXPECT_THAT(contents(suite()),
              ElementsAre("XYZ0010102030405 borehole: XYZ0010102030405.EW1 XYZ0010102030405.NS1 "
                          "XYZ0010102030405.UD1",
                          "XYZ0010102030405 surface: XYZ0010102030405.EW2 XYZ0010102030405.NS2 "
                          "XYZ0010102030405.UD2"));
  EXPECT_THAT(error_text([&] {
                read_record({{folder_.file("XYZ0010102030405.EW1")},
                             {folder_.file("XYZ0010102030405.NS2")}});
              }),
              HasSubstr("the components are of 2 places or instruments: 'EW1' at 'BOREHOLE', "
                        "'NS2' at 'SURFACE'; one record is of one place"));
}

TEST_F(Grouping, PartsChannelsOfSeveralPlaces) {
  const auto channel = [](int number, const char* label, const char* place) {
    return csmip_volume1(
        {.label = fmt::format("CHAN  {}: {}   Location: {}", number, label, place), .code = 0});
  };
  const auto path = folder_.write(
      "building.V1", channel(1, "UP", "Ground") + channel(2, "90 DEG", "Ground") +
                         channel(3, "360 DEG", "ground ") + channel(4, "90 DEG", "Roof,  N wall") +
                         channel(5, "90 DEG", "Roof, S wall"));
  EXPECT_THAT(
      contents(suite()),
      ElementsAre("building Ground: building.V1#1 building.V1#2 building.V1#3",
                  "building Roof, N wall: building.V1#4", "building Roof, S wall: building.V1#5"));
  EXPECT_EQ(read_record(suite().records[0])[Direction::kH2]->name, "360 DEG");
  EXPECT_EQ(read_record(suite().records[2])[Direction::kH1]->name, "90 DEG");
  EXPECT_THAT(
      error_text([&] { read_record({RecordFile{.path = path}}); }),
      HasSubstr("say which by --columns (tables of plain text) or by `channels` in a list"));

  folder_.write("list.csv", "name,file,channels\nground,building.V1,1;2;3\nroof,building.V1,4\n");
  const Suite list = read_suite({folder_.file("list.csv")});
  EXPECT_THAT(contents(list), ElementsAre("ground: building.V1#1 building.V1#2 building.V1#3",
                                          "roof: building.V1#4"));
  folder_.write("list.csv", "name,file,channels\nx,building.V1,1.5\n");
  EXPECT_THAT(error_text([&] { read_suite({folder_.file("list.csv")}); }),
              HasSubstr("list.csv:2:15: channels must be whole numbers from 1 to 1000"));
}

// Channels of a structure without a place each: which belong together is not known.
TEST_F(Grouping, GivesEachChannelOfAnArrayWithoutPlaces) {
  std::string text;
  for (const char* label : {"90 DEG", "90 DEG", "90 DEG", "UP"})
    text += csmip_volume1({.label = std::string("CHAN  1: ") + label, .code = 0});
  folder_.write("bridge.V1", text);
  EXPECT_THAT(contents(suite()), ElementsAre("bridge channel 1 (90 DEG): bridge.V1#1",
                                             "bridge channel 2 (90 DEG): bridge.V1#2",
                                             "bridge channel 3 (90 DEG): bridge.V1#3",
                                             "bridge channel 4 (UP): bridge.V1#4"));
}

TEST_F(Grouping, JoinsSmcFilesWithOtherBlanks) {
  folder_.write("0111a.smc", smc_file({.component = "    360", .integers = {{14, 360}}}));
  folder_.write("0111b.smc", smc_file({.component = "   up", .integers = {{13, 0}, {14, 0}}}));
  folder_.write("0111c.smc", smc_file({.component = " 270", .integers = {{14, 270}}}));
  EXPECT_THAT(contents(suite()), ElementsAre("0111: 0111a.smc 0111b.smc 0111c.smc"));
}

// FEMA P-695 as plain text: only the names say the directions. Run numbers are no azimuths.
TEST_F(Grouping, TakesAzimuthsFromNamesOnlyAtARightAngle) {
  const std::string text = "time (s)  acc (g)\n0.00 0.1\n0.01 0.2\n0.02 -0.1\n";
  for (const char* name : {"KOBE_NIS000.txt", "KOBE_NIS090.txt", "run001.txt", "run002.txt"})
    folder_.write(name, text);
  EXPECT_THAT(contents(suite()), ElementsAre("KOBE_NIS: KOBE_NIS000.txt KOBE_NIS090.txt",
                                             "run001: run001.txt", "run002: run002.txt"));
  const Record record = read_record(suite().records[0]);
  EXPECT_THAT(record[Direction::kH1]->file, HasSubstr("NIS090"));  // east is h1, north h2
  EXPECT_THAT(record.warnings, testing::Contains(HasSubstr("taken from the file's name")));
  EXPECT_EQ(
      read_record({{folder_.file("KOBE_NIS000.txt")}, {folder_.file("KOBE_NIS090.txt")}}).name,
      "KOBE_NIS");
}

TEST_F(Grouping, PassesOverVelocitiesBesideTheirAcceleration) {
  folder_.write("R_X090.AT2", at2("090"));
  folder_.write("R_X000.AT2", at2("000"));
  for (const char* name : {"R_X090.VT2", "R_X090.DT2", "R_X000.vt2"})
    folder_.write(name, "velocity\n");
  const Suite found = suite();
  EXPECT_THAT(contents(found), ElementsAre("R_X: R_X000.AT2 R_X090.AT2"));
  EXPECT_THAT(found.refused, IsEmpty());
  EXPECT_THAT(found.notes, ElementsAre("3 files of velocity or displacement beside their "
                                       "acceleration: not needed, skipped"));
  folder_.write("alone.VT2", "velocity\n");
  EXPECT_EQ(suite().refused.size(), 1u);
}

TEST(Companions, KnowsTheSpellings) {
  std::vector<std::filesystem::path> files = {"x/1.acc",       "x/1.vel",       "x/1.DIS",
                                              "x/S.ACC.ASC",   "x/S.VEL.ASC",   "y/1.vel",
                                              "x/S.ACC.D.V2c", "x/S.dis.d.v2c", "x/level.txt"};
  EXPECT_EQ(drop_companions(files), 4u);
  EXPECT_THAT(files,
              ElementsAre("x/1.acc", "x/S.ACC.ASC", "y/1.vel", "x/S.ACC.D.V2c", "x/level.txt"));
}

TEST_F(Grouping, TakesPatterns) {
  folder_.write("recs/R_X090.AT2", at2("090"));
  folder_.write("recs/R_X000.AT2", at2("000"));
  folder_.write("recs/notes.txt", "nothing\n");
  EXPECT_THAT(contents(read_suite({folder_.file("recs/*.AT2")})),
              ElementsAre("R_X: R_X000.AT2 R_X090.AT2"));
  EXPECT_THAT(contents(read_suite({folder_.file("re?s")})),
              ElementsAre("R_X: R_X000.AT2 R_X090.AT2"));
  EXPECT_EQ(error_text([&] { read_suite({folder_.file("*.at9")}); }),
            folder_.file("*.at9") + ": no file or folder has a name of this pattern");
}

}  // namespace
}  // namespace gurney::groundmotions
