#include "groundmotions/selection/selection.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "engine/base/random/normal_draw.h"
#include "groundmotions/measures/response_spectrum.h"
#include "tests/support/expect_error.h"

namespace gurney::groundmotions {
namespace {

using Eigen::Index;

constexpr Index kPeriods = 15, kAt = 10, kCount = 20, kCandidates = 400;

SelectionTarget unconditional() {
  return {"scenario", bssa14_spectrum({7, 10, 400}, logarithmic_periods(0.05, 5, kPeriods))};
}

SelectionTarget conditional() {
  SelectionTarget target = unconditional();
  const double ln_sa = target.spectrum.mean[kAt] + target.spectrum.sigma()[kAt];
  target.spectrum = conditioned(target.spectrum, kAt, ln_sa);
  target.conditioning = kAt;
  return target;
}

/// Spectra drawn from a distribution, of `events` earthquakes at `stations` stations in turn.
Candidates drawn(const SpectrumDistribution& from, Index count, Index events = 1000,
                 Index stations = 1000) {
  Candidates candidates;
  candidates.ln_spectra = simulated_spectra(from, {.count = count, .seed = 99, .trials = 1});
  for (Index i = 0; i < count; ++i) {
    candidates.events.push_back("event " + std::to_string(i % events));
    candidates.stations.push_back("station " + std::to_string(i / 7 % stations));
  }
  return candidates;
}

int most_common(const std::vector<std::string>& groups, const Selection& selection) {
  std::map<std::string, int> count;
  for (const Index j : selection.records) ++count[groups[static_cast<std::size_t>(j)]];
  return std::ranges::max_element(count, {}, [](const auto& each) { return each.second; })->second;
}

TEST(SimulatedSpectra, HaveTheMomentsOfTheTarget) {
  const SelectionTarget target = unconditional();
  constexpr Index kMany = 4000;
  const Eigen::MatrixXd spectra = simulated_spectra(target.spectrum, {.count = kMany, .trials = 1});
  const SpectraErrors errors = spectra_errors(spectra, target.spectrum);
  // Random samples would err by sigma / sqrt(n) and sigma / sqrt(2 n); a Latin hypercube errs less.
  // Five standard errors; sigma also by the eigenvalues below 0, of 1e-4 n at most (bssa14 tests).
  const Eigen::ArrayXd sigma = target.spectrum.sigma();
  const double root = std::sqrt(kMany);
  EXPECT_TRUE((errors.mean.array().abs() < 5 * sigma / root).all());
  EXPECT_TRUE((errors.sigma.array().abs() < 5 * sigma / root / std::sqrt(2.) + 15e-4).all());
  const Eigen::MatrixXd apart = spectra.rowwise() - spectra.colwise().mean();
  const Eigen::MatrixXd covariance = apart.transpose() * apart / (kMany - 1);
  // Standard error of a covariance: sigma_i sigma_j sqrt((1 + rho^2) / n).
  EXPECT_TRUE(
      ((covariance - target.spectrum.covariance).array().abs() <
       5 * std::sqrt(2.) / root * (sigma.matrix() * sigma.matrix().transpose()).array() + 15e-4)
          .all());
}

TEST(SimulatedSpectra, OfAConditionalTargetMeetItAtTheGivenPeriod) {
  const SelectionTarget target = conditional();
  const Eigen::MatrixXd spectra = simulated_spectra(target.spectrum, {.count = kCount});
  EXPECT_LT((spectra.col(kAt).array() - target.spectrum.mean[kAt]).abs().maxCoeff(), 1e-7);
}

// Candidates drawn from the target: any N of them at random would err by sigma / sqrt(N) in the mean
// and by sigma / sqrt(2 (N - 1)) in sigma, in the root mean square over many draws. A selection is
// better than these.
TEST(SelectRecords, IsBetterThanARandomSample) {
  for (const SelectionTarget& target : {unconditional(), conditional()}) {
    const Candidates candidates = drawn(target.spectrum, kCandidates);
    for (const bool scaled : {false, true}) {
      const Selection s = select_records(target, candidates, {.count = kCount, .scaled = scaled});
      const double sigma = target.spectrum.sigma().norm();
      EXPECT_LT(s.errors.mean.norm(), sigma / std::sqrt(kCount));
      EXPECT_LT(s.errors.sigma.norm(), sigma / std::sqrt(2. * (kCount - 1)));
      EXPECT_EQ(std::set(s.records.begin(), s.records.end()).size(), kCount);
      EXPECT_TRUE(std::ranges::is_sorted(s.records));
    }
  }
}

TEST(SelectRecords, ScalesToTheGivenValue) {
  const SelectionTarget target = conditional();
  Candidates candidates = drawn(target.spectrum, kCandidates);
  // Factors 1/8 to 8, of which those from 0.6 to 1.6 are allowed.
  Index within = 0;
  for (Index j = 0; j < kCandidates; ++j) {
    const double ln_factor = std::log(8.) * (2. * static_cast<double>(j) / (kCandidates - 1) - 1);
    candidates.ln_spectra.row(j).array() -= ln_factor;
    within += std::log(0.6) < ln_factor && ln_factor < std::log(1.6);
  }
  const Selection s = select_records(
      target, candidates, {.count = kCount, .smallest_factor = 0.6, .largest_factor = 1.6});
  EXPECT_EQ(s.excluded, kCandidates - within);
  EXPECT_LT((s.ln_spectra.col(kAt).array() - target.spectrum.mean[kAt]).abs().maxCoeff(), 1e-12);
  EXPECT_GE(s.factors.minCoeff(), 0.6);
  EXPECT_LE(s.factors.maxCoeff(), 1.6);
  for (Index i = 0; i < kCount; ++i) {
    const Eigen::RowVectorXd spectrum =
        candidates.ln_spectra.row(s.records[static_cast<std::size_t>(i)]).array() +
        std::log(s.factors[i]);
    EXPECT_LT((spectrum - s.ln_spectra.row(i)).cwiseAbs().maxCoeff(), 1e-12);
  }
  EXPECT_ERROR(select_records(target, candidates,
                              {.count = kCount, .smallest_factor = 0.99, .largest_factor = 1.01}),
               "of 400 records have a factor from 0.99 to 1.01: 20 are to be selected");
}

TEST(SelectRecords, HoldsFactorsWithinTheirLimits) {
  const SelectionTarget target = unconditional();
  Candidates candidates = drawn(target.spectrum, kCandidates);
  candidates.ln_spectra.array() -= std::log(10.);
  const Selection s = select_records(target, candidates, {.count = kCount});
  EXPECT_NEAR(s.factors.maxCoeff(), 4, 1e-12);
  EXPECT_EQ(s.excluded, 0);
  // ln 10 - ln 4 is missing in the mean, less what the limit leaves to choose.
  EXPECT_LT(s.errors.mean.maxCoeff(), 0);
}

TEST(SelectRecords, LimitsRecordsOfOneEventAndOfOneStation) {
  const SelectionTarget target = unconditional();
  const Candidates candidates = drawn(target.spectrum, kCandidates, 10, 12);
  const Selection free = select_records(target, candidates, {.count = kCount});
  EXPECT_GT(most_common(candidates.events, free), 2);
  const Selection s =
      select_records(target, candidates, {.count = kCount, .per_event = 2, .per_station = 3});
  EXPECT_EQ(most_common(candidates.events, s), 2);  // 20 of 10 events
  EXPECT_LE(most_common(candidates.stations, s), 3);
  EXPECT_ERROR(select_records(target, candidates, {.count = kCount, .per_event = 1}),
               "only 10 of 20 records found, with at most 1 of one event and 0 of one station");
  Candidates unknown = candidates;
  for (std::string& event : unknown.events) event.clear();  // of which nothing is known
  EXPECT_NO_THROW(select_records(target, unknown, {.count = kCount, .per_event = 1}));
}

TEST(SelectRecords, ImprovementNeverWorsens) {
  for (const SelectionTarget& target : {unconditional(), conditional()})
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
      const Selection s = select_records(target, drawn(target.spectrum, 100),
                                         {.count = kCount, .seed = seed, .trials = 1});
      EXPECT_LE(s.total, s.nearest_total);
      EXPECT_DOUBLE_EQ(s.total, s.errors.total(2));
      EXPECT_NEAR(s.total, s.errors.mean.squaredNorm() + 2 * s.errors.sigma.squaredNorm(), 1e-14);
    }
}

TEST(SelectRecords, DependsOnTheSeedAlone) {
  const SelectionTarget target = conditional();
  const Candidates candidates = drawn(unconditional().spectrum, kCandidates);
  const auto records = [&](std::uint64_t seed) {
    return select_records(target, candidates, {.count = kCount, .seed = seed}).records;
  };
  EXPECT_EQ(records(1), records(1));
  EXPECT_NE(records(1), records(2));
}

// Without a variance to match, the records nearest to the median: the same one N times is best.
TEST(SelectRecords, TakesTheNearestWhereSigmaIsZero) {
  SelectionTarget target = unconditional();
  Candidates candidates = drawn(target.spectrum, 50);
  target.spectrum.covariance.setZero();
  for (const Index j : {7, 31}) candidates.ln_spectra.row(j) = target.spectrum.mean.transpose();
  const Selection s = select_records(target, candidates, {.count = 2, .scaled = false});
  EXPECT_THAT(s.records, testing::ElementsAre(7, 31));
  EXPECT_NEAR(s.total, 0, 1e-20);
  EXPECT_NEAR(s.misfits.maxCoeff(), 0, 1e-12);
}

TEST(SelectRecords, RefusesWhatItCannotDo) {
  const SelectionTarget target = unconditional();
  const Candidates few = drawn(target.spectrum, 12);
  EXPECT_ERROR(select_records(target, few, {.count = 20}),
               "12 of 12 records are there: 20 are to be selected");
  EXPECT_ERROR(select_records(target, {}, {.count = 20}), "0 of 0 records are there");
  EXPECT_ERROR(select_records(target, few, {.count = 1}), "1 records to select: must be >= 2");
  EXPECT_ERROR(select_records(target, few, {.count = 2, .smallest_factor = 3, .largest_factor = 2}),
               "factors from 3 to 2: must be > 0 and increase");
}

}  // namespace
}  // namespace gurney::groundmotions
