#include "studies/plan/study_job.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/studies/small_study.h"
#include "tests/support/error_text.h"

namespace gurney::study {
namespace {

using testing::ElementsAre;

StudyJob job_of(const std::string& study) { return StudyJob(small_job(study), "a.toml"); }

std::string errors(const std::string& study) {
  return error_text([&] { job_of(study); });
}

std::vector<std::string> names(const StudyJob& job) {
  std::vector<std::string> all;
  for (const Configuration& each : job.configurations()) {
    std::string name;
    for (const std::string& level : each.levels) name += (name.empty() ? "" : "|") + level;
    all.push_back(name);
  }
  return all;
}

constexpr const char* kTwoFactors = R"([[study.factor]]
name = "casters"
[study.factor.level.small]
item.casters = "R100"
[study.factor.level.big]
item.casters = "R125"
floor.slope = 0.01
[[study.factor]]
key = "item.brakes"
values = [false, true, [true, true, false, false]]
)";

TEST(StudyJob, CombinesEachLevelWithEachOfTheOthersTheLastFastest) {
  const StudyJob job = job_of(kTwoFactors);
  EXPECT_THAT(names(job),
              ElementsAre("small|false", "small|true", "small|[true, true, false, false]",
                          "big|false", "big|true", "big|[true, true, false, false]"))
      << "levels in the order of the file, not of their names";
  EXPECT_EQ(job.study().factors[1].name, "factor 2");
}

TEST(StudyJob, PutsThePatchesOverTheJob) {
  const StudyJob job = job_of(kTwoFactors);
  const Job small = job.job(0, {}), half = job.job(5, {});
  EXPECT_EQ(small.scene.slope, 0);
  EXPECT_EQ(half.scene.slope, 0.01);
  const auto& small_casters = small.scene.items[0].model.casters;
  const auto& big_casters = half.scene.items[0].model.casters;
  EXPECT_LT(small_casters[0].wheel_radius, big_casters[0].wheel_radius);
  EXPECT_EQ(small_casters[0].brake_torque, 0);
  EXPECT_GT(big_casters[1].brake_torque, 0);
  EXPECT_EQ(big_casters[2].brake_torque, 0);
}

TEST(StudyJob, MakesTheCombinationsThatAreListedInTheirOrder) {
  const std::string rows = R"(combinations = [["big", true], ["small", "false"], ["big", false]]
)";
  const StudyJob job = job_of(rows + kTwoFactors);
  EXPECT_THAT(names(job), ElementsAre("big|true", "small|false", "big|false"));
  EXPECT_EQ(job.job(0, {}).scene.slope, 0.01);
  EXPECT_EQ(job.job(1, {}).scene.slope, 0);
  EXPECT_GT(job.job(0, {}).scene.items[0].model.casters[0].brake_torque, 0);
  EXPECT_EQ(job.job(2, {}).scene.items[0].model.casters[0].brake_torque, 0);
}

TEST(StudyJob, EachWrongCombinationIsReportedWhereItStands) {
  const std::string rows = R"(combinations = [["bib", true], ["big"], ["small", true],
  ["small", true], 3]
)";
  EXPECT_EQ(
      errors(rows + kTwoFactors),
      "a.toml:11:18: study.combinations[0][0] = \"bib\": no level of factor 'casters'; did "
      "you mean 'big'?\n"
      "a.toml:11:32: study.combinations[1] = [\"big\"]: must name a level of each of the 2 "
      "factors, in their order\n"
      "a.toml:12:3: study.combinations[3] = [\"small\", true]: is there twice\n"
      "a.toml:12:20: study.combinations[4] = 3: must name a level of each of the 2 factors, in "
      "their order");
  EXPECT_EQ(
      errors("combinations = [[1]]\n"),
      "a.toml:11:16: study.combinations = [[1]]: must be an array of 1 or more rows of levels, "
      "and needs [[study.factor]]");
}

TEST(StudyJob, AWrongLevelIsReportedWhereItStands) {
  EXPECT_EQ(errors("[[study.factor]]\nkey = \"item.brake\"\nvalues = [false, true]\n"),
            "a.toml:12:7: item.brake: unknown key; did you mean 'brakes'?");
  EXPECT_EQ(errors("[[study.factor]]\nkey = \"item.yaw_deg\"\nvalues = [0, \"north\"]\n"),
            "a.toml:13:14: item.yaw_deg = \"north\": must be a finite number");
  EXPECT_EQ(errors("[[study.factor]]\n[study.factor.level.a]\nitem.casters = \"R101\"\n"),
            "a.toml:13:16: item.casters = \"R101\": unknown caster; did you mean 'R100'?");
}

TEST(StudyJob, ErrorsOfTheStudyDoNotHideThoseOfTheJob) {
  EXPECT_EQ(
      errors("draws = 0\n[[study.factor]]\nkey = \"item.brakes\"\nvalues = [2]\n[uncertainty]\n"),
      "a.toml:11:9: study.draws = 0: must be a whole number in 1..2147483647\n"
      "a.toml:15:2: uncertainty: must not go with [study], which has draws and a seed of its "
      "own\n"
      "a.toml:14:11: item.brakes = 2: must be true or false");
}

TEST(StudyJob, HasNoPeakErrorOfItsRuns) {
  EXPECT_EQ(errors("[[study.factor]]\nkey = \"settings.peak_error\"\nvalues = [0.01]\n"),
            "a.toml:13:11: settings.peak_error: is for single runs; in a study, study.step_check "
            "compares runs with half the time step");
}

TEST(StudyJob, ALevelNamesOneOfSeveralItems) {
  const std::string head = R"(schema = "gurney-job/1"
[[item]]
name = "bed"
equipment = "icu_bed"
[[item]]
name = "trolley"
equipment = "xu_trolley"
position_m = [3, 0]
[study]
[[study.factor]]
)";
  const StudyJob job(head + "key = \"item.trolley.brakes\"\nvalues = [false, true]\n", "a.toml");
  const auto brake = [&](std::size_t configuration, std::size_t item) {
    return job.job(configuration, {}).scene.items[item].model.casters[0].brake_torque;
  };
  EXPECT_EQ(brake(0, 0), brake(1, 0));
  EXPECT_EQ(brake(0, 1), 0);
  EXPECT_GT(brake(1, 1), 0);
  EXPECT_EQ(error_text([&] {
              StudyJob(head + "name = \"b\"\nkey = \"item.troley.brakes\"\nvalues = [true]\n",
                       "a.toml");
            }),
            "a.toml:12:7: study.factor.b.item.troley: no [[item]] has this name; did you mean "
            "'trolley'?");
}

TEST(StudyJob, ReadsTheSameFromTheTextItKeeps) {
  const StudyJob job = job_of(kTwoFactors);
  const StudyJob again(job.text(), job.file());
  EXPECT_EQ(names(job), names(again));
  EXPECT_EQ(job.job(3, {}).scene.slope, again.job(3, {}).scene.slope);
}

}  // namespace
}  // namespace gurney::study
