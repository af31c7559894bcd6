#include "equipment/catalogue/item_sheet.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/base/units.h"

namespace gurney::equipment {
namespace {

/// A box of 80 kg on four rigid wheels of nearly no mass at (+-0.3, +-0.2), its centre of mass at
/// (0.1, 0, 0.5).
EquipmentModel cart() {
  EquipmentModel item;
  item.name = "cart";
  item.chassis_mass = 80;
  item.chassis_center_of_mass = {0.1, 0, 0.5};
  item.chassis_inertia = solid_box_inertia(80, {0.6, 0.4, 0.8});
  item.shape = {{{0, 0, 0.6}, {0.6, 0.4, 0.8}}};
  for (const Vector2& at : {Vector2(0.3, 0.2), {0.3, -0.2}, {-0.3, 0.2}, {-0.3, -0.2}}) {
    Caster caster;
    caster.mount = {at.x(), at.y(), caster.height};
    caster.swivels = false;
    caster.trail = 0;
    caster.wheel_mass = caster.fork_mass = 1e-9;
    caster.wheel_axial_inertia = caster.wheel_transverse_inertia = 1e-12;
    item.casters.push_back(caster);
  }
  return item;
}

// The light casters have 1e-10 of the mass.
constexpr double kLight = 1e-8;

TEST(ItemSheet, FollowsFromTheConstants) {
  const ItemSheet sheet = item_sheet(cart());
  EXPECT_NEAR(sheet.whole.mass, 80, 80 * kLight);
  EXPECT_NEAR(sheet.size.z(), 1.0, 1e-12);
  EXPECT_NEAR(sheet.tilts[0].as_placed, std::atan(0.2 / 0.5), kLight);   // forward
  EXPECT_NEAR(sheet.tilts[6].as_placed, std::atan(0.2 / 0.5), kLight);   // left
  EXPECT_NEAR(sheet.tilts[12].as_placed, std::atan(0.4 / 0.5), kLight);  // back
  EXPECT_NEAR(sheet.tilts[12].direction, std::numbers::pi, 1e-12);
  EXPECT_EQ(sheet.tilts[12].worst, sheet.tilts[12].as_placed);  // nothing swivels
  // Two thirds of the weight on the front wheels: (0.3 + 0.1) / 0.6.
  const double weight = 80 * kStandardGravity;
  EXPECT_NEAR(sheet.wheels[0].load, weight / 3, weight * kLight);
  EXPECT_NEAR(sheet.wheels[2].load, weight / 6, weight * kLight);
  EXPECT_NEAR(sheet.wheels[0].sink, weight / 3 / 3e5, 1e-9);
  // Equal wheels: Cr / R of the weight; mu_s of it.
  EXPECT_NEAR(sheet.rolling_resistance_force, 1e-3 / 0.05 * weight, weight * kLight);
  EXPECT_NEAR(sheet.rolling_resistance_coefficient, 0.02, kLight);
  EXPECT_NEAR(sheet.sliding_share, 0.6, kLight);
  EXPECT_NEAR(sheet.tipping_share, 0.2 / 0.5, kLight);
  EXPECT_EQ(sheet.support_polygon.size(), 4u);
  for (int k = 0; k < 2; ++k) EXPECT_LE(sheet.principal_inertia[k], sheet.principal_inertia[k + 1]);
}

TEST(ItemSheet, BrakesHoldUpToTheirTorque) {
  EquipmentModel item = cart();
  const double weight = 80 * kStandardGravity;
  // No brake is on: only the rolling resistance holds.
  EXPECT_NEAR(item_sheet(item).holding_share, 0.02, kLight);
  // Brakes that are stronger than the grip: the wheels slide at mu_s of the weight.
  for (Caster& caster : item.casters) caster.brake_torque = 100;
  EXPECT_NEAR(item_sheet(item).holding_share, 0.6, kLight);
  // Weak ones of 2 N m give way at T / R + Cr N / R: 4 x 40 N + 0.02 W.
  for (Caster& caster : item.casters) caster.brake_torque = 2;
  EXPECT_NEAR(item_sheet(item).holding_share, 160 / weight + 0.02, kLight);
}

}  // namespace
}  // namespace gurney::equipment
