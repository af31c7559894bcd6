#include "studies/analysis/fragility_result.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>

#include "engine/base/error.h"
#include "engine/base/random/normal_draw.h"
#include "engine/base/units.h"
#include "studies/analysis/demands.h"
#include "studies/figures/study_figures.h"
#include "studies/render/render.h"
#include "studies/report/fragility_report.h"
#include "tests/studies/analysis/small_study.h"
#include "tests/support/error_text.h"
#include "tests/support/temp_folder.h"

namespace gurney::study {
namespace {

constexpr double kG = kStandardGravity;

/// Records whose displacement is im^b e^(a + sigma z): all that follows is known.
std::vector<SmallRun> known_runs(std::size_t records, const std::vector<double>& levels) {
  constexpr double kTheta = 0.2 * kG, kBeta = 0.5;
  std::vector<SmallRun> runs;
  for (std::size_t record = 0; record < records; ++record) {
    // Evenly spread capacities: their sample has the mean and nearly the spread of the law.
    const double z = normal_quantile((static_cast<double>(record) + 0.5) / double(records));
    for (const double level : levels) {
      const double demand = 0.1 * level * kG / (kTheta * std::exp(kBeta * z));
      runs.push_back({record, level * kG, demand, false, false});
    }
  }
  return runs;
}

class FragilityResultTest : public testing::Test {
 protected:
  StudyData data(const std::vector<SmallRun>& runs, const std::string& job = kSmallStudy) {
    write_small_study(folder_.file("s.h5"), runs, job);
    return StudyData(folder_.file("s.h5"));
  }
  TempFolder folder_;
};

TEST(IntervalText, SaysWhyThereIsNone) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  CurveAudit audit;
  audit.theta = 1;
  audit.records = 6;
  audit.effective = 6;
  audit.fewest = 8;
  EXPECT_EQ(interval_text({0, kFar}, 1, 3, audit), "none: fewer than 8 effective records");
  audit.records = 12;
  audit.effective = 12;
  EXPECT_EQ(interval_text({0, kFar}, 1, 3, audit), "unbounded (12 records)");
  EXPECT_EQ(interval_text({0.5, kFar}, 0.5, 3, audit), "1 to unbounded");
}

TEST_F(FragilityResultTest, GivesBackTheCurveThatTheDemandsFollow) {
  // 400 records on nine levels: fractions are those of the law to 1/400, and the levels weigh at
  // least 100 records each near the median, so that theta is off by less than 0.5 / sqrt(12) / 100
  // of beta and beta by twice that.
  const StudyData study = data(known_runs(400, {0.05, 0.08, 0.1, 0.15, 0.2, 0.3, 0.4, 0.5, 0.8}));
  const FragilityResult result = fragility_of(study, {});
  ASSERT_TRUE(result.fit.curve);
  EXPECT_NEAR(result.fit.curve->theta / kG, 0.2, 0.2 * 0.002);
  EXPECT_NEAR(result.fit.curve->beta, 0.5, 0.005);
  EXPECT_EQ(result.records, 400);
  EXPECT_TRUE(result.band.theta.contains(0.2 * kG));
  // ln demand = ln im - ln theta + ln 0.1 - 0.5 z: slope 1, sigma 0.5, exactly on one line a
  // record.
  ASSERT_TRUE(result.cloud_curve);
  EXPECT_NEAR(result.cloud->b, 1, 1e-9);
  EXPECT_NEAR(result.cloud_curve->theta / kG, 0.2, 1e-6);
  EXPECT_NEAR(result.cloud_curve->beta, 0.5, 0.005);
  // Cornell: k0 theta^-k exp(k^2 beta^2 / 2) with im in g, k0 = 1e-3, k = 2.
  ASSERT_TRUE(result.rate);
  const statistics::LognormalCurve& curve = *result.fit.curve;
  EXPECT_NEAR(result.rate->rate,
              1e-3 * std::pow(curve.theta / kG, -2) * std::exp(2 * curve.beta * curve.beta), 1e-9);
}

// An item that falls before it has moved 10 cm does not exceed "moved", and a state of another kind has no such runs.
TEST_F(FragilityResultTest, SaysHowManyOverturnedShortOfALimit) {
  std::vector<SmallRun> runs = known_runs(40, {0.1, 0.2, 0.4});
  std::size_t short_of = 0;
  for (SmallRun& run : runs) {
    run.fell = run.record % 4 == 0;
    short_of += run.fell && run.displacement <= 0.1;
  }
  ASSERT_GT(short_of, 0);
  const StudyData study = data(runs);
  EXPECT_EQ(fragility_of(study, {.state = 0}).audit.overturned_short, short_of);
  EXPECT_EQ(fragility_of(study, {.state = 1}).audit.overturned_short, 0);
  EXPECT_EQ(fragility_of(study, {.state = 2}).audit.overturned_short, 0);
  EXPECT_THAT(cautions(fragility_of(study, {}).audit, {"g", kG}),
              testing::Contains(testing::HasSubstr("overturned without having moved so far")));
}

// A demand that is no number exceeds no limit: it would count as safe.
TEST_F(FragilityResultTest, RefusesADemandThatIsNoNumber) {
  std::vector<SmallRun> runs = known_runs(10, {0.1, 0.2});
  runs[3].displacement = std::nan("");
  const StudyData study = data(runs);
  try {
    fragility_of(study, {});
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(),
                testing::HasSubstr("/items/peak_displacement[6] = nan: must be a number"));
  }
}

