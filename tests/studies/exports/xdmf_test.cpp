#include <gmock/gmock.h>

#include <cmath>
#include <map>

#include "engine/base/units.h"
#include "engine/base/vector.h"
#include "engine/run/simulate.h"
#include "studies/exports/export.h"
#include "studies/prepare/run_job.h"
#include "studies/results/hdf5_reader.h"
#include "studies/results/results_file.h"
#include "tests/support/error_text.h"
#include "tests/support/temp_folder.h"

namespace gurney::study {
namespace {

using testing::HasSubstr;

constexpr double kSink = 0.002;  ///< of a tread under a quarter of the trolley: 240 N / 3e5 N/m

class XdmfTest : public testing::Test {
 protected:
  /// A trolley pulled along x with casters that point the other way, beside a column.
  XdmfTest() {
    const std::string job = folder_.write("job.toml", R"(schema = "gurney-job/1"
[item]
equipment = "xu_trolley"
headings_deg = 90
position_m = [1, 2]
[[excitation.force]]
point_m = [0, 0, 0.5]
direction = [1, 0, 0]
force_n = 80
until_s = 2
[[room.column]]
name = "column"
center_m = [9, 9]
radius_m = 0.2
height_m = 1
[settings]
duration_s = 3
)");
    const PreparedRun run = prepare_run(job);
    const Response response = simulate(run.facts.scene, run.facts.floor, run.facts.settings);
    path_ = folder_.write("run.h5", results_image(run.facts, response));
    export_xdmf(path_, "run", [&](const std::string& name, std::string_view bytes) {
      files_[name] = folder_.write(name, std::string(bytes));
    });
  }

  std::vector<Vector3> points(const std::string& dataset) const {
    const std::vector<double> numbers = Hdf5Reader(files_.at("run_shapes.h5")).numbers(dataset);
    std::vector<Vector3> points;
    for (std::size_t i = 0; i < numbers.size(); i += 3)
      points.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
    return points;
  }

