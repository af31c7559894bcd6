#include "engine/contact/impact_law.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/contact/one_sided_spring.h"

namespace gurney {
namespace {

/// Rebound of a mass under the law alone, by explicit midpoint steps of 1e-4 of a period.
double rebound(const ImpactLaw& law, double mass, double stiffness, double speed) {
  const double h = 1e-4 / std::sqrt(stiffness / mass);
  double d = 0, v = speed;
  Matrix3 slope;
  const auto acceleration = [&](double compression, double rate) {
    const ImpactLaw::Stage stage{0, compression, speed, Vector2::Zero()};
    ImpactLaw::Stage at = stage;
    at.tau = 1e-12;
    return -law.force(at, {0, 0, -rate}, slope).z() / mass;
  };
  do {
    const double a = acceleration(d, v);
    const double dm = d + h / 2 * v, vm = v + h / 2 * a;
    v += h * acceleration(dm, vm);
    d += h * vm;
  } while (d > 0);
  return -v / speed;
}

// A spring that pushes below x = 0 only, in two stages of SDIRK2: what both give it, (1 - gamma) h and gamma h times
// force and rate, less the energy it has gained, is what the rates make of it, wherever it touches or parts.
TEST(OneSidedSpring, LosesWhatItsRatesSayWhereverItTouches) {
  constexpr double kGamma = 0.29289321881345247560, h = 0.004, tau = kGamma * h;
  const double k = 1e6, ahead = (1 - kGamma) / kGamma;
  const auto energy = [&](double x) { return x > 0 ? 0.5 * k * x * x : 0; };
  for (const auto& [start, first, end] : {std::array{1e-5, 2e-5, 4e-5},
                                          {-1e-5, 1e-6, 4e-5},
                                          {-1e-5, -2e-6, 4e-5},
                                          {3e-5, 1e-6, -2e-5},
                                          {3e-5, -1e-6, -2e-5},
                                          {-3e-5, -1e-5, -1e-6},
                                          {2e-5, 1e-5, 3e-5}}) {
    const double second_start = start + ahead * (first - start);
    // A stage goes from where its bodies have turned to.
    const double turned = 3e-6, second_turned = -2e-6;
    const double given =
        (1 - kGamma) * h * k * std::max(first, 0.0) * (first - start - turned) / tau +
        kGamma * h * k * std::max(end, 0.0) * (end - second_start - second_turned) / tau;
    const double rates =
        one_sided_rates(k, {second_start, second_start + second_turned, end, 0}, tau) -
        one_sided_rates(k, {start, start + turned, first, ahead}, tau);
    // Energies of at most 1e-3 J: rounding.
    EXPECT_NEAR(given - (energy(end) - energy(start)), 0.5 * tau * tau * rates, 1e-15)
        << start << " " << first << " " << end;
    // Pressed throughout, it loses as any spring does: tau^2 / 2 (k x2'^2 - k x1'^2).
    if (start > 0 && first > 0 && end > 0 && second_start > 0) {
      EXPECT_NEAR(one_sided_rates(k, {start, start, first, ahead}, tau),
                  k * std::pow((first - start) / tau, 2), 1e-9 * k * 1e-4);
    }
  }
}

TEST(ImpactLaw, ReboundsWithItsRestitutionWhateverMassStiffnessAndSpeed) {
  for (double e : {0.1, 0.2, 0.4, 0.7, 0.95, 1.0})
    for (double mass : {2.0, 300.0})
      for (double k : {1e5, 1e7})
        for (double speed : {0.05, 3.0}) {
          const ImpactLaw law({.stiffness = k, .restitution = e});
          // Midpoint steps: error (1e-4)^2 a step, 3e4 steps; the end inside a step: 1e-4.
          EXPECT_NEAR(rebound(law, mass, k, speed), e, 5e-4) << e << " " << mass << " " << speed;
        }
}

TEST(ImpactLaw, DampingNumberSolvesItsEquation) {
  for (double e : {0.1, 0.3, 0.9, 0.999}) {
    const double x = ImpactLaw::damping_number(e);
    EXPECT_GT(x, 0);
    EXPECT_LT(e * x, 1);
    EXPECT_NEAR(std::log1p(x) - std::log1p(-e * x), (1 + e) * x, 1e-9 * (1 + x)) << e;
  }
  EXPECT_EQ(ImpactLaw::damping_number(1), 0);
}

TEST(ImpactLaw, NeverPullsAndStaysInTheFrictionCone) {
  for (const auto kind :
       {ContactConstants::Kind::kRestitution, ContactConstants::Kind::kCompliant}) {
    const ImpactLaw law({.kind = kind, .restitution = 0.3, .damping = 2e4, .friction = 0.5});
    Matrix3 slope;
    for (double d : {-1e-3, 1e-5, 1e-3})
      for (double uz : {-3.0, -0.1, 0.1, 3.0})
        for (double ux : {0.0, 0.5}) {
          const Vector3 f = law.force({1e-3, d, 0.5, Vector2::Zero()}, {ux, -ux, uz}, slope);
          EXPECT_GE(f.z(), 0);
          EXPECT_LE(f.head<2>().norm(), 0.5 * f.z() * (1 + 1e-12));
          if (d - 1e-3 * uz <= 0) {
            EXPECT_EQ(f.norm(), 0);
          }
        }
  }
}

TEST(ImpactLaw, SlopeIsTheDerivative) {
  for (const auto kind :
       {ContactConstants::Kind::kRestitution, ContactConstants::Kind::kCompliant}) {
    const ImpactLaw law({.kind = kind, .restitution = 0.3, .damping = 500, .friction = 0.5});
    const ImpactLaw::Stage stage{1e-3, 2e-3, 0.5, {1e-4, -2e-4}};
    for (const Vector3& u : {Vector3(0.01, 0.02, -0.2), Vector3(2, -1, -0.2), Vector3(0, 1, 0.1)}) {
      Matrix3 slope, unused;
      law.force(stage, u, slope);
      for (int k = 0; k < 3; ++k) {
        const Vector3 step = 1e-6 * Vector3::Unit(k);
        const Vector3 change =
            (law.force(stage, u - step, unused) - law.force(stage, u + step, unused)) / 2e-6;
        // Central differences of a quadratic are exact but for rounding and the kinks.
        EXPECT_LT((change - slope.col(k)).norm(), 1e-5 * slope.norm()) << k;
      }
    }
  }
}

// Energy that the body gives is stored or lost, to rounding: in an implicit Euler step a spring k loses
// k tau^2 x'^2 / 2. So it is when the body parts faster than the force lets it, still overlapping,
// with a deflection that no force holds, and when it has parted.
TEST(ImpactLaw, AccountsForTheEnergyOfAStage) {
  for (const auto kind :
       {ContactConstants::Kind::kRestitution, ContactConstants::Kind::kCompliant}) {
    const ImpactLaw law({.kind = kind, .restitution = 0.3, .damping = 5e4, .friction = 0.5});
    const double tau = 1e-4;
    const Vector2 before(1e-5, -2e-5);
    struct {
      double compression;
      Vector3 u;
      bool pushes;
    } const stages[] = {{1e-3, {0.01, 0.02, -0.2}, true},  // sticks
                        {1e-3, {2, -1, -0.2}, true},       // slides
                        {1e-3, {0.1, 0.3, 5}, false},      // parts and overlaps by half of that
                        {0, {0.1, 0.3, 1}, false}};        // has parted
    for (const auto& [compression, u, pushes] : stages) {
      SCOPED_TRACE(u.z());
      const ImpactLaw::Stage stage{tau, compression, 0.5, before};
      Matrix3 slope;
      const Vector3 force = law.force(stage, u, slope);
      EXPECT_EQ(force.z() > 0, pushes);
      const ImpactLaw::Result result = law.finish(stage, u, force);
      const double stored = law.stored_energy(result.compression, result.deflection.norm()) -
                            law.stored_energy(compression, before.norm());
      const double lost = tau * (result.sliding_power + result.damping_power) +
                          0.5 * tau * tau * result.spring_rates;
      const double given = -tau * force.dot(u);
      EXPECT_NEAR(given, stored + lost, 1e-12 * law.stored_energy(1e-3, before.norm()));
      EXPECT_GE(lost, 0);
    }
  }
}

}  // namespace
}  // namespace gurney