// A file of the days when the key of an IDA was `hunt`.
TEST_F(FragilityResultTest, AnIdaUnderItsOldNameGivesCapacities) {
  std::string job = kSmallStudy;
  const std::string levels = "levels = [0.1, 0.2, 0.4]\n";
  job.replace(job.find(levels), levels.size(),
              "hunt = { first = 0.1, increment = 0.1, until = \"moved\" }\n");
  std::vector<SmallRun> runs;
  for (std::size_t record = 0; record < 5; ++record) {
    const double capacity = (0.1 + 0.05 * double(record)) * kG;
    runs.push_back({record, 0.9 * capacity, 0.05});
    runs.push_back({record, 1.1 * capacity, 0.2});
  }
  EXPECT_TRUE(fragility_of(data(runs, job), {}).capacities);
}

TEST_F(FragilityResultTest, AnIdaGivesCapacities) {
  std::string job = kSmallStudy;
  const std::string levels = "levels = [0.1, 0.2, 0.4]\n";
  job.replace(job.find(levels), levels.size(),
              "ida = { first = 0.1, increment = 0.1, until = \"moved\" }\n");
  // Brackets of 2 % around capacities exp(ln 0.2 + 0.5 z). ML's beta is the capacities' own spread
  // but for the width w = 0.02 of a bracket, which it takes as (w^2 / 12) / (2 beta) = 4e-5 at
  // most.
  std::vector<SmallRun> runs;
  double squares = 0;
  for (std::size_t record = 0; record < 101; ++record) {
    const double z = normal_quantile((double(record) + 0.5) / 101);
    const double capacity = 0.2 * kG * std::exp(0.5 * z);
    squares += z * z;
    runs.push_back({record, 0.99 * capacity, 0.05});
    runs.push_back({record, 1.01 * capacity, 0.2});
  }
  runs.push_back({7, 5 * kG, 0.05});  // a resurrection
  const FragilityResult result = fragility_of(data(runs, job), {});
  ASSERT_TRUE(result.capacities && result.curve());
  EXPECT_NEAR(result.curve()->theta / kG, 0.2, 0.2 * 1e-4);
  EXPECT_NEAR(result.curve()->beta, 0.5 * std::sqrt(squares / 101), 1e-4);
  EXPECT_EQ(result.capacities->resurrections, 1);
  // Intervals are those of the capacities: Student's of 101 means of ln capacity, t(0.975, 100) =
  // 1.983972, to the width of the brackets as above.
  const double half = 1.983972 * 0.5 * std::sqrt(squares / 100) / std::sqrt(101.0);
  EXPECT_NEAR(std::log(result.band.theta.high / result.curve()->theta), half, 1e-4);
  EXPECT_NEAR(std::log(result.band.theta.low / result.curve()->theta), -half, 1e-4);
  EXPECT_TRUE(result.band.beta.contains(result.curve()->beta));
  for (std::size_t i = 0; i < result.im.size(); ++i) {
    const double p = result.curve()->probability(result.im[i]);
    EXPECT_LE(result.band.of_curve[i].low, p) << i;
    EXPECT_GE(result.band.of_curve[i].high, p) << i;
  }
  EXPECT_FALSE(result.profile);  // of stripes
  ASSERT_TRUE(result.p_of_fit);
  EXPECT_GT(*result.p_of_fit, 0.05);
  const StudyData study(folder_.file("s.h5"));
  EXPECT_THAT(render::text(report::fragility_findings(study, {result})),
              testing::HasSubstr("101 of 101 records"));
  const auto json = nlohmann::json::parse(
      render::json(report::fragility_findings(study, {result})))["fragilities"][0];
  EXPECT_EQ(json["capacities"]["records"], 101);
  EXPECT_EQ(json["capacities"]["brackets"].size(), 101);
  EXPECT_DOUBLE_EQ(json["theta_interval"][0], result.band.theta.low);
  EXPECT_FALSE(json.contains("profile"));
  EXPECT_THAT(figures::fragility_figure(study, {result}),
              testing::AllOf(testing::HasSubstr("empirical distribution"),
                             testing::Not(testing::HasSubstr("<circle"))));
}

