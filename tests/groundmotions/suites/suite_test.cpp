#include "groundmotions/suites/suite.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "groundmotions/suites/grouping.h"
#include "tests/support/error_text.h"
#include "tests/support/temp_folder.h"

namespace gurney::groundmotions {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Pair;

std::string at2(const std::string& component, const std::string& station = "Y") {
  return fmt::format(
      "PEER NGA STRONG MOTION DATABASE RECORD\nX, 1/2/2003, {}, {}\n"
      "ACCELERATION TIME SERIES IN UNITS OF G\nNPTS= 3, DT= .01 SEC\n .1 -.1 .{}\n",
      station, component, component.size());
}

std::vector<std::string> names(const Suite& suite) {
  std::vector<std::string> result;
  for (const SuiteRecord& record : suite.records)
    result.push_back(fmt::format("{}:{}", record.name, record.files.size()));
  return result;
}

TEST(FolderSuite, KnowsTheNameWithoutTheComponent) {
  EXPECT_EQ(name_without_component("RSN1_A_RRS228.AT2", "228"), "RSN1_A_RRS*.AT2");
  EXPECT_EQ(name_without_component("RSN1_A_RRS-UP.AT2", "UP"), "RSN1_A_RRS*.AT2");
  EXPECT_EQ(name_without_component("ABC0012401010101.EW", "E-W"), "ABC0012401010101*");
  EXPECT_EQ(name_without_component("XX.ST..HNE.D.ASC", "HNE"), "XX.ST*.D.ASC");
  EXPECT_EQ(name_without_component("RSN1_A_NWH090.AT2", "90"), "RSN1_A_NWH*.AT2");
  EXPECT_EQ(name_without_component("RSN1_ABBAR--T.AT2", "T"), "RSN1_ABBAR*.AT2");
  EXPECT_EQ(name_without_component("RSN1_TCU065-E.AT2", "E"), "RSN1_TCU065*.AT2");
  EXPECT_EQ(name_without_component("STATION.000", "000"), "STATION*");
  EXPECT_EQ(name_without_component("--E-x.AT2", "E"), "--*-x.AT2") << "nothing else is before it";
  EXPECT_EQ(name_without_component("first.AT2", "090"), "");
  EXPECT_EQ(name_without_component("EAST.AT2", "E"), "");
  EXPECT_EQ(name_without_component("RSN1090_X.AT2", "090"), "");
  EXPECT_EQ(name_without_component("14383980_13849090.AT2", "90"), "14383980_13849*.AT2");
}

TEST(FolderSuite, GroupsFilesByNameAndByHeader) {
  const TempFolder folder;
  for (const char* component : {"090", "000", "UP"})
    folder.write(fmt::format("a/RSN1_X_ST{}{}.AT2", component[0] == 'U' ? "-" : "", component),
                 at2(component));
  folder.write("b/one.AT2", at2("090", "Z"));
  folder.write("b/two.AT2", at2("000", "Z"));
  folder.write("b/other.AT2", at2("000", "W"));
  folder.write("b/notes.txt", "nothing to read\n");
  folder.write(".hidden/x.AT2", at2("000"));
  const Suite suite = read_suite({folder.path()});
  EXPECT_THAT(names(suite), ElementsAre("RSN1_X_ST:3", "one + two:2", "other:1"));
  ASSERT_EQ(suite.refused.size(), 1u);
  EXPECT_THAT(suite.refused[0].file, HasSubstr("notes.txt"));
  EXPECT_THAT(suite.refused[0].reason, HasSubstr("not a record in a known format"));
  const Record record = read_record(suite.records[0]);
  EXPECT_EQ(record.name, "RSN1_X_ST");
  EXPECT_EQ(record[Direction::kH1]->name, "090");
}

const std::string kReport =
    "\n PEER Ground Motion Database, Time Series Search Report\n\n"
    " -- Summary of Metadata of Selected Records --\n"
    "Result ID, Record Sequence Number, Scale Factor, Tp-Pulse Period (sec), Station Name, "
    "Horizontal-1 Acc. Filename, Horizontal-2 Acc. Filename, Vertical Acc. Filename\n"
    "1, 11, 1.5, -, \"A, B\", RSN11_E.AT2, RSN11_N.AT2 , RSN11_V.AT2  \n"
    "2, 12, 1.0, 3.5, C, RSN12_E.AT2, RSN12_N.AT2, - \n"
    "3, 13, 1.0, -, D, RSN13_E.AT2, RSN13_N.AT2, RSN13_V.AT2\n\n"
    " -- Scaled Spectra --\nPeriod (sec), pSa\n0.1, 1\n";

TEST(PeerSearchResults, DrivesASuite) {
  const TempFolder folder;
  const auto report = folder.write("_SearchResults.csv", kReport);
  for (const char* name : {"RSN11_E", "RSN12_E"})
    folder.write(name + std::string(".AT2"), at2("090"));
  for (const char* name : {"RSN11_N", "RSN12_N"})
    folder.write(name + std::string(".AT2"), at2("000"));
  folder.write("RSN11_V.AT2", at2("UP"));
  for (const std::string& path : {report, folder.path()}) {
    const Suite suite = read_suite({path});
    EXPECT_THAT(names(suite), ElementsAre("RSN11:3", "RSN12:2"));
    EXPECT_THAT(suite.records[0].facts, ElementsAre(Pair("RSN", "11"), Pair("station", "A, B"),
                                                    Pair("scale factor of the search", "1.5")));
    EXPECT_EQ(suite.records[0].scale, 1);
    EXPECT_THAT(suite.refused, IsEmpty());
    EXPECT_THAT(suite.notes,
                ElementsAre(report + ": the files of 1 of its 3 records are not in the folder: "
                                     "RSN13"));
    EXPECT_EQ(read_record(suite.records[0])[Direction::kVertical]->name, "UP");
  }
}

TEST(PeerSearchResults, RefusesARecordOfWhichAFileIsAbsentAndAReportWithoutAny) {
  const TempFolder folder;
  const auto report = folder.write("_SearchResults.csv", kReport);
  Suite suite = read_suite({report});
  ASSERT_EQ(suite.refused.size(), 1u);
  EXPECT_EQ(
      text_of(suite.refused[0]),
      report + ": the files of 3 of its 3 records are not in the folder: RSN11, RSN12, RSN13");
  folder.write("RSN11_E.AT2", at2("090"));
  folder.write("RSN11_N.AT2", at2("000"));
  suite = read_suite({report});
  ASSERT_EQ(suite.refused.size(), 1u);
  EXPECT_EQ(text_of(suite.refused[0]), "RSN11: RSN11_V.AT2 is not in the folder");
  EXPECT_EQ(suite.notes.size(), 1u);
}

TEST(PeerSearchResults, RefusesRowsThatAreCutAndTablesWithoutFileNames) {
  const TempFolder folder;
  const auto cut = folder.write("cut.csv", kReport.substr(0, kReport.find(", RSN12_N")) + "\n");
  folder.write("RSN11_E.AT2", at2("090"));
  const Suite suite = read_suite({cut});
  EXPECT_THAT(suite.records, IsEmpty());
  ASSERT_EQ(suite.refused.size(), 2u);
  EXPECT_THAT(suite.refused[1].reason, HasSubstr("cut.csv:7:1: 6 cells, the header has 8 columns"));
  const auto bare = folder.write(
      "bare.csv", " -- Summary of Metadata of Selected Records --\nResult ID, Year\n1,2\n");
  EXPECT_EQ(error_text([&] { read_suite({bare}); }),
            bare + ":2:1: no column 'Horizontal-1 Acc. Filename'");
}

TEST(ListSuite, ReadsRecordsWithTheirUnitsAndScales) {
  const TempFolder folder;
  folder.write("e.txt", "1\n-1\n2\n");
  folder.write("n.txt", "2\n-2\n1\n");
  const auto list =
      folder.write("list.csv",
                   "# comment\nname, h1, h2, unit, time_step_s, scale\n"
                   "first, e.txt, n.txt, m/s2, 0.01, 2\n\nsecond, n.txt, , g, 0.02,\n");
  const Suite suite = read_suite({list});
  EXPECT_THAT(names(suite), ElementsAre("first:2", "second:1"));
  const Record record = read_record(suite.records[0]);
  EXPECT_EQ(record[Direction::kH1]->acceleration, Eigen::Vector3d(2, -2, 4));
  EXPECT_THAT(record.processing, ElementsAre("scaled by 2, as the list says"));
  EXPECT_EQ(read_record(suite.records[1]).time_step(), 0.02);
}

TEST(ListSuite, TakesSeveralFilesThatPlaceThemselves) {
  const TempFolder folder;
  folder.write("n.AT2", at2("000"));
  folder.write("e.AT2", at2("090"));
  const auto list =
      folder.write("list.csv", "name,file,h1\n\"A, B\",n.AT2; e.AT2,\nC,,n.AT2\nD,e.AT2,n.AT2\n");
  EXPECT_EQ(error_text([&] { read_suite({list}); }),
            list + ":4:1: a record has files in 'file' or in 'h1', 'h2', 'vertical', not in both");
  folder.write("list.csv", "name,file,h1\n\"A, B\",n.AT2; e.AT2,\nC,,n.AT2\n");
  const Suite suite = read_suite({list});
  EXPECT_THAT(names(suite), ElementsAre("A, B:2", "C:1"));
  EXPECT_EQ(read_record(suite.records[0])[Direction::kH1]->name, "090");
}

TEST(ListSuite, ReportsEveryError) {
  const TempFolder folder;
  folder.write("e.txt", "1\n-1\n2\n");
  const auto list = folder.write("list.csv",
                                 "name, h1, units, scale\na, e.txt, g, 1\na, none.txt, ft, -1\n"
                                 "b, e.txt\n,e.txt,,\n");
  EXPECT_EQ(error_text([&] { read_suite({list}); }),
            fmt::format("{0}:1:11: unknown column 'units'; did you mean 'unit'?\n"
                        "{0}:3:1: the name 'a' comes twice\n"
                        "{0}:3:4: 'none.txt': no such file\n"
                        "{0}:3:18: scale '-1': must be a finite number > 0 and <= 1000000\n"
                        "{0}:4:1: 2 cells, the header has 4 columns\n"
                        "{0}:5:1: a record needs a name",
                        list));
}

TEST(ListSuite, RefusesAHeaderThatNamesNoFiles) {
  const TempFolder folder;
  const auto list = folder.write("list.csv", "name, unit\na, g\n");
  EXPECT_EQ(error_text([&] { read_suite({list}); }),
            list + ":1:1: a list needs a column 'file', or columns 'h1', 'h2', 'vertical'");
}

TEST(ListSuite, RefusesFoldersAndTimeStepsThatNoRecordHas) {
  const TempFolder folder;
  folder.write("e.txt", "1\n-1\n2\n");
  const auto list = folder.write("list.csv", "name, h1, time_step_s\na, ., 0.01\nb, e.txt, 1e-6\n");
  EXPECT_EQ(error_text([&] { read_suite({list}); }),
            fmt::format("{0}:2:4: '.': is a folder, a file is needed\n"
                        "{0}:3:11: time_step_s '1e-6': must be a finite number >= 1e-05 and <= 1",
                        list));
}

}  // namespace
}  // namespace gurney::groundmotions
