#include "groundmotions/buildings/floor_tables.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "engine/base/units.h"
#include "groundmotions/buildings/building.h"
#include "groundmotions/buildings/floor_record.h"
#include "groundmotions/scaling/scale.h"
#include "groundmotions/synthetic/clough_penzien.h"
#include "tests/support/error_text.h"
#include "tests/support/temp_folder.h"

namespace gurney::groundmotions {
namespace {

using testing::AllOf;
using testing::HasSubstr;

const Record& ground() {
  static const Record kRecord = [] {
    Record record = synthetic_record(shipped_synthetic_motion());
    record.name = "quake";
    return record;
  }();
  return kRecord;
}

/// Our own model, which stands for the other program.
Building house() {
  Building building{"House", 2, {}, {}, {}};
  for (std::size_t i = 0; i < 2; ++i) {
    building.axes[i] = modes_of(Eigen::Vector2d(1, 1), shear_stiffness(Eigen::Vector2d(1, 1)));
    scale_to_period(building.axes[i], i == 0 ? 0.5 : 0.4);
    set_damping(building.axes[i], 0.05);
  }
  return building;
}

using Cell = std::function<double(Eigen::Index)>;

/// Rows of some cells for each sample, six digits like a recorder of OpenSees.
std::string rows(Eigen::Index samples, const std::vector<Cell>& cells) {
  std::string text;
  for (Eigen::Index i = 0; i < samples; ++i) {
    for (const Cell& cell : cells) text += fmt::format("{:.6g} ", cell(i));
    text += "\n";
  }
  return text;
}

struct Floors {
  Record first = floor_record(ground(), house(), 1), roof = floor_record(ground(), house(), 2);
  Eigen::Index samples = std::min(first.samples(), roof.samples());
  double step = first.time_step();

  Cell time() const {
    return [this](Eigen::Index i) { return step * static_cast<double>(i); };
  }
  Cell of(const Record& record, Direction direction, double unit = 1) const {
    return [&record, direction, unit](Eigen::Index i) {
      return record[direction]->acceleration[i] / unit;
    };
  }
};

class FloorTablesTest : public testing::Test {
 protected:
  Building read(const std::string& keys) {
    config::Document document("kind = 'tables'\nname = 'House'\nfloors = ['1', 'roof']\n" + keys,
                              folder_.file("b.toml"));
    config::Table table = document.root();
    const Building building = read_building(table);
    document.finish();
    return building;
  }

  std::string error(const std::string& keys, const Record& record = ground(), int floor = 1) {
    return error_text([&] { floor_record(record, read(keys), floor); });
  }

  /// Largest difference of the floor from the model's, over the peak.
  double difference(const Record& found, const Record& model, Direction direction) {
    const Eigen::VectorXd &a = found[direction]->acceleration, &b = model[direction]->acceleration;
    const Eigen::Index samples = std::min(a.size(), b.size());
    EXPECT_EQ(found.time_step(), model.time_step());
    EXPECT_GE(samples, floors_.samples);
    return (a.head(samples) - b.head(samples)).cwiseAbs().maxCoeff() / b.cwiseAbs().maxCoeff();
  }