TEST_F(FragilityResultTest, AnIdaOfOverturningIsCautionedAgainst) {
  std::string job = kSmallStudy;
  const std::string levels = "levels = [0.1, 0.2, 0.4]\n";
  job.replace(job.find(levels), levels.size(),
              "ida = { first = 0.1, increment = 0.1, until = \"fell\" }\n");
  std::vector<SmallRun> runs;
  for (std::size_t record = 0; record < 12; ++record) {
    const double capacity = (0.2 + 0.02 * double(record)) * kG;
    runs.push_back({record, 0.95 * capacity, 0.05, false});
    runs.push_back({record, 1.05 * capacity, 0.05, true});
  }
  const StudyData study = data(runs, job);
  const std::string report =
      render::text(report::fragility_findings(study, {fragility_of(study, {1, 0, ""})}));
  EXPECT_THAT(report, testing::HasSubstr("12 runs of the IDA overturned; rocking is chaotic"));
  EXPECT_THAT(report, testing::HasSubstr("12 of 12 records"));
}

TEST_F(FragilityResultTest, AnIdaWithoutOverturningIsNot) {
  CurveAudit audit;
  audit.of_capacities = true;
  EXPECT_THAT(cautions(audit, {}), testing::IsEmpty());
  audit.overturned = 1;
  EXPECT_THAT(cautions(audit, {}),
              testing::ElementsAre(testing::StartsWith("1 run of the IDA overturned")));
}

TEST_F(FragilityResultTest, AQuasiCompleteSeparationHasNoMedian) {
  std::vector<SmallRun> runs;
  for (std::size_t record = 0; record < 44; ++record) {
    runs.push_back({record, 0.8 * kG, 0.05});
    runs.push_back({record, 1.2 * kG, record < 7 ? 0.2 : 0.05});
  }
  const StudyData study = data(runs);
  const FragilityResult result = fragility_of(study, {});
  const std::string report = render::text(report::fragility_findings(study, {result}));
  EXPECT_THAT(report, testing::HasSubstr("quasi-complete separation"));
  EXPECT_THAT(report, testing::HasSubstr("median above 1.2 g"));
  EXPECT_THAT(report, testing::Not(testing::HasSubstr("theta at")));
  const auto json = nlohmann::json::parse(
      render::json(report::fragility_findings(study, {result})))["fragilities"][0];
  EXPECT_TRUE(json["curve"].is_null());
  EXPECT_THAT(json["reason"].get<std::string>(),
              testing::HasSubstr("outcomes change at 11.8 m/s2: median above 11.8 m/s2"));
  EXPECT_NEAR(json["median_between"][0].get<double>(), 1.2 * kG, 1e-9);
  EXPECT_TRUE(json["median_between"][1].is_null());
}

