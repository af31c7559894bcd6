#include <gtest/gtest.h>

#include <random>

#include "engine/caster/caster_geometry.h"
#include "engine/contact/tread_patch.h"

// Four casters side by side have the numbers of each alone. The same formulas round alike but where
// the compiler orders their sums otherwise: 1e-12 is 4,500 roundings of the largest number.
namespace gurney {
namespace {

template <class Structure>
Structure drawn(std::mt19937& random, double scale) {
  constexpr std::size_t kCount = sizeof(Structure) / sizeof(double);
  std::normal_distribution<double> normal(0, scale);
  std::array<double, kCount> numbers;
  for (double& number : numbers) number = normal(random);
  return std::bit_cast<Structure>(numbers);
}

template <template <class> class Structure>
void expect_lane(const Structure<Lanes>& lanes, std::size_t lane, const Structure<double>& one) {
  constexpr std::size_t kCount = sizeof(one) / sizeof(double);
  const auto found = std::bit_cast<std::array<Lanes, kCount>>(lanes);
  const auto expected = std::bit_cast<std::array<double, kCount>>(one);
  double largest = 0;
  for (double number : expected) largest = std::max(largest, std::abs(number));
  for (std::size_t i = 0; i < kCount; ++i)
    EXPECT_NEAR(found[i][lane], expected[i], 1e-12 * largest) << i;
}

// Axles of all directions: upright wheels, wheels on their crowns, wheels that lie.
TEST(CasterLanes, HaveTheGeometryOfEachCaster) {
  std::mt19937 random(1);
  for (int trial = 0; trial < 200; ++trial) {
    CasterConstants<Lanes> constants;
    CasterMotion<Lanes> motion;
    std::array<CasterGeometry<double>, kLanes> expected;
    for (std::size_t k = 0; k < kLanes; ++k) {
      auto c = drawn<CasterConstants<double>>(random, 1);
      auto m = drawn<CasterMotion<double>>(random, 1);
      c.swivels = k % 2 == 0 ? 1 : 0;
      c.radius = std::abs(c.radius);
      c.width = std::abs(c.width);
      m.rotation = splat<double>(
          Matrix3(Quaternion(1, trial % 3 * m.sine, trial % 2 * m.cosine, 0.3).normalized()));
      set_lane(constants, k, c);
      set_lane(motion, k, m);
      caster_geometry(c, m, expected[k]);
    }
    CasterGeometry<Lanes> found;
    caster_geometry(constants, motion, found);
    for (std::size_t k = 0; k < kLanes; ++k) expect_lane(found, k, expected[k]);
  }
}

// In the air, sticking, sliding, rolling, leaving and landing.
TEST(CasterLanes, HaveTheTreadForcesOfEachCaster) {
  std::mt19937 random(2);
  for (int trial = 0; trial < 500; ++trial) {
    TreadConstants<Lanes> constants;
    TreadStage<Lanes> stage;
    TreadRates<Lanes> rates;
    std::array<TreadForce<double>, kLanes> expected;
    std::array<TreadSlope<double>, kLanes> slopes;
    for (std::size_t k = 0; k < kLanes; ++k) {
      const TreadConstants<double> c{3e5, 500, 1e5, 150, 0.01, 1e-3, 0.002, {2500, 0}};
      auto s = drawn<TreadStage<double>>(random, 1e-3);
      s.tau = 0.001;
      s.mu = 0.5;
      s.set_rolling(c, std::abs(s.forgetting_rate));
      const auto u = drawn<TreadRates<double>>(random, trial % 2 == 0 ? 1e-2 : 2);
      set_lane(constants, k, c);
      set_lane(stage, k, s);
      set_lane(rates, k, u);
      tread_force(c, s, u, expected[k], slopes[k]);
    }
    TreadForce<Lanes> force;
    TreadSlope<Lanes> slope;
    tread_force(constants, stage, rates, force, slope);
    const TreadOutcome<Lanes> outcome = tread_outcome(constants, stage, rates, force);
    for (std::size_t k = 0; k < kLanes; ++k) {
      expect_lane(force, k, expected[k]);
      expect_lane(slope, k, slopes[k]);
      EXPECT_GE(outcome.sliding_power[k], 0);
    }
  }
}

TEST(Lanes, AreAddedInTheirOrder) {
  std::mt19937 random(3);
  for (std::size_t lanes = 1; lanes <= kLanes; ++lanes) {
    const auto values = drawn<std::array<Lanes, 8>>(random, 1);
    const auto start = drawn<std::array<double, 8>>(random, 1e3);
    auto sums = loaded<2>(start.data());
    add_lanes(values.data(), lanes, sums);
    std::array<double, 8> found;
    store(sums, found.data());
    for (std::size_t i = 0; i < 8; ++i) {
      double expected = start[i];
      for (std::size_t k = 0; k < lanes; ++k) expected += values[i][k];
      EXPECT_EQ(found[i], expected);
    }
  }
}

}  // namespace
}  // namespace gurney
