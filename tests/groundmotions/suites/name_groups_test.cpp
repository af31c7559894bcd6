#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>

#include "groundmotions/assembly/read_record.h"
#include "groundmotions/suites/suite.h"
#include "tests/groundmotions/formats/array_samples.h"
#include "tests/support/error_text.h"
#include "tests/support/temp_folder.h"

namespace gurney::groundmotions {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A plain table of times and accelerations; each name gives other samples.
std::string table(const std::string& name, int samples = 200, double step = 0.01) {
  double phase = 0;
  for (const char c : name) phase += 0.37 * c;
  std::string text = "time (s)  acc (g)\n";
  for (int i = 0; i < samples; ++i)
    text += fmt::format("{:.3f} {:.6f}\n", i * step, 0.2 * std::sin(0.3 * i + phase));
  return text;
}

/// `name: h1 h2 vertical`, the files of the components; - for none.
std::vector<std::string> motions(const Suite& suite) {
  std::vector<std::string> result;
  for (const SuiteRecord& entry : suite.records) {
    const Record record = read_record(entry);
    std::string text = entry.name + ":";
    for (const auto& each : record.components)
      text += each ? " " + std::filesystem::path(each->file).filename().string() : " -";
    result.push_back(text);
  }
  return result;
}

class NameGroups : public testing::Test {
 protected:
  void write(const std::vector<std::string>& names) {
    for (const std::string& name : names) folder_.write(name, table(name));
  }
  std::vector<std::string> found(const std::vector<std::string>& names) {
    write(names);
    return motions(read_suite({folder_.path()}));
  }
  Record read(const std::string& name, std::optional<Direction> direction = {}) const {
    return read_record(std::vector{RecordFile{.path = folder_.file(name), .direction = direction}});
  }
  const TempFolder folder_;
};

struct Style {
  std::vector<std::string> files;  ///< h1, h2, vertical
  std::string name;
};

class NameStyles : public testing::TestWithParam<Style> {};

// E and N by their azimuths, others in the order of their names; by folder and by files alike.
TEST_P(NameStyles, MakeOneRecord) {
  const TempFolder folder;
  std::vector<RecordFile> files;
  for (const std::string& name : GetParam().files) {
    folder.write(name, table(name));
    files.insert(files.begin(), RecordFile{folder.file(name)});
  }
  const auto base = [](const std::string& path) {
    return std::filesystem::path(path).filename().string();
  };
  const auto& all = GetParam().files;
  const std::string vertical = all.size() > 2 ? base(all[2]) : "-";
  const Suite suite = read_suite({folder.path()});
  EXPECT_THAT(motions(suite), ElementsAre(fmt::format("{}: {} {} {}", GetParam().name, base(all[0]),
                                                      base(all[1]), vertical)));
  EXPECT_THAT(suite.warnings, IsEmpty());
  const Record stated = read_record(files);
  EXPECT_EQ(base(stated[Direction::kH1]->file), base(all[0]));
  EXPECT_EQ(base(stated[Direction::kH2]->file), base(all[1]));
  if (all.size() > 2) {
    EXPECT_EQ(base(stated[Direction::kVertical]->file), vertical);
  }
  EXPECT_THAT(stated.warnings, testing::Contains(HasSubstr("taken from the file's name")));
}

INSTANTIATE_TEST_SUITE_P(
    All, NameStyles,
    testing::Values(
        Style{{"S1_E.acc", "S1_N.acc", "S1_Z.acc"}, "S1"},
        Style{{"S_EW.txt", "S_NS.txt", "S_UD.txt"}, "S"}, Style{{"S.EW", "S.NS", "S.UD"}, "S"},
        Style{{"S.E", "S.N", "S.Z"}, "S"}, Style{{"S_E-W.txt", "S_N-S.txt", "S_U-D.txt"}, "S"},
        Style{{"eq1_X.dat", "eq1_Y.dat", "eq1_Z.dat"}, "eq1"},
        Style{{"eq1_x.dat", "eq1_y.dat", "eq1_V.dat"}, "eq1"},
        Style{{"gacc_N_x.txt", "gacc_N_y.txt"}, "gacc_N"},
        Style{{"a_H1.txt", "a_H2.txt", "a_V.txt"}, "a"},
        Style{{"a_FN.txt", "a_FP.txt", "a_UP.txt"}, "a"},
        Style{{"GM7/H1.txt", "GM7/H2.txt", "GM7/V.txt"}, "GM7"},
        Style{{"GM7/EW.txt", "GM7/NS.txt", "GM7/UD.txt"}, "GM7"},
        Style{{"GM1_X.txt", "GM1_Y.txt"}, "GM1"}, Style{{"GM1X.txt", "GM1Y.txt"}, "GM1"},
        Style{{"120111.th", "120112.th"}, "12011"},
        Style{{"SortedEQFile_(120111).txt", "SortedEQFile_(120112).txt"}, "SortedEQFile_(12011)"},
        Style{{"12_COOLWATERLN.txt", "12_COOLWATERTR.txt"}, "12_COOLWATER"},
        Style{{"15_ABBARL.txt", "15_ABBART.txt"}, "15_ABBAR"},
        Style{{"19_CHY101E.txt", "19_CHY101N.txt"}, "19_CHY101"},
        Style{{"1_MULHOLLAND009.txt", "1_MULHOLLAND279.txt"}, "1_MULHOLLAND"},
        Style{{"H1_rec12.txt", "H2_rec12.txt", "V_rec12.txt"}, "rec12"},
        Style{{"r_EW_acc.txt", "r_NS_acc.txt", "r_UD_acc.txt"}, "r_acc"},
        Style{{"ST.HNE.txt", "ST.HNN.txt", "ST.HNZ.txt"}, "ST"},
        Style{{"ST.HN1.txt", "ST.HN2.txt", "ST.HNZ.txt"}, "ST"},
        Style{{"EQ/long.txt", "EQ/trans.txt", "EQ/vert.txt"}, "EQ"}));

TEST_F(NameGroups, KeepTwoEventsOfOneFolderApart) {
  EXPECT_THAT(found({"A_E.txt", "A_N.txt", "A_Z.txt", "B_E.txt", "B_N.txt", "120111.th",
                     "120112.th", "120121.th", "120122.th", "run001.txt", "run002.txt"}),
              ElementsAre("12011: 120111.th 120112.th -", "12012: 120121.th 120122.th -",
                          "A: A_E.txt A_N.txt A_Z.txt", "B: B_E.txt B_N.txt -",
                          "run001: run001.txt - -", "run002: run002.txt - -"));
}

TEST_F(NameGroups, JoinNoNumbersAndNoLettersThatCount) {
  EXPECT_THAT(found({"gm1.txt", "gm2.txt", "gm3.txt", "acc_1.txt", "acc_2.txt"}).size(), 5u);
  write({"c/recD.txt", "c/recE.txt", "c/recF.txt", "c/recN.txt"});
  EXPECT_EQ(read_suite({folder_.file("c")}).records.size(), 4u);
  write({"d/120111.th", "d/120112.th", "d/120113.th"});
  EXPECT_EQ(read_suite({folder_.file("d")}).records.size(), 3u);
  write({"e/120121.txt", "e/120211.txt"});  // 121 and 211 degrees by chance
  EXPECT_EQ(read_suite({folder_.file("e")}).records.size(), 2u);
  write({"f/A_E.txt", "f/B_N.txt"});
  EXPECT_EQ(read_suite({folder_.file("f")}).records.size(), 2u);
}

TEST_F(NameGroups, PointToAListWhereTheyDoNotFit) {
  folder_.write("a/S_E.txt", table("e"));
  folder_.write("a/S_N.txt", table("n", 200, 0.02));
  folder_.write("a/S_Z.txt", table("z"));
  Suite suite = read_suite({folder_.file("a")});
  EXPECT_THAT(motions(suite),
              ElementsAre("S_E: S_E.txt - -", "S_N: S_N.txt - -", "S_Z: - - S_Z.txt"));
  EXPECT_THAT(suite.warnings, ElementsAre(testing::AllOf(
                                  HasSubstr("S_E.txt"), HasSubstr("time steps of 0.01 and 0.02 s"),
                                  HasSubstr("a list with the columns name, h1, h2, vertical"))));
  folder_.write("b/S_E.txt", table("e"));
  folder_.write("b/S_N.txt", table("n", 180));
  suite = read_suite({folder_.file("b")});
  EXPECT_EQ(suite.records.size(), 2u);
  EXPECT_THAT(suite.warnings, ElementsAre(HasSubstr("180 and 200 samples")));
  write({"c/S_E.txt", "c/S_EW.txt", "c/S_N.txt"});
  suite = read_suite({folder_.file("c")});
  EXPECT_EQ(suite.records.size(), 3u);
  EXPECT_THAT(suite.warnings, ElementsAre(HasSubstr("more than one file for a direction")));
  folder_.write("d/S_E.txt", table("e"));
  folder_.write("d/S_N.txt", table("n", 199));  // 0.5 % fewer
  EXPECT_EQ(read_suite({folder_.file("d")}).records.size(), 1u);
}

TEST_F(NameGroups, AreAVerticalAlone) {
  for (const char* name : {"X_UP.txt", "X_UD.txt", "X_Z.acc", "X-V.txt", "X_vert.txt", "X.UD",
                           "C05UP.txt", "X_Z_acc.txt", "UP.txt", "X_DWN.txt", "UD_X.txt"}) {
    folder_.write(name, table(name));
    const Record record = read(name);
    EXPECT_TRUE(record[Direction::kVertical]) << name;
    EXPECT_FALSE(record[Direction::kH1]) << name;
  }
  for (const char* name : {"backup.txt", "group.txt", "quiz.txt", "X_E.txt", "X_A.txt"}) {
    folder_.write(name, table(name));
    EXPECT_TRUE(read(name)[Direction::kH1]) << name;
  }
  const Record turned = read("X_DWN.txt");
  EXPECT_THAT(turned.warnings, testing::Contains(HasSubstr("points down")));
  EXPECT_THAT(read("X_UP.txt", Direction::kH1).warnings,
              testing::Contains(HasSubstr("the file's name says 'UP', a vertical")));
}

TEST_F(NameGroups, NameFilesThatAreThereTwice) {
  folder_.write("a.txt", table("a"));
  folder_.write("b.txt", table("a"));
  EXPECT_THAT(read_suite({folder_.path()}).warnings,
              ElementsAre(testing::AllOf(HasSubstr("a.txt"), HasSubstr("b.txt"),
                                         HasSubstr("are the same file, byte by byte"))));
}

// "SN1" and "SN2" within a word are no channels.
TEST_F(NameGroups, TakeNoChannelCodeOutOfAWord) {
  EXPECT_THAT(found({"RSN1_UP.txt", "RSN2_UP.txt"}),
              ElementsAre("RSN1_UP: - - RSN1_UP.txt", "RSN2_UP: - - RSN2_UP.txt"));
}

TEST_F(NameGroups, EndWithTheirComponent) {
  write({"vertical_park_NS.txt", "UP_station_EW.txt", "sismo_EO.txt", "sismo_NS.txt"});
  EXPECT_FALSE(read("vertical_park_NS.txt")[Direction::kVertical]);
  EXPECT_FALSE(read("UP_station_EW.txt")[Direction::kVertical]);
  EXPECT_THAT(motions(read_suite({folder_.path()})),
              testing::Contains("sismo: sismo_EO.txt sismo_NS.txt -"));
}

}  // namespace
}  // namespace gurney::groundmotions
