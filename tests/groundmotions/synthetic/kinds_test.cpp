#include "groundmotions/synthetic/kinds.h"

#include <gmock/gmock.h>

#include "engine/base/units.h"
#include "engine/config/document.h"
#include "groundmotions/measures/peaks.h"
#include "groundmotions/record/record_motion.h"
#include "groundmotions/synthetic/clough_penzien.h"
#include "tests/support/expect_error.h"

namespace gurney::groundmotions {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Pair;

TEST(SyntheticKinds, AllAreMadeAndSayThatTheyAreSynthetic) {
  for (const SyntheticKind& kind : synthetic_kinds()) {
    SCOPED_TRACE(kind.name);
    const Record record = make_record(synthetic_request(kind.name, {}));
    EXPECT_EQ(record.name, "synthetic " + kind.name);
    ASSERT_TRUE(record[Direction::kH1]);
    EXPECT_GT(peaks(record.time_step(), record[Direction::kH1]->acceleration).acceleration, 0.1);
    EXPECT_TRUE(floor_motion(record).acceleration().allFinite());
    for (const auto& component : record.components) {
      if (!component) continue;
      EXPECT_THAT(component->header, Contains(Pair("synthetic", "never recorded; made by Gurney")));
      EXPECT_THAT(component->header, Contains(Pair("kind", kind.name)));
      EXPECT_THAT(component->header, Contains(Pair("source", kind.source)));
      for (const SyntheticParameter& parameter : kind.parameters) {
        EXPECT_THAT(component->header, Contains(Pair(parameter.key, testing::Not(IsEmpty()))));
        EXPECT_TRUE(parameter.range.contains(parameter.fallback)) << parameter.key;
      }
    }
    const bool moves_on = kind.name == "half_sine" || kind.name == "full_sine" ||
                          kind.name == "step" || kind.name == "double_impulse";
    EXPECT_EQ(record.warnings.empty(), !moves_on);
  }
}

TEST(SyntheticKinds, TakeSettings) {
  const Record record = make_record(synthetic_request("ricker", {"pga_g=0.25", "period_s = 2"}));
  EXPECT_NEAR(record[Direction::kH1]->acceleration.maxCoeff(), 0.25 * kStandardGravity, 1e-4);
  EXPECT_THAT(record[Direction::kH1]->header, Contains(Pair("period_s", "2")));
  EXPECT_EQ(record.samples(), 1201);
}

TEST(SyntheticKinds, NoiseHasThePeakOfEachComponent) {
  const Record record = make_record(synthetic_request(
      "white_noise", {"pga_h1_g=0.3", "pga_h2_g=0.2", "pga_vertical_g=0.1", "duration_s=10"}));
  for (const auto& [direction, peak] :
       {std::pair{Direction::kH1, 0.3}, {Direction::kH2, 0.2}, {Direction::kVertical, 0.1}})
    EXPECT_NEAR(record[direction]->acceleration.cwiseAbs().maxCoeff(), peak * kStandardGravity,
                1e-12);
  EXPECT_ERROR(make_record(synthetic_request("white_noise", {"duration_s=10", "taper_s=6"})),
               "taper 6 s: must be > 0 and at most half the duration, 5 s");
}

// Default values: the middle of the noise is at 8 s, the pulse is 3 s long.
TEST(SyntheticKinds, NearFaultIsStochasticMotionAndAPulseInItsMiddle) {
  const Record both = make_record(synthetic_request("near_fault", {"seed=4"}));
  const Record noise = make_record(synthetic_request("stochastic", {"seed=4"}));
  const Record pulse = make_record(synthetic_request("near_fault_pulse", {"time_step_s=0.01"}));
  for (const Direction direction : {Direction::kH2, Direction::kVertical})
    EXPECT_EQ(both[direction]->acceleration, noise[direction]->acceleration);
  Eigen::VectorXd rest = both[Direction::kH1]->acceleration - noise[Direction::kH1]->acceleration;
  const Eigen::VectorXd& alone = pulse[Direction::kH1]->acceleration;
  // Rounding of a sum and a difference of numbers below 10 m/s2.
  EXPECT_LT((rest.segment(650, alone.size()) - alone).cwiseAbs().maxCoeff(), 4e-15);
  rest.segment(650, alone.size()).setZero();
  EXPECT_EQ(rest.cwiseAbs().maxCoeff(), 0);
}

TEST(SyntheticKinds, APulseLongerThanTheMotionIsAnError) {
  EXPECT_ERROR(make_record(synthetic_request("near_fault", {"period_s=100"})),
               "synthetic near_fault: the pulse ends at 150 s, after the motion, which ends at ");
}

TEST(SyntheticKinds, MakeTheShippedRecord) {
  const Record made = make_record(synthetic_request("clough_penzien", {}));
  const Record shipped = synthetic_record(shipped_synthetic_motion());
  for (const Direction direction : kDirections)
    // The same equations with frequencies given in Hz: rounding only.
    EXPECT_LT(
        (made[direction]->acceleration - shipped[direction]->acceleration).cwiseAbs().maxCoeff(),
        1e-9);
}

TEST(SyntheticKinds, WarnOfNoiseThatIsCut) {
  const Record cut = make_record(synthetic_request("clough_penzien", {"duration_s=15"}));
  EXPECT_THAT(cut.warnings, ElementsAre(HasSubstr("still at 0.17 of its peak at the end of 15 s")));
}

TEST(SyntheticKinds, LongPeriodMotionTravelsMetres) {
  const Record record = make_record(synthetic_request("long_period", {}));
  const auto& a = record[Direction::kH1]->acceleration;
  EXPECT_EQ(a.size(), 30001);
  const Peaks p = peaks(record.time_step(), a);
  EXPECT_NEAR(p.velocity, 0.8, 1e-9);
  // A sine of 4 s with this velocity has 0.51 m and 0.13 g.
  EXPECT_GT(p.displacement, 0.4);
  EXPECT_LT(p.acceleration, 0.3 * kStandardGravity);
  EXPECT_FALSE(record[Direction::kVertical]);
  EXPECT_ERROR(
      make_record(synthetic_request("long_period", {"pgv_h1_m_per_s=0", "pgv_h2_m_per_s=0"})),
      "synthetic long_period: a long-period motion needs a peak velocity > 0");
}

TEST(SyntheticKinds, RefuseWhatTheyDoNotKnow) {
  EXPECT_ERROR(synthetic_request("riker", {}),
               "records make: unknown kind 'riker'; did you mean 'ricker'?");
  EXPECT_ERROR(synthetic_request("earthquake", {}), "; known: half_sine, full_sine, step, ");
  EXPECT_ERROR(synthetic_request("ricker", {"pga_g=0.2", "perod_s=2"}),
               "records make ricker: perod_s: unknown key; did you mean 'period_s'?");
  EXPECT_ERROR(synthetic_request("ricker", {"duration_s=2"}),
               "duration_s: unknown key; known: period_s, pga_g, time_step_s");
  EXPECT_ERROR(synthetic_request("ricker", {"pga_g=-1"}),
               "records make ricker: pga_g = -1: must be a finite number > 0");
  EXPECT_ERROR(synthetic_request("ricker", {"pga_g=nan"}), "pga_g = 'nan': must be a number");
  EXPECT_ERROR(synthetic_request("white_noise", {"seed=1.5"}),
               "seed = 1.5: must be a whole number in 0..2147483647");
  EXPECT_ERROR(synthetic_request("ricker", {"pga_g"}),
               "records make ricker: 'pga_g': must be key=value, a number");
  EXPECT_ERROR(synthetic_request("ricker", {"pga_g=1\nperiod_s=2"}), "must be key=value");
  EXPECT_ERROR(make_record(synthetic_request("harmonic", {"taper_s=20"})),
               "synthetic harmonic: taper 20 s: must be > 0 and at most half the duration, 15 s");
}

TEST(SyntheticKinds, AreReadFromAJob) {
  config::Document document("[synthetic]\nkind = \"ac156\"\nsds_g = 1.2\nseed = 7\n", "job.toml");
  auto table = *document.root().table("synthetic");
  const auto request = read_synthetic_request(table);
  document.finish();
  ASSERT_TRUE(request);
  EXPECT_EQ(request->kind->name, "ac156");
  EXPECT_EQ(request->values.at("sds_g"), 1.2);
  EXPECT_EQ(request->values.at("seed"), 7);
  EXPECT_EQ(request->values.at("height_ratio"), 1);
}

TEST(SyntheticKinds, ReportedWrongInAJobAreErrorsAtTheirPlace) {
  config::Document document("kind = \"ac165\"\nsds_g = 1.2\n", "job.toml");
  auto table = document.root();
  EXPECT_FALSE(read_synthetic_request(table));
  EXPECT_ERROR(document.finish(),
               "job.toml:1:8: kind = \"ac165\": must be a known name; did you mean 'ac156'?");
  config::Document unknown("kind = \"ac156\"\nsds = 1.2\n", "job.toml");
  auto second = unknown.root();
  EXPECT_TRUE(read_synthetic_request(second));
  EXPECT_ERROR(unknown.finish(), "job.toml:2:1: sds: unknown key; did you mean 'sds_g'?");
}

}  // namespace
}  // namespace gurney::groundmotions
