#include "studies/convergence/convergence.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "engine/run/simulate.h"
#include "studies/figures/verification_figures.h"
#include "studies/report/verification_report.h"
#include "tests/studies/small_study.h"
#include "tests/support/one_line.h"
#include "tests/support/temp_folder.h"

namespace gurney::study {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

std::string study_file(const TempFolder& folder, const std::string& name = "a.toml") {
  return folder.write(name, small_job("synthetic_records = 2\nangles_deg = [0, 30]\n"
                                      "[study.intensity]\nmeasure = \"PGA\"\nunit = \"g\"\n"
                                      "component = \"h1\"\nlevels = [0.1, 0.4]\n",
                                      "kind = \"clough_penzien\", duration_s = 5"));
}

const ConvergedNumber& number_named(const Convergence& found, const std::string& name) {
  return *std::ranges::find(found.numbers, name, &ConvergedNumber::name);
}

TEST(ConvergenceCasesTest, OfAStudyAreSpreadOverItsPlan) {
  const TempFolder folder;
  const ConvergenceCases all = convergence_cases(study_file(folder), 100, 1);
  EXPECT_EQ(all.of_runs, 8);
  EXPECT_THAT(all.runs, SizeIs(8));
  const ConvergenceCases some = convergence_cases(study_file(folder, "b.toml"), 4, 1);
  ASSERT_THAT(some.runs, SizeIs(4));
  EXPECT_THAT(some.names[0], HasSubstr("0.1 g"));
  EXPECT_THAT(some.names[1], HasSubstr("0.4 g"));
  EXPECT_NE(some.names[0].substr(0, some.names[0].find(',')),
            some.names[2].substr(0, some.names[2].find(',')));
  for (const RunCase& run : some.runs) EXPECT_EQ(run.settings.history_step, 0);
}

TEST(ConvergenceTest, ValuesAreThoseOfTheVariants) {
  const TempFolder folder;
  const ConvergenceCases cases = convergence_cases(study_file(folder), 1, 1);
  const Convergence found = converge(cases, 0.02, 1);
  EXPECT_EQ(found.runs, 1);
  EXPECT_EQ(found.of_runs, 8);
  EXPECT_THAT(found.failed, IsEmpty());
  const ConvergedNumber& peak = number_named(found, "peak_displacement");
  ASSERT_EQ(peak.values.size(), found.variants.size());
  for (std::size_t i = 0; i < found.variants.size(); ++i) {
    const RunCase run = varied(cases.runs[0], found.variants[i]);
    EXPECT_EQ(peak.values[i],
              simulate(run.scene, run.floor, run.settings).items[0].demands.peak_displacement);
  }
  EXPECT_GT(*std::ranges::max_element(peak.values), *std::ranges::min_element(peak.values));
}

TEST(ConvergenceTest, OfAStudyAreMediansAndSharesOfAnyNumberOfThreads) {
  const TempFolder folder;
  const ConvergenceCases cases = convergence_cases(study_file(folder), 8, 1);
  const Convergence found = converge(cases, 0.02, 1);
  EXPECT_EQ(number_named(found, "peak_displacement").runs, 8);
  EXPECT_GT(number_named(found, "peak_displacement").scatter, 0);
  const ConvergedNumber& moved = number_named(found, "exceeds rolled");
  EXPECT_EQ(moved.item, "");
  EXPECT_EQ(render::json(report::convergence_findings(found)),
            render::json(report::convergence_findings(converge(cases, 0.02, 3))));
}

TEST(ConvergenceTest, ARunThatFailsIsNamedAndLeftOut) {
  const TempFolder folder;
  ConvergenceCases cases = convergence_cases(study_file(folder), 2, 1);
  cases.runs[1].scene.items[0].model.chassis_mass = -1;
  const Convergence found = converge(cases, 0.02, 1);
  ASSERT_THAT(found.failed, SizeIs(1));
  EXPECT_THAT(found.failed[0], HasSubstr(cases.names[1] + ": "));
  EXPECT_EQ(number_named(found, "peak_displacement").runs, 1);
}

TEST(ConvergenceReportTest, ReportsVerdictsAndWhatWasVaried) {
  Convergence found;
  found.tolerance = 0.02;
  found.runs = found.of_runs = 1;
  found.variants = variants_for(found.settings);
  found.numbers.push_back({.item = "cart",
                           .name = "peak_displacement",
                           .units = "m",
                           .runs = 1,
                           .values = std::vector<double>(found.variants.size(), 0.25),
                           .change = 0.1,
                           .order = 1.5,
                           .step = StepVerdict::kConverging,
                           .step_needed = 0.0013,
                           .solver_change = 0.03});
  const std::string text = one_line(report::convergence_findings(found));
  EXPECT_THAT(text, HasSubstr("time step 0.004 s, compared with 0.0005 s"));
  EXPECT_THAT(text, HasSubstr("needs a smaller step (0.0013 s); solver tolerance too loose"));
  const auto json = nlohmann::json::parse(render::json(report::convergence_findings(found)));
  EXPECT_EQ(json["numbers"][0]["verdict"], "needs a smaller step");
  EXPECT_EQ(json["variants"][1]["varied"], "time_step");
  EXPECT_EQ(json["variants"][1]["factor"], 2);
  EXPECT_THAT(figures::convergence_figure(found),
              HasSubstr(">no change above 0.001 %: cart, peak_displacement<"));
}

}  // namespace
}  // namespace gurney::study