TEST_F(FragilityResultTest, TwoRecordsThatNeverExceedBoundNoMedian) {
  const StudyData study = data({{0, 0.4 * kG, 0.05}, {1, 0.4 * kG, 0.05}});
  const FragilityResult result = fragility_of(study, {});
  const std::string report = render::text(report::fragility_findings(study, {result}));
  EXPECT_THAT(report, testing::HasSubstr("no run exceeds up to 0.4 g\n"));
  EXPECT_THAT(report, testing::Not(testing::HasSubstr("median above")));
  const auto json = nlohmann::json::parse(
      render::json(report::fragility_findings(study, {result})))["fragilities"][0];
  EXPECT_EQ(json["median_between"][0], 0);
  EXPECT_TRUE(json["median_between"][1].is_null());
}

TEST_F(FragilityResultTest, CautionsAgainstWhatTheRunsDoNotCarry) {
  // 3 of 20 records exceed at the highest level and 1 at the one below.
  std::vector<SmallRun> runs;
  for (std::size_t record = 0; record < 20; ++record)
    for (const double level : {0.1, 0.2, 0.4}) {
      const bool moves = (level > 0.3 && record < 3) || (level > 0.15 && record == 0);
      runs.push_back({record, level * kG, moves ? 0.2 : 0.05, false, false, false,
                      record == 5 ? 60.6 : level});
    }
  const StudyData study = data(runs);
  const FragilityResult result = fragility_of(study, {});
  ASSERT_TRUE(result.curve());
  const std::string report = render::text(report::fragility_findings(study, {result}));
  EXPECT_THAT(report, testing::HasSubstr("is extrapolated beyond the highest intensity of the "
                                         "runs, 0.4 g"));
  EXPECT_THAT(report, testing::HasSubstr("only 4 of 60 runs exceed; fewer than 10"));
  EXPECT_THAT(report, testing::HasSubstr("scale factors 0.1 to 60.6; 1 of 20 records above 5, 19 "
                                         "below 0.2"));
  const auto json = nlohmann::json::parse(
      render::json(report::fragility_findings(study, {result})))["fragilities"][0];
  EXPECT_EQ(json["cautions"].size(), 3);
  EXPECT_EQ(json["audit"]["extrapolated"], "above");
  EXPECT_EQ(json["audit"]["scale_factors"]["records_above"], 1);
}

// Few runs exceed, so that the stripes determine little; the demands of 20 records do.
TEST_F(FragilityResultTest, ACloudHasIntervalsAndRatesOfItsOwn) {
  const StudyData study = data(known_runs(20, {0.03, 0.05, 0.08}));
  const FragilityResult result =
      fragility_of(study, {.measure = "", .method = CurveMethod::kCloud});
  ASSERT_TRUE(result.curve());
  EXPECT_NEAR(result.curve()->theta / kG, 0.2, 1e-6);
  EXPECT_FALSE(result.band.too_few);
  EXPECT_TRUE(result.band.theta.contains(0.2 * kG));
  EXPECT_TRUE(result.band.beta.contains(0.5));
  // Wider than if sigma alone were unknown, t(19) 0.5 / sqrt(20) in ln theta, as the line has to be
  // carried on to 0.2 g; bounded within ten times the highest level.
  EXPECT_GT(std::log(result.band.theta.high / result.band.theta.low), 2 * 2.093 * 0.5 / 4.472);
  EXPECT_LE(result.band.theta.high, 0.8 * kG);
  ASSERT_EQ(result.band.of_curve.size(), result.im.size());
  for (std::size_t i = 0; i < result.im.size(); ++i)
    EXPECT_TRUE(result.band.of_curve[i].contains(result.curve()->probability(result.im[i])));
  ASSERT_TRUE(result.rate && result.rate->has_interval);
  EXPECT_TRUE(result.rate->interval.contains(result.rate->rate));
  const auto json = nlohmann::json::parse(
      render::json(report::fragility_findings(study, {result})))["fragilities"][0];
  EXPECT_EQ(json["method"], "cloud");
  EXPECT_DOUBLE_EQ(json["theta_interval"][0], result.band.theta.low);
  EXPECT_EQ(json["band"].size(), result.im.size());
  // The outcomes do not determine this curve: only the extrapolation is a caution.
  ASSERT_EQ(json["cautions"].size(), 1);
  EXPECT_THAT(json["cautions"][0].get<std::string>(), testing::HasSubstr("is extrapolated"));
}

