#include "studies/analysis/step_check.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "engine/base/random/normal_draw.h"
#include "studies/analysis/replica_spread.h"
#include "tests/studies/analysis/synthetic_runs.h"
#include "tests/support/temp_folder.h"

namespace gurney::study {
namespace {

using testing::ElementsAre;

constexpr std::size_t kRecords = 20;
constexpr int kReplicas = 4;

/// Records with one number each, on half the step 0.1 % larger.
std::vector<SyntheticRun> smooth() {
  std::vector<SyntheticRun> runs;
  for (std::size_t record = 0; record < kRecords; ++record)
    for (int replica = 0; replica < kReplicas; ++replica)
      runs.push_back(
          {.record = record, .displacement = 0.2, .replica = replica, .half_step = 0.2002});
  return runs;
}

/// Peaks drawn anew at each step, 0.08 m e^(0.5 z), times `factor` at half the step.
std::vector<SyntheticRun> scattered(double factor) {
  std::vector<SyntheticRun> runs = smooth();
  for (std::size_t i = 0; i < runs.size(); ++i) {
    runs[i].displacement = 0.08 * std::exp(0.5 * normal_draw(1, 0, i));
    runs[i].half_step = factor * 0.08 * std::exp(0.5 * normal_draw(1, 1, i));
  }
  return runs;
}

constexpr const char* kJoltedState =
    "[[study.limit_state]]\nname = \"jolted\"\npoint = \"top\"\n"
    "demand = \"peak_absolute_acceleration\"\nabove = 1.5\nunit = \"m/s2\"\n";

class StepCheckTest : public testing::Test {
 protected:
  StudyData data(const std::vector<SyntheticRun>& runs, const std::string& states = "") {
    SyntheticRuns study{.job = synthetic_job("", states), .records = {}, .files = {}, .runs = runs};
    for (std::size_t i = 0; i < kRecords; ++i) study.records.push_back(std::to_string(i));
    const std::string path = folder_.file(std::to_string(++files_) + ".h5");
    study.write(path);
    return StudyData(path);
  }
  TempFolder folder_;
  int files_ = 0;
};

TEST_F(StepCheckTest, ReplicasThatStayTogetherAreComparedByNumbers) {
  const auto check = step_check(data(smooth()));
  ASSERT_TRUE(check);
  EXPECT_FALSE(check->chaotic);
  EXPECT_EQ(check->changes[0].compared, kRecords * kReplicas);
  EXPECT_NEAR(check->changes[0].median, 1 - 0.2 / 0.2002, 1e-12);
}

// Of one distribution at both steps the interval of 95 % holds a ratio of 1 and a difference of 0;
// these draws are fixed, and such that it does. ln(1.6) = 0.47 is 8 standard errors
// 0.5 sqrt(2 / 80) = 0.079 and a bit away from 0.
/// The smooth runs; of their point 64 stay, 12 change by 2 %, and 4 by half, across 1.5 m/s2.
std::vector<SyntheticRun> with_points() {
  std::vector<SyntheticRun> runs = smooth();
  for (std::size_t i = 0; i < runs.size(); ++i) {
    runs[i].acceleration = 2;
    runs[i].half_step_acceleration = i % 20 == 0 ? 1 : i % 5 == 0 ? 1.96 : 2;
  }
  return runs;
}

TEST_F(StepCheckTest, MarkedPointsAreCompared) {
  const auto check = step_check(data(with_points(), kJoltedState));
  ASSERT_TRUE(check);
  const auto found = std::ranges::find(check->changes, "top: peak_absolute_acceleration",
                                       [](const StepChange& each) { return name_of(each); });
  ASSERT_NE(found, check->changes.end());
  EXPECT_EQ(found->compared, 80u);
  EXPECT_DOUBLE_EQ(found->largest, 0.5);
  EXPECT_DOUBLE_EQ(found->within_1_percent, 64.0 / 80);
  EXPECT_DOUBLE_EQ(found->within_5_percent, 76.0 / 80);
  EXPECT_EQ(found->median, 0);
  EXPECT_EQ(check->states.back().state, "jolted");
  EXPECT_THAT(check->states.back().runs, ElementsAre(0u, 20u, 40u, 60u));
  EXPECT_TRUE(check->unjudged.empty());
}

TEST_F(StepCheckTest, FilesWithoutPointsAtHalfTheStepSaySo) {
  std::vector<SyntheticRun> runs = with_points();
  for (SyntheticRun& run : runs) run.half_step_acceleration = {};
  const auto check = step_check(data(runs, kJoltedState));
  ASSERT_TRUE(check);
  EXPECT_THAT(check->unjudged, ElementsAre("jolted"));
  for (const StepChange& each : check->changes) EXPECT_EQ(each.point, "");
}

TEST_F(StepCheckTest, ReplicasThatPartAreComparedByDistributions) {
  const auto same = step_check(data(scattered(1)));
  ASSERT_TRUE(same && same->chaotic);
  EXPECT_EQ(same->chaotic->runs, kRecords * kReplicas);
  EXPECT_EQ(same->changes[0].compared, 0u) << "numbers are for the others";
  EXPECT_EQ(same->chaotic->demands[0].name, "peak_displacement");
  EXPECT_TRUE(same->chaotic->demands[0].of.interval.contains(0));
  EXPECT_EQ(same->chaotic->states[0].name, "moved");
  EXPECT_TRUE(same->chaotic->states[0].of.interval.contains(0));
  const auto other = step_check(data(scattered(1.6)));
  ASSERT_TRUE(other && other->chaotic);
  EXPECT_GT(other->chaotic->demands[0].of.interval.low, 0);
  EXPECT_NEAR(other->chaotic->demands[0].of.difference, std::log(1.6), 4.5 * 0.079);
  EXPECT_LT(other->chaotic->demands[0].of.p_permutation, 0.001);
}

TEST_F(StepCheckTest, OnlyTheCaseWhoseReplicasPartIsChaotic) {
  std::vector<SyntheticRun> runs = smooth();
  runs[5].displacement *= 1.02;  // a replica of record 1
  runs[9].fell = true;           // of record 2
  const StudyData study = data(runs);
  const std::vector<bool> chaotic = in_chaotic_cases(study.file());
  for (std::size_t run = 0; run < runs.size(); ++run)
    EXPECT_EQ(chaotic[run], runs[run].record == 1 || runs[run].record == 2) << run;
  const auto check = step_check(study);
  ASSERT_TRUE(check && check->chaotic);
  EXPECT_EQ(check->chaotic->runs, 2u * kReplicas);
  EXPECT_EQ(check->changes[0].compared, (kRecords - 2) * kReplicas);
}

}  // namespace
}  // namespace gurney::study
