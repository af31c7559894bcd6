#include "engine/solver/mechanical_energy.h"

#include <gtest/gtest.h>

#include <cmath>

#include "studies/verification/scenes/small_scenes.h"

namespace gurney {
namespace {

constexpr double kNormal = 3e5, kTangential = 1e5;

/// On n casters, one of every place of the lanes and of a second group.
struct Item {
  Scene scene;
  Mechanism mechanism;
  State state;

  explicit Item(std::size_t casters)
      : scene(scene_of(small::item_on(mounts(casters), std::vector<double>(casters, 20),
                                      small::bare_tread(kNormal, kTangential)))),
        mechanism(scene, 0),
        state(mechanism.placed({})) {}
  static std::vector<Vector2> mounts(std::size_t casters) {
    std::vector<Vector2> mounts;
    for (std::size_t i = 0; i < casters; ++i)
      mounts.emplace_back(0.2 * static_cast<double>(i) - 0.4, i % 2 == 0 ? 0.2 : -0.2);
    return mounts;
  }
  MechanicalEnergy energy() const { return MechanicalEnergies(mechanism).at(state); }
};

TEST(MechanicalEnergy, IsThatOfTheWholeMassAndOfTheWheelsThatSpin) {
  for (const std::size_t casters : {3, 4, 5, 8}) {
    Item item(casters);
    const double mass = item.mechanism.total_mass;
    const double at_rest = item.energy().gravitational;
    EXPECT_EQ(item.energy().kinetic, 0);
    item.state.position.z() += 0.3;
    EXPECT_NEAR(item.energy().gravitational - at_rest, 0.3 * mass * item.scene.gravity, 1e-9);
    item.state.velocity.chassis.head<3>() = Vector3(1, -2, 0.5);
    EXPECT_NEAR(item.energy().kinetic, 0.5 * mass * 5.25, 1e-10);
    for (std::size_t i = 0; i < casters; ++i)
      item.state.velocity.joints[i][1] = 10 + static_cast<double>(i);
    double spin = 0;
    for (std::size_t i = 0; i < casters; ++i)
      spin += 0.5 * item.mechanism.casters[i].constants().axial_inertia *
              std::pow(10 + static_cast<double>(i), 2);
    EXPECT_NEAR(item.energy().kinetic, 0.5 * mass * 5.25 + spin, 1e-10);
  }
}

TEST(MechanicalEnergy, IsStoredInTreadsAndStuckBearings) {
  for (const std::size_t casters : {3, 4, 5, 8}) {
    Item item(casters);
    EXPECT_NEAR(item.energy().elastic, 0, 1e-20);  // of treads that touch
    item.state.position.z() -= 1e-3;
    double expected = static_cast<double>(casters) * 0.5 * kNormal * 1e-6;
    EXPECT_NEAR(item.energy().elastic, expected, 1e-9 * expected);
    for (std::size_t i = 0; i < casters; ++i) {
      CasterState& s = item.state.casters[i];
      const CasterDynamics& caster = item.mechanism.casters[i];
      s.tread.deflection = {1e-3, 2e-3, -2e-3};
      s.tread.roll_deflection = 1e-4 * static_cast<double>(i);
      s.swivel_wind = 2e-4;
      s.axle_wind = 3e-4;
      expected +=
          0.5 * kTangential * 9e-6 +
          0.5 * caster.tread().constants().roll.stiffness * std::pow(s.tread.roll_deflection, 2) +
          0.5 * caster.swivel_friction().stiffness * 4e-8 +
          0.5 * caster.axle_friction().stiffness * 9e-8;
    }
    EXPECT_NEAR(item.energy().elastic, expected, 1e-9 * expected);
    item.state.position.z() += 1;
    const double lifted = expected - static_cast<double>(casters) * 0.5 * kNormal * 1e-6;
    EXPECT_NEAR(item.energy().elastic, lifted, 1e-9 * expected);
  }
}

}  // namespace
}  // namespace gurney
