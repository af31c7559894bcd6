#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "engine/base/units.h"
#include "engine/simulate.h"
#include "studies/verification/scenes/scenes.h"

// A cart with one axle locked and the other free, without rolling resistance, on a floor that
// accelerates. The locked wheels carry N = M g l_f / w (1 +- a h / (g l_f)), the inertia M a is all
// theirs to hold, so sliding starts (statics) at
//
//     a / g = mu (l_f / w) / (1 - mu h / w)   inertia towards the locked axle (it loads it)
//     a / g = mu (l_f / w) / (1 + mu h / w)   towards the free axle
//
// w wheelbase, h height of the centre of mass, l_f its distance from the free axle. It tips about
// the locked axle at l_L / h, l_L the distance from it, if that comes first.
namespace gurney {
namespace {

using namespace scenes;

constexpr double kG = kStandardGravity;
constexpr double kRamp = 3, kHold = 1;  // [s]

struct Cart {
  double mu, wheelbase, height, offset;  // offset of the chassis from the middle, forwards [m]
};

/// The front axle is locked.
EquipmentModel half_locked(const Cart& cart) {
  ItemOptions options;
  stiffen(options.caster.tread);
  options.caster.swivels = false;
  options.caster.trail = 0;
  options.caster.tread.rolling_resistance = 0;
  options.caster.tread.static_friction = options.caster.tread.kinetic_friction = cart.mu;
  options.half_wheelbase = cart.wheelbase / 2;
  options.chassis_center = {cart.offset, 0, cart.height};
  EquipmentModel item = trolley(options);
  for (int front : {0, 1})
    item.casters[front].brake_torque = std::numeric_limits<double>::infinity();
  return item;
}

struct Thresholds {
  double towards_locked, towards_free, tip;  // [g]
};

Thresholds thresholds(const Cart& cart, const EquipmentModel& item) {
  const Vector3 center = whole_item(item).center_of_mass;  // the casters lower it
  const double w = cart.wheelbase, h = center.z(), from_free = center.x() + w / 2;
  const double share = cart.mu * from_free / w;
  return {share / (1 - cart.mu * h / w), share / (1 + cart.mu * h / w), (w - from_free) / h};
}

/// The floor's acceleration rises slowly to `level` [g] and stays; slow against the treads' periods
/// of milliseconds, so the cart sees a static load. Inertia acts along -direction.
Response push(const EquipmentModel& item, double level, double direction) {
  Scene scene;
  scene.items[0].model = item;
  Excitation excitation;
  excitation.floor = floor_motion(0.01, kRamp + kHold, direction * Vector3::UnitX(),
                                  [=](double t) { return level * kG * std::min(1.0, t / kRamp); });
  return simulate(scene, excitation, run_for(kRamp + kHold, 0.002));
}

// 1 % below a threshold the cart moves by the sway of its treads, M a / (2 k_t) < 1e-6 m, and the
// tilt on them; 1 % above it slides, by hold^2 / 2 times an excess of 1 % of the level and more.
constexpr double kBelow = 0.99, kAbove = 1.01;
constexpr double kHeld = 1e-5;
double slid(double level) { return 0.5 * 0.01 * level * kG * kHold * kHold; }

class HalfLocked : public testing::TestWithParam<Cart> {};

TEST_P(HalfLocked, SlidesTowardsTheFreeAxleAtItsThreshold) {
  const EquipmentModel item = half_locked(GetParam());
  const double level = thresholds(GetParam(), item).towards_free;
  EXPECT_LT(push(item, kBelow * level, 1).items[0].demands.peak_displacement, kHeld);
  const auto response = push(item, kAbove * level, 1);
  EXPECT_GT(response.items[0].demands.peak_displacement, 0.5 * slid(level));
  EXPECT_LT(response.items[0].demands.residual_displacement_x, 0);
}

TEST_P(HalfLocked, SlidesOrTipsTowardsTheLockedAxleAtItsThreshold) {
  const EquipmentModel item = half_locked(GetParam());
  const Thresholds at = thresholds(GetParam(), item);
  const bool tips = at.tip < at.towards_locked || at.towards_locked < 0;
  const double level = tips ? at.tip : at.towards_locked;
  const auto held = push(item, kBelow * level, -1);
  EXPECT_LT(held.items[0].demands.peak_displacement, kHeld);
  EXPECT_EQ(held.items[0].demands.most_wheels_lifted, 0);
  const auto moved = push(item, kAbove * level, -1);
  if (tips) {
    EXPECT_EQ(moved.items[0].demands.most_wheels_lifted, 2);
    EXPECT_GT(moved.items[0].demands.wheels[2].lifted_time, 0);
    EXPECT_EQ(moved.items[0].demands.wheels[0].lifted_time, 0);
  } else {
    EXPECT_GT(moved.items[0].demands.residual_displacement_x, 0.5 * slid(level));
    EXPECT_EQ(moved.items[0].demands.most_wheels_lifted, 0);
  }
}

INSTANTIATE_TEST_SUITE_P(Carts, HalfLocked,
                         testing::Values(Cart{0.5, 0.6, 0.45, 0},     // slides both ways
                                         Cart{0.3, 0.98, 0.618, 0},   // the trolley
                                         Cart{0.4, 0.8, 0.5, 0.1},    // heavy at the locked axle
                                         Cart{0.4, 0.8, 0.5, -0.15},  // at the free axle
                                         Cart{0.5, 0.5, 0.618, 0}));  // tips first

// The unequal thresholds make such a cart creep one way under symmetric shaking: strong enough for
// one direction, too weak for the other.
TEST(HalfLockedCart, RatchetsTowardsTheFreeAxle) {
  const Cart cart{0.5, 0.6, 0.45, 0};
  Scene scene;
  scene.items[0].model = half_locked(cart);
  const Thresholds at = thresholds(cart, scene.items[0].model);
  const double level = 0.5 * (at.towards_free + at.towards_locked);
  Excitation excitation;
  excitation.floor = floor_motion(0.004, 5, Vector3::UnitX(), [=](double t) {
    return level * kG * std::sin(2 * std::numbers::pi * t) * std::min(1.0, t);
  });
  const auto response = simulate(scene, excitation, run_for(5, 0.002, 0.1));
  EXPECT_LT(response.items[0].demands.residual_displacement_x, -0.1);
  double last = 0;
  for (const Sample& s : response.items[0].history) {
    EXPECT_LT(s.displacement.x(), last + 1e-4);  // the sway of the treads
    last = s.displacement.x();
  }
}

}  // namespace
}  // namespace gurney
