#include <gmock/gmock.h>

#include <cmath>

#include "engine/base/random/normal_draw.h"
#include "engine/base/units.h"
#include "studies/analysis/fragility_result.h"
#include "studies/plan/stages.h"
#include "studies/statistics/special.h"
#include "tests/studies/analysis/small_study.h"
#include "tests/support/temp_folder.h"

/// Curves of an IDA, whose runs were chosen by the response of their record.
namespace gurney::study {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

constexpr double kTheta = 2, kBeta = 0.4;  // of the state that ends the IDA [m/s2]
constexpr std::size_t kRecords = 400;

std::string ida_job() {
  std::string job = kSmallStudy;
  const std::string levels = "levels = [0.1, 0.2, 0.4]\n";
  return job.replace(job.find(levels), levels.size(),
                     "ida = { first = 0.05, increment = 0.05, until = \"moved\" }\n");
}

double capacity_of(std::size_t record) {
  return kTheta * std::exp(kBeta * normal_draw(11, 0, record));
}

class IdaCapacities : public testing::Test {
 protected:
  /// An IDA as it is run, that ends where the cart moves; it falls at `fall` times that intensity.
  /// @param fall  of a record
  template <class Fall>
  StudyData traced(Fall fall) {
    IntensityPlan plan;
    plan.kind = IntensityPlan::Kind::kIda;
    plan.first = plan.increment = 0.05 * kStandardGravity;
    plan.most_runs = 20;
    plan.resolution = 0.1;
    std::vector<SmallRun> runs;
    for (std::size_t record = 0; record < kRecords; ++record) {
      const double capacity = capacity_of(record);
      Intensities trace(plan);
      while (const auto im = trace.next()) {
        const bool moved = *im > capacity;
        runs.push_back({record, *im, moved ? 0.2 : 0.05, *im > fall(record) * capacity});
        trace.report(*im, moved);
      }
    }
    write_small_study(folder_.file("s.h5"), runs, ida_job());
    return StudyData(folder_.file("s.h5"));
  }

  TempFolder folder_;
};

constexpr std::size_t kMoved = 0, kFell = 1;

// Standard errors of 400 capacities are beta / 20 of ln theta and 1 / sqrt(800) of ln beta; four of
// them are allowed. Brackets of 10 % add nothing to speak of.
constexpr double kOfTheta = 4 * kBeta / 20, kOfBeta = 4 * 0.0354;

TEST_F(IdaCapacities, OfStatesThatExceedInTheSameRunsAreTheSame) {
  const StudyData study = traced([](std::size_t) { return 1.0; });
  const FragilityResult moved = fragility_of(study, {.state = kMoved}),
                        fell = fragility_of(study, {.state = kFell});
  ASSERT_TRUE(moved.curve() && fell.curve() && fell.capacities);
  EXPECT_EQ(fell.curve()->theta, moved.curve()->theta);
  EXPECT_EQ(fell.curve()->beta, moved.curve()->beta);
  EXPECT_EQ(fell.band.theta.low, moved.band.theta.low);
  EXPECT_EQ(fell.audit.ended, 0);
  EXPECT_NEAR(std::log(fell.curve()->theta / kTheta), 0, kOfTheta);
  EXPECT_NEAR(std::log(fell.curve()->beta / kBeta), 0, kOfBeta);
  // A probit of the outcomes takes the runs as if they had been chosen before.
  EXPECT_GT(std::abs(std::log(fell.fit.curve->beta / kBeta)), 2 * kOfBeta);
}

TEST_F(IdaCapacities, OfOutcomesThatSomebodyElseHasJudgedAreThoseOfTheState) {
  const StudyData study = traced([](std::size_t) { return 1.0; });
  const std::vector<std::size_t>& runs = study.runs_of(0);
  const std::vector<bool> exceeds = study.exceedances(kFell, runs);
  std::map<std::size_t, bool> outcomes;
  for (std::size_t i = 0; i < runs.size(); ++i) outcomes[runs[i]] = exceeds[i];
  const FragilityResult judged = fragility_of_outcomes(study, outcomes, {});
  ASSERT_TRUE(judged.capacities && judged.curve());
  EXPECT_EQ(judged.curve()->theta, fragility_of(study, {.state = kFell}).curve()->theta);
}

// Falls come first: their capacities are bracketed by coarser steps, but known in every record.
TEST_F(IdaCapacities, OfAMilderStateHaveTheirOwnCurve) {
  const StudyData study = traced([](std::size_t) { return 0.6; });
  const FragilityResult fell = fragility_of(study, {.state = kFell});
  ASSERT_TRUE(fell.curve());
  EXPECT_NEAR(std::log(fell.curve()->theta / (0.6 * kTheta)), 0, kOfTheta);
  EXPECT_NEAR(std::log(fell.curve()->beta / kBeta), 0, kOfBeta);
  EXPECT_THAT(cautions(fell.audit, {"g", kStandardGravity}), Not(Contains(HasSubstr("ended"))));
}

TEST_F(IdaCapacities, SayWhereAnotherStateEndedTheRuns) {
  const StudyData study = traced([](std::size_t record) { return record % 4 == 0 ? 3.0 : 0.8; });
  const FragilityResult fell = fragility_of(study, {.state = kFell});
  EXPECT_EQ(fell.audit.ended, kRecords / 4);
  EXPECT_THAT(cautions(fell.audit, {"g", kStandardGravity}),
              Contains(HasSubstr("100 of 400 records do not exceed and end where another limit "
                                 "state ended the IDA")));
  EXPECT_EQ(fragility_of(study, {.state = kMoved}).audit.ended, 0);
}

// pfv is a tenth of the intensity: a record has its capacity in either. A duration is not scaled.
TEST_F(IdaCapacities, HoldInMeasuresThatAreScaledWithTheRecord) {
  const StudyData study = traced([](std::size_t) { return 1.0; });
  const FragilityResult own = fragility_of(study, {.state = kFell}),
                        other = fragility_of(study, {.state = kFell, .measure = "pfv"});
  ASSERT_TRUE(own.curve() && other.capacities && other.curve());
  EXPECT_NEAR(other.curve()->theta, 0.1 * own.curve()->theta, 1e-9 * own.curve()->theta);
  EXPECT_NEAR(other.curve()->beta, own.curve()->beta, 1e-9);
  EXPECT_THAT(cautions(other.audit, {"m/s", 1}),
              Contains("no annual rate: the hazard of the job is over PGA h1"));
  EXPECT_THAT(cautions(own.audit, {"g", kStandardGravity}), Not(Contains(HasSubstr("no annual"))));

  RunMeasure duration{"duration", "s", {}};
  for (std::size_t run = 0; run < study.runs_of(0).size(); ++run)
    duration.values.push_back(10 + static_cast<double>(study.record_of(run)));
  const FittedCurve fitted = fitted_curve(study, kFell, 0, duration);
  EXPECT_FALSE(fitted.capacities);
  EXPECT_THAT(cautions(fitted.audit, {"s", 1}), Contains(HasSubstr("chosen by their response")));
}

}  // namespace
}  // namespace gurney::study
