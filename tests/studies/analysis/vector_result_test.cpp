#include <gmock/gmock.h>

#include <cmath>

#include "engine/base/random/normal_draw.h"
#include "studies/analysis/fragility_result.h"
#include "studies/figures/study_figures.h"
#include "studies/render/render.h"
#include "studies/report/fragility_report.h"
#include "tests/studies/analysis/synthetic_runs.h"
#include "tests/support/expect_error.h"
#include "tests/support/temp_folder.h"

namespace gurney::study {
namespace {

/// The text in one line, wherever lines were broken.
std::string words_of(const findings::Section& section) {
  std::istringstream text(render::text(section));
  std::string line;
  for (std::string word; text >> word;) line += (line.empty() ? "" : " ") + word;
  return line;
}

using testing::HasSubstr;

/// 300 runs of 30 records at two levels; `moved` follows the level and, by `power`, the floor's
/// velocity.
std::vector<SyntheticRun> runs(double power) {
  std::vector<SyntheticRun> all;
  for (std::uint64_t i = 0; i < 300; ++i) {
    const auto normal = [&](std::uint64_t stream) {
      return normal_quantile(uniform_draw(7, stream, i));
    };
    SyntheticRun run{.record = i % 30, .level = 1.0 + static_cast<double>(i % 2)};
    run.pfv = std::exp(0.5 * normal(1));
    run.displacement = 0.07 * run.level * std::pow(run.pfv, power) * std::exp(0.3 * normal(2));
    all.push_back(run);
  }
  return all;
}

/// An IDA of 30 records in brackets of 4 %: `moved` above 2 m/s2 (PGA h1 times velocity over 0.1)
/// to the power 1/2, but for a scatter of 0.2. Velocities grow with the level, or stay.
std::vector<SyntheticRun> ida_runs(bool grow) {
  std::vector<SyntheticRun> all;
  for (std::uint64_t i = 0; i < 30; ++i) {
    const auto normal = [&](std::uint64_t stream) {
      return normal_quantile(uniform_draw(8, stream, i));
    };
    // ln capacity c: (ln c + ln pfv / 0.1) / 2 = ln 2 + 0.2 z at pfv = c exp(r), or at exp(r).
    const double r = 0.6 * normal(1), at = std::log(2) + 0.2 * normal(2);
    const double capacity = std::exp(grow ? at - r / 2 : 2 * at - r);
    for (const double of : {0.5, 0.98, 1.02})
      all.push_back({.record = i,
                     .level = of * capacity,
                     .displacement = of > 1 ? 0.2 : 0.05,
                     .pfv = 0.1 * std::exp(r) * (grow ? of * capacity : 1)});
  }
  return all;
}

std::string traced_job() {
  std::string job = synthetic_job();
  return job.replace(job.find("levels = [1, 2]"), 15,
                     "ida = { first = 0.5, increment = 0.5, until = \"moved\" }");
}

class VectorResultTest : public testing::Test {
 protected:
  StudyData data(const std::vector<SyntheticRun>& all, const std::string& job = synthetic_job()) {
    std::vector<std::string> records;
    for (int i = 0; i < 30; ++i) records.push_back("r" + std::to_string(i));
    const SyntheticRuns study{.job = job, .records = records, .files = {}, .runs = all};
    const std::string path = folder_.file(std::to_string(++files_) + ".h5");
    study.write(path);
    return StudyData(path);
  }
  TempFolder folder_;
  int files_ = 0;
};

TEST_F(VectorResultTest, TwoMeasuresThatBothTellMakeOne) {
  const StudyData study = data(runs(1));
  const VectorResult found = vector_of(study, 0, 0, {"PGA h1", "pfv"});
  ASSERT_EQ(found.fit.status, statistics::VectorStatus::kFitted);
  EXPECT_EQ(found.fit.runs, 300);
  EXPECT_EQ(found.fit.groups, 30);
  // ln displacement = ln level + ln pfv + 0.3 z: slopes 1 / 0.3, within 4 standard errors.
  for (const Eigen::Index i : {0, 1})
    EXPECT_NEAR(found.fit.plane[i], 1 / 0.3, 4 * std::sqrt(found.fit.cluster_covariance(i, i)));
  EXPECT_GT(found.alone[0].curve->beta, 1.3 * found.fit.beta());
  EXPECT_GT(found.fit.log_likelihood, found.alone[0].log_likelihood + 20);
  const std::string text = words_of(report::vector_findings(study, {found}));
  EXPECT_THAT(text, HasSubstr("a = PGA h1 [g], b = pfv [m/s]"));
  EXPECT_THAT(text, HasSubstr("moved: each adds information to the other; together they are one "
                              "measure (PGA h1)^"));
  EXPECT_THAT(render::json(report::vector_findings(study, {found})), HasSubstr("\"share\""));
  const std::string figure = figures::vector_figure(study, {found});
  EXPECT_THAT(figure, HasSubstr("pfv (m/s)"));
  EXPECT_EQ(figure.find("nan"), std::string::npos);
}

TEST_F(VectorResultTest, AMeasureThatAddsNothingIsNamed) {
  const StudyData study = data(runs(0));
  const VectorResult found = vector_of(study, 0, 0, {"pfv", "PGA h1"});
  EXPECT_GT(found.fit.p_of(0), 0.001) << "once in 1000";
  EXPECT_LT(found.fit.p_of(1), 1e-6);
  EXPECT_THAT(words_of(report::vector_findings(study, {found})),
              HasSubstr("pfv adds nothing beyond chance to PGA h1"));
}

TEST_F(VectorResultTest, SaysWhatIsMissing) {
  std::vector<SyntheticRun> all = runs(1);
  all[3].pfv = std::nan("");
  all[4].failed = true;
  const StudyData study = data(all);
  const VectorResult found = vector_of(study, 0, 0, {"PGA h1", "pfv"});
  EXPECT_EQ(found.fit.runs, 298);
  EXPECT_THAT(words_of(report::vector_findings(study, {found})),
              HasSubstr("; 1 runs lack a measure; 1 runs failed"));
  const VectorResult fell = vector_of(study, 1, 0, {"PGA h1", "pfv"});
  EXPECT_THAT(words_of(report::vector_findings(study, {fell})), HasSubstr("no run exceeds"));
  EXPECT_THAT(render::json(report::vector_findings(study, {fell})), HasSubstr("\"plane\": null"));
  EXPECT_THAT(figures::vector_figure(study, {fell}), HasSubstr("no fit"));
  EXPECT_ERROR(vector_of(study, 0, 0, {"PGA h1", "pfw"}),
               "no intensity measure 'pfw'; did you mean 'pfa'?");
  EXPECT_ERROR(vector_of(study, 0, 0, {"", "PGA h1"}),
               "the second measure must not be the first, PGA h1");
}

// Both slopes are 1/2 over the scatter 0.2 where both measures grow, and over twice of it where one
// stays: 2.5 and 2.5, or ln c = 2 ln 2 - r + 0.4 z. Within 4 standard errors.
TEST_F(VectorResultTest, AfterAnIdaIsOfCapacities) {
  for (const bool grow : {true, false}) {
    const StudyData study = data(ida_runs(grow), traced_job());
    const VectorResult found = vector_of(study, 0, 0, {"PGA h1", "pfv"}),
                       turned = vector_of(study, 0, 0, {"pfv", "PGA h1"});
    ASSERT_EQ(found.fit.status, statistics::VectorStatus::kFitted);
    EXPECT_EQ(found.fit.runs, 30);
    EXPECT_EQ(found.runs.size(), 90);
    for (const Eigen::Index i : {0, 1})
      EXPECT_NEAR(found.fit.plane[i], 2.5, 4 * std::sqrt(found.fit.covariance(i, i))) << grow;
    EXPECT_LT(found.fit.p_of(1), 0.001);
    // Capacities do not depend on the measure that they are seen along: brackets are alike in both.
    EXPECT_NEAR(turned.fit.log_likelihood, found.fit.log_likelihood, 1e-6);
    for (const Eigen::Index i : {0, 1}) {
      EXPECT_NEAR(turned.fit.plane[i], found.fit.plane[1 - i], 1e-4);
      EXPECT_NEAR(turned.fit.covariance(i, i), found.fit.covariance(1 - i, 1 - i), 1e-4);
    }
    EXPECT_EQ(found.alone[1].curve.has_value(), grow) << "what stays has no capacities";
    ASSERT_TRUE(found.alone[0].curve);
    EXPECT_GT(found.alone[0].curve->beta, found.fit.beta());
    EXPECT_FALSE(found.audit.chosen_by_response);
    EXPECT_EQ(found.audit.outcomes, 30);
    const findings::Section all = report::vector_findings(study, {found});
    EXPECT_THAT(words_of(all), HasSubstr("moved: each adds information to the other"));
    EXPECT_THAT(render::json(all), HasSubstr("\"of_capacities\": true"));
    EXPECT_EQ(figures::vector_figure(study, {found}).find("nan"), std::string::npos);
  }
}

TEST_F(VectorResultTest, RefusesAnIdaOfMeasuresThatGrowApart) {
  auto all = ida_runs(true);
  all[1].pfv *= 1.1;
  const StudyData study = data(all, traced_job());
  EXPECT_ERROR(vector_of(study, 0, 0, {"PGA h1", "pfv"}),
               "of two measures of an IDA one must grow with the factor on the record, and the "
               "other in proportion to it or not at all: PGA h1 and pfv do otherwise");
}

}  // namespace
}  // namespace gurney::study
