#include "studies/analysis/assessment.h"

#include <gmock/gmock.h>

#include "studies/analysis/fragility_result.h"
#include "tests/studies/analysis/small_study.h"
#include "tests/support/expect_error.h"
#include "tests/support/temp_folder.h"

namespace gurney::study {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr const char* kFile = R"(schema = "gurney-limit-states/1"
performance = ["near", "far"]
[[limit_state]]
name = "near"
demand = "peak_displacement"
above = 3
unit = "cm"
[[limit_state]]
name = "far"
item = "cart"
demand = "peak_displacement"
above = 0.15
unit = "m"
)";

constexpr const char* kHazard = R"(schema = "gurney-hazard/1"
measure = "PGA"
component = "h1"
unit = "g"
k0 = 1e-3
k = 2
)";

class AssessmentTest : public testing::Test {
 protected:
  AssessmentTest() {
    // Outcomes of both kinds at each level, so that curves can be fitted.
    std::vector<SmallRun> runs;
    for (std::size_t record = 0; record < 8; ++record)
      for (const double intensity : {1.0, 2.0, 4.0})
        runs.push_back({record, intensity, 0.01 * intensity * static_cast<double>(record + 1)});
    write_small_study(path_, runs);
  }
  StudyData assessed(const AssessmentRequest& by) { return StudyData(path_, by); }

  TempFolder folder_;
  std::string path_ = folder_.file("s.h5");
};

TEST_F(AssessmentTest, TheJobsAreTheDefault) {
  const StudyData study = assessed({});
  EXPECT_EQ(study.limit_states().size(), 3);
  EXPECT_THAT(study.performance(), ElementsAre(0, 1));
  EXPECT_NE(study.hazard_over(study.measure("")), nullptr);
  EXPECT_EQ(study.hazard_over(study.measure("pfa")), nullptr);
}

TEST_F(AssessmentTest, GivenStatesReplaceThoseOfTheJobAndItsPerformanceLevels) {
  const StudyData study = assessed({.limit_states = {"peak_displacement > 5 cm", "overturned"}});
  ASSERT_EQ(study.limit_states().size(), 2);
  EXPECT_EQ(study.limit_states()[0].name, "peak_displacement > 5 cm");
  EXPECT_THAT(study.performance(), IsEmpty());
  EXPECT_THAT(study.exceedances(0, {0, 14, 15}), ElementsAre(false, true, true));
}

TEST_F(AssessmentTest, AStateGivenAfterwardsHasTheCurveOfTheJobs) {
  const FragilityResult job = fragility_of(assessed({}), {});
  const FragilityResult given =
      fragility_of(assessed({.limit_states = {"peak_displacement > 0.1 m"}}), {});
  ASSERT_TRUE(job.curve().has_value());
  EXPECT_EQ(given.curve()->theta, job.curve()->theta);
  EXPECT_EQ(given.curve()->beta, job.curve()->beta);
  EXPECT_EQ(given.band.theta.low, job.band.theta.low);
  EXPECT_EQ(given.rate->rate, job.rate->rate);
}

TEST_F(AssessmentTest, FilesHaveStatesAndPerformanceLevels) {
  const StudyData study = assessed(
      {.limit_states = {"fell = overturned"}, .limit_states_file = folder_.write("l.toml", kFile)});
  ASSERT_EQ(study.limit_states().size(), 3);
  EXPECT_EQ(study.limit_states()[1].words, "cart: peak_displacement > 0.15 m");
  EXPECT_EQ(study.limit_states()[2].name, "fell");
  EXPECT_THAT(study.performance(), ElementsAre(0, 1));
  const std::vector<FragilityResult> results = {fragility_of(study, {.state = 0}),
                                                fragility_of(study, {.state = 1})};
  EXPECT_EQ(performance_tables(study, results).size(), 1);
}

TEST_F(AssessmentTest, PerformanceLevelsMayBeStatesOfTheJob) {
  const StudyData study = assessed(
      {.limit_states_file = folder_.write(
           "l.toml", "schema = \"gurney-limit-states/1\"\nperformance = [\"fell\", \"both\"]\n")});
  EXPECT_EQ(study.limit_states().size(), 3);
  EXPECT_THAT(study.performance(), ElementsAre(1, 2));
}

TEST_F(AssessmentTest, RefusesWhatTheFileDoesNotHold) {
  EXPECT_ERROR(assessed({.limit_states = {"screen: overturned"}}),
               "no item, marked point, zone or tether 'screen'; known: cart, bed");
  std::string file = kFile;
  file.replace(file.find("\"cart\""), 6, "\"card\"");
  EXPECT_ERROR(assessed({.limit_states_file = folder_.write("l.toml", file)}),
               "l.toml:8:1: limit_state[1]: " + path_ +
                   ", configuration all has no item 'card'; did you mean 'cart'?");
  EXPECT_ERROR(assessed({.limit_states_file = folder_.write(
                             "z.toml",
                             "schema = \"gurney-limit-states/1\"\n[[limit_state]]\nname = \"z\"\n"
                             "zone = \"door\"\nevent = \"entered\"\n")}),
               "z.toml:2:1: limit_state[0]: " + path_ + " holds no /zones");
  EXPECT_ERROR(assessed({.limit_states = {"a = overturned", "a = impact"}}),
               "two limit states have the name 'a'");
}

TEST_F(AssessmentTest, ListsAllErrorsWithTheirPlaces) {
  const std::string wrong = folder_.write("w.toml",
                                          "schema = \"gurney-limit-states/1\"\n"
                                          "performance = \"fal\"\n"
                                          "[[limit_state]]\n"
                                          "name = \"far\"\n"
                                          "demand = \"peak_displacment\"\n"
                                          "above = 1\n"
                                          "unit = \"m\"\n"
                                          "below_ = 1\n");
  const AssessmentRequest by{.limit_states_file = wrong};
  EXPECT_ERROR(assessed(by), "w.toml:2:15: performance: no limit state 'fal'; did you mean 'far'?");
  EXPECT_ERROR(assessed(by), "w.toml:5:10: limit_state[0].demand = \"peak_displacment\"");
  EXPECT_ERROR(assessed(by), "w.toml:8:1: limit_state[0].below_: unknown key");
  EXPECT_ERROR(assessed({.limit_states = {"x", "y"}}), "\n--limit-state \"y\"");
  EXPECT_ERROR(assessed({.limit_states_file = folder_.write("j.toml", kSmallStudy)}),
               "the file is a job, not a list of limit states");
  EXPECT_ERROR(assessed({.limit_states_file =
                             folder_.write("e.toml", "schema = \"gurney-limit-states/1\"\n")}),
               "limit_state: must be given, tables [[limit_state]], or performance, or both");
}

TEST_F(AssessmentTest, HazardsAreOverAMeasureOfTheirOwn) {
  const StudyData study = assessed({.hazard_file = folder_.write("h.toml", kHazard)});
  EXPECT_EQ(fragility_of(study, {}).rate->rate, fragility_of(assessed({}), {}).rate->rate);
  EXPECT_ERROR(study.hazard_over(study.measure("pfa")),
               "h.toml:2:11: the hazard is over PGA h1, the curves are over pfa");
  EXPECT_ERROR(assessed({.hazard_file = folder_.write("l.toml", kFile)}),
               "the file is a list of limit states, not a hazard curve");
}

}  // namespace
}  // namespace gurney::study
