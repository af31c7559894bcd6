#include <gmock/gmock.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "engine/base/units.h"
#include "groundmotions/formats/format.h"
#include "groundmotions/formats/numbers.h"
#include "groundmotions/measures/peaks.h"
#include "tests/support/error_text.h"

/// Real files of arrays and national networks, which may not be part of the project: a folder
/// named by GURNEY_RECORDS, with reference_values.csv (one row for each component, in the file's
/// order).
namespace gurney {
namespace {

using testing::Contains;
using testing::HasSubstr;

constexpr int kUp = -1;  ///< else an azimuth in degrees

class RealArrayRecords : public testing::Test {
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

  /// @param directions  of the components: azimuth in degrees or kUp
  /// @returns the components
  std::vector<Component> expect_references(const std::string& file,
                                           const std::vector<int>& directions,
                                           const ReadOptions& options = {}) const {
    SCOPED_TRACE(file);
    const auto rows = references(file);
    auto components = read_components(folder_ / file, options);
    EXPECT_EQ(components.size(), rows.size());
    EXPECT_EQ(components.size(), directions.size());
    if (components.size() != rows.size() || rows.size() != directions.size()) return components;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      SCOPED_TRACE(rows[i][1]);
      expect_values(components[i], rows[i], components[i].format == "SAC");
      EXPECT_EQ(components[i].direction == Direction::kVertical, directions[i] == kUp);
      EXPECT_NEAR(components[i].azimuth.value_or(kUp * kRadiansPerDegree),
                  directions[i] * kRadiansPerDegree, 1e-12);
    }
    return components;
  }

  /// The references of SAC files are those of the samples without their mean.
  static void expect_values(const Component& component, const std::vector<std::string>& row,
                            bool without_mean) {
    EXPECT_EQ(component.acceleration.size(), number(row[3]));
    EXPECT_NEAR(component.time_step, *number(row[5]), 1e-12);
    Eigen::VectorXd a = component.acceleration;
    if (without_mean) a.array() -= a.mean();
    const Peaks p = peaks(component.time_step, a);
    const double pga = *number(row[6]), pgv = *number(row[10]) / 100;
    EXPECT_NEAR(p.acceleration, pga, 0.001 * pga);
    EXPECT_NEAR(p.velocity, pgv, 0.005 * pgv);
    EXPECT_NEAR(p.time_of_acceleration, *number(row[7]), 0.5 * component.time_step);
  }

  std::string error(const std::string& file, const ReadOptions& options = {}) const {
    return error_text([&] { read_components(folder_ / file, options); });
  }

  std::filesystem::path folder_;
};

TEST_F(RealArrayRecords, Smc) {
  for (const auto& [file, direction] :
       {std::pair{"0111a.smc", 0}, {"0111b.smc", kUp}, {"0111c.smc", 270}})
    EXPECT_TRUE(
        expect_references(std::string("usgs_smc/") + file, {direction})[0].warnings.empty());
  EXPECT_THAT(expect_references("usgs_smc/0165b_a.smc", {kUp})[0].warnings,
              Contains(HasSubstr("the station is in a building, floor 12")));
  const auto dam = expect_references("usgs_smc/891018_1.sma-1.0444a.smc", {65})[0];
  EXPECT_THAT(dam.warnings, Contains(HasSubstr("the station is in a dam")));
  EXPECT_THAT(dam.warnings, Contains(HasSubstr("brought to even steps of 0.005 s")));
}

TEST_F(RealArrayRecords, SmcWithoutOrientation) {
  const auto component = read_components(folder_ / "usgs_smc/A-CAT180.AT2.smc")[0];
  expect_values(component, references("usgs_smc/A-CAT180.AT2.smc")[0], false);
  EXPECT_FALSE(component.azimuth || component.direction);
  EXPECT_THAT(component.warnings, Contains(HasSubstr("does not say what it holds")));
}

TEST_F(RealArrayRecords, GeoNet) {
  const auto v1 = expect_references("geonet_v1a_v2a/20161113_110259_WTMC_20.V1A", {332, 242, kUp});
  const auto v2 = expect_references("geonet_v1a_v2a/20161113_110259_WTMC_20.V2A", {332, 242, kUp});
  for (const Component& component : v1) EXPECT_TRUE(component.warnings.empty());
  for (const Component& component : v2) EXPECT_TRUE(component.warnings.empty());
  // V2A puts five seconds before the samples of V1A.
  EXPECT_NEAR(*v1[0].start_time - *v2[0].start_time, 5, 1e-6);
}

TEST_F(RealArrayRecords, Unam) {
  const auto cup = expect_references("other_networks/CUP50401.012", {kUp, 90, 0});
  EXPECT_THAT(cup[0].warnings,
              Contains("the header states 17500 samples, but the file has 17502 rows; all were "
                       "taken"));
  const auto acac = expect_references("other_networks/ACAC8903.101", {kUp, 90, 0});
  EXPECT_EQ(acac[0].warnings.size(), 1u);
}

TEST_F(RealArrayRecords, Cwb) {
  for (const Component& component : expect_references("other_networks/1-EAS.dat", {kUp, 0, 90})) {
    EXPECT_TRUE(component.warnings.empty());
    EXPECT_EQ(component.start_time, 1517932229);  // date -u -d '2018-02-06 15:50:29' +%s
  }
}

TEST_F(RealArrayRecords, Sac) {
  const std::string stem = "sac/20190706031952.CJ.T001230.";
  EXPECT_TRUE(expect_references(stem + "HNE.sac", {90}, {.unit = "g"})[0].warnings.empty());
  expect_references(stem + "HNN.sac", {0}, {.unit = "g"});
  const auto up = expect_references(stem + "HNZ.sac", {kUp}, {.unit = "g"})[0];
  EXPECT_NEAR(up.acceleration.mean(), kStandardGravity, 0.03 * kStandardGravity);
  EXPECT_EQ(up.start_time, 1562383192);  // date -u -d '2019-07-06 03:19:52' +%s
  EXPECT_THAT(error(stem + "HNE.sac"), HasSubstr("a SAC file does not state its unit"));
}

TEST_F(RealArrayRecords, RefusesWhatIsNoRecord) {
  EXPECT_THAT(error("miniseed/CI.CCC..HNE.mseed"), HasSubstr("a miniSEED file, not a record"));
  EXPECT_THAT(error("miniseed/CI.CCC.xml"), HasSubstr("a StationXML file"));
}

// Whoever adds a file to these folders must add it here.
TEST_F(RealArrayRecords, LeavesNoFileOut) {
  for (const auto& [folder, count] :
       {std::pair{"usgs_smc", 6}, {"geonet_v1a_v2a", 2}, {"sac", 3}, {"miniseed", 4}})
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_ / folder),
                            std::filesystem::directory_iterator()),
              count)
        << folder;
}

}  // namespace
}  // namespace gurney
