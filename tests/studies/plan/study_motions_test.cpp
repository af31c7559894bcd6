#include "studies/plan/study_motions.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "studies/run/run_batch.h"
#include "studies/run/run_task.h"
#include "tests/support/expect_error.h"
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

/// Two records, `a` for the first level and `a` and `b` for the second.
class SuiteByLevel : public testing::Test {
 protected:
  SuiteByLevel() {
    for (const std::string name : {"a", "b"})
      folder_.write(name + ".csv", "# time step 0.01 s, unit m/s2\ntime,h1\n0,0\n0.01," +
                                       std::string(name == "a" ? "1" : "2") +
                                       "\n0.02,2\n0.03,1\n0.04,0\n");
    folder_.write("low.csv", "name, file\na, a.csv\n");
    folder_.write("high.csv", "name, file, scale\na, a.csv, \nb, b.csv, 3\n");
  }

  std::string job(const std::string& suites, const std::string& intensity,
                  const std::string& study = "") const {
    return folder_.write("job.toml",
                         "schema = \"gurney-job/1\"\nitem.equipment = \"xu_trolley\"\n"
                         "[excitation.record]\n" +
                             suites + "\nuse = \"x\"\n[settings]\nduration_s = 0.2\n[study]\n" +
                             study + "\n[study.intensity]\n" + intensity);
  }

  static constexpr const char* kSuites = "suite_by_level = [\"low.csv\", \"high.csv\"]";
  static constexpr const char* kLevels =
      "measure = \"PGA\"\ncomponent = \"h1\"\nunit = \"g\"\nlevels = [0.1, 0.3]";
  TempFolder folder_;
};

TEST_F(SuiteByLevel, EachRecordIsRunAtItsOwnLevelOnly) {
  const StudyJob study(job(kSuites, kLevels, "angles_deg = [0, 90]"));
  const StudyMotions motions(study);
  const MotionSet& set = motions.set(0);
  ASSERT_EQ(set.size(), 3U);
  EXPECT_EQ(set.name(0), "a at 0.1 g");
  EXPECT_EQ(set.name(1), "a at 0.3 g");
  EXPECT_EQ(set.name(2), "b at 0.3 g");
  EXPECT_EQ(set.stated_scale(1), 1);
  EXPECT_EQ(set.stated_scale(2), 3);
  const std::vector<double>& levels = study.study().intensity.levels;
  EXPECT_THAT(set.levels(0), testing::ElementsAre(levels[0]));
  EXPECT_THAT(set.levels(2), testing::ElementsAre(levels[1]));
  const Plan plan(study, motions);
  EXPECT_EQ(plan.runs(), 3U * 2);
  const Batch batch{study, motions, plan};
  for (const std::size_t task : {0U, 3U, 4U}) {
    const std::vector<double> of_stage = StageLevels(batch).of(plan.task(task));
    const TaskResult result = run_task(
        batch, task, [] { return true; }, {}, &of_stage);
    ASSERT_EQ(result.runs.size(), 1U);
    const double level = levels[task < 2 ? 0 : 1];
    EXPECT_EQ(result.runs[0].intensity, level) << task;
    EXPECT_NEAR(result.runs[0].pfa / level, 1, 1e-12) << "one horizontal has the whole PGA";
  }
}

TEST_F(SuiteByLevel, GoesWithLevelsThatAreAsMany) {
  const auto error = [&](const std::string& suites, const std::string& intensity,
                         const std::string& study = "") {
    const std::string text = error_text([&] { StudyJob{job(suites, intensity, study)}; });
    const std::string where =
        folder_.file("job.toml") + ":4:18: excitation.record.suite_by_level: ";
    EXPECT_TRUE(text.starts_with(where)) << text;
    return text.substr(std::min(text.size(), where.size()));
  };
  EXPECT_EQ(error("suite_by_level = [\"low.csv\"]", kLevels),
            "must have a suite for each of the 2 study.intensity.levels, has 1");
  for (const std::string& intensity :
       {std::string("scales = [1, 2]"),
        std::string(kLevels) + "\nadaptive = { stages = 2, limit_state = \"moved\" }"})
    EXPECT_EQ(error(kSuites, intensity),
              "must go with study.intensity.levels that are not adaptive");
  EXPECT_EQ(error(kSuites, kLevels, "draws = 2\nsampling = \"saltelli\""),
            "must not go with study.sampling = \"saltelli\", where each record has each level");
}

TEST_F(SuiteByLevel, IsOfAllConfigurationsOrOfNone) {
  const StudyJob study(job("unit = \"m/s2\"", std::string(kLevels) +
                                                  "\n[[study.factor]]\nname = \"motions\"\n"
                                                  "[study.factor.level.each]\nexcitation.record." +
                                                  kSuites +
                                                  "\n[study.factor.level.all]\n"
                                                  "excitation.record.suite = [\"high.csv\"]\n"));
  const StudyMotions motions(study);
  EXPECT_EQ(error_text([&] { Plan(study, motions); }),
            folder_.file("job.toml") +
                ":3:1: excitation.record.suite_by_level: must be of all configurations or of none");
}

}  // namespace
}  // namespace gurney::study