  const TempFolder folder_;
  std::string path_;
  std::map<std::string, std::string> files_;
};

TEST_F(XdmfTest, EveryTimeHasItsPoints) {
  const std::string xml = contents_of(files_.at("run.xdmf"));
  const std::vector<double> times = Hdf5Reader(path_).numbers("/histories/time");
  EXPECT_THAT(xml, HasSubstr("<Time Value=\"0\"/>"));
  EXPECT_THAT(xml, HasSubstr("<Time Value=\"3\"/>"));
  std::size_t grids = 0;
  for (std::size_t at = 0; (at = xml.find("CollectionType=\"Spatial\"", at)) != std::string::npos;
       ++at)
    ++grids;
  EXPECT_EQ(grids, times.size());
  EXPECT_THAT(xml, HasSubstr("run_shapes.h5:/items/points/000000"));
  const std::size_t vertices = points("/items/points/000000").size();
  EXPECT_THAT(xml, HasSubstr("Dimensions=\"" + std::to_string(vertices) + " 3\""));
  // 48 points of four wheels less than all: boxes of the chassis.
  EXPECT_EQ((vertices - 4 * 32) % 8, 0);
}

TEST_F(XdmfTest, TheRoomIsWrittenOnceAndNamedAtEachTime) {
  const std::string xml = contents_of(files_.at("run.xdmf"));
  EXPECT_EQ(points("/room/points/000000").size(), 32u) << "the column";
  EXPECT_THROW(points("/room/points/000001"), Error);
  std::size_t rooms = 0;
  for (std::size_t at = 0; (at = xml.find(":/room/points/000000<", at)) != std::string::npos; ++at)
    ++rooms;
  EXPECT_EQ(rooms, Hdf5Reader(path_).numbers("/histories/time").size());
}

TEST_F(XdmfTest, CellsNameEachPointOfEveryShape) {
  const Hdf5Reader file(files_.at("run_shapes.h5"));
  const std::map<double, std::size_t> sizes{{9, 8}, {5, 4}, {4, 3}};  // no polygons
  for (const std::string group : {"/items", "/room"}) {
    const std::vector<double> cells = file.numbers(group + "/cells"),
                              items = file.numbers(group + "/item");
    std::vector<bool> named(points(group + "/points/000000").size());
    std::size_t count = 0;
    for (std::size_t at = 0; at < cells.size(); ++count) {
      ASSERT_TRUE(sizes.contains(cells[at])) << cells[at];
      const std::size_t size = sizes.at(cells[at]);
      for (std::size_t i = 1; i <= size; ++i)
        named.at(static_cast<std::size_t>(cells.at(at + i))) = true;
      at += 1 + size;
    }
    EXPECT_THAT(named, testing::Each(true));
    ASSERT_EQ(items.size(), count);
    EXPECT_THAT(items, testing::Each(group == "/room" ? -1 : 0));
  }
}

// A regular prism of 16 sides and radius r: the caps' cells cover 8 r^2 sin(22.5 deg) each.
TEST_F(XdmfTest, CapsAreCoveredOnce) {
  const Hdf5Reader file(files_.at("run_shapes.h5"));
  const std::vector<double> cells = file.numbers("/room/cells");
  const std::vector<Vector3> all = points("/room/points/000000");
  double area = 0;
  for (std::size_t at = 0; at < cells.size(); at += cells[at] == 5 ? 5 : 4)
    for (std::size_t i = 2; i < (cells[at] == 5 ? 4u : 3u); ++i) {
      const auto point = [&](std::size_t k) {
        return all[static_cast<std::size_t>(cells[at + k])];
      };
      area += (point(i) - point(1)).cross(point(i + 1) - point(1)).z() / 2 *
              (point(1).z() > 0.5 ? 1 : 0) * (point(i).z() > 0.5 ? 1 : 0);
    }
  EXPECT_NEAR(std::abs(area), 8 * 0.2 * 0.2 * std::sin(22.5 * kRadiansPerDegree), 1e-12);
}

TEST_F(XdmfTest, WheelsStandOnTheFloorAndTurnAboutTheirSwivels) {
  const Hdf5Reader file(path_);
  const auto kinds = file.strings("/shapes/kind");
  const auto first = file.numbers("/shapes/first");
  const auto start = points("/items/points/000000"), end = points("/items/points/000150");
  const double moved = file.numbers("/histories/displacement")[3 * 150];
  EXPECT_GT(moved, 0.5);
  for (std::size_t shape = 0; shape < kinds.size(); ++shape) {
    const auto from = static_cast<std::size_t>(first[shape]);
    if (kinds[shape] != "prism" || file.strings("/shapes/item")[shape].empty()) continue;
    const auto axle = [&](const std::vector<Vector3>& all) {
      return Vector3(all[from + 16] - all[from]).normalized();
    };
    for (const auto* all : {&start, &end}) {
      double lowest = 1;
      for (std::size_t i = from; i < from + 32; ++i) lowest = std::min(lowest, (*all)[i].z());
      EXPECT_NEAR(lowest, 0, kSink);
    }
    // At the start they roll along y, at the end they have come round to roll along x.
    EXPECT_NEAR(std::abs(axle(start).x()), 1, 1e-3);
    EXPECT_GT(std::abs(axle(end).y()), 0.95);
  }
}

TEST_F(XdmfTest, TheChassisMovesAsARigidBodyAndTheRoomStands) {
  const auto start = points("/items/points/000000"), end = points("/items/points/000150");
  for (int i = 1; i < 8; ++i)
    EXPECT_NEAR((end[i] - end[0]).norm(), (start[i] - start[0]).norm(), 1e-12);
  Vector3 middle = Vector3::Zero();
  for (int i = 0; i < 8; ++i) middle += start[i] / 8;
  // Casters that stand aside by their trail of 34 mm tilt it: M g t / (4 k_n b^2) = 4e-4 rad with
  // b = 0.25 m, which moves what is up to 1.5 m high by 0.6 mm.
  EXPECT_NEAR(middle.x(), 1, 6e-4);
  EXPECT_NEAR(middle.y(), 2, 6e-4);
  EXPECT_NEAR(points("/room/points/000000").back().z(), 1, 1e-12);
}

TEST_F(XdmfTest, RefusesWhatHasNoHistories) {
  PreparedRun run = prepare_run(folder_.file("job.toml"));
  run.facts.settings.history_step = 0;
  const Response response = simulate(run.facts.scene, run.facts.floor, run.facts.settings);
  const std::string path = folder_.write("none.h5", results_image(run.facts, response));
  EXPECT_EQ(error_text([&] { export_xdmf(path, "none", [](const auto&, auto) {}); }),
            path + ": has no histories (settings.history_step_s)");
}

}  // namespace
}  // namespace gurney::study
