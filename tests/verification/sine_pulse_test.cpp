#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <ostream>
#include <vector>

#include "engine/base/units.h"
#include "engine/simulate.h"
#include "studies/verification/scenes/scenes.h"
#include "studies/verification/scenes/blocks.h"
#include "studies/verification/scenes/housner.h"

// One cycle of a sine, a(t) = a_p sin(w_p t), under a rocking block (Zhang & Makris 2001). With
// growing strength s = a_p / (alpha g) the block overturns after one impact from a on, is safe
// again from b on, and overturns without impact from c on; it falls the other way then. Where w_p /
// p is large, only c is left.
namespace gurney {
namespace {

using std::numbers::pi;
constexpr double kG = kStandardGravity;
constexpr double kRebound = 0.01;

enum class End { kStands, kAfterImpact, kWithoutImpact };

void PrintTo(End end, std::ostream* out) {
  *out << (end == End::kStands        ? "stands"
           : end == End::kAfterImpact ? "falls after an impact"
                                      : "falls without impact");
}

End reference(const RockingBlock& block, double ratio, double strength) {
  const double omega = ratio * block.p;
  RockingReference r(block);
  r.advance([&](double t) { return strength * block.alpha * kG * std::sin(omega * t); },
            2 * pi / omega);
  // The block leaves its unstable balance as exp(p t): 20 / p to see on which side.
  r.advance([](double) { return 0.0; }, 20 / block.p);
  if (!r.fallen()) return End::kStands;
  return r.impacts() == 0 ? End::kWithoutImpact : End::kAfterImpact;
}

/// The strength between `without` and `with` from which on the block ends as `end`.
double boundary(const RockingBlock& block, double ratio, End end, double without, double with) {
  for (int i = 0; i < 24; ++i) {
    const double middle = 0.5 * (without + with);
    (reference(block, ratio, middle) == end ? with : without) = middle;
  }
  return 0.5 * (without + with);
}

struct Regions {
  double a = 0, b = 0, c = 0;  ///< strengths; a = b = 0: no impact ever helps the block to fall
};

Regions regions(const RockingBlock& block, double ratio) {
  Regions r;
  r.c = boundary(block, ratio, End::kWithoutImpact, 1, 40);
  for (double inside = 0.99 * r.c; inside > 1 && r.a == 0; inside *= 0.98) {
    if (reference(block, ratio, inside) != End::kAfterImpact) continue;
    r.a = boundary(block, ratio, End::kAfterImpact, 1, inside);
    r.b = boundary(block, ratio, End::kAfterImpact, 0.9999 * r.c, inside);
  }
  return r;
}

TEST(SinePulseReference, GivesTheTableOfAnIndependentIntegration) {
  // alpha = 0.25, p = 2.14 /s, eta = 0.9, the full equation; strengths to their digits. For
  // ratio 5 the linearised equation has 3.02, 6.32 and 7.17.
  const RockingBlock block{0.25, 2.14, 0.9};
  struct Row {
    double ratio;
    Regions regions;
  };
  for (const Row& row : {Row{2, {1.2509, 2.3742, 2.4081}}, Row{4, {1.8443, 5.0794, 5.4368}},
                         Row{5, {3.0323, 6.7430, 7.4930}}, Row{7, {7.6143, 10.1394, 12.7193}},
                         Row{8, {0, 0, 15.9049}}}) {
    const Regions found = regions(block, row.ratio);
    EXPECT_NEAR(found.a, row.regions.a, 5e-4) << row.ratio;
    EXPECT_NEAR(found.b, row.regions.b, 5e-4) << row.ratio;
    EXPECT_NEAR(found.c, row.regions.c, 5e-4) << row.ratio;
  }
}

struct Case {
  double alpha, radius;  ///< [rad], [m]
  double inertia;        ///< I_O / (M R^2); 4/3: a rectangle
  std::vector<double> ratios;
};

void PrintTo(const Case& c, std::ostream* out) {
  *out << "alpha " << c.alpha << ", R " << c.radius << " m, I_O/(M R^2) " << c.inertia;
}

class SinePulse : public testing::TestWithParam<Case> {
 protected:
  SinePulse() {
    const Case& c = GetParam();
    const Vector3 size(2 * c.radius * std::sin(c.alpha), 1, 2 * c.radius * std::cos(c.alpha));
    scene_ = blocks::block(kMass, size,
                           {.stiffness = kStiffness, .restitution = kRebound, .friction = 5});
    scene_.items[0].model.chassis_inertia =
        (c.inertia - 1) * kMass * c.radius * c.radius * Matrix3::Identity();
    block_ = {c.alpha, std::sqrt(kG / (c.inertia * c.radius)),
              1 - 2 * std::pow(std::sin(c.alpha), 2) / c.inertia};
    // An edge that lands with v and leaves with e v takes e (1 - eta) from the angular velocity
    // about it: e v = 2 b e w, up, at the lever b of the centre: 2 M b^2 e / I_O = e (1 - eta).
    eta_error_ = kRebound * (1 - block_.eta);
  }

