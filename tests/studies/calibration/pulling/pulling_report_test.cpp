#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "studies/figures/pulling_figures.h"
#include "studies/render/render.h"
#include "studies/report/calibration_report.h"
#include "tests/studies/calibration/pulling/pulling_study.h"

namespace gurney::calibration {
namespace {

using testing::HasSubstr;
using testing::Not;

report::PullingReport small_report(const TempFolder& folder) {
  const std::string path = folder.file("a.h5");
  run_pulling_tests(pulling_tests_of(R"(["R100", "polyflor_mystique", 0, "6 kg", "aligned"],
["R100", "polyflor_forest_fx", 2, "6 kg", "aligned"],
["R125", "polyflor_mystique", 0, "6 kg", "aligned"],
["R100", "polyflor_mystique", 0, "8 kg", "crosswise"])"),
                    path);
  return {"a.h5", "Small", simulated_trials(study::StudyReader(path)), {}, 0, {}};
}

std::size_t count(const std::string& text, const std::string& word) {
  std::size_t n = 0;
  for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++n;
  return n;
}

TEST(PullingReport, FiguresHaveTheirSeries) {
  const TempFolder folder;
  report::PullingReport report = small_report(folder);
  const std::string four = figures::pulling_figure_4(report);
  for (const char* title : {">Displacement<", ">Velocity<", ">Acceleration<", ">Cable force<"})
    EXPECT_THAT(four, HasSubstr(title));
  for (const char* phase : {">I<", ">II<", ">III<", ">IV<"})
    EXPECT_EQ(count(four, phase), 4u) << phase;
  const std::string six = figures::pulling_figure_6(report);
  EXPECT_EQ(count(six, "<circle"), 3u) << "aligned trials only";
  EXPECT_THAT(six, HasSubstr("R100: Cr/R = 0.0200 (0.0200 input)"));
  EXPECT_THAT(six, HasSubstr("R125: Cr/R = 0.0160 (0.0160 input)"));
  const std::string seven = figures::pulling_figure_7(report);
  EXPECT_EQ(count(seven, "<circle"), 2u + 2u) << "empty trolleys; both phases of R100";
  const std::string eleven = figures::pulling_figure_11(report);
  EXPECT_EQ(count(eleven, ">closed form<"), 2u);
  EXPECT_THAT(eleven, Not(HasSubstr(">measured<")));
  for (const char* energy : {">W_F: weight and strings<", ">W_R: rolling<", ">E_KT: kinetic<"})
    EXPECT_THAT(eleven, HasSubstr(energy));
}

TEST(PullingReport, MeasuredTrialsAreOverlaidWhereTheyAreLike) {
  const TempFolder folder;
  report::PullingReport report = small_report(folder);
  MeasuredTrial measured{report.trials[0].trial, report.trials[0].phases, report.trials[0].averages,
                         ""};
  measured.trial.name = "of the laboratory";
  report.measured = {measured};
  EXPECT_EQ(count(figures::pulling_figure_11(report), ">synthetic<"), 2u) << "an engine made it";
  EXPECT_THAT(render::text(report::pulling_findings(report)),
              HasSubstr("of the laboratory  simulated"));
  measured.trial.setup.origin = TrialOrigin::kMeasured;
  measured.trial.setup.mass *= 1.01;  // within 2 %
  report.measured = {measured};
  EXPECT_EQ(count(figures::pulling_figure_11(report), ">measured<"), 2u);
  EXPECT_THAT(render::text(report::pulling_findings(report)), HasSubstr("of the laboratory"));
  EXPECT_THAT(figures::pulling_figure_11(report), HasSubstr("measured: of the laboratory"));
  report.shown = 2;
  EXPECT_EQ(count(figures::pulling_figure_11(report), ">measured<"), 0u) << "another caster";
  report.measured[0].fault = "a.csv:3: cells are empty";
  EXPECT_THAT(render::text(report::pulling_findings(report)),
              HasSubstr("not used: a.csv:3: cells are empty"));
}

TEST(PullingReport, TextAndJsonSayWhatTheyAre) {
  const TempFolder folder;
  const report::PullingReport report = small_report(folder);
  EXPECT_THAT(render::text(report::pulling_findings(report)),
              HasSubstr("reproduces no measured finding"));
  EXPECT_THAT(render::text(report::pulling_findings(report)),
              testing::ContainsRegex("crosswise +1 "));
  const auto json = nlohmann::json::parse(render::json(report::pulling_findings(report)));
  EXPECT_EQ(json["trials"].size(), 4u);
  EXPECT_EQ(json["trials"][0]["phases"]["end"], "rested");
  EXPECT_EQ(json["bias"][1]["alignment"], "crosswise");
  EXPECT_TRUE(json["bias"][1]["both"]["standard_deviation"].is_null()) << "of one trial";
  EXPECT_TRUE(json["trials"][3]["error_at_rest"].is_null())
      << "the closed form is of casters in line";
  EXPECT_NEAR(json["casters"][0]["cr_over_r_found"], 0.02, 2e-5);
}

}  // namespace
}  // namespace gurney::calibration
