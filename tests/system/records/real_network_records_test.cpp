#include "tests/system/records/real_records.h"

namespace gurney::groundmotions {
namespace {

/// Of strong motion networks; their reference values are in real_records_test.cpp.
using RealNetworkRecords = RealRecords;

TEST_F(RealNetworkRecords, Csmip) {
  expect_directions("csmip_v1_v2_v3/CE23837.V1", {0, kUp, 90});
  expect_directions("csmip_v1_v2_v3/SYLMOVFF.V2", {90, kUp, 0});
  expect_directions("csmip_v1_v2_v3/ce23583r_HESPERIA.RAW", {90, kUp, 180});
  expect_directions("csmip_v1_v2_v3/ce36456p_CE36456.V2", {90, kUp, 0});
  expect_directions("other_networks/cuya0911131.v1", {kNoDirection, kUp, kNoDirection});
}

TEST_F(RealNetworkRecords, Cosmos) {
  expect_directions("cosmos/CE23837.V1C", {0, kUp, 90});
  expect_directions("cosmos/Cosmos12TimeSeriesTest.v1", {340});
  // Its first channel states 340 degrees in the text, but 400 (up) where the format has it.
  expect_directions("cosmos/Cosmos12TimeSeriesTest2.v1", {kUp, 90});
  expect_directions("cosmos/NP8040-n.1000hyfh.HNE.01.V0c", {kNoDirection});
}

TEST_F(RealNetworkRecords, Usc) {
  expect_directions("usc_volume/017m30bt.s0a", {352});
  expect_directions("usc_volume/017m30cc.y0a", {0});
  expect_directions("usc_volume/usaca40.044", {90});
}

TEST_F(RealNetworkRecords, Bhrc) { expect_directions("other_networks/5526-1.V1", {50, kUp, 140}); }

TEST_F(RealNetworkRecords, CosmosCountsOfTheHeaderAreAPlausibleMotion) {
  const auto counts = read("cosmos/NP8040-n.1000hyfh.HNE.01.V0c")[0];
  const auto rows = references("cosmos/NP8040-n.1000hyfh.HNE.01.V0c,");
  const double mean = counts.acceleration.mean();
  const double peak = (counts.acceleration.array() - mean).abs().maxCoeff();
  // 0.298024 microvolts, 1.2553 V/g; the reference is in counts.
  EXPECT_NEAR(peak, rows[0].pga * 0.298024e-6 / 1.2553 * kStandardGravity, 1e-6 * peak);
}

TEST_F(RealNetworkRecords, OneRecordInTwoFormatsIsTheSame) {
  const auto csmip = read("csmip_v1_v2_v3/CE23837.V1");
  const auto cosmos = read("cosmos/CE23837.V1C");
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(csmip[i].acceleration, cosmos[i].acceleration);
    EXPECT_EQ(csmip[i].start_time, cosmos[i].start_time);
  }
}

}  // namespace
}  // namespace gurney::groundmotions
