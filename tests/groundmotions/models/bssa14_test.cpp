#include "groundmotions/models/bssa14.h"

#include <gmock/gmock.h>

#include "engine/base/units.h"
#include "tests/support/expect_error.h"

namespace gurney::groundmotions {
namespace {

struct Verified {
  Scenario scenario;
  double pgv;                                  ///< [cm/s]
  std::vector<std::pair<double, double>> psa;  ///< period [s], [g]
};

// Medians of the verification table BSSA_2014_MEAN of OpenQuake's hazard library. Six digits: half of the last
// is at most 5e-6 of a value.
const Verified kVerified[] = {
    {{8, 20, 600, Faulting::kStrikeSlip},
     30.4374,
     {{0, 0.254966},
      {0.1, 0.428918},
      {0.2, 0.509995},
      {1, 0.206713},
      {3, 0.0861615},
      {10, 0.0353295}}},
    {{8, 20, 200, Faulting::kStrikeSlip},
     49.2945,
     {{0, 0.295543},
      {0.1, 0.384389},
      {0.2, 0.532673},
      {1, 0.412081},
      {3, 0.258779},
      {10, 0.0726121}}},
    {{8, 100, 760, Faulting::kStrikeSlip},
     6.15376,
     {{0, 0.0570218}, {0.1, 0.085025}, {1, 0.0399696}, {10, 0.00912965}}},
    {{3, 0, 200, Faulting::kNormal},
     0.219327,
     {{0, 0.0122054}, {0.1, 0.0252967}, {0.2, 0.0144677}, {1, 0.000543518}, {10, 1.24281e-6}}},
    {{3, 50, 760, Faulting::kReverse}, 0.0027737, {{0, 0.00015492}, {1, 8.54947e-6}}},
};

TEST(Bssa14, HasTheValuesOfAVerificationTable) {
  for (const Verified& each : kVerified) {
    EXPECT_NEAR(bssa14_pgv(each.scenario).median / 0.01 / each.pgv, 1, 5.1e-6);
    for (const auto& [period, psa] : each.psa)
      EXPECT_NEAR(bssa14_sa(each.scenario, period).median / kStandardGravity / psa, 1, 5.1e-6)
          << "M " << each.scenario.magnitude << ", " << period << " s";
  }
}

// Of its BSSA_2014_TOTAL_STD: four digits.
TEST(Bssa14, HasTheScatterOfAVerificationTable) {
  EXPECT_NEAR(bssa14_pgv({3, 0, 200, Faulting::kNormal}).sigma(), 0.6920, 1e-4);
  EXPECT_NEAR(bssa14_sa({3, 0, 200, Faulting::kNormal}, 0).sigma(), 0.7410, 1e-4);
  EXPECT_NEAR(bssa14_sa({3, 0, 250, Faulting::kNormal}, 1).sigma(), 0.7348, 1e-4);
  EXPECT_NEAR(bssa14_sa({3, 100, 600, Faulting::kNormal}, 0.1).sigma(), 0.8521, 1e-4);
}

TEST(Bssa14, IsContinuousInMagnitudeDistanceAndSite) {
  constexpr double kStep = 1e-9;  // changes ln Y by no more than some 10 of it
  const auto same = [](const Scenario& a, const Scenario& b) {
    for (const double period : {0., 0.1, 0.3, 1., 5.}) {
      const Prediction p = bssa14_sa(a, period), q = bssa14_sa(b, period);
      EXPECT_NEAR(std::log(q.median / p.median), 0, 100 * kStep);
      EXPECT_NEAR(q.sigma() - p.sigma(), 0, 100 * kStep);
    }
  };
  for (const double hinge : {4.5, 5.5, 5.54, 6.14, 6.2}) same({hinge, 20}, {hinge + kStep, 20});
  for (const double hinge : {79.59, 110., 116.39, 270.}) same({7, hinge}, {7, hinge + kStep});
  for (const double hinge : {225., 300., 760., 1109.95})
    same({7, 20, hinge}, {7, 20, hinge + kStep});
}

TEST(Bssa14, IsStraightInLogarithmsBetweenPeriods) {
  const Scenario scenario{7, 20, 400};
  const Prediction a = bssa14_sa(scenario, 1), b = bssa14_sa(scenario, 1.5);
  const Prediction middle = bssa14_sa(scenario, std::sqrt(1.5));
  EXPECT_NEAR(middle.median / std::sqrt(a.median * b.median), 1, 1e-12);
  EXPECT_NEAR(middle.phi, (a.phi + b.phi) / 2, 1e-12);
}

TEST(Bssa14, BehavesAsMotionsDo) {
  // Larger and nearer is stronger; soft ground amplifies long periods, and strong motion less than weak.
  EXPECT_GT(bssa14_pgv({7, 20, 400}).median, bssa14_pgv({6, 20, 400}).median);
  EXPECT_GT(bssa14_pgv({7, 10, 400}).median, bssa14_pgv({7, 20, 400}).median);
  const auto amplification = [](double distance, double period) {
    return bssa14_sa({7, distance, 250}, period).median /
           bssa14_sa({7, distance, 760}, period).median;
  };
  EXPECT_GT(amplification(60, 1), 1.5);
  EXPECT_LT(amplification(5, 0.1), amplification(60, 0.1));
  EXPECT_EQ(bssa14_sa({7, 20, 1500}, 3).median, bssa14_sa({7, 20, 1400}, 3).median);  // above vc
}

TEST(Bssa14, RefusesWhatItIsNotFor) {
  EXPECT_ERROR(bssa14_pgv({9, 20}), "magnitude 9: must be from 3 to 8.5");
  EXPECT_ERROR(bssa14_pgv({7, -1}), "distance -1 km: must be from 0 to 400 km");
  EXPECT_ERROR(bssa14_pgv({7, 20, 100}), "V_S30 100 m/s: must be from 150 to 1500 m/s");
  EXPECT_ERROR(bssa14_sa({7, 20}, 0.001), "period 0.001 s: must be 0 or from 0.01 to 10 s");
}

}  // namespace
}  // namespace gurney::groundmotions
