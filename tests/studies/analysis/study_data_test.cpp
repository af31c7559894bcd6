#include "studies/analysis/study_data.h"

#include <gmock/gmock.h>

#include "engine/base/units.h"
#include "tests/studies/analysis/small_study.h"
#include "tests/studies/analysis/synthetic_runs.h"
#include "tests/support/expect_error.h"
#include "tests/support/temp_folder.h"

namespace gurney::study {
namespace {

using testing::ElementsAre;

class StudyDataTest : public testing::Test {
 protected:
  StudyData data(const std::vector<SmallRun>& runs) {
    write_small_study(folder_.file("s.h5"), runs);
    return StudyData(folder_.file("s.h5"));
  }
  TempFolder folder_;
};

TEST_F(StudyDataTest, FailedRunsAreCountedApart) {
  const StudyData study = data({{0, 1, 0.2}, {0, 2, 0.2, false, true}, {1, 1, 0.05}});
  EXPECT_THAT(study.runs_of(0), ElementsAre(0, 2));
  EXPECT_EQ(study.failed(0), 1);
}

TEST_F(StudyDataTest, UntrustedRunsAreFailedOnes) {
  SmallRun untrusted{0, 2, 17.0};
  untrusted.untrusted = true;
  const StudyData study = data({{0, 1, 0.2}, untrusted, {1, 1, 0.05}});
  EXPECT_THAT(study.runs_of(0), ElementsAre(0, 2));
  EXPECT_EQ(study.failed(0), 1);
}

TEST_F(StudyDataTest, ObservationsAreTheRunsOfTheItemsAsked) {
  const StudyData study = data({{0, 1, 0.2}, {0, 2, 0.11, true}, {1, 1, 0.05}});
  const RunMeasure own = study.measure("");
  EXPECT_EQ(own.name, "PGA h1");
  const auto moved = study.observations(0, 0, own);
  ASSERT_EQ(moved.size(), 3);
  EXPECT_TRUE(moved[0].exceeded);
  EXPECT_FALSE(moved[2].exceeded);
  EXPECT_EQ(moved[2].group, 1);
  EXPECT_EQ(moved[1].im, 2);
  // The fall at 0 s counts: -1, not 0, is "never". Combined: both of its parts.
  EXPECT_THAT(study.exceedances(1, {0, 1, 2}), ElementsAre(false, true, false));
  EXPECT_THAT(study.exceedances(2, {0, 1, 2}), ElementsAre(false, true, false));
}

// A jug that falls 3 m away from its cart is no cart that moved; it fell, and it can be asked for.
TEST_F(StudyDataTest, ContentsCountInWhatOnlyTheyHave) {
  SmallRun run{0, 1, 0.05};
  run.content_fell = true;
  const StudyData study = data({run});
  FileValues values(study.file());
  using Of = Quantity::Of;
  EXPECT_THAT(values(0, {Of::kItem, "peak_displacement", "", ""}), ElementsAre(0.05, 0));
  EXPECT_THAT(values(0, {Of::kItem, "peak_displacement", "cart/jug", ""}), ElementsAre(3));
  EXPECT_THAT(values(0, {Of::kItem, "time_of_fall", "", ""}), ElementsAre(-1, 1, -1));
  EXPECT_THAT(values(0, {Of::kItem, "time_of_toppling", "", ""}), ElementsAre(-1, 1, -1));
  EXPECT_THAT(study.exceedances(0, {0}), ElementsAre(false));
}

TEST_F(StudyDataTest, CloudsNeedALimitAboveZero) {
  std::string job = kSmallStudy;
  job.replace(job.find("above = 10"), 10, "above = 0 ");
  write_small_study(folder_.file("zero.h5"), {{0, 1, 0.2}, {1, 1, 0.1}}, job);
  const StudyData study(folder_.file("zero.h5"));
  EXPECT_ERROR(study.cloud(0, 0, study.measure(""), 1e-4), "a cloud needs a demand above a limit");
}

TEST_F(StudyDataTest, CloudsCensorWhatFellAndWhatStood) {
  const StudyData study = data({{0, 1, 0.2}, {1, 2, 0.04, true}, {2, 1, 0.0}});
  const auto points = study.cloud(0, 0, study.measure(""), 1e-4);
  ASSERT_EQ(points.size(), 3);
  EXPECT_EQ(points[0].known, statistics::CloudPoint::Known::kExactly);
  EXPECT_EQ(points[0].edp, 0.2);
  EXPECT_EQ(points[1].known, statistics::CloudPoint::Known::kAtLeast);
  EXPECT_EQ(points[1].edp, 0.1);  // the limit: it fell before it had gone so far
  EXPECT_EQ(points[2].known, statistics::CloudPoint::Known::kAtMost);
  EXPECT_ERROR(study.cloud(1, 0, study.measure(""), 1e-4), "a cloud needs a demand above a limit");
}

TEST_F(StudyDataTest, NamesTheNearestMeasure) {
  const StudyData study = data({{0, 1, 0.2}});
  EXPECT_ERROR(study.measure("PGA h2"), "no intensity measure 'PGA h2'; did you mean 'PGA h1'?");
}

TEST_F(StudyDataTest, RecordsThatAreAtOneLevelEachAreASuiteByLevel) {
  const auto by_level = [&](const std::vector<SmallRun>& runs) {
    return data(runs).has_suites_by_level();
  };
  EXPECT_TRUE(by_level({{0, 1, 0.2}, {1, 1, 0.2}, {2, 2, 0.2}}));
  EXPECT_FALSE(by_level({{0, 1, 0.2}, {1, 1, 0.2}, {1, 2, 0.2}}));
  EXPECT_FALSE(by_level({{0, 1, 0.2}, {1, 1, 0.2}})) << "of one level all records are";
}

TEST_F(StudyDataTest, ARecordThatIsAtTwoLevelsIsOneGroup) {
  const auto groups = [&](const std::vector<SyntheticRun>& runs) {
    SyntheticRuns study = study_of_records(3, runs);
    study.files = {"5a one.csv\n5b two.csv", "5a one.csv\n5c two.csv", "5a 1.csv\n5b 2.csv"};
    study.write(folder_.file("r.h5"));
    const StudyData read(folder_.file("r.h5"));
    std::vector<std::size_t> found;
    for (const auto& each : read.observations(0, 0, read.measure(""))) found.push_back(each.group);
    for (const auto& each : read.cloud(0, 0, read.measure(""), 1e-4)) found.push_back(each.group);
    return found;
  };
  EXPECT_THAT(groups({{0, 0, 1, 0.2}, {0, 1, 1, 0.2}, {0, 2, 2, 0.2}}),
              ElementsAre(0, 1, 0, 0, 1, 0));
  // Records that are at all levels are as many as the suite has.
  EXPECT_THAT(groups({{0, 0, 1, 0.2}, {0, 0, 2, 0.2}, {0, 2, 2, 0.2}}),
              ElementsAre(0, 0, 2, 0, 0, 2));
}

// The factor of a run stands on that of a list, which files of earlier programs do not state.
TEST_F(StudyDataTest, FactorsAreOnTheRecordsAsTheyWereRecorded) {
  const auto factors = [&](const std::vector<std::string>& scales) {
    SyntheticRuns study = study_of_records(2, {{0, 0, 1, 0.2}, {0, 1, 1, 0.2}, {0, 1, 2, 0.2}});
    study.scales = scales;
    study.write(folder_.file("r.h5"));
    return StudyData(folder_.file("r.h5")).factors_on_records();
  };
  EXPECT_THAT(factors({}), ElementsAre(1, 1, 2));
  EXPECT_THAT(factors({"3", "0.25"}), ElementsAre(3, 0.25, 0.5));
  for (const std::string bad : {"x", "0", ""})
    EXPECT_ERROR(factors({"3", bad}),
                 "r.h5: /records/scale[1] = '" + bad + "': must be a number > 0");
}

TEST_F(StudyDataTest, RefusesFilesOfSingleRuns) {
  Hdf5Writer file(folder_.file("one.h5"));
  file.set_attribute("/", "filetype", std::string("gurney-results"));
  file.finish();
  EXPECT_ERROR(StudyData(folder_.file("one.h5")), "is not a results file of a study");
}

}  // namespace
}  // namespace gurney::study