  TempFolder folder_;
  Floors floors_;
};

constexpr const char* kOneTable =
    "file = '{record}.out'\ncolumns = 'time, 1 h1, 1 h2, roof h1, roof h2'\n"
    "unit = 'm/s2'\nacceleration = 'absolute'\n";

// Printed with six digits: half of the last is at most 5e-6 of the peak.
constexpr double kPrinted = 5e-6;

TEST_F(FloorTablesTest, OneTableOfAllFloorsIsTheMotionOfTheModel) {
  folder_.write("quake.out",
                rows(floors_.samples, {floors_.time(), floors_.of(floors_.first, Direction::kH1),
                                       floors_.of(floors_.first, Direction::kH2),
                                       floors_.of(floors_.roof, Direction::kH1),
                                       floors_.of(floors_.roof, Direction::kH2)}));
  const Building building = read(kOneTable);
  EXPECT_EQ(floor_of(building, "roof"), 1);
  EXPECT_EQ(floor_of(building, "0"), std::nullopt);
  const Record first = floor_record(ground(), building, 0),
               roof = floor_record(ground(), building, 1);
  for (const Direction direction : {Direction::kH1, Direction::kH2}) {
    EXPECT_LT(difference(first, floors_.first, direction), kPrinted);
    EXPECT_LT(difference(roof, floors_.roof, direction), kPrinted);
  }
  // The tables have no vertical: as the ground.
  EXPECT_LT(difference(roof, floors_.roof, Direction::kVertical), 1e-12);
  EXPECT_EQ(roof.name, "quake, floor roof of House");
  ASSERT_EQ(roof.floor_files.size(), 2U);
  EXPECT_THAT(roof.floor_files[0].first, HasSubstr("quake.out"));
}

TEST_F(FloorTablesTest, FilesOfEachFloorAndDirectionOfRelativeAccelerations) {
  // Recorders write the first row after the first step.
  const Record& roof = floors_.roof;
  const auto relative = [&](Direction direction) -> Cell {
    return [&roof, direction, step = floors_.step](Eigen::Index i) {
      const Component& below = *ground()[direction];
      const double place = static_cast<double>(i + 1) * step / below.time_step;
      const auto k = static_cast<Eigen::Index>(place + 1e-9);
      double base = 0;
      if (k + 1 < below.acceleration.size())
        base = below.acceleration[k] + (place - static_cast<double>(k)) *
                                           (below.acceleration[k + 1] - below.acceleration[k]);
      else if (k < below.acceleration.size())
        base = below.acceleration[k] * (1 - (place - static_cast<double>(k)));
      return (roof[direction]->acceleration[i + 1] - base) / kStandardGravity;
    };
  };
  const Cell time = [&](Eigen::Index i) { return floors_.step * static_cast<double>(i + 1); };
  for (const Direction direction : {Direction::kH1, Direction::kH2})
    folder_.write(fmt::format("quake_roof_{}.out", direction == Direction::kH1 ? "X" : "Y"),
                  rows(floors_.samples - 1, {time, relative(direction)}));
  const Building building = read(
      "file = '{record}_{floor}_{direction}.out'\ndirections = ['X', 'Y', '']\n"
      "columns = ['time', 'acceleration']\nunit = 'g'\nacceleration = 'relative'\n");
  const Record found = floor_record(ground(), building, 1);
  for (const Direction direction : {Direction::kH1, Direction::kH2})
    EXPECT_LT(difference(found, roof, direction), 3 * kPrinted);
}

TEST_F(FloorTablesTest, TimeSeriesOfAnEventFile) {
  const auto series = [&](const char* name, const Record& record, Direction direction) {
    const Eigen::VectorXd& a = record[direction]->acceleration;
    std::string text;
    for (Eigen::Index i = 0; i < floors_.samples; ++i)
      text += fmt::format("{}{:.6g}", i > 0 ? "," : "", a[i]);
    return fmt::format(R"({{"name": "{}", "type": "Value", "dT": {}, "data": [{}]}})", name,
                       floors_.step, text);
  };
  folder_.write("quake.json", R"({"Events": [{"type": "Seismic", "timeSeries": [)" +
                                  series("roof_1", floors_.roof, Direction::kH1) + "," +
                                  series("roof_2", floors_.roof, Direction::kH2) + "]}]}");
  const std::string keys =
      "file = '{record}.json'\nseries = '{floor}_{direction}'\ndirections = ['1', '2']\n"
      "unit = 'm/s2'\nacceleration = 'absolute'\n";
  const Record found = floor_record(ground(), read(keys), 1);
  EXPECT_LT(difference(found, floors_.roof, Direction::kH1), kPrinted);
  EXPECT_LT(difference(found, floors_.roof, Direction::kH2), kPrinted);
  EXPECT_THAT(error(keys, ground(), 0), AllOf(HasSubstr("quake.json: no time series '1_1'"),
                                              HasSubstr("known: roof_1, roof_2")));
  folder_.write("quake.json", R"({"Events": [{"timeSeries": [{"name": "a", "dT": 7}]}]})");
  EXPECT_THAT(error(keys), HasSubstr("quake.json: time series 'a': "));
}

TEST_F(FloorTablesTest, FollowAScaledGroundOnlyInProportion) {
  folder_.write("quake.out", "0 1 2 3 4\n0.01 1 2 3 4\n0.02 0 0 0 0\n");
  const Record twice = scaled(ground(), 2);
  EXPECT_THAT(error(kOneTable, twice),
              HasSubstr("'quake' is scaled by 2: only floors that move in "
                        "proportion to the ground (`proportional = true`)"));
  const Building building = read(std::string(kOneTable) + "proportional = true\n");
  EXPECT_EQ(floor_record(twice, building, 1)[Direction::kH2]->acceleration[1], 8);
  const Building of_twice = read(std::string(kOneTable) + "ground_scale = 2\n");
  EXPECT_EQ(floor_record(twice, of_twice, 1)[Direction::kH2]->acceleration[1], 4);
}

TEST_F(FloorTablesTest, SayWhatIsWrongWithATableAndWhere) {
  EXPECT_THAT(error(kOneTable), AllOf(HasSubstr("b.toml:4:8: no such file: "),
                                      HasSubstr("floor 'roof' under the ground motion 'quake'")));
  const auto of = [&](const std::string& table) {
    folder_.write("quake.out", table);
    return error(kOneTable);
  };
  EXPECT_THAT(of("0 1 2 3\n0.01 1 2 3\n"),
              HasSubstr("quake.out:1:1: has 4 numbers; `columns` names 5"));
  EXPECT_THAT(of("0 1 2 3 4\n0.01 1 2 3 4\n0.02 1 2 3\n"),
              HasSubstr("quake.out:3:1: has 4 numbers"));
  EXPECT_THAT(of("0 1 2 3 4\n0.01 1 2 nan 4\n0.02 1 2 3 4\n"), HasSubstr("quake.out:2:10: "));
  EXPECT_THAT(of("0 1 nan 3 4\n0.01 1 2 3 4\n0.02 1 2 3 4\n"), HasSubstr("quake.out:1:5: "));
  EXPECT_THAT(of("0 1 2 3 4\n0.01 1 2 3 4\n0.02 1 2 3 4\n0.023 1 2 3 4\n0.033 1 2 3 4\n"),
              HasSubstr("quake.out:4:1: "));
  EXPECT_THAT(of("5 1 2 3 4\n5.01 1 2 3 4\n5.02 1 2 3 4\n"),
              HasSubstr("quake.out:1:1: the first time is 5 s: must be 0 or one step, 0.01 s"));
  EXPECT_THAT(of("0 1 2 3 4\n"), HasSubstr("must have two rows"));
}

TEST_F(FloorTablesTest, SayWhatIsWrongWithTheKeys) {
  const auto of = [&](const std::string& columns, const std::string& more = "") {
    return error_text([&] {
      read("file = '{record}.out'\nacceleration = 'absolute'\ncolumns = '" + columns + "'\n" +
           (more.empty() ? "unit = 'g'\n" : more));
    });
  };
  EXPECT_THAT(
      of("time, rof h1"),
      HasSubstr("b.toml:6:11: columns: \"rof h1\": 'rof' is no floor; did you mean 'roof'?"));
  EXPECT_THAT(of("time, roof x"), HasSubstr("'x' is no direction; known: h1, h2, vertical"));
  EXPECT_THAT(of("time, roof h1, roof h1"), HasSubstr("has 'roof h1' twice"));
  EXPECT_THAT(of("roof h1"), HasSubstr("has no time; time_step_s is needed"));
  EXPECT_THAT(of("time, skip"), HasSubstr("must have an acceleration"));
  EXPECT_THAT(of("time, roof h1", "unit = 'G'\n"), HasSubstr("did you mean 'g'?"));
  EXPECT_THAT(of("time, roof h1", "directions = ['h1']\n"), HasSubstr("unit: missing"));
}

// Times of 100 s have four decimals: steps of 2.5 ms are off the grid by up to a fifth.
TEST_F(FloorTablesTest, TimesOfSixDigitsAreEven) {
  std::string table;
  for (int i = 1; i <= 44000; ++i) table += fmt::format("{:.6g} 1 2 3 {}\n", i * 0.0025, i % 7);
  folder_.write("quake.out", table);
  const Record found = floor_record(ground(), read(kOneTable), 1);
  EXPECT_EQ(found.time_step(), 0.0025);
  EXPECT_EQ(found.samples(), 44001);
}

}  // namespace
}  // namespace gurney::groundmotions
