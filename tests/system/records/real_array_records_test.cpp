#include "tests/system/records/real_records.h"

namespace gurney::groundmotions {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Pair;

/// Of arrays and national networks; their reference values are in real_records_test.cpp.
using RealArrayRecords = RealRecords;

TEST_F(RealArrayRecords, Smc) {
  for (const auto& [file, direction] :
       {std::pair{"0111a.smc", 0}, {"0111b.smc", kUp}, {"0111c.smc", 270}})
    EXPECT_TRUE(
        expect_directions(std::string("usgs_smc/") + file, {direction})[0].warnings.empty());
  EXPECT_THAT(expect_directions("usgs_smc/0165b_a.smc", {kUp})[0].header,
              Contains(Pair("location", "a building, floor 12")));
  const auto dam = expect_directions("usgs_smc/891018_1.sma-1.0444a.smc", {65})[0];
  EXPECT_THAT(dam.header, Contains(Pair("location", HasSubstr("a dam"))));
  EXPECT_THAT(dam.warnings, Contains(HasSubstr("brought to even steps of 0.005 s")));
  EXPECT_THAT(expect_directions("usgs_smc/A-CAT180.AT2.smc", {kNoDirection})[0].warnings,
              Contains(HasSubstr("does not say what it holds")));
}

TEST_F(RealArrayRecords, GeoNet) {
  const auto v1 = expect_directions("geonet_v1a_v2a/20161113_110259_WTMC_20.V1A", {332, 242, kUp});
  const auto v2 = expect_directions("geonet_v1a_v2a/20161113_110259_WTMC_20.V2A", {332, 242, kUp});
  for (const Component& component : v1) EXPECT_TRUE(component.warnings.empty());
  for (const Component& component : v2) EXPECT_TRUE(component.warnings.empty());
  // V2A puts five seconds before the samples of V1A.
  EXPECT_NEAR(*v1[0].start_time - *v2[0].start_time, 5, 1e-6);
}

TEST_F(RealArrayRecords, Unam) {
  const auto cup = expect_directions("other_networks/CUP50401.012", {kUp, 90, 0});
  EXPECT_THAT(cup[0].warnings,
              Contains("the header states 17500 samples, but the file has 17502 rows; all were "
                       "taken"));
  const auto acac = expect_directions("other_networks/ACAC8903.101", {kUp, 90, 0});
  EXPECT_EQ(acac[0].warnings.size(), 1u);
}

TEST_F(RealArrayRecords, Cwb) {
  for (const Component& component : expect_directions("other_networks/1-EAS.dat", {kUp, 0, 90})) {
    EXPECT_TRUE(component.warnings.empty());
    EXPECT_EQ(component.start_time, 1517932229);  // date -u -d '2018-02-06 15:50:29' +%s
  }
}

TEST_F(RealArrayRecords, Sac) {
  const std::string stem = "sac/20190706031952.CJ.T001230.";
  EXPECT_TRUE(expect_directions(stem + "HNE.sac", {90}, {.unit = "g"})[0].warnings.empty());
  expect_directions(stem + "HNN.sac", {0}, {.unit = "g"});
  const auto up = expect_directions(stem + "HNZ.sac", {kUp}, {.unit = "g"})[0];
  EXPECT_NEAR(up.acceleration.mean(), kStandardGravity, 0.03 * kStandardGravity);
  EXPECT_EQ(up.start_time, 1562383192);  // date -u -d '2019-07-06 03:19:52' +%s
  EXPECT_THAT(error(stem + "HNE.sac"), HasSubstr("a SAC file does not state its unit"));
}

}  // namespace
}  // namespace gurney::groundmotions
