#include "studies/analysis/overview.h"

#include <gmock/gmock.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "studies/report/overview_report.h"
#include "studies/results/results_file.h"
#include "tests/support/expect_error.h"
#include "tests/support/one_line.h"
#include "tests/support/synthetic_run.h"
#include "tests/support/synthetic_study.h"
#include "tests/support/temp_folder.h"

namespace gurney::study {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class Overview : public testing::Test {
 protected:
  Overview() { SyntheticStudy::write(path_); }

  TempFolder folder_;
  std::string path_ = folder_.file("overview.h5");
};

TEST_F(Overview, CountsRunsOfEachConfigurationAtEachLevel) {
  const StudyOverview overview = study_overview(path_);
  const std::size_t levels = SyntheticStudy::kLevels.size();
  ASSERT_EQ(overview.counts.size(), 2 * levels);
  for (std::size_t i = 0; i < overview.counts.size(); ++i) {
    std::size_t moved = 0;
    for (std::size_t record = 0; record < SyntheticStudy::kRecords; ++record)
      moved += SyntheticStudy::run(i / levels, record, i % levels) != SyntheticStudy::kFailed &&
               SyntheticStudy::moved(i / levels, record, i % levels);
    const LevelCounts& counts = overview.counts[i];
    EXPECT_EQ(counts.configuration, i < levels ? "false" : "true");
    EXPECT_EQ(counts.runs, SyntheticStudy::kRecords);
    EXPECT_EQ(counts.failed, i == levels - 1 ? 1u : 0u);  // run 17: record 2 at the last level
    EXPECT_THAT(counts.exceeded, ElementsAre(moved, 0, 0, 0)) << i;
  }
  EXPECT_EQ(overview.counts[2].level, "0.3 g");
  EXPECT_EQ(overview.runs, 2 * levels * SyntheticStudy::kRecords);
  EXPECT_EQ(overview.failed, 1u);
  EXPECT_EQ(overview.overturned, 0u);
}

TEST_F(Overview, PrintsTheScaleFactorsOfAllRecords) {
  const StudyOverview overview = study_overview(path_);
  EXPECT_THAT(one_line(report::overview_findings(overview)),
              HasSubstr("scaling factors 0.49 to 5.88; 40 of 40 records above 5"));
  EXPECT_EQ(nlohmann::json::parse(render::json(
                report::overview_findings(overview)))["scale_factors"]["records_above"],
            40);
}

TEST_F(Overview, HasOneMeaningForEachColumn) {
  const StudyOverview overview = study_overview(path_);
  ASSERT_TRUE(std::ranges::any_of(
      overview.states, [](const LimitState& state) { return state.name == "overturned"; }));
  std::vector<std::string> labels;
  for (const findings::Column& column : report::share_findings(overview).columns)
    if (!column.label.empty()) labels.push_back(column.label);
  for (const std::string& label : labels) EXPECT_EQ(std::ranges::count(labels, label), 1) << label;
}

TEST_F(Overview, NamesFailedRunsAndWhatMakesThemAgain) {
  const StudyOverview overview = study_overview(path_);
  ASSERT_EQ(overview.failures.size(), 1u);
  EXPECT_EQ(overview.failures[0].run, SyntheticStudy::kFailed);
  EXPECT_EQ(overview.failures[0].cause, "did not converge, \"badly\"");
  EXPECT_EQ(overview.failures[0].command, "gurney replay " + path_ + " 17");
}

TEST_F(Overview, ListsTheRangesThatWereNotDrawn) {
  const StudyOverview overview = study_overview(path_);
  ASSERT_TRUE(overview.undrawn.has_value());
  EXPECT_THAT(overview.undrawn->lines(), ElementsAre("bed.toml: chassis.mass_kg"));
  EXPECT_THAT(one_line(report::overview_findings(overview)),
              HasSubstr("uncertainties not propagated, parameters with a range that keep their "
                        "values bed.toml: chassis.mass_kg "));
  const auto json = nlohmann::json::parse(render::json(report::overview_findings(overview)));
  EXPECT_EQ(json["ranges_not_drawn"], nlohmann::json({"bed.toml: chassis.mass_kg"}));
}

TEST_F(Overview, QuotesNamesOfFilesForTheShell) {
  const std::string path = folder_.file("it's a study.h5");
  SyntheticStudy::write(path);
  EXPECT_THAT(study_overview(path).failures.at(0).command, HasSubstr("/it'\\''s a study.h5' 17"));
}

TEST_F(Overview, ReportsRecordsAssumptionsAndTheWorstEnergyAccount) {
  const StudyOverview overview = study_overview(path_);
  ASSERT_EQ(overview.file.motions.size(), SyntheticStudy::kRecords);
  EXPECT_THAT(overview.file.motions[3].warnings, ElementsAre("no vertical component"));
  EXPECT_THAT(overview.file.motions[0].files, ElementsAre(HasSubstr(" record_0.csv")));
  ASSERT_EQ(overview.file.assumptions.size(), 1u);  // both configurations share it
  EXPECT_EQ(overview.file.assumptions[0].range, "80 to 120");
  EXPECT_EQ(overview.file.energy_closure, 2e-4);
  EXPECT_EQ(overview.energy_closure_run, 30u);
}

TEST_F(Overview, ComparesDemandsWithThoseAtHalfTheStep) {
  const std::optional<StepCheck> step_check = study_overview(path_).step_check;
  ASSERT_TRUE(step_check);
  EXPECT_EQ(step_check->runs, 10u);
  const StepChange& peak = step_check->changes.at(0);
  EXPECT_EQ(peak.demand, "peak_displacement");
  EXPECT_EQ(peak.compared, 10u);
  // The change of run k is 1 - 1 / (1 + 0.01 (1 + k)); the median lies between those of 4 and 5.
  EXPECT_NEAR(peak.median, 1 - (1 / 1.05 + 1 / 1.06) / 2, 1e-12);
  EXPECT_NEAR(peak.largest, 1 - 1 / 1.10, 1e-12);
  EXPECT_EQ(peak.largest_run, 9u);
  ASSERT_EQ(step_check->states.size(), 4u);
  EXPECT_EQ(step_check->states[0].state, "moved");
  EXPECT_THAT(step_check->states[0].runs, ElementsAre(SyntheticStudy::kChanged));
  EXPECT_THAT(step_check->states[1].runs, IsEmpty());
  for (const StepChange& each : step_check->changes) {
    const bool any = each.demand != "time_of_overturning" &&
                     each.demand != "direction_of_overturning" &&
                     each.demand != "peak_impact_force" && each.demand != "peak_slide" &&
                     each.demand != "time_of_fall" && each.demand != "time_of_toppling" &&
                     each.demand != "peak_travel" && each.demand != "residual_travel" &&
                     each.demand != "peak_swing" && each.demand != "residual_swing" &&
                     each.demand != "time_of_release" && each.demand != "largest_stop_speed";
    EXPECT_EQ(each.compared, any ? 10u : 0u) << each.demand;
  }
}

TEST_F(Overview, HasNoStepCheckWhereTheStudyHasNone) {
  SyntheticStudy::write(path_, false);
  const StudyOverview overview = study_overview(path_);
  EXPECT_FALSE(overview.step_check);
  EXPECT_THAT(one_line(report::overview_findings(overview)), Not(HasSubstr("half the step")));
}

TEST_F(Overview, IsReadInATerminal) {
  const std::string text = one_line(report::overview_findings(study_overview(path_)));
  for (const char* line :
       {"Synthetic & <plain> ", "factor brakes false, true ",
        "intensity, PGA larger 0.1 g, 0.2 g, 0.3 g, 0.5 g, 0.8 g, 1.2 g ",
        "480, 0 overturned, 1 failed ", "(worst: run 30) ", "1 parameter without a source",
        " warning: no vertical component ", " and 31 more; --json lists all ",
        "did not converge, \"badly\" gurney replay ", "10 runs were repeated with half the step",
        " 1 further repetition failed ", " moved: a different outcome in 1 of 10 runs "})
    EXPECT_THAT(text, HasSubstr(line));
}

TEST_F(Overview, IsJson) {
  const auto json =
      nlohmann::json::parse(render::json(report::overview_findings(study_overview(path_))));
  EXPECT_EQ(json["filetype"], "gurney-study");
  EXPECT_EQ(json["counts"][5]["failed"], 1);
  EXPECT_EQ(json["records"].size(), SyntheticStudy::kRecords);
  EXPECT_EQ(json["failures"][0]["run"], SyntheticStudy::kFailed);
  EXPECT_EQ(json["step_check"]["failed"], 1);
  EXPECT_EQ(json["step_check"]["limit_states"][0]["changed_runs"][0], SyntheticStudy::kChanged);
}

TEST_F(Overview, OfOneRunHasItsMotionItsEndAndItsItems) {
  const Response response = synthetic_response();
  folder_.write("run.h5", results_image(synthetic_facts(), response));
  const RunOverview overview = run_overview(folder_.file("run.h5"));
  ASSERT_EQ(overview.file.motions.size(), 1u);
  EXPECT_EQ(overview.file.motions[0].name, "made-up");
  EXPECT_THAT(overview.file.motions[0].files,
              ElementsAre(std::string(64, 'b') + " x.AT2", std::string(64, 'c') + " y.AT2"));
  EXPECT_THAT(overview.file.warnings, ElementsAre("the record ends with 2.0 mm/s"));
  EXPECT_EQ(overview.outcome, "rested");
  EXPECT_EQ(overview.cause, "");
  EXPECT_EQ(overview.end_time, response.end_time);
  ASSERT_EQ(overview.items.size(), 1u);
  const Demands& demands = response.items[0].demands;
  EXPECT_EQ(overview.items[0].model, "Trolley");
  EXPECT_EQ(overview.items[0].peak_displacement, demands.peak_displacement);
  EXPECT_EQ(overview.items[0].residual_displacement, demands.residual_displacement);
  EXPECT_EQ(overview.items[0].peak_velocity, demands.peak_velocity);
  EXPECT_EQ(overview.items[0].peak_tilt, demands.peak_tilt);
  EXPECT_EQ(overview.items[0].time_of_overturning, demands.time_of_overturning);
}

TEST_F(Overview, RefusesOtherFiles) {
  const std::string text = folder_.file("text.h5");
  std::ofstream(text) << "no HDF5";
  EXPECT_ERROR(is_study_file(text), "text.h5: is not a results file of gurney");
  EXPECT_ERROR(is_study_file(text + "x"), "text.h5x: no such file");
  EXPECT_ERROR(run_overview(path_), "overview.h5: is the results file of a study");
  EXPECT_TRUE(is_study_file(path_));
}

}  // namespace
}  // namespace gurney::study
