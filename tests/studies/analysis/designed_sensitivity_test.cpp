#include <gmock/gmock.h>

#include "engine/base/random/sampling.h"
#include "studies/analysis/study_sensitivity.h"
#include "studies/figures/study_figures.h"
#include "studies/report/study_report.h"
#include "tests/studies/analysis/synthetic_runs.h"
#include "tests/support/expect_error.h"
#include "tests/support/one_line.h"
#include "tests/support/temp_folder.h"

namespace gurney::study {
namespace {

using testing::HasSubstr;

constexpr std::size_t kInputs = 3, kMatrices = 5;

/// Displacement 4 u + 3 r w of numbers u and w, uniform in (0, 1), and the record r, 0 or 1. The
/// group is of w.
std::vector<SyntheticRun> rows(std::size_t points, double level = 1, double shift = 0) {
  std::vector<SyntheticRun> runs;
  for (std::size_t draw = 0; draw < points * kMatrices; ++draw) {
    const SaltelliRow row{draw / kMatrices, draw % kMatrices};
    const auto input = [&](std::size_t i) { return saltelli_draw(1, kInputs, i, row); };
    const double w = input(0), u = input(2);
    const std::size_t record =
        row.from_b(1) ? static_cast<std::size_t>(2 * input(1)) : 2 * row.point / points;
    SyntheticRun run{.record = record, .level = level, .draw = static_cast<int>(draw)};
    run.displacement = shift + 4 * u + 3 * static_cast<double>(record) * w;
    run.drawn = {{"u", u}, {"w", w}};
    runs.push_back(run);
  }
  return runs;
}

// Variances: of 4 u 16 / 12; of 3 r w 9 E(r^2) E(w^2) - (3 / 4)^2, of it by r alone 9 / 4 / 4 and
// by w alone 9 / 4 / 12.
constexpr double kOfU = 4 / 3.0, kOfBoth = 1.5 - 9 / 16.0, kOfRecord = 9 / 16.0, kOfW = 3 / 16.0;
constexpr double kAll = kOfU + kOfBoth;

class DesignedSensitivity : public testing::Test {
 protected:
  StudyData data(const std::vector<SyntheticRun>& runs) {
    SyntheticRuns study{.job = synthetic_job("draws = 9\nsampling = \"saltelli\"\n"),
                        .records = {"r", "s"},
                        .files = {},
                        .runs = runs};
    study.design = {"group treads", "record", "variable u"};
    const std::string path = folder_.file(std::to_string(++files_) + ".h5");
    study.write(path);
    return StudyData(path);
  }
  TempFolder folder_;
  int files_ = 0;
};

const SensitiveInput& named(const StudySensitivity& found, const std::string& name) {
  for (const SensitiveInput& input : found.inputs)
    if (input.names.front() == name) return input;
  throw std::out_of_range(name);
}

const SensitivityRequest kPeak{
    .demand = "peak_displacement", .limit = "", .level = {}, .all_levels = true};

TEST_F(DesignedSensitivity, IndicesAreTheClosedForms) {
  const StudyData study = data(rows(4096));
  const StudySensitivity found = study_sensitivity({&study, 0}, kPeak);
  EXPECT_TRUE(found.designed);
  EXPECT_EQ(found.runs, 4096 * kMatrices);
  EXPECT_EQ(found.draws, 4096);
  EXPECT_FALSE(found.repeated_draws);
  // Random points err by about 1 / sqrt(n) = 0.016, Sobol points by less.
  constexpr double kError = 0.016;
  const auto expect = [&](const std::string& name, double first, double total) {
    EXPECT_NEAR(named(found, name).index->estimate, first / kAll, kError) << name;
    EXPECT_NEAR(named(found, name).total->estimate, total / kAll, kError) << name;
  };
  expect("u", kOfU, kOfU);
  expect("record", kOfRecord, kOfBoth - kOfW);
  expect("group treads", kOfW, kOfBoth - kOfRecord);
  EXPECT_NEAR(found.sum, (kOfU + kOfRecord + kOfW) / kAll, 3 * kError);
  EXPECT_NEAR(found.mean, 2.75, 3 * std::sqrt(kAll / 8192));
  EXPECT_NEAR(found.deviation, std::sqrt(kAll), 0.05);
  EXPECT_EQ(found.inputs.front().names.front(), "u") << "largest total first";
  // u in its lowest and highest tenth.
  EXPECT_NEAR(named(found, "u").low, 0.1, 0.01);
  EXPECT_NEAR(named(found, "u").bar.swing(), 3.6, 0.15);
  EXPECT_NEAR(named(found, "u").bar.low, 2.75 - 1.8, 0.1);
  EXPECT_FALSE(named(found, "record").drawn);
  EXPECT_FALSE(named(found, "group treads").drawn);
  const std::string text = one_line(report::sensitivity_findings({"", found, ""}));
  EXPECT_THAT(text, HasSubstr(" first 95 % interval total 95 % interval"));
  EXPECT_THAT(text, HasSubstr("an input whose total is 0 does not matter"));
  EXPECT_THAT(render::json(report::sensitivity_findings({"", found, ""})),
              HasSubstr("\"total_interval\""));
  EXPECT_THAT(figures::sensitivity_figure({"", found, ""}), HasSubstr("total index"));
}

TEST_F(DesignedSensitivity, WhatLevelsAddIsNoVarianceOfTheInputs) {
  std::vector<SyntheticRun> runs = rows(1024);
  for (const SyntheticRun& run : rows(1024, 2, 100)) runs.push_back(run);
  const StudyData study = data(runs);
  const StudySensitivity both = study_sensitivity({&study, 0}, kPeak);
  SensitivityRequest second = kPeak;
  second.level = 1;
  const StudySensitivity one = study_sensitivity({&study, 0}, second);
  EXPECT_TRUE(both.repeated_draws);
  EXPECT_THAT(one_line(report::sensitivity_findings({"", both, ""})),
              HasSubstr("Several angles or levels share 1024 points"));
  EXPECT_FALSE(one.repeated_draws);
  EXPECT_NEAR(one.mean, both.mean + 50, 1e-9);
  EXPECT_NEAR(both.deviation, one.deviation, 1e-3);
  for (const SensitiveInput& input : both.inputs)
    EXPECT_NEAR(input.total->estimate, named(one, input.names.front()).total->estimate, 1e-9);
}

TEST_F(DesignedSensitivity, PointsThatAreNotWholeAreLeftOut) {
  std::vector<SyntheticRun> runs = rows(100);
  runs[7 * kMatrices + 3].failed = true;
  const StudyData study = data(runs);
  const StudySensitivity found = study_sensitivity({&study, 0}, kPeak);
  EXPECT_EQ(found.draws, 99);
  EXPECT_EQ(found.left_out, kMatrices - 1);
  EXPECT_THAT(one_line(report::sensitivity_findings({"", found, ""})),
              HasSubstr("4 runs are excluded: they have no such demand, or another run of their "
                        "point has none or failed."));
  for (std::size_t point = 0; point < 81; ++point) runs[point * kMatrices].failed = true;
  const StudyData broken = data(runs);
  EXPECT_ERROR(study_sensitivity({&broken, 0}, kPeak),
               "19 points with all 5 runs of cart: peak_displacement are too few");
}

}  // namespace
}  // namespace gurney::study