  Response shake(double ratio, double strength, double cycles, double history_step) const {
    const double omega = ratio * block_.p, length = 2 * pi / omega * cycles;
    Excitation excitation;
    excitation.floor = scenes::floor_motion(length / 1000, length, Vector3::UnitX(), [&](double t) {
      return strength * block_.alpha * kG * std::sin(omega * t);
    });
    SimulationSettings settings = blocks::run_for(length + 12 / block_.p, 0.002, history_step);
    settings.follow_overturning = false;
    return simulate(scene_, excitation, settings);
  }

  End end_of(double ratio, double strength) const {
    const Response response = shake(ratio, strength, 1, 0);
    if (response.outcome != Outcome::kOverturned) return End::kStands;
    // A floor that starts along +x throws the block towards -x: without impact it falls there.
    const double direction = response.items[0].demands.direction_of_overturning;
    return std::cos(direction) > 0 ? End::kAfterImpact : End::kWithoutImpact;
  }

  /// How far the reference's boundary moves with the uncertainty of eta, as a fraction, and 0.5 %
  /// for edges that give way: they take pi/2 sqrt(M / k) = 2.2 ms to load or unload, 0.5 % of 1/p.
  double margin(double ratio, double strength, double without, double with) const {
    double worst = 0;
    for (const double sign : {-1.0, 1.0}) {
      RockingBlock other = block_;
      other.eta += sign * eta_error_;
      const double moved = boundary(other, ratio, End::kAfterImpact, without, with);
      worst = std::max(worst, std::abs(moved / strength - 1));
    }
    return worst + 0.005;
  }

  static constexpr double kMass = 200, kStiffness = 1e8;
  Scene scene_;
  RockingBlock block_;
  double eta_error_ = 0;
};

TEST_P(SinePulse, BlockLosesWhatHousnerSaysAtAnImpact) {
  // The tilts between impacts after a half sine: cos(alpha - theta) - cos(alpha) is the energy.
  const Response response = shake(6, 3.5, 0.5, 0.002);
  const auto energy = [&](double tilt) {
    return std::cos(block_.alpha - tilt) - std::cos(block_.alpha);
  };
  std::vector<double> energies;
  const auto& h = response.items[0].history;
  for (std::size_t i = 1; i + 1 < h.size(); ++i)
    if (h[i].tilt > h[i - 1].tilt && h[i].tilt >= h[i + 1].tilt && h[i].tilt > 0.2 * block_.alpha)
      energies.push_back(energy(h[i].tilt));
  ASSERT_GE(energies.size(), 3u);
  for (std::size_t i = 0; i + 1 < energies.size(); ++i)
    EXPECT_NEAR(std::sqrt(energies[i + 1] / energies[i]), block_.eta, eta_error_) << "impact " << i;
}

TEST_P(SinePulse, OverturnsInTheSameRegionsAsTheRigidBlock) {
  for (const double ratio : GetParam().ratios) {
    SCOPED_TRACE(testing::Message() << "omega / p " << ratio);
    const Regions r = regions(block_, ratio);
    EXPECT_EQ(end_of(ratio, 1.005 * r.c), End::kWithoutImpact);
    EXPECT_EQ(end_of(ratio, 0.995 * r.c), End::kStands);
    if (r.a == 0) {
      EXPECT_EQ(end_of(ratio, 0.6 * r.c), End::kStands);
      continue;
    }
    const double inside = 0.5 * (r.a + r.b);
    const double low = margin(ratio, r.a, 0.9 * r.a, inside);
    const double high = margin(ratio, r.b, 0.5 * (r.b + r.c), inside);
    EXPECT_LT(low + high, 0.05) << "a test that asks";
    EXPECT_EQ(end_of(ratio, (1 - low) * r.a), End::kStands);
    EXPECT_EQ(end_of(ratio, (1 + low) * r.a), End::kAfterImpact);
    EXPECT_EQ(end_of(ratio, inside), End::kAfterImpact);
    EXPECT_EQ(end_of(ratio, (1 - high) * r.b), End::kAfterImpact);
    if ((1 + high) * r.b < 0.995 * r.c) {
      EXPECT_EQ(end_of(ratio, (1 + high) * r.b), End::kStands);
    }
  }
}

// The first is the block of the table, I_O = 20 sin^2(0.25) M R^2 = 1.2242 M R^2.
INSTANTIATE_TEST_SUITE_P(Blocks, SinePulse,
                         testing::Values(Case{0.25, 1.749, 1.224175, {2, 4, 5, 7, 8}},
                                         Case{0.25, 0.7, 4.0 / 3, {3, 5.5, 6.5}},
                                         Case{0.2, 1, 4.0 / 3, {4.5, 9}},
                                         Case{0.33, 0.9, 1.5, {3.5, 6}}));

}  // namespace
}  // namespace gurney
