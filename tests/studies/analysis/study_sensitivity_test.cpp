#include "studies/analysis/study_sensitivity.h"

#include <gmock/gmock.h>

#include "engine/base/random/normal_draw.h"
#include "studies/figures/study_figures.h"
#include "studies/report/study_report.h"
#include "tests/studies/analysis/synthetic_runs.h"
#include "tests/support/expect_error.h"
#include "tests/support/one_line.h"
#include "tests/support/temp_folder.h"

namespace gurney::study {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class StudySensitivityTest : public testing::Test {
 protected:
  StudyData data(const std::vector<SyntheticRun>& runs) {
    SyntheticRuns study{
        .job = synthetic_job("draws = 9\n"), .records = {"r"}, .files = {}, .runs = runs};
    const std::string path = folder_.file(std::to_string(++files_) + ".h5");
    study.write(path);
    return StudyData(path);
  }
  TempFolder folder_;
  int files_ = 0;
};

/// displacement = 3 u1 + u2 of uniform numbers: 9 / 10 and 1 / 10 of the variance.
std::vector<SyntheticRun> linear(int draws) {
  std::vector<SyntheticRun> runs;
  for (int i = 0; i < draws; ++i) {
    const auto k = static_cast<std::uint64_t>(i);
    const double u1 = uniform_draw(1, k, 1), u2 = uniform_draw(1, k, 2);
    SyntheticRun run{.level = 1, .displacement = 3 * u1 + u2, .draw = i};
    run.drawn = {{"big", u1}, {"idle", uniform_draw(1, k, 3)}, {"small", u2}};
    runs.push_back(run);
  }
  return runs;
}

const SensitivityRequest kPeak{
    .demand = "peak_displacement", .limit = "", .level = {}, .all_levels = true};

TEST_F(StudySensitivityTest, SharesOfTheVarianceAreFound) {
  const StudyData study = data(linear(900));
  const StudySensitivity found = study_sensitivity({&study, 0}, kPeak);
  ASSERT_EQ(found.inputs.size(), 3);
  EXPECT_THAT(found.inputs[0].names, ElementsAre("big"));
  EXPECT_THAT(found.inputs[1].names, ElementsAre("small"));
  // 30 classes: the spread within takes 1 / 900 of the share; chance about sqrt(2 * 29) / 900.
  EXPECT_NEAR(found.inputs[0].index->estimate, 0.9, 0.03);
  EXPECT_NEAR(found.inputs[1].index->estimate, 0.1, 0.06);
  EXPECT_NEAR(found.inputs[2].index->estimate, 0.0, 0.04);
  // u1 within its lowest and highest tenth: means 0.05 and 0.95 of it.
  EXPECT_NEAR(found.inputs[0].bar.swing(), 2.7, 0.15);
  EXPECT_NEAR(found.inputs[0].low, 0.1, 0.05);
  EXPECT_TRUE(found.correlated.empty());
  EXPECT_EQ(found.output, "cart: peak_displacement");
  const std::string text = one_line(report::sensitivity_findings({"", found, ""}));
  EXPECT_THAT(text, HasSubstr("big contributes most"));
  EXPECT_THAT(text, HasSubstr("(interactions) is in none of them"));
  EXPECT_THAT(text, testing::Not(HasSubstr("Few runs")));
}

TEST_F(StudySensitivityTest, ALargerIndexThatIsNotSettledIsNamed) {
  const StudyData study = data(linear(900));
  StudySensitivity found = study_sensitivity({&study, 0}, kPeak);
  found.inputs[0].index->interval.low = 0;
  found.inputs[1].index->interval.low = 0.05;
  const std::string text = one_line(report::sensitivity_findings({"", found, ""}));
  EXPECT_THAT(text, HasSubstr("small contributes most of those whose interval does not reach 0: "));
  EXPECT_THAT(text, HasSubstr("Before it, but not settled, since the interval reaches 0: big."));
}

TEST_F(StudySensitivityTest, EqualConstantAndCorrelatedInputsAreNamed) {
  std::vector<SyntheticRun> runs = linear(100);
  for (SyntheticRun& run : runs) {
    run.drawn["big again"] = run.drawn["big"];
    run.drawn["fixed"] = 7;
    run.drawn["much like small"] = run.drawn["small"] + 0.3 * run.drawn["idle"];
  }
  const StudyData study = data(runs);
  const StudySensitivity found = study_sensitivity({&study, 0}, kPeak);
  EXPECT_THAT(found.constant, ElementsAre("fixed"));
  EXPECT_THAT(found.inputs[0].names, ElementsAre("big", "big again"));
  ASSERT_EQ(found.correlated.size(), 1);
  EXPECT_THAT(found.correlated[0], ElementsAre("much like small", "small"));
  const std::string text = one_line(report::sensitivity_findings({"", found, ""}));
  EXPECT_THAT(text, HasSubstr("big and 1 equal to it"));
  EXPECT_THAT(text, HasSubstr("Equal in every run, so one input: big, big again."));
  EXPECT_THAT(text,
              HasSubstr("the index of each holds what the others do: much like small, small"));
  EXPECT_THAT(text, HasSubstr("Drawn, but the same in every run: fixed."));
  EXPECT_THAT(figures::sensitivity_figure({"", found, ""}), HasSubstr("big and 1 equal to it"));
}

TEST_F(StudySensitivityTest, CorrelatedInputsCountOnce) {
  std::vector<SyntheticRun> runs = linear(400);
  for (SyntheticRun& run : runs)
    run.drawn["big, nearly"] = run.drawn["big"] + 1e-3 * run.drawn["idle"];
  const StudyData study = data(runs);
  // Twice 0.9 would be 1.9 with the small one.
  EXPECT_NEAR(study_sensitivity({&study, 0}, kPeak).sum, 1, 0.15);
}

TEST_F(StudySensitivityTest, LevelsAreAnInputUnlessOneIsChosen) {
  std::vector<SyntheticRun> runs = linear(100);
  for (SyntheticRun run : linear(100)) {
    run.level = 2;
    run.displacement += 10;
    runs.push_back(run);
  }
  const StudyData study = data(runs);
  const StudySensitivity all = study_sensitivity({&study, 0}, kPeak);
  EXPECT_THAT(all.inputs[0].names, ElementsAre("level"));
  EXPECT_FALSE(all.inputs[0].drawn);
  EXPECT_TRUE(all.repeated_draws);
  EXPECT_THAT(one_line(report::sensitivity_findings({"", all, ""})),
              HasSubstr("200 runs share 100 draws"));
  SensitivityRequest second = kPeak;
  second.level = 1;
  const StudySensitivity one = study_sensitivity({&study, 0}, second);
  EXPECT_EQ(one.runs, 100);
  EXPECT_EQ(one.level, "PGA h1 = 0.2039 g");
  EXPECT_THAT(one.inputs[0].names, ElementsAre("big"));
  second.level = 2;
  EXPECT_ERROR(study_sensitivity({&study, 0}, second), "has no level 3; it has 1 to 2");
}

// Stages planned for each configuration: the levels 1 and 4 of one, 2 of the other.
TEST_F(StudySensitivityTest, TheLevelIsOneThatTheConfigurationHas) {
  SyntheticRuns study{.job = synthetic_job("draws = 9\n", kBrakes),
                      .configurations = {"false", "true"},
                      .records = {"r"},
                      .files = {},
                      .runs = {}};
  for (const auto& [configuration, level] : {std::pair{0, 1.0}, {0, 4.0}, {1, 2.0}})
    for (SyntheticRun run : linear(40)) {
      run.configuration = static_cast<std::size_t>(configuration);
      run.level = level;
      study.runs.push_back(run);
    }
  study.write(folder_.file("stages.h5"));
  const StudyData stages(folder_.file("stages.h5"));
  const SensitivityRequest any{.demand = "peak_displacement", .limit = "", .level = {}};
  for (const std::size_t configuration : {0, 1})
    EXPECT_EQ(study_sensitivity({&stages, configuration}, any).runs, 40) << configuration;
}

TEST_F(StudySensitivityTest, LimitStatesAreOutputsToo) {
  std::vector<SyntheticRun> runs = linear(200);
  for (SyntheticRun& run : runs)
    run.displacement *= 0.05;  // above 0.1 where 3 u1 + u2 > 2: half of them
  const StudyData study = data(runs);
  const StudySensitivity found =
      study_sensitivity({&study, 0}, {.demand = "", .limit = "moved", .level = {}});
  EXPECT_EQ(found.output, "exceedance of moved");
  EXPECT_NEAR(found.mean, 0.5, 0.14);  // four standard deviations of 200 runs
  EXPECT_THAT(found.inputs[0].names, ElementsAre("big"));
}

TEST_F(StudySensitivityTest, WhatCannotBeReportedIsRefused) {
  const StudyData few = data(linear(19));
  EXPECT_ERROR(study_sensitivity({&few, 0}, kPeak),
               "19 runs of cart: peak_displacement are too few");
  std::vector<SyntheticRun> runs = linear(50);
  for (SyntheticRun& run : runs) run.displacement = 1;
  const StudyData same = data(runs);
  EXPECT_ERROR(study_sensitivity({&same, 0}, kPeak), "is 1 in every run: no input controls it");
  EXPECT_ERROR(
      study_sensitivity({&same, 0}, {.demand = "peak_displacment", .limit = "", .level = {}}),
      "no demand 'peak_displacment'; did you mean 'peak_displacement'?");
  for (SyntheticRun& run : runs) run.draw = -1;
  const StudyData undrawn = data(runs);
  EXPECT_ERROR(study_sensitivity({&undrawn, 0}, kPeak), "the study drew no numbers");
}

// displacement = 3 u + v with v anew in each of four replicas: chaos is 1 / 10 of the variance.
// MS_within of 300 * 3 degrees has the relative error sqrt(2 / 900) sqrt(1 + kurtosis / 2 of -1.2),
// 3 %; the variance of 3 u over 300 draws 5 %: together 0.006, times 4.5.
TEST_F(StudySensitivityTest, ReplicasShowTheShareOfChaos) {
  std::vector<SyntheticRun> runs;
  for (int i = 0; i < 300; ++i)
    for (int replica = 0; replica < 4; ++replica) {
      const auto k = static_cast<std::uint64_t>(i);
      const double u = uniform_draw(1, k, 1);
      SyntheticRun run{
          .displacement = 3 * u + uniform_draw(2, k, static_cast<std::uint64_t>(replica)),
          .draw = i,
          .replica = replica};
      run.drawn = {{"big", u}};
      runs.push_back(run);
    }
  const StudyData study = data(runs);
  const StudySensitivity found = study_sensitivity({&study, 0}, kPeak);
  ASSERT_EQ(found.inputs.size(), 2);
  EXPECT_THAT(found.inputs[1].names, ElementsAre(kChaos));
  EXPECT_FALSE(found.inputs[1].drawn);
  EXPECT_NEAR(found.inputs[1].index->estimate, 0.1, 0.027);
  EXPECT_NEAR(found.sum, 1, 0.05);
  EXPECT_THAT(one_line(report::sensitivity_findings({"", found, ""})), HasSubstr("chaos"));
}

}  // namespace
}  // namespace gurney::study
