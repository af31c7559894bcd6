#include <gmock/gmock.h>

#include <algorithm>

#include "engine/base/units.h"
#include "groundmotions/formats/writers.h"
#include "tests/support/error_text.h"

namespace gurney::groundmotions {
namespace {

using testing::HasSubstr;

std::vector<Component> read(const std::string& text, const ReadOptions& options = {}) {
  return read_components(SourceFile("f.csv", text), options);
}

const std::string kThree =
    "# a comment\n"
    "time_s, x_m_per_s2, y_g, z_cm_per_s2\n"
    "0,    1.5, 0.1, 10\n"
    "\n"
    "0.01, -2,  0.2, 20\n"
    "0.02, +.5, 0.3, -3e1\n";

TEST(ColumnsCsv, ReadsThreeComponentsEachInItsUnit) {
  const auto components = read(kThree);
  ASSERT_EQ(components.size(), 3u);
  EXPECT_EQ(components[0].direction, Direction::kH1);
  EXPECT_EQ(components[1].direction, Direction::kH2);
  EXPECT_EQ(components[2].direction, Direction::kVertical);
  EXPECT_EQ(components[0].acceleration, Eigen::Vector3d(1.5, -2, 0.5));
  EXPECT_TRUE(
      components[1].acceleration.isApprox(Eigen::Vector3d(1, 2, 3) * 0.1 * kStandardGravity));
  EXPECT_TRUE(components[2].acceleration.isApprox(Eigen::Vector3d(0.1, 0.2, -0.3)));
  for (const Component& component : components) {
    EXPECT_EQ(component.time_step, 0.01);
    EXPECT_EQ(component.format, "columns CSV");
  }
}

TEST(ColumnsCsv, ReadsOneComponentWithoutAPlace) {
  const auto components = read("time_s,a_g\n0,0.1\n0.005,0.2\n");
  ASSERT_EQ(components.size(), 1u);
  EXPECT_FALSE(components[0].direction);
}

TEST(ColumnsCsv, RefusesUnknownDoubledAndMissingColumns) {
  EXPECT_EQ(error_text([] { read("time_s,x_m_per_s,y_g\n0,1,2\n1,2,3\n"); }),
            "f.csv:1:8: unknown column 'x_m_per_s'; did you mean 'x_m_per_s2'?");
  EXPECT_THAT(error_text([] { read("time_s,x_g,x_m_per_s2\n0,1,2\n1,2,3\n"); }),
              HasSubstr("f.csv:1:12: column 'x_m_per_s2' repeats component x"));
  EXPECT_THAT(error_text([] { read("time,x_g\n0,1\n1,2\n"); }),
              HasSubstr("f.csv:1:1: the first column must be time_s, got 'time'"));
  EXPECT_THAT(error_text([] { read("time_s,\n0,1\n1,2\n"); }),
              HasSubstr("f.csv:1:8: unknown column"));
  EXPECT_THAT(error_text([] { read("time_s,a_g,x_g\n0,1,2\n1,2,3\n"); }),
              HasSubstr("column a stands alone"));
}

TEST(ColumnsCsv, ReportsAllBadCellsAndRowsAtOnce) {
  EXPECT_EQ(error_text([] {
              read("time_s,x_g,y_g\n0,1,nan\n0.01,x1,2\n0.02,1\n0.03,1,2,3\n0.04,,1e999\n");
            }),
            "f.csv:2:5: 'nan' is not a finite number\n"
            "f.csv:3:6: 'x1' is not a finite number\n"
            "f.csv:4:1: 2 columns, the header has 3\n"
            "f.csv:5:1: 4 columns, the header has 3\n"
            "f.csv:6:6: '' is not a finite number\n"
            "f.csv:6:7: '1e999' is not a finite number");
}

TEST(ColumnsCsv, RefusesTimesThatAreNotEven) {
  EXPECT_EQ(error_text([] { read("time_s,x_g\n0,1\n0.01,1\n0.02,1\n0.04,1\n0.05,1\n"); }),
            "f.csv:5:1: the time goes from 0.02 to 0.04 s where the step is 0.01 s");
  EXPECT_THAT(error_text([] { read("time_s,x_g\n0,1\n0.01,1\n0.01,1\n0.02,1\n"); }),
              HasSubstr("f.csv:4:1: the time goes from 0.01 to 0.01 s"));
  EXPECT_THAT(error_text([] { read("time_s,x_g\n0.02,1\n0.01,1\n0,1\n"); }),
              HasSubstr("f.csv:3:1: time steps must be in [1e-05, 1] s, got -0.01"));
  // 0.0102 is off the grid by 2 % of the step, 0.01005 by 0.5 %.
  EXPECT_THAT(error_text([] { read("time_s,x_g\n0,1\n0.0102,1\n0.02,1\n"); }),
              HasSubstr("f.csv:3:1: time 0.0102 s is off the even grid (0.01 s, step 0.01 s)"));
  EXPECT_EQ(read("time_s,x_g\n0,1\n0.01005,1\n0.02,1\n")[0].time_step, 0.01);
}

TEST(ColumnsCsv, SaysThatAMotionDoesNotStartAtZero) {
  const auto components = read("time_s,x_g\n0.02,1\n0.04,1\n");
  EXPECT_THAT(components[0].warnings, testing::ElementsAre(HasSubstr("the first time is 0.02 s")));
}

TEST(ColumnsCsv, RefusesAFileThatIsCut) {
  for (std::size_t length = 0; length < kThree.size(); ++length) {
    const std::string text = kThree.substr(0, length);
    const auto rows = std::count(text.begin(), text.end(), '\n') - 3;
    // A cut at the end of a row leaves a shorter but whole file.
    if (text.ends_with('\n') && rows >= 2) continue;
    EXPECT_NE(error_text([&] { read(text); }), "") << length;
  }
}

TEST(ColumnsCsv, RefusesOptionsAgainstTheFile) {
  EXPECT_EQ(error_text([] { read(kThree, {.unit = "g", .time_step = 0.02}); }),
            "f.csv: unit = \"g\" was given, but the columns of this file state their units\n"
            "f.csv: the file has a time step of 0.01 s, but time_step_s = 0.02 was given");
  EXPECT_EQ(error_text([] { read(kThree, {.time_step = 0.005}); }),
            "f.csv: the file has a time step of 0.01 s, but time_step_s = 0.005 was given");
  EXPECT_EQ(read(kThree, {.time_step = 0.01 * (1 - 1e-7)})[0].time_step, 0.01);
}

TEST(ColumnsCsv, ReadsWhatItWrites) {
  Record record;
  for (Component& component : read("time_s,x_m_per_s2,z_m_per_s2\n0,1.25,-0.00001\n0.005,-3,7\n"))
    record.components[static_cast<std::size_t>(*component.direction)] = component;
  const std::string text = columns_csv_text(record, {"made by a test"});
  EXPECT_EQ(text,
            "# made by a test\ntime_s,x_m_per_s2,z_m_per_s2\n0,1.25000,-0.00001\n"
            "0.005,-3.00000,7.00000\n");
  EXPECT_EQ(read(text)[1].acceleration, record[Direction::kVertical]->acceleration);
}

TEST(ColumnsCsv, RefusesOptionsForOtherFiles) {
  EXPECT_EQ(error_text([] { read(kThree, {.si_per_count = 2, .columns = "samples"}); }),
            "f.csv: count_m_per_s2 = 2 was given, but the file does not hold raw counts\n"
            "f.csv: columns = \"samples\" was given, but the layout of this file is known");
}

TEST(ColumnsCsv, LeavesForeignTablesToPlainText) {
  EXPECT_EQ(read("time,acc\n0,1\n0.1,2\n0.2,3\n", {.unit = "g"})[0].format, "plain text");
  EXPECT_EQ(read(kThree)[0].format, "columns CSV");
}

}  // namespace
}  // namespace gurney::groundmotions
