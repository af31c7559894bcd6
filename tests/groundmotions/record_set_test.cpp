#include "groundmotions/record_set.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <unistd.h>

#include <fstream>

#include "engine/base/units.h"
#include "tests/support/error_text.h"

namespace gurney {
namespace {

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

TEST_F(ReadRecord, RefusesDifferentTimeSteps) {
  const auto h1 = at2("090", {0.1, 0.2}, 0.01), h2 = at2("000", {0.1, 0.2}, 0.02);
  EXPECT_EQ(error_text([&] {
              read_record({{h1, Direction::kH1}, {h2, Direction::kH2}});
            }),
            "components of one record must have one time step: " + h1.string() + " has 0.01 s, " +
                h2.string() + " has 0.02 s");
}

TEST_F(ReadRecord, RefusesNoPlaceTwoPlacesAndWrongPlaces) {
  const auto a = at2("090", {0.1, 0.2}), b = at2("000", {0.1, 0.2});
  const auto csv = file("r.csv", "time_s,x_g,y_g\n0,0.1,0.2\n0.1,0.3,0.4\n");
  const auto one = file("one.csv", "time_s,x_g\n0,0.1\n0.1,0.3\n");
  EXPECT_EQ(error_text([] { read_record({}); }),
            "a record needs at least one component: h1, h2 or vertical");
  EXPECT_EQ(error_text([&] {
              read_record({{a, {}}});
            }),
            a.string() + ": the file does not say whether it is h1, h2 or vertical; state it");
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
            one.string() + ": given as vertical, but its column x_g is h1");
}

TEST_F(ReadRecord, TellsTheMistakesOfAllFiles) {
  const auto bad = file("bad.AT2", "nonsense\n");
  EXPECT_THAT(error_text([&] {
                read_record({{folder_ / "none.AT2", Direction::kH1}, {bad, Direction::kH2}});
              }),
              testing::AllOf(HasSubstr((folder_ / "none.AT2").string() + ": no such file\n" +
                                       bad.string() + ":1:1: not a record in a known format ("),
                             HasSubstr("; the file starts with 'nonsense'")));
}

TEST_F(ReadRecord, RefusesARecordThatIsAllZero) {
  EXPECT_EQ(error_text([&] {
              read_record({{at2("090", {0, 0, 0}), Direction::kH1}});
            }),
            "090: all accelerations of the record are zero");
  const Record record = read_record(
      {{at2("090", {0, 0, 0}), Direction::kH1}, {at2("000", {0, 1, 0}), Direction::kH2}});
  EXPECT_THAT(record.warnings, ElementsAre(HasSubstr("the h1 component is all zero")));
}

TEST_F(ReadRecord, WarnsOfPlacesAnglesAndPeaks) {
  EXPECT_THAT(error_text([&] {
                read_record({{at2("UP", {0.1, 0.2}), Direction::kH1}});
              }),
              HasSubstr("given as h1, but its column UP is vertical"));
  EXPECT_THAT(read_record({{at2("090", {0.1, 0.2}), Direction::kVertical}}).warnings,
              ElementsAre(HasSubstr("calls this component '090', it is used as vertical")));
  EXPECT_THAT(read_record({{at2("090", {0.1, 0.2}), Direction::kH1},
                           {at2("060", {0.1, 0.2}), Direction::kH2}})
                  .warnings,
              ElementsAre(HasSubstr("azimuths of 90 and 60 degrees, which is no right angle")));
  EXPECT_THAT(
      read_record({{at2("090", {0.1, 98.1}), Direction::kH1}}).warnings,
      ElementsAre(HasSubstr("the peak acceleration of h1 is 98.1 g, outside 0.001 to 3 g")));
}

TEST_F(ReadRecord, KeepsTheWarningsOfTheFiles) {
  const auto csv = file("r.csv", "time_s,x_g\n0.1,0.1\n0.2,0.3\n");
  EXPECT_THAT(read_record({{csv, {}}}).warnings, ElementsAre(HasSubstr("the first time is 0.1 s")));
}

}  // namespace
}  // namespace gurney