// One note for all curves whose records are scaled, also where the factors differ.
TEST_F(FragilityResultTest, CautionsAgainstScaleFactorsOnce) {
  const StudyData study = data(known_runs(20, {0.1, 0.2, 0.4}));
  FragilityResult first = fragility_of(study, {}), second = first;
  first.audit.factors.add(0, 7);
  second.configuration = "braked";
  second.audit.factors.add(0, 9);
  const std::string report = render::text(report::fragility_findings(study, {first, second}));
  const std::string note =
      "all curves: caution: scale factors 1 to 9; up to 1 of 20 records above 5\n";
  EXPECT_THAT(report, testing::HasSubstr(note));
  EXPECT_EQ(report.find("scale factors"), report.rfind("scale factors"));
}

TEST_F(FragilityResultTest, SaysWhyThereIsNoCurve) {
  const StudyData study = data({{0, 1, 0.05}, {1, 1, 0.05}, {0, 2, 0.2}, {1, 2, 0.2}});
  const std::vector<FragilityResult> results{fragility_of(study, {0, 0, ""}),
                                             fragility_of(study, {1, 0, ""})};
  EXPECT_EQ(results[0].fit.status, statistics::FragilityStatus::kSeparated);
  EXPECT_FALSE(results[0].curve());
  const std::string report = render::text(report::fragility_findings(study, results));
  EXPECT_THAT(report, testing::HasSubstr("outcomes change between 0.102 and 0.204 g"));
  EXPECT_THAT(report, testing::HasSubstr("no run exceeds"));
  EXPECT_THAT(render::json(report::fragility_findings(study, results)),
              testing::HasSubstr("\"curve\": null"));
  EXPECT_THAT(figures::fragility_figure(study, results), testing::HasSubstr("all (no curve)"));
}

TEST_F(FragilityResultTest, OfRunsThatAllFailedThereIsNoFigure) {
  const StudyData study =
      data({{.record = 0, .intensity = 1, .displacement = 0.1, .failed = true},
            {.record = 1, .intensity = 2, .displacement = 0.1, .failed = true}});
  const FragilityResult result = fragility_of(study, {0, 0, ""});
  EXPECT_FALSE(result.curve());
  EXPECT_THAT(error_text([&] { figures::fragility_figure(study, {result}); }),
              testing::HasSubstr("no run of all has results"));
  EXPECT_THAT(error_text([&] { demands_named(study, 0, {"peak_displacement"}); }),
              testing::HasSubstr("all runs of all failed: none has demands"));
}

TEST_F(FragilityResultTest, PerformanceLevelsAddUpToOne) {
  std::vector<SmallRun> runs = known_runs(20, {0.1, 0.2, 0.4});
  for (SmallRun& run : runs) run.fell = run.displacement > 0.2;
  const StudyData study = data(runs);
  std::vector<FragilityResult> results;
  for (std::size_t state : {0, 1, 2}) results.push_back(fragility_of(study, {state, 0, ""}));
  const auto tables = performance_tables(study, results);
  ASSERT_EQ(tables.size(), 1);
  EXPECT_THAT(tables[0].levels, testing::ElementsAre("moved", "fell"));
  for (std::size_t i = 0; i < tables[0].im.size(); ++i) {
    const auto& of = tables[0].at[i].of_level;
    EXPECT_NEAR(of[0] + of[1] + of[2], 1, 1e-12);
    EXPECT_NEAR(1 - of[0], results[0].curve()->probability(tables[0].im[i]), 1e-12);
  }
}

// Four equal runs of each record: their fractions are twice as far from the curve, in standard
// deviations, as those of independent runs would be.
TEST_F(FragilityResultTest, RepeatedRunsOfARecordHaveNoGoodnessOfFit) {
  const std::vector<SmallRun> once = known_runs(40, {0.1, 0.2, 0.4});
  EXPECT_TRUE(fragility_of(data(once), {}).p_of_fit);
  std::vector<SmallRun> four;
  for (int i = 0; i < 4; ++i) four.insert(four.end(), once.begin(), once.end());
  const FragilityResult result = fragility_of(data(four), {});
  EXPECT_FALSE(result.fit_is_judged);
  EXPECT_FALSE(result.p_of_fit);
}

}  // namespace
}  // namespace gurney::study
