#include "studies/analysis/measure_choice.h"

#include <gmock/gmock.h>

#include <cmath>

#include "engine/base/random/normal_draw.h"
#include "studies/report/study_report.h"
#include "tests/studies/analysis/synthetic_runs.h"
#include "tests/support/expect_error.h"
#include "tests/support/one_line.h"
#include "tests/support/temp_folder.h"

namespace gurney::study {
namespace {

using testing::HasSubstr;

class MeasureChoiceTest : public testing::Test {
 protected:
  StudyData data(const std::vector<SyntheticRun>& runs, std::size_t records) {
    study_of_records(records, runs).write(folder_.file("s.h5"));
    return StudyData(folder_.file("s.h5"));
  }
  TempFolder folder_;
};

/// ln displacement = ln 0.3 + 1.5 ln pfv + sigma z: pfa (= level) has nothing to do with it.
std::vector<SyntheticRun> ruled_by_pfv(std::size_t records, double sigma) {
  std::vector<SyntheticRun> runs;
  for (std::size_t i = 0; i < records; ++i)
    for (int level = 1; level <= 2; ++level) {
      SyntheticRun run{0, i, double(level)};
      const auto k = static_cast<std::uint64_t>(2 * i) + static_cast<std::uint64_t>(level);
      run.pfv = std::exp(normal_draw(1, k, 0));
      run.displacement = 0.3 * std::pow(run.pfv, 1.5) * std::exp(sigma * normal_draw(1, k, 1));
      runs.push_back(run);
    }
  return runs;
}

TEST_F(MeasureChoiceTest, FindsTheMeasureThatRules) {
  const StudyData study = data(ruled_by_pfv(40, 0.3), 40);
  const MeasureChoice choice = rank_measures({&study, 0}, 0);
  ASSERT_EQ(choice.rows.front().name, "pfv");
  // 80 runs: standard errors 0.3 / sqrt(160) = 0.024 of sigma, 0.3 / sqrt(80) = 0.034 of b; four of
  // them.
  EXPECT_NEAR(choice.rows.front().efficiency, 0.3, 0.1);
  EXPECT_NEAR(choice.rows.front().practicality, 1.5, 0.14);
  EXPECT_GT(choice.lead, 50);
  EXPECT_EQ(choice.stays_best, 1);
  EXPECT_THAT(choice.unknown, testing::ElementsAre("PGV h1"));
  EXPECT_THAT(report::verdict(choice), HasSubstr("pfv predicts this demand best"));
  EXPECT_THAT(report::verdict(choice), HasSubstr("the difference matters"));
}

TEST_F(MeasureChoiceTest, MeasuresInOneProportionAreEquallyGood) {
  std::vector<SyntheticRun> runs = ruled_by_pfv(20, 0.3);
  for (SyntheticRun& run : runs) run.pfv = 0.1 * run.level;  // as pfa and PGA h1
  const StudyData study = data(runs, 20);
  const MeasureChoice choice = rank_measures({&study, 0}, 0);
  EXPECT_EQ(choice.ties, 2);
  EXPECT_THAT(report::verdict(choice),
              HasSubstr("as good as pfa, pfv, to which it is proportional"));
}

/// A measure that one run lacks rests on fewer runs: its likelihood cannot be compared.
TEST_F(MeasureChoiceTest, MeasuresThatSomeRunsLackRankBehind) {
  std::vector<SyntheticRun> runs = ruled_by_pfv(20, 0.3);
  runs.back().pfv = std::nan("");
  const StudyData study = data(runs, 20);
  const MeasureChoice choice = rank_measures({&study, 0}, 0);
  ASSERT_EQ(choice.rows.size(), 3);
  EXPECT_EQ(choice.rows[0].left_out, 0);
  EXPECT_EQ(choice.rows[1].left_out, 0);
  EXPECT_EQ(choice.rows[2].name, "pfv");
  EXPECT_EQ(choice.rows[2].left_out, 1);
  EXPECT_LT(choice.rows[2].efficiency, choice.rows[0].efficiency);
}

TEST_F(MeasureChoiceTest, NoiseSettlesNothing) {
  std::vector<SyntheticRun> runs = ruled_by_pfv(10, 3);
  const StudyData study = data(runs, 10);
  const MeasureChoice choice = rank_measures({&study, 0}, 0);
  EXPECT_LT(choice.stays_best, 0.95);
  EXPECT_THAT(report::verdict(choice), testing::Not(HasSubstr("matters")));
}

TEST_F(MeasureChoiceTest, FallenAndResettingRunsAreCensored) {
  std::vector<SyntheticRun> runs = ruled_by_pfv(20, 0.3);
  runs[0].fell = true;
  runs[1].displacement = 0;
  const StudyData study = data(runs, 20);
  const MeasureChoice choice = rank_measures({&study, 0}, 0);
  EXPECT_EQ(choice.overturned, 1);
  EXPECT_EQ(choice.at_floor, 1);
  EXPECT_DOUBLE_EQ(choice.floor, 1e-4);  // of the limit, 0.1 m
  const std::string text = one_line(report::measure_findings({"", "moved", "", choice}));
  EXPECT_THAT(text, HasSubstr("1 overturned: demand at least the limit; 1 below 0.0001 m"));
  EXPECT_THAT(text, HasSubstr("not tested: magnitude, which"));
}

/// The demand rises e-fold with each magnitude, over 2 of them.
std::vector<SyntheticRun> ruled_by_magnitude() {
  std::vector<SyntheticRun> runs = ruled_by_pfv(40, 0.1);
  for (SyntheticRun& run : runs) {
    run.magnitude = 6 + 0.05 * static_cast<double>(run.record);
    run.displacement *= std::exp(*run.magnitude - 7);
  }
  return runs;
}

TEST_F(MeasureChoiceTest, MagnitudesOfAllRunsAreTested) {
  const StudyData study = data(ruled_by_magnitude(), 40);
  const MeasureChoice choice = rank_measures({&study, 0}, 0);
  ASSERT_THAT(choice.properties, testing::ElementsAre("factor on the record", "magnitude"));
  // ln demand scatters by 0.1 about a slope of 1: 50 standard errors and more in 80 runs.
  EXPECT_LT(choice.rows.front().sufficiency[1], 1e-6);
  const std::string text = one_line(report::measure_findings({"", "moved", "", choice}));
  EXPECT_THAT(text, HasSubstr("p of magnitude: the same for the magnitude of the records"));
  EXPECT_THAT(text, HasSubstr("not tested: distance,"));
}

TEST_F(MeasureChoiceTest, MagnitudesOfSomeRunsAreNot) {
  std::vector<SyntheticRun> runs = ruled_by_magnitude();
  runs.back().magnitude = std::nan("");
  const StudyData study = data(runs, 40);
  EXPECT_EQ(rank_measures({&study, 0}, 0).properties.size(), 1);
}

TEST_F(MeasureChoiceTest, EventsHaveNoSize) {
  const StudyData study = data(ruled_by_pfv(5, 0.3), 5);
  EXPECT_THAT(sized_states(study), testing::ElementsAre(0));
  EXPECT_ERROR(rank_measures({&study, 0}, 1), "a cloud needs a demand above a limit");
}

}  // namespace
}  // namespace gurney::study
