#include <gmock/gmock.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "engine/base/units.h"
#include "groundmotions/formats/format.h"
#include "groundmotions/formats/numbers.h"
#include "groundmotions/measures/peaks.h"
#include "tests/support/error_text.h"

/// Real files of strong motion networks, which may not be part of the project: a folder named by
/// GURNEY_RECORDS, with reference_values.csv (one row for each component, in the file's order).
namespace gurney {
namespace {

using testing::HasSubstr;

constexpr int kUp = -1, kNoDirection = -2;  ///< else an azimuth in degrees

class RealNetworkRecords : public testing::Test {
 protected:
  void SetUp() override {
    const char* folder = std::getenv("GURNEY_RECORDS");
    if (!folder) GTEST_SKIP() << "GURNEY_RECORDS names no folder of real records";
    folder_ = folder;
  }

  std::vector<std::vector<std::string>> references(const std::string& file) const {
    std::ifstream stream(folder_ / "reference_values.csv");
    std::vector<std::vector<std::string>> rows;
    for (std::string line; std::getline(stream, line);) {
      if (!line.starts_with(file + ",")) continue;
      std::istringstream cells(line);
      rows.emplace_back();
      for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(cell);
    }
    return rows;
  }

  /// @param directions  of the components: azimuth in degrees, kUp or kNoDirection
  void expect_references(const std::string& file, const std::vector<int>& directions) const {
    SCOPED_TRACE(file);
    const auto rows = references(file);
    const auto components = read_components(folder_ / file);
    ASSERT_EQ(components.size(), rows.size());
    ASSERT_EQ(components.size(), directions.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      SCOPED_TRACE(rows[i][1]);
      expect_values(components[i], rows[i]);
      expect_direction(components[i], directions[i]);
    }
  }

  static void expect_values(const Component& component, const std::vector<std::string>& row) {
    EXPECT_EQ(component.acceleration.size(), number(row[3]));
    EXPECT_NEAR(component.time_step, *number(row[5]), 1e-12);
    if (component.unit == "counts") return;  // the reference values are counts without their mean
    const Peaks p = peaks(component.time_step, component.acceleration);
    const double pga = *number(row[6]), pgv = *number(row[10]) / 100;
    EXPECT_NEAR(p.acceleration, pga, 0.001 * pga);
    EXPECT_NEAR(p.velocity, pgv, 0.005 * pgv);
    EXPECT_NEAR(p.time_of_acceleration, *number(row[7]), 0.5 * component.time_step);
  }

  static void expect_direction(const Component& component, int direction) {
    EXPECT_EQ(component.direction == Direction::kVertical, direction == kUp);
    ASSERT_EQ(component.azimuth.has_value(), direction >= 0);
    if (!component.azimuth) return;
    EXPECT_NEAR(*component.azimuth, direction * kRadiansPerDegree, 1e-12);
  }

  std::filesystem::path folder_;
};

TEST_F(RealNetworkRecords, Csmip) {
  expect_references("csmip_v1_v2_v3/CE23837.V1", {0, kUp, 90});
  expect_references("csmip_v1_v2_v3/SYLMOVFF.V2", {90, kUp, 0});
  expect_references("csmip_v1_v2_v3/ce23583r_HESPERIA.RAW", {90, kUp, 180});
  expect_references("csmip_v1_v2_v3/ce36456p_CE36456.V2", {90, kUp, 0});
  expect_references("other_networks/cuya0911131.v1", {kNoDirection, kUp, kNoDirection});
}

TEST_F(RealNetworkRecords, Cosmos) {
  expect_references("cosmos/CE23837.V1C", {0, kUp, 90});
  expect_references("cosmos/Cosmos12TimeSeriesTest.v1", {340});
  // Its first channel states 340 degrees in the text, but 400 (up) where the format has it.
  expect_references("cosmos/Cosmos12TimeSeriesTest2.v1", {kUp, 90});
  expect_references("cosmos/NP8040-n.1000hyfh.HNE.01.V0c", {kNoDirection});
}

TEST_F(RealNetworkRecords, Usc) {
  expect_references("usc_volume/017m30bt.s0a", {352});
  expect_references("usc_volume/017m30cc.y0a", {0});
  expect_references("usc_volume/usaca40.044", {90});
}

TEST_F(RealNetworkRecords, Bhrc) { expect_references("other_networks/5526-1.V1", {50, kUp, 140}); }

TEST_F(RealNetworkRecords, CosmosCountsOfTheHeaderAreAPlausibleMotion) {
  const auto counts = read_components(folder_ / "cosmos/NP8040-n.1000hyfh.HNE.01.V0c")[0];
  const auto rows = references("cosmos/NP8040-n.1000hyfh.HNE.01.V0c");
  const double mean = counts.acceleration.mean();
  const double peak = (counts.acceleration.array() - mean).abs().maxCoeff();
  // 0.298024 microvolts, 1.2553 V/g; the reference is in counts.
  EXPECT_NEAR(peak, *number(rows[0][6]) * 0.298024e-6 / 1.2553 * kStandardGravity, 1e-6 * peak);
}

TEST_F(RealNetworkRecords, OneRecordInTwoFormatsIsTheSame) {
  const auto csmip = read_components(folder_ / "csmip_v1_v2_v3/CE23837.V1");
  const auto cosmos = read_components(folder_ / "cosmos/CE23837.V1C");
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(csmip[i].acceleration, cosmos[i].acceleration);
    EXPECT_EQ(csmip[i].start_time, cosmos[i].start_time);
  }
}

TEST_F(RealNetworkRecords, RefusesWhatIsNoRecord) {
  EXPECT_THAT(error_text([&] { read_components(folder_ / "csmip_v1_v2_v3/SYLMOVFF.V3"); }),
              HasSubstr("holds response spectra, not an acceleration history; take the .V2 of this "
                        "record"));
  EXPECT_THAT(
      error_text([&] {
        read_components(folder_ / "csmip_v1_v2_v3/24514_Sylmar_OliveView_MedicalCenterFF.zip");
      }),
      HasSubstr("a zip archive; unpack it first"));
}

// Whoever adds a file to these folders must add it here.
TEST_F(RealNetworkRecords, LeavesNoFileOut) {
  const std::map<std::string, int> files = {
      {"csmip_v1_v2_v3", 6}, {"cosmos", 4}, {"usc_volume", 3}};
  for (const auto& [folder, count] : files)
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_ / folder),
                            std::filesystem::directory_iterator()),
              count)
        << folder;
}

}  // namespace
}  // namespace gurney
