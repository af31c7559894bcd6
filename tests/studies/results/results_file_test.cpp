#include "studies/results/results_file.h"

#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <thread>

#include "engine/base/hash/sha256.h"
#include "studies/results/hdf5_reader.h"
#include "studies/results/histories.h"
#include "tests/support/page_rows.h"
#include "tests/support/synthetic_run.h"
#include "tests/support/synthetic_ward.h"
#include "tests/support/temp_folder.h"

namespace gurney::study {
namespace {

class ResultsFile : public testing::Test {
 protected:
  std::string save(const RunFacts& facts, const Response& response) {
    const std::string path = folder_.file("results.h5");
    std::ofstream(path, std::ios::binary) << results_image(facts, response);
    return path;
  }

  TempFolder folder_;
};

TEST_F(ResultsFile, HoldsTheRun) {
  const Response response = synthetic_response();
  const Hdf5Reader file(save(synthetic_facts(), response));
  EXPECT_EQ(file.text_attribute("filetype"), "gurney-results");
  EXPECT_EQ(file.text_attribute("job_text"), "title = \"A trolley\"\n");
  EXPECT_EQ(file.strings("/runs/outcome"), std::vector<std::string>{"rested"});
  EXPECT_EQ(file.numbers("/items/residual_yaw"),
            std::vector<double>{response.items[0].demands.residual_yaw});
  EXPECT_EQ(file.numbers("/wheels/liftoffs"), (std::vector<double>{0, 1, 2, 3}));
  EXPECT_EQ(file.numbers("/runs/record_pgv"), (std::vector<double>{0.31, 0.22, 0.11}));
  EXPECT_EQ(file.numbers("/verification/subdivided_steps"), std::vector<double>{4});
  EXPECT_EQ(file.numbers("/points/numerical_acceleration"), std::vector<double>{98.5});
  EXPECT_EQ(file.strings("/items/item"), std::vector<std::string>{"Trolley"});
  EXPECT_TRUE(file.numbers("/events/time").empty());
  EXPECT_EQ(file.strings("/assumptions/key"),
            std::vector<std::string>{"tread.rolling_resistance_m"});
  EXPECT_EQ(file.text_attribute("draw_seed"), "1");
  EXPECT_EQ(file.text_attribute("draw"), "3");
  EXPECT_EQ(file.numbers("/drawn/value"), (std::vector<double>{1.0625, 0.001}));
  EXPECT_EQ(file.strings("/drawn/unit"), (std::vector<std::string>{"mm", "1"}));
}

TEST_F(ResultsFile, HoldsTheHistories) {
  const Response response = synthetic_response();
  const Hdf5Reader file(save(synthetic_facts(), response));
  constexpr std::size_t kSample = 345, kWheel = 2, kWheels = 4;
  const Sample& sample = response.items[0].history[kSample];
  EXPECT_EQ(file.numbers("/histories/count").at(0), response.items[0].history.size());
  EXPECT_EQ(file.numbers("/histories/time").at(kSample), sample.time);
  EXPECT_EQ(file.numbers("/histories/start").at(2), 0) << "on the floor";
  EXPECT_EQ(file.numbers("/histories/velocity").at(3 * kSample + 1), sample.velocity.y());
  EXPECT_EQ(file.numbers("/histories/normal_force").at(kWheels * kSample + kWheel),
            sample.wheels[kWheel].normal_force);
  EXPECT_EQ(file.numbers("/histories/mode").at(kWheels * kSample + kWheel),
            static_cast<double>(sample.wheels[kWheel].mode));
  EXPECT_EQ(file.numbers("/histories/point_displacement").at(3 * kSample + 2),
            sample.points[0].displacement.z());
  EXPECT_EQ(file.numbers("/histories/loss_tread").at(kSample), sample.energy.tread_loss);
}

TEST_F(ResultsFile, HoldsTheMotionOfTheFloor) {
  const RunFacts facts = synthetic_facts();
  const Response response = synthetic_response();
  const Hdf5Reader file(save(facts, response));
  const double time = response.items[0].history[345].time;
  EXPECT_EQ(file.numbers("/histories/floor_velocity").at(3 * 345 + 1),
            facts.floor.velocity_at(time).y());
  EXPECT_EQ(file.numbers("/histories/floor_acceleration").at(3 * 345),
            facts.floor.acceleration_at(time).x());
}

TEST(FloorHistories, DisplacementIsTheDoubleIntegralOfTheRecord) {
  // Accelerations 0, 6, -6 at 0, 1, 2 s: in the first second x = t^3; then, with s = t - 1,
  // x = 1 + 3 s + 3 s^2 - 2 s^3; after the record the velocity of 3 m/s stays.
  Eigen::Matrix3Xd acceleration = Eigen::Matrix3Xd::Zero(3, 3);
  acceleration.row(0) << 0, 6, -6;
  const FloorMotion floor(1, acceleration);
  const std::vector<double> times{0, 0.5, 1.25, 2, 4};
  const std::vector<double> wanted{0, 0.125, 1 + 0.75 + 0.1875 - 0.03125, 5, 11};
  const std::vector<Vector3> found = floor_displacement(floor, times);
  // Sums of at most 10 terms below 11, each rounded a few times by 2^-53: 11 * 40 * 1.1e-16.
  for (std::size_t i = 0; i < times.size(); ++i) EXPECT_NEAR(found[i].x(), wanted[i], 5e-14);
  EXPECT_EQ(found.back().y(), 0);
  EXPECT_NEAR(found[3].x(), floor.residual_displacement().x(), 5e-14);
  EXPECT_EQ(floor_displacement(FloorMotion(), times).back(), Vector3::Zero());
}

TEST_F(ResultsFile, HoldsARowForEachItemWheelImpactZoneAndTether) {
  const Response response = synthetic_ward_response();
  const Hdf5Reader file(save(synthetic_ward(), response));
  const auto items = file.strings("/items/item");
  ASSERT_EQ(items.size(), 10u);
  EXPECT_EQ(items[3], "infusion pump");
  EXPECT_EQ(file.numbers("/items/time_of_overturning")[3], 4.5);
  EXPECT_EQ(file.numbers("/items/time_of_overturning")[4], -1);
  EXPECT_TRUE(std::isnan(file.numbers("/items/direction_of_overturning")[4]));
  EXPECT_EQ(file.numbers("/items/impacts")[4], 3);

  ASSERT_EQ(file.strings("/wheels/wheel").size(), 36u) << "the bookcase has none";
  EXPECT_EQ(file.strings("/wheels/item")[4 * 3], "infusion pump");
  EXPECT_EQ(file.strings("/wheels/wheel")[4 * 3 + 1], "front right");
  EXPECT_EQ(file.numbers("/wheels/liftoff_before_overturning")[4 * 3 + 1], 4.4);
  EXPECT_EQ(file.strings("/points/item")[9], "bookcase");

  EXPECT_EQ(file.numbers("/events/time"), (std::vector<double>{2.5, 2.9, 3.5, 3.75, 4.75, 5.25}));
  EXPECT_EQ(file.strings("/events/item")[1], "ventilator");
  EXPECT_EQ(file.strings("/events/body")[1], "front right");
  EXPECT_EQ(file.strings("/events/other")[1], "monitor");
  EXPECT_EQ(file.strings("/events/other_body")[1], "rear left");
  EXPECT_EQ(file.strings("/events/other")[3], "north wall");
  EXPECT_EQ(file.numbers("/events/point_y")[3], 2.4);
  EXPECT_EQ(file.numbers("/events/normal_y")[3], -1);
  EXPECT_EQ(file.numbers("/events/peak_force")[3], 5200);
  EXPECT_TRUE(std::isnan(file.numbers("/events/peak_force")[0]));

  EXPECT_EQ(file.strings("/zones/zone"), (std::vector<std::string>{"doorway", "egress lane"}));
  EXPECT_EQ(file.numbers("/zones/occupied_at_end"), (std::vector<double>{1, 0}));
  EXPECT_EQ(file.numbers("/zones/free_width_at_end"), (std::vector<double>{0.35, 0.9}));
  EXPECT_EQ(file.strings("/tethers/item")[1], "anaesthesia workstation");
  EXPECT_EQ(file.numbers("/tethers/time_broken"), (std::vector<double>{3.5, -1, -1}));
}

TEST_F(ResultsFile, HoldsTheHistoriesOfSeveralItems) {
  const Response response = synthetic_ward_response();
  const Hdf5Reader file(save(synthetic_ward(), response));
  constexpr std::size_t kSample = 245, kItem = 3, kItems = 10;
  const Sample& sample = response.items[kItem].history[kSample];
  EXPECT_EQ(file.numbers("/histories/count").at(0), 751);
  EXPECT_EQ(file.numbers("/histories/time").size(), 751u);
  EXPECT_EQ(file.numbers("/histories/tilt").at(kItems * kSample + kItem), sample.tilt);
  EXPECT_EQ(file.numbers("/histories/displacement").at(3 * (kItems * kSample + kItem) + 1),
            sample.displacement.y());
  EXPECT_EQ(file.numbers("/histories/orientation").at(4 * (kItems * kSample + kItem) + 1),
            sample.orientation.x());
  EXPECT_EQ(file.strings("/histories/wheel").at(13), "infusion pump/front right");
  EXPECT_EQ(file.numbers("/histories/swivel_angle").at(36 * kSample + 13),
            sample.wheels[1].swivel_angle);
  EXPECT_EQ(file.strings("/histories/point").at(9), "bookcase/top");
}

TEST_F(ResultsFile, GivesTheSameBytesForTheSameRun) {
  const std::string first = results_image(synthetic_facts(), synthetic_response());
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // HDF5's times count seconds
  EXPECT_EQ(first, results_image(synthetic_facts(), synthetic_response()));
  RunFacts other = synthetic_facts();
  other.job_text += "#";
  EXPECT_NE(first, results_image(other, synthetic_response()));
}

TEST_F(ResultsFile, ManagesWithoutHistoryRecordOrPoints) {
  RunFacts facts = synthetic_facts(true);
  facts.scene.items[0].model.marked_points.clear();
  facts.assumptions.clear();
  Response response = synthetic_response(true);
  response.items[0].history.clear();
  response.items[0].demands.points.clear();
  const Hdf5Reader file(save(facts, response));
  EXPECT_TRUE(file.numbers("/histories/displacement").empty());
  EXPECT_EQ(file.strings("/runs/record"), std::vector<std::string>{""});
}

TEST_F(ResultsFile, HoldsARunThatDiverged) {
  Response response;
  response.cause = "the solve did not converge";
  response.items.resize(1);
  response.items[0].demands.wheels.resize(4);
  response.items[0].demands.points.resize(1);
  const Hdf5Reader file(save(synthetic_facts(), response));
  EXPECT_EQ(file.strings("/runs/outcome"), std::vector<std::string>{"diverged"});
  EXPECT_EQ(file.strings("/runs/cause"), std::vector<std::string>{"the solve did not converge"});
}

TEST_F(ResultsFile, IsWhatItsPageSays) {
  RunFacts facts = synthetic_facts();
  facts.seed = 7;
  const std::string page = GURNEY_SOURCE_DIR "/docs/formats/results_file.md";
  expect_as_on_page(Hdf5Reader(save(facts, synthetic_response())), page, page);
}

TEST(Sha256, MatchesThePublishedExample) {
  // FIPS 180-4 example: one block, "abc".
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

}  // namespace
}  // namespace gurney::study
