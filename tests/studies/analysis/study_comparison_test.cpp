#include "studies/analysis/study_comparison.h"

#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "studies/figures/study_figures.h"
#include "studies/report/comparison_report.h"
#include "tests/studies/analysis/synthetic_runs.h"
#include "tests/support/error_text.h"
#include "tests/support/one_line.h"
#include "tests/support/temp_folder.h"

namespace gurney::study {
namespace {

using testing::HasSubstr;
using testing::Not;
using Kind = ComparedQuantity::Kind;

class StudyComparisonTest : public testing::Test {
 protected:
  StudyData data(const SyntheticRuns& study, const std::string& name = "s.h5") {
    study.write(folder_.file(name));
    return StudyData(folder_.file(name));
  }
  TempFolder folder_;
};

/// Configurations false and true of `records` records at one level: all move without brakes, of
/// those with brakes the first `moved`.
SyntheticRuns brakes(std::size_t records, std::size_t moved) {
  SyntheticRuns study{.job = synthetic_job("", kBrakes),
                      .configurations = {"false", "true"},
                      .records = {},
                      .files = {},
                      .runs = {}};
  for (std::size_t i = 0; i < records; ++i) study.records.push_back("r" + std::to_string(i));
  for (std::size_t configuration : {0, 1})
    for (std::size_t i = 0; i < records; ++i)
      study.runs.push_back({configuration, i, 1, configuration == 0 || i < moved ? 0.2 : 0.05});
  return study;
}

const ComparedQuantity& row(const StudyComparison& found, Kind kind, const std::string& name) {
  for (const ComparedQuantity& each : found.quantities)
    if (each.kind == kind && each.name == name) return each;
  throw std::out_of_range(name);
}

TEST_F(StudyComparisonTest, SharesHaveStudentsIntervalAndMcNemarsTest) {
  const StudyData study = data(brakes(6, 1));
  const StudyComparison found = compare_studies({&study, 0}, {&study, 1});
  const ComparedQuantity& moved = row(found, Kind::kShare, "moved");
  EXPECT_EQ(moved.a, 1);
  EXPECT_DOUBLE_EQ(moved.b, 1.0 / 6);
  EXPECT_DOUBLE_EQ(moved.difference, -5.0 / 6);
  // Five differences of -1, one of 0: variance 1/6; t(0.975, 5) = 2.570582 (tables).
  EXPECT_NEAR(moved.interval.high, -5.0 / 6 + 2.570582 / 6, 1e-6);
  EXPECT_EQ(moved.interval.low, -1);                            // a share differs by no more
  EXPECT_DOUBLE_EQ(moved.p, 2 * std::exp2(-5));                 // 5 of 5
  EXPECT_TRUE(std::isnan(row(found, Kind::kShare, "fell").p));  // none fell: no test
}

TEST_F(StudyComparisonTest, MeansAndMediansOfDemands) {
  SyntheticRuns made = brakes(7, 0);
  for (std::size_t i = 0; i < 7; ++i) {
    made.runs[i].displacement = 1;
    made.runs[7 + i].displacement = 1 + 0.1 * static_cast<double>(i + 1) + (i == 6 ? 10 : 0);
  }
  const StudyData study = data(made);
  const StudyComparison found =
      compare_studies({&study, 0}, {&study, 1}, {.demands = {"peak_displacement"}});
  const ComparedQuantity& mean = row(found, Kind::kMean, "cart: peak_displacement");
  EXPECT_NEAR(mean.difference, 0.4 + 10.0 / 7, 1e-12);
  EXPECT_DOUBLE_EQ(mean.p, std::exp2(-6));  // all of 2^7 signs but two are less
  EXPECT_EQ(mean.units, "m");
  const ComparedQuantity& median = row(found, Kind::kMedian, "cart: peak_displacement");
  EXPECT_NEAR(median.difference, 0.4, 1e-12);    // the outlier does not pull it
  EXPECT_NEAR(median.interval.low, 0.1, 1e-12);  // of 7 values: smallest to largest
  EXPECT_NEAR(median.interval.high, 10.7, 1e-12);
  EXPECT_DOUBLE_EQ(median.p, std::exp2(-6));
  // Tests: mean and median, and the curves of nothing; moved is 7 of 7 on both sides. Mean and
  // median are two families: that the one was looked at does not weaken the other.
  EXPECT_EQ(found.tests.means, 1);
  EXPECT_EQ(found.tests.medians, 1);
  EXPECT_EQ(found.tests.all(), 2);
  EXPECT_DOUBLE_EQ(mean.p_holm, mean.p);
}

// Sizes are compared, not directions; in the units of reports, with the names of configurations.
TEST_F(StudyComparisonTest, ReportsInTheUnitsOfOtherReports) {
  const StudyData study = data(brakes(6, 1));
  const report::ComparisonReport report{
      {&study, 0}, {&study, 1}, "free", "locked", {}, compare_studies({&study, 0}, {&study, 1})};
  const std::string text = one_line(report::comparison_findings(report));
  EXPECT_THAT(text, HasSubstr("|residual_yaw|"));
  EXPECT_THAT(text, HasSubstr("peak_tilt [deg]"));
  EXPECT_THAT(text, Not(HasSubstr("[rad")));
  EXPECT_THAT(text, HasSubstr("Holm's adjustment within each of these families"));
}

TEST_F(StudyComparisonTest, LevelsOfARecordAreNotMoreRecords) {
  SyntheticRuns made = brakes(2, 0);
  const std::vector<SyntheticRun> runs = made.runs;
  for (int level = 2; level < 20; ++level)
    for (SyntheticRun run : runs) {
      run.level = level;
      made.runs.push_back(run);
    }
  const StudyData study = data(made);
  const StudyComparison found = compare_studies({&study, 0}, {&study, 1});
  EXPECT_EQ(found.pairs.pairs.size(), 38);
  EXPECT_EQ(found.pairs.groups, 2);
  EXPECT_DOUBLE_EQ(row(found, Kind::kShare, "moved").p, 0.5);
  for (const ComparedCurves& curves : found.curves)
    if (curves.name == "moved") {
      EXPECT_GE(curves.p, 0.4);  // 1 / 2 but for the number of resamples
    }
  EXPECT_EQ(found.smallest_p, 0.5);
  // The value of a record is the mean of its levels.
  const ComparedQuantity median =
      row(compare_studies({&study, 0}, {&study, 1}, {.demands = {"peak_displacement"}}),
          Kind::kMedian, "cart: peak_displacement");
  EXPECT_NEAR(median.a, 0.2, 1e-12);
  EXPECT_NEAR(median.b, 0.05, 1e-12);
}

TEST_F(StudyComparisonTest, OneRecordWithoutDrawsHasNoP) {
  const StudyData study = data(brakes(1, 0));
  const StudyComparison found = compare_studies({&study, 0}, {&study, 1});
  EXPECT_EQ(row(found, Kind::kShare, "moved").difference, -1);
  EXPECT_TRUE(std::isnan(row(found, Kind::kShare, "moved").p));
  EXPECT_EQ(found.tests.all(), 0);
}

TEST_F(StudyComparisonTest, AStudyIsTheSameAsItself) {
  const StudyData study = data(brakes(8, 3));
  const StudyComparison found = compare_studies({&study, 1}, {&study, 1});
  EXPECT_EQ(found.tests.all(), 0);
  for (const ComparedQuantity& each : found.quantities) EXPECT_EQ(each.difference, 0) << each.name;
  EXPECT_TRUE(input_differences({&study, 1}, {&study, 1}).empty());
}

TEST_F(StudyComparisonTest, CurvesThatDifferAreFound) {
  SyntheticRuns made = brakes(12, 0);
  made.runs.clear();
  for (std::size_t configuration : {0, 1})
    for (std::size_t i = 0; i < 12; ++i)
      for (int level = 1; level <= 6; ++level) {
        // Capacities scatter from record to record; brakes make them twice as large.
        const double capacity = (1.2 + 0.2 * static_cast<double>(i)) * (configuration == 1 ? 2 : 1);
        made.runs.push_back({configuration, i, double(level), level > capacity ? 0.2 : 0.05});
      }
  const StudyData study = data(made);
  const StudyComparison found = compare_studies({&study, 0}, {&study, 1});
  ASSERT_EQ(found.curves.size(), 2);
  ASSERT_EQ(found.measure, "PGA h1");
  const ComparedCurves& moved = found.curves[0];
  ASSERT_TRUE(moved.a.curve() && moved.b.curve());
  EXPECT_GT(moved.b.curve()->theta, 1.5 * moved.a.curve()->theta);
  // A swap of every record gives the same ratio, others less: of 999, about 999 / 2^11.
  EXPECT_LT(moved.p, 0.01);
  EXPECT_TRUE(std::isnan(found.curves[1].p));  // none fell
  EXPECT_EQ(moved.b.audit.theta, moved.b.curve()->theta);
  EXPECT_EQ(moved.b.audit.highest, 6);
  EXPECT_EQ(moved.b.audit.exceeded, moved.b.fit.exceeded);
}

// Brackets of 5 % about capacities that brakes double: so are the medians, with the same beta. The
// first run, at the same level in both, is not doubled, and the outcomes of all runs have other
// curves.
TEST_F(StudyComparisonTest, CurvesOfAnIdaAreThoseOfItsCapacities) {
  SyntheticRuns made = brakes(12, 0);
  made.job.replace(made.job.find("levels = [1, 2]"), 15,
                   "ida = { first = 0.5, increment = 0.5, until = \"moved\" }");
  made.runs.clear();
  for (std::size_t configuration : {0, 1})
    for (std::size_t i = 0; i < 12; ++i) {
      const double capacity = (1.2 + 0.2 * static_cast<double>(i)) * (configuration == 1 ? 2 : 1);
      made.runs.push_back({configuration, i, 0.5, 0.05});
      made.runs.push_back({configuration, i, 0.95 * capacity, 0.05});
      made.runs.push_back({configuration, i, 1.05 * capacity, 0.2});
    }
  const StudyData study = data(made);
  const StudyComparison found = compare_studies({&study, 0}, {&study, 1});
  ASSERT_FALSE(found.curves.empty());
  const ComparedCurves& moved = found.curves[0];
  ASSERT_TRUE(moved.a.capacities && moved.b.capacities && moved.a.curve() && moved.b.curve());
  EXPECT_NEAR(moved.b.curve()->theta, 2 * moved.a.curve()->theta, 1e-6);
  EXPECT_NEAR(moved.b.curve()->beta, moved.a.curve()->beta, 1e-6);
  EXPECT_LT(moved.p, 0.01);
  EXPECT_GT(std::abs(moved.b.fit.curve->theta / moved.a.fit.curve->theta - 2), 0.01);
}

TEST_F(StudyComparisonTest, LimitStatesOfOneNameMustSayTheSame) {
  SyntheticRuns other = brakes(3, 0);
  other.job.replace(other.job.find("above = 0.1"), 11, "above = 0.3");
  const StudyData a = data(brakes(3, 0)), b = data(other, "b.h5");
  const StudyComparison found = compare_studies({&a, 0}, {&b, 0});
  EXPECT_THAT(found.not_common, testing::Contains("limit state moved"));
  EXPECT_THROW(row(found, Kind::kShare, "moved"), std::out_of_range);
}

TEST_F(StudyComparisonTest, InputsAreReportedByTheirKeys) {
  SyntheticRuns made = brakes(2, 0);
  const StudyData a = data(made);
  made.records = {"r0", "other"};
  made.files = {"changed", "other"};
  made.commit = "def";
  made.caster_sha256 = "c2";
  made.job.replace(made.job.find("levels = [1, 2]"), 15, "levels = [1, 3]");
  const StudyData b = data(made, "b.h5");
  const InputDifferences inputs = input_differences({&a, 0}, {&b, 1});
  ASSERT_EQ(inputs.job.size(), 2);
  EXPECT_EQ(inputs.job[0].key, "item.brakes");
  EXPECT_EQ(inputs.job[0].a, "false");
  EXPECT_EQ(inputs.job[0].b, "true");
  EXPECT_EQ(inputs.job[1].key, "study.intensity.levels");
  EXPECT_EQ(inputs.job[1].b, "[1, 3]");
  ASSERT_EQ(inputs.assumptions.size(), 1);
  EXPECT_THAT(inputs.assumptions[0].b, HasSubstr("10 N m"));
  ASSERT_EQ(inputs.data_files.size(), 1);
  EXPECT_EQ(inputs.data_files[0].key, "casters/a.toml");
  EXPECT_EQ(inputs.data_files[0].b, "c2");
  ASSERT_EQ(inputs.program.size(), 1);
  EXPECT_EQ(inputs.program[0].key, "git_commit");
  EXPECT_THAT(inputs.records_of_a, testing::ElementsAre("r1"));
  EXPECT_THAT(inputs.records_of_b, testing::ElementsAre("other"));
  EXPECT_THAT(inputs.records_changed, testing::ElementsAre("r0"));
  EXPECT_EQ(inputs.records_common, 1);
}

TEST_F(StudyComparisonTest, FilesOfLaterVersionsAreRefused) {
  SyntheticRuns made = brakes(2, 0);
  made.format_version = 1;
  EXPECT_EQ(error_text([&] { data(made); }), "(no error)");
  for (const int version : {0, kStudyFormatVersion + 1}) {
    made.format_version = version;
    EXPECT_THAT(error_text([&] { data(made); }),
                HasSubstr("is a study file of format_version " + std::to_string(version) +
                          ", made by gurney "));
  }
}

TEST_F(StudyComparisonTest, TheReportSaysWhatWasLeftOutAndWhatItMeans) {
  SyntheticRuns made = brakes(10, 0);
  made.runs[3].failed = true;
  made.runs[0].fell = true;
  const StudyData study = data(made);
  report::ComparisonReport report{{&study, 0}, {&study, 1}, "free", "locked", {}, {}};
  report.inputs = input_differences(report.a, report.b);
  report.found = compare_studies(report.a, report.b, {.demands = {"peak_displacement"}});
  const std::string text = one_line(report::comparison_findings(report));
  EXPECT_THAT(text, HasSubstr("free: 9 runs paired, 1 excluded because they failed"));
  EXPECT_THAT(text, HasSubstr("locked: 9 runs paired, 1 without a partner"));
  EXPECT_THAT(text, HasSubstr("9 records, each counts once"));
  EXPECT_THAT(text, HasSubstr("1 of the paired runs overturned"));
  EXPECT_THAT(text, HasSubstr("'moved' is exceeded less often in locked: in 0 % against 100 %"));
  EXPECT_THAT(text, HasSubstr("less in locked: cart: peak_displacement"));
  EXPECT_THAT(text, HasSubstr("difference locked - free"));
  EXPECT_THAT(text, Not(HasSubstr("caution")));
  const auto json = nlohmann::json::parse(render::json(report::comparison_findings(report)));
  EXPECT_EQ(json["b"]["runs_without_partner"], 1);
  EXPECT_EQ(json["shares"][0]["name"], "moved");
  EXPECT_EQ(json["shares"][0]["difference"], -1);
  EXPECT_TRUE(json["shares"][0]["interval"][0].is_null());  // all records differ alike
  EXPECT_THAT(text, HasSubstr("interval unknown: too few groups, or all of them differ alike"));
  EXPECT_THAT(figures::comparison_figure(report), HasSubstr("free against locked"));
}

TEST_F(StudyComparisonTest, TooFewGroupsAreWarnedOf) {
  const StudyData study = data(brakes(4, 0));
  report::ComparisonReport report{{&study, 0}, {&study, 1}, "free", "locked", {}, {}};
  report.found = compare_studies(report.a, report.b);
  EXPECT_THAT(one_line(report::comparison_findings(report)),
              HasSubstr("so few groups give a p of 0.1250 or more"));
}

}  // namespace
}  // namespace gurney::study
