#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "engine/base/error.h"
#include "studies/run/run_batch.h"
#include "studies/run/shard_status.h"
#include "studies/run/study_identity.h"
#include "tests/studies/small_study.h"
#include "tests/support/temp_folder.h"

/// The order of the cases of a study, judged by the time that each of them simulates, at one time
/// step: the pace of the machine and its load do not matter.
namespace gurney::study {
namespace {

/// Forty cases of 0.15 to 1.5 s.
constexpr const char* kForty = R"(schema = "gurney-job/1"
[item]
equipment = "xu_trolley"
[excitation.record]
synthetic = { kind = "ricker" }
[settings]
settle_time_s = 0
[study]
angles_deg = [0, 30, 60, 90]
[study.intensity]
scales = [1]
[[study.factor]]
name = "length"
key = "excitation.record.synthetic.period_s"
values = [0.05, 0.3, 0.1, 0.5, 0.2, 0.45, 0.15, 0.4, 0.25, 0.35]
)";

/// The cases in the order in which one thread ran them.
std::vector<TaskResult> in_order(const SmallStudy& study, PartFolder& folder) {
  std::vector<TaskResult> cases;
  for (std::size_t task = 0; task < study.plan.tasks(); ++task)
    cases.push_back(task_from_bytes(folder.read(task)));
  std::ranges::sort(cases, {}, [](const TaskResult& each) { return each.cost.ended; });
  return cases;
}

/// How many times faster two threads are than one, where each that is free takes the next case.
double speed_up_of_two(const std::vector<double>& times) {
  double busy[2] = {0, 0};
  for (const double time : times) *std::ranges::min_element(busy) += time;
  return std::accumulate(times.begin(), times.end(), 0.0) / std::max(busy[0], busy[1]);
}

TEST(Schedule, KeepsTwoThreadsBusyToTheEnd) {
  const TempFolder temp;
  const SmallStudy study(kForty);
  ASSERT_EQ(study.plan.tasks(), 40u);
  PartFolder folder(temp.file("parts"), identity_of(study.batch), 40, PartFolder::Start::kNew);
  const CrashLog crashes(temp.file("crashes"));
  run_batch(
      study.batch, folder, crashes, {}, 1, [] { return true; }, [](const auto&) {});
  std::vector<double> times;
  double cpu_seconds = 0;
  for (const TaskResult& each : in_order(study, folder)) {
    times.push_back(each.runs.at(0).response.end_time);
    cpu_seconds += each.cost.cpu_seconds;
  }
  // Graham's bound: the thread that ends last began its last case when the other was busy too, so that
  // the speed-up is at least 2 / (1 + last / sum). One mean case of 40 gives 1.951, the shortest 1.99;
  // the longest, at the end, 1.91.
  EXPECT_GT(speed_up_of_two(times), 1.95);
  std::rotate(times.begin(), std::ranges::max_element(times), times.end());
  std::rotate(times.begin(), times.begin() + 1, times.end());
  EXPECT_LT(speed_up_of_two(times), 1.95) << "the longest case at the end, and yet as fast";
  const std::vector<ShardStatus> status = study_status(temp.file("parts")).shards;
  ASSERT_EQ(status.size(), 1u);
  ASSERT_EQ(status[0].records.size(), 1u);
  const RecordTime& all = status[0].records.begin()->second;
  EXPECT_EQ(all.runs, 40u);
  EXPECT_NEAR(all.seconds, cpu_seconds, 1e-9);
  EXPECT_GT(status[0].runs_per_second, 0);
}

// An error ends a batch, such as that of a full disk: cases that have ended are in the folder.
TEST(RunBatch, KeepsWhatEndedBeforeAnError) {
  const TempFolder temp;
  const SmallStudy study(kForty);
  PartFolder folder(temp.file("parts"), identity_of(study.batch), 40, PartFolder::Start::kNew);
  const CrashLog crashes(temp.file("crashes"));
  int asked = 0;
  const auto fails = [&] {
    if (++asked > 20) throw Error("no space left");
    return true;
  };
  EXPECT_THROW(run_batch(study.batch, folder, crashes, {}, 1, fails, [](const auto&) {}), Error);
  std::size_t kept = 0;
  for (std::size_t task = 0; task < study.plan.tasks(); ++task) kept += folder.has(task);
  EXPECT_GT(kept, 0u);
  EXPECT_LT(kept, 40u);
}

}  // namespace
}  // namespace gurney::study
