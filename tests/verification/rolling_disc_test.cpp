#include "studies/verification/scenes/rolling_disc.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/base/units.h"

// The reference of the cases of `gurney verify "rolling disc"` against known numbers.
namespace gurney {
namespace {

constexpr double kG = kStandardGravity;

TEST(DiscReference, KeepsSteadyPrecessions) {
  // (C + m r^2) w3 Om sin th - A Om^2 sin th cos th + m g r cos th = 0, th from the vertical to the
  // axle, for a thin disc of r = 0.05 m: without spin at 20 and 40 degrees (the table has g
  // = 9.81), and at 60 degrees with Om = -12 rad/s.
  struct Row {
    double theta, precession, spin;
  };
  for (const Row& row : {Row{20, 47.90200, 0}, Row{40, 34.94184, 0}, Row{60, -12, 5.293118}}) {
    const Disc disc{1, 0.05, 0.5, 0};
    const double theta = row.theta * kRadiansPerDegree, scale = std::sqrt(kG / 9.81);
    const Vector3 axle(std::sin(theta), 0, std::cos(theta));
    // Om turns the axle; the rest of the angular velocity is along it.
    const Vector3 across = row.precession * scale * (Vector3::UnitZ() - axle.z() * axle);
    DiscReference reference(disc, axle, across + row.spin * scale * axle);
    for (int i = 0; i < 20; ++i) {
      reference.advance(0.02);
      EXPECT_NEAR(std::acos(reference.axle().z()) / kRadiansPerDegree, row.theta, 1e-4) << i;
    }
  }
}

TEST(DiscReference, WobblesAndFallsAtKnownRates) {
  // Frequency [Hz], or rate of growth [1/s] below the critical speed, for g = 9.81 m/s2.
  struct Row {
    double axial, ratio, known;
  };
  for (const Row& row :
       {Row{0.5, 1.2, 1.32264}, Row{0.5, 1.5, 2.22931}, Row{0.5, 2, 3.45363}, Row{0.5, 0.8, 7.517},
        Row{1, 1.2, 1.20740}, Row{1, 1.5, 2.03506}, Row{1, 2, 3.15271}, Row{1, 0.8, 6.862}}) {
    const Disc disc{1, 0.05, row.axial};
    const double stiffness = disc.stiffness(row.ratio * disc.critical_speed());
    EXPECT_EQ(stiffness > 0, row.ratio > 1);
    const double lambda = std::sqrt(std::abs(stiffness)) * std::sqrt(9.81 / kG);
    EXPECT_NEAR(row.ratio > 1 ? lambda / (2 * std::numbers::pi) : lambda, row.known,
                1e-4 * row.known)
        << row.axial << ", " << row.ratio;
  }
}

}  // namespace
}  // namespace gurney
