#include "equipment/item_sheet.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "engine/base/units.h"
#include "equipment/implausible.h"

namespace gurney {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

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
  EXPECT_NEAR(sheet.rolling_resistance, 1e-3 / 0.05 * weight, weight * kLight);
  EXPECT_NEAR(sheet.rolling_share, 0.02, kLight);
  EXPECT_NEAR(sheet.sliding_share, 0.6, kLight);
  EXPECT_NEAR(sheet.tipping_share, 0.2 / 0.5, kLight);
  EXPECT_EQ(sheet.support_polygon.size(), 4u);
  for (int k = 0; k < 2; ++k) EXPECT_LE(sheet.principal_inertia[k], sheet.principal_inertia[k + 1]);
}

TEST(Implausible, FindsWhatIsHardlyMeant) {
  EXPECT_THAT(implausible(cart()), IsEmpty());
  EquipmentModel heavy = cart();
  heavy.chassis_mass = 800;
  EXPECT_THAT(implausible(heavy), ElementsAre(HasSubstr("are 4167 kg/m3; 20 to 3000 is usual")));
  EquipmentModel outside = cart();
  outside.chassis_center_of_mass.x() = 0.31;
  EXPECT_THAT(implausible(outside), ElementsAre(HasSubstr("lies outside the shapes")));
  EquipmentModel swivel = cart();
  swivel.casters[1].swivels = true;
  swivel.casters[1].name = "right";
  EXPECT_THAT(implausible(swivel), ElementsAre(HasSubstr("'right' swivels but has no trail")));

  CasterType caster;
  caster.name = "odd";
  caster.properties.wheel_axial_inertia = 1;
  caster.properties.tread.patch_width = 0.1;
  EXPECT_THAT(implausible(caster), ElementsAre(HasSubstr("wider than the wheel"),
                                               HasSubstr("larger than that of a hoop")));
}

}  // namespace
}  // namespace gurney
