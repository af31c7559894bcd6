#include <gmock/gmock.h>

#include "studies/analysis/study_comparison.h"
#include "tests/studies/analysis/synthetic_runs.h"
#include "tests/support/expect_error.h"
#include "tests/support/temp_folder.h"

namespace gurney::study {
namespace {

using testing::ElementsAre;

class RunPairsTest : public testing::Test {
 protected:
  StudyData data(const std::string& name, const SyntheticRuns& study) {
    study.write(folder_.file(name));
    return StudyData(folder_.file(name));
  }
  TempFolder folder_;
};

SyntheticRuns study(const std::vector<std::string>& records, const std::vector<SyntheticRun>& runs,
                    const std::string& in_study = "") {
  return {.job = synthetic_job(in_study), .records = records, .files = {}, .runs = runs};
}

TEST_F(RunPairsTest, RunsAreFoundByTheNameOfTheirRecordAndTheirLevel) {
  // The records stand in another order; one of A has no partner, one level of B has none.
  const StudyData a = data("a.h5", study({"r1", "r2", "r3"}, {{0, 0, 1}, {0, 1, 1}, {0, 2, 1}}));
  const StudyData b = data("b.h5", study({"r2", "r1"}, {{0, 0, 1}, {0, 1, 1}, {0, 1, 2}}));
  const RunPairs pairs = pair_runs({&a, 0}, {&b, 0});
  ASSERT_EQ(pairs.pairs.size(), 2);
  EXPECT_THAT(pairs.pairs[0].a, ElementsAre(0));
  EXPECT_THAT(pairs.pairs[0].b, ElementsAre(1));
  EXPECT_THAT(pairs.pairs[1].a, ElementsAre(1));
  EXPECT_THAT(pairs.pairs[1].b, ElementsAre(0));
  EXPECT_EQ(pairs.groups, 2);
  EXPECT_EQ(pairs.group, RunPairs::Group::kRecord);
  EXPECT_EQ(pairs.left_out_a, 1);
  EXPECT_EQ(pairs.left_out_b, 1);
  EXPECT_EQ(pairs.level, "PGA h1");
}

TEST_F(RunPairsTest, ARunThatFailedLeavesItsPartnerOut) {
  const StudyData a = data("a.h5", study({"r1", "r2"}, {{0, 0, 1}, {0, 1, 1}}));
  SyntheticRun failed{0, 1, 1};
  failed.failed = true;
  const StudyData b = data("b.h5", study({"r1", "r2"}, {{0, 0, 1}, failed}));
  const RunPairs pairs = pair_runs({&a, 0}, {&b, 0});
  EXPECT_EQ(pairs.pairs.size(), 1);
  EXPECT_EQ(pairs.left_out_a, 1);
  EXPECT_EQ(pairs.left_out_b, 0);
}

TEST_F(RunPairsTest, EqualNamesAreReportedApartByTheirOrder) {
  const SyntheticRuns two = study({"r", "r"}, {{0, 0, 1}, {0, 1, 1}});
  const StudyData a = data("a.h5", two), b = data("b.h5", two);
  EXPECT_THAT(record_names({&a, 0}), ElementsAre("r", "r (2)"));
  EXPECT_EQ(pair_runs({&a, 0}, {&b, 0}).pairs.size(), 2);
}

TEST_F(RunPairsTest, DrawsArePairedWhereTheyAreTheSame) {
  const std::vector<SyntheticRun> runs{{0, 0, 1, 0, 0, 0}, {0, 0, 1, 0, 0, 1}};
  const StudyData a = data("a.h5", study({"r"}, runs, "draws = 2\n"));
  const StudyData same = data("s.h5", study({"r"}, runs, "draws = 2\n"));
  const StudyData other = data("o.h5", study({"r"}, runs, "draws = 2\nseed = 7\n"));
  const RunPairs by_draw = pair_runs({&a, 0}, {&same, 0});
  EXPECT_EQ(by_draw.pairs.size(), 2);
  EXPECT_EQ(by_draw.group, RunPairs::Group::kDraw);  // the only record
  EXPECT_EQ(by_draw.groups, 2);
  // Draw 1 of another seed has nothing to do with draw 1: their means are held against each other.
  const RunPairs by_mean = pair_runs({&a, 0}, {&other, 0});
  ASSERT_EQ(by_mean.pairs.size(), 1);
  EXPECT_THAT(by_mean.pairs[0].b, ElementsAre(0, 1));
  EXPECT_EQ(by_mean.group, RunPairs::Group::kNone);
}

TEST_F(RunPairsTest, HypercubesOfOtherSizesHaveNoDrawsInCommon) {
  const std::string text = "draws = 1\nsampling = \"latin-hypercube\"\n";
  const StudyData a = data("a.h5", study({"r1"}, {{0, 0, 1, 0, 0, 0}}, text));
  const StudyData b =
      data("b.h5", study({"r1", "r2"}, {{0, 0, 1, 0, 0, 0}, {0, 1, 1, 0, 0, 1}}, text));
  EXPECT_FALSE(pair_runs({&a, 0}, {&b, 0}).by_draw);
}

TEST_F(RunPairsTest, AnglesThatNeverAgreeAreLeftOutOfSight) {
  const StudyData a = data("a.h5", study({"r1", "r2"}, {{0, 0, 1}, {0, 1, 1}}));
  const StudyData b = data("b.h5", study({"r1", "r2"}, {{0, 0, 1, 0, 0.7}, {0, 1, 1, 0, 0.7}}));
  const RunPairs pairs = pair_runs({&a, 0}, {&b, 0});
  EXPECT_FALSE(pairs.by_angle);
  EXPECT_EQ(pairs.pairs.size(), 2);
  EXPECT_TRUE(pair_runs({&a, 0}, {&a, 0}).by_angle);
}

TEST_F(RunPairsTest, NothingInCommonIsRefused) {
  const StudyData a = data("a.h5", study({"r1"}, {{0, 0, 1}}));
  const StudyData record = data("r.h5", study({"r9"}, {{0, 0, 1}}));
  const StudyData level = data("l.h5", study({"r1"}, {{0, 0, 2}}));
  EXPECT_ERROR(pair_runs({&a, 0}, {&record, 0}),
               "have no record in common: nothing can be compared with each other");
  EXPECT_ERROR(pair_runs({&a, 0}, {&level, 0}), "have no level in common");
}

TEST_F(RunPairsTest, ConfigurationsAreNamedEvenWithCommasInThem) {
  SyntheticRuns two = study({"r"}, {{0, 0, 1}});
  two.configurations = {"free, vinyl", "locked, vinyl", "free"};
  const StudyData a = data("a.h5", two);
  EXPECT_THAT(named_configurations(a, "locked, vinyl"), ElementsAre(1));
  EXPECT_THAT(named_configurations(a, "free, vinyl, locked, vinyl"), ElementsAre(0, 1));
  EXPECT_THAT(named_configurations(a, "free,locked, vinyl"), ElementsAre(2, 1));
  EXPECT_THAT(wanted_configurations(a, {"free,locked, vinyl", "free"}), ElementsAre(2, 1));
  EXPECT_ERROR(named_configurations(a, "fee"), "no configuration 'fee'; did you mean 'free'?");
  EXPECT_ERROR(named_configurations(a, "free,brake"),
               "no configuration 'brake'; known: 'free, vinyl', 'locked, vinyl', 'free'");
}

}  // namespace
}  // namespace gurney::study
