#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/base/units.h"
#include "engine/simulate.h"
#include "studies/verification/scenes/scenes.h"

// The pulling rig of Xu, Ma & Kurata 2022: blocks hold the trolley (phase I), a weight m_d on a
// cable over a pulley pulls it (II) until it lands, and the trolley coasts (III). String
// potentiometers pull back on the trolley (F_s) and up on the weight (F_w). Newton's law for the
// train of trolley, cable, pulley and weight, with J = sum I_w / R^2 and p = I_p / r_p^2:
//
//     a1 = (m_d g - f_r - F_s - F_w) / (M + J + m_d + p),   a2 = (f_r + F_s) / (M + J)
//     cable: T = m_d (g - a1) - F_w - p a1, not m_d g
namespace gurney {
namespace {

using namespace scenes;

constexpr double kG = kStandardGravity;
constexpr double kReleaseTime = 0.5;
constexpr double kCableStiffness = 1e7;

struct Rig {
  const char* name;
  double weight, drop, resistance;  // m_d [kg], [m], Cr / R
  double trolley_string = 0, weight_string = 0;
  double pulley_inertia = 0;
  double block_height = 0.618;  // where the blocks hold; the cable pulls at 0.618 m
  double mass = 96.5;
};

std::ostream& operator<<(std::ostream& out, const Rig& rig) { return out << rig.name; }

struct Exact {
  double a1, a2, tension, landing, velocity, distance, stop;
};

Exact exact(const Rig& rig, const EquipmentModel& item) {
  const double pulley = rig.pulley_inertia / (0.05 * 0.05);
  const double inertia = total_mass(item) + wheel_inertia_mass(item);
  const double resistance = rig.resistance * total_mass(item) * kG;
  Exact e;
  e.a1 = (rig.weight * kG - resistance - rig.trolley_string - rig.weight_string) /
         (inertia + rig.weight + pulley);
  e.a2 = (resistance + rig.trolley_string) / inertia;
  e.tension = rig.weight * (kG - e.a1) - rig.weight_string - pulley * e.a1;
  e.landing = std::sqrt(2 * rig.drop / e.a1);
  e.velocity = e.a1 * e.landing;
  e.distance = rig.drop + e.velocity * e.velocity / (2 * e.a2);
  e.stop = e.landing + e.velocity / e.a2;
  return e;
}

EquipmentModel pulled_trolley(const Rig& rig, double normal_stiffness) {
  ItemOptions options;
  options.total_mass = rig.mass;
  stiffen(options.caster.tread);
  options.caster.tread.normal_stiffness = normal_stiffness;
  options.caster.tread.rolling_resistance = rig.resistance * options.caster.wheel_radius;
  return trolley(options);
}

Excitation rigged(const Rig& rig) {
  Excitation excitation;
  DropWeight weight;
  weight.point = {0, 0, 0.618};
  weight.mass = rig.weight;
  weight.drop_height = rig.drop;
  weight.pulley_inertia = rig.pulley_inertia;
  weight.potentiometer_tension = rig.weight_string;
  weight.cable_stiffness = kCableStiffness;
  excitation.drop_weights = {weight};
  if (rig.trolley_string > 0)
    excitation.string_potentiometers = {{{0, 0, 0.618}, -Vector3::UnitX(), rig.trolley_string}};
  Blocks blocks;
  blocks.point = {0, 0, rig.block_height};
  blocks.release_time = kReleaseTime;
  excitation.blocks = {blocks};
  return excitation;
}

/// Runs a rig and holds every phase against the closed form, within `tolerance` of the largest
/// displacement and velocity.
void check(const Rig& rig, double normal_stiffness, double time_step, const Fixture& fixture,
           double tolerance) {
  Scene scene;
  scene.items[0].model = pulled_trolley(rig, normal_stiffness);
  Excitation excitation = rigged(rig);
  excitation.fixture = fixture;
  const Exact e = exact(rig, scene.items[0].model);
  const auto response =
      simulate(scene, excitation, run_for(kReleaseTime + e.stop + 1, time_step, 0.02));
  EXPECT_EQ(response.quality.unconverged_steps, 0);
  EXPECT_EQ(response.quality.event_steps, 1);  // the landing

  for (const Sample& s : response.items[0].history) {
    SCOPED_TRACE(s.time);
    const double t = std::clamp(s.time - kReleaseTime, 0.0, e.stop);
    const double pull = std::min(t, e.landing), coast = t - pull;
    const double x = e.a1 * pull * pull / 2 + e.velocity * coast - e.a2 * coast * coast / 2;
    const double v = e.a1 * pull - e.a2 * coast;
    ASSERT_NEAR(s.displacement.x(), x, tolerance * e.distance);
    ASSERT_NEAR(s.velocity.x(), v, tolerance * e.velocity);
    // Held, the cable carries the weight; it then swings for some periods of the cable and
    // treads; landed, it is slack.
    if (s.time < kReleaseTime - 1e-9) {
      ASSERT_NEAR(s.cable_tension, rig.weight * kG - rig.weight_string, 1e-6 * rig.weight * kG);
    } else if (t > 0.7 * e.landing && t < e.landing - time_step) {
      ASSERT_NEAR(s.cable_tension, e.tension, 2e-3 * e.tension);
    } else if (t > e.landing + time_step) {
      ASSERT_EQ(s.cable_tension, 0);
    }
  }
  // The weight loses its energy where it lands, so the loss tells the speed at the event. Blocks
  // and cable lose their strain energy besides, at most F^2 / (2 k) each.
  const double pulley = rig.pulley_inertia / (0.05 * 0.05), force = rig.weight * kG;
  const double landing_loss = 0.5 * (rig.weight + pulley) * e.velocity * e.velocity;
  const double strain = force * force / kCableStiffness;
  EXPECT_NEAR(response.items[0].energy.damper_loss, landing_loss,
              2 * tolerance * landing_loss + strain);
  EXPECT_NEAR(response.items[0].energy.weight_energy, -rig.weight * kG * rig.drop, 1e-8 * force);
}

class DropWeightPull : public testing::TestWithParam<Rig> {};

TEST_P(DropWeightPull, AgreesWithin0p1PercentAt4ms) { check(GetParam(), 3e6, 0.004, {}, 1e-3); }

// With the pitch held. What is left is the wind-up of the treads (pulling_test.cpp) and the stretch
// m_d g / k of the cable.
TEST_P(DropWeightPull, AgreesWithin0p01PercentAtHalfAMillisecond) {
  check(GetParam(), 3e8, 0.0005, hold_rotations(false, true, false), 1e-4);
}

INSTANTIATE_TEST_SUITE_P(Rigs, DropWeightPull,
                         testing::Values(Rig{"plain", 5, 0.7, 0.02},
                                         Rig{"strings", 6, 0.8, 0.02, 3, 2},
                                         Rig{"pulley", 8, 0.6, 0.03, 2, 2, 0.002},
                                         Rig{"low_blocks", 6, 0.8, 0.025, 0, 0, 0, 0.131},
                                         Rig{"loaded", 9, 0.9, 0.015, 4, 4, 0.001, 0.618, 164.5}),
                         [](const auto& c) { return c.param.name; });

// Locating the landing inside the step is worth more than the tolerance: a landing rounded to a
// step of 4 ms moves the velocity by up to a1 dt.
TEST(DropWeightEvent, LandingDoesNotDependOnTheGridOfSteps) {
  const Rig rig{"plain", 5, 0.7, 0.02};
  Scene scene;
  scene.items[0].model = pulled_trolley(rig, 3e8);
  Excitation excitation = rigged(rig);
  excitation.fixture = hold_rotations(false, true, false);
  const Exact e = exact(rig, scene.items[0].model);
  for (const double time_step : {0.004, 0.0041, 0.0043, 0.0047}) {
    const auto response =
        simulate(scene, excitation, run_for(kReleaseTime + e.stop + 1, time_step));
    EXPECT_NEAR(response.items[0].demands.residual_displacement_x, e.distance, 1e-4 * e.distance);
    EXPECT_NEAR(response.items[0].demands.peak_velocity, e.velocity, 1e-4 * e.velocity);
  }
}

// Releases at times whose multiples of the step round up: 175 x 0.004 s > 0.7 s in binary. The
// blocks must hold to the end of that step, so the motion since the release is always the same.
TEST(DropWeightEvent, BlocksHoldUntilTheirTime) {
  const Rig rig{"plain", 5, 0.7, 0.02};
  Scene scene;
  scene.items[0].model = pulled_trolley(rig, 3e8);
  std::vector<double> travelled;
  for (const double release : {0.696, 0.7, 0.704, 1.404}) {
    Excitation excitation = rigged(rig);
    excitation.fixture = hold_rotations(false, true, false);
    excitation.blocks[0].release_time = release;
    const auto response = simulate(scene, excitation, run_for(release + 1, 0.004));
    travelled.push_back(response.items[0].demands.residual_displacement_x);
  }
  for (double x : travelled) EXPECT_NEAR(x, travelled[0], 1e-6 * travelled[0]);
}

// In the floor's frame a steady upward acceleration of the floor is more gravity, for weights too.
TEST(DropWeightEvent, VerticalFloorAccelerationIsGravity) {
  const Rig rig{"plain", 5, 0.7, 0.02};
  Scene scene;
  scene.items[0].model = pulled_trolley(rig, 3e8);
  Excitation excitation = rigged(rig);
  excitation.blocks.clear();
  excitation.fixture = hold_rotations(false, true, false);
  Scene heavy = scene;
  heavy.gravity += 2;
  const double expected =
      simulate(heavy, excitation, run_for(1.5, 0.004)).items[0].demands.residual_displacement_x;
  excitation.floor = floor_motion(0.01, 3, Vector3::UnitZ(), [](double) { return 2.0; });
  const auto response = simulate(scene, excitation, run_for(1.5, 0.004));
  // The floor starts at once, so the treads sink and swing a little; their mean load is the same.
  EXPECT_NEAR(response.items[0].demands.residual_displacement_x, expected, 1e-3 * expected);
  EXPECT_LT(response.quality.energy_closure, 1e-4);
}

// An item that runs ahead of its weight lets the cable go slack. All wheels are locked, so it
// slides and brakes at mu g; the weight falls freely, at g' = (m_d g - F_w) / (m_d + p), and takes
// up the slack when both have gone as far: t = 2 v0 / (g' + mu g).
TEST(DropWeightEvent, CableGoesSlackWhenTheItemIsFaster) {
  for (const double pulley_inertia : {0.0, 0.01}) {
    SCOPED_TRACE(pulley_inertia);
    ItemOptions options;
    stiffen(options.caster.tread);
    options.caster.tread.static_friction = options.caster.tread.kinetic_friction = 0.3;
    Scene scene;
    scene.items[0].model = locked_block(options);
    const double v0 = 0.8, braking = 0.3 * kG;
    scene.items[0].initial.velocity.x() = v0;
    scene.items[0].initial.wheels_roll = false;
    Excitation excitation;
    excitation.fixture = hold_rotations();
    DropWeight weight;
    weight.point = {0, 0, 0.618};
    weight.mass = 5;
    weight.drop_height = 2;
    weight.pulley_inertia = pulley_inertia;
    excitation.drop_weights = {weight};
    const double fall = 5 * kG / (5 + pulley_inertia / (0.05 * 0.05));
    const double taut = 2 * v0 / (fall + braking);
    ASSERT_LT(taut, v0 / braking);  // before the item rests

    constexpr double kStep = 0.001;
    const auto response = simulate(scene, excitation, run_for(2, kStep, kStep));
    const double pull = 5 * kG;
    double first_taut = 0;
    for (const Sample& s : response.items[0].history) {
      if (s.cable_tension > 0 && first_taut == 0) first_taut = s.time;
      if (s.time > taut - kStep) continue;
      SCOPED_TRACE(s.time);
      EXPECT_EQ(s.cable_tension, 0);
      // The wind-up of the sliding treads takes mu M g / (n k_t) = 7e-8 m from the path.
      EXPECT_NEAR(s.displacement.x(), v0 * s.time - braking * s.time * s.time / 2, 1e-6);
      EXPECT_NEAR(s.energy.weight_energy, 0, 1e-9 * pull);  // free fall
    }
    EXPECT_NEAR(first_taut, taut, 2 * kStep);
    // Locked wheels hold the weight (m_d g < mu M g): all rests, the cable carries the weight.
    EXPECT_NEAR(response.items[0].history.back().cable_tension, pull, 1e-3 * pull);
    EXPECT_NEAR(response.items[0].history.back().velocity.x(), 0, 1e-6);
  }
}

}  // namespace
}  // namespace gurney
