#include "studies/plan/study_motions.h"

#include <gtest/gtest.h>

#include "tests/support/temp_folder.h"

namespace gurney::study {
namespace {

/// A study without a floor's building, whose records are stated in the job.
std::string job_with(const std::string& record, const std::string& study) {
  return "schema = \"gurney-job/1\"\nitem.equipment = \"xu_trolley\"\n[excitation.record]\n" +
         record + "\n[study]\n" + study + "\n[study.intensity]\nscales = [1]\n";
}

// Memory must not grow with the number of synthetic motions: one that nobody uses is let go, and
// is the same when it is made again.
TEST(StudyMotions, SyntheticMotionsAreNotKeptAndAreMadeAgainAlike) {
  const StudyJob job(job_with("synthetic = { kind = \"stochastic\" }", "synthetic_records = 3"),
                     "a.toml");
  FloorRecords none(1);
  const MotionSet set(job.job(0, {}), job.study(), none, 0);
  ASSERT_EQ(set.size(), 3U);
  FloorRecords::Shared motion = set.ground_record(1);
  const Eigen::VectorXd first = motion->components[0]->acceleration;
  const std::weak_ptr<const groundmotions::Record> seen = motion;
  motion.reset();
  EXPECT_TRUE(seen.expired());
  EXPECT_EQ(set.ground_record(1)->components[0]->acceleration, first);
  EXPECT_NE(set.ground_record(2)->components[0]->acceleration[9], first[9]);
  EXPECT_EQ(set.ground(1).duration,
            set.ground_record(1)->time_step() * static_cast<double>(first.size()));
}

TEST(StudyMotions, RecordedMotionsAreReadOnce) {
  const TempFolder folder;
  const std::string path = folder.write(
      "r.csv", "# time step 0.01 s, unit m/s2\ntime,h1\n0,0\n0.01,1\n0.02,2\n0.03,1\n0.04,0\n");
  const StudyJob job(folder.write("a.toml", job_with("file = \"r.csv\"\nunit = \"m/s2\"", "")));
  FloorRecords none(1);
  const MotionSet set(job.job(0, {}), job.study(), none, 0);
  const groundmotions::Record* const first = set.ground_record(0).get();
  EXPECT_EQ(set.ground_record(0).get(), first);
  EXPECT_EQ(first->samples(), 5);
}

}  // namespace
}  // namespace gurney::study
