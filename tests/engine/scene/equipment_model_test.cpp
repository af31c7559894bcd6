#include "engine/scene/equipment_model.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/error_text.h"

namespace gurney {
namespace {

/// A plain cart on one caster that `validate` accepts.
EquipmentModel cart() {
  EquipmentModel item;
  item.name = "cart";
  item.chassis_mass = 50;
  item.chassis_center_of_mass = {0, 0, 0.5};
  item.chassis_inertia = solid_box_inertia(50, {0.6, 0.5, 0.8});
  item.shape = {{{0, 0, 0.5}, {0.6, 0.5, 0.8}}};
  Caster caster;
  caster.name = "c";
  caster.mount = {0.2, 0.1, 0.131};
  caster.wheel_axial_inertia = 3e-4;
  caster.wheel_transverse_inertia = 1.7e-4;
  caster.fork_inertia = solid_box_inertia(0.25, {0.08, 0.05, 0.09});
  item.casters = {caster};
  return item;
}

std::string problems(const EquipmentModel& item) {
  return error_text([&] { validate(item); });
}

TEST(MassProperties, TwoHalvesMakeTheWholeBox) {
  // A box 0.6 x 0.4 x 1.0 of 30 kg cut in two by a plane across x.
  MassProperties sum;
  sum.add(15, {1.15, 2, 3}, solid_box_inertia(15, {0.3, 0.4, 1.0}));
  sum.add(15, {0.85, 2, 3}, solid_box_inertia(15, {0.3, 0.4, 1.0}));
  const Matrix3 whole = solid_box_inertia(30, {0.6, 0.4, 1.0});
  // Rounding: sums of numbers up to 30 * 3^2 in double precision.
  EXPECT_NEAR(sum.mass, 30, 1e-14);
  EXPECT_NEAR((sum.center_of_mass - Vector3(1, 2, 3)).norm(), 0, 1e-14);
  EXPECT_NEAR((sum.inertia - whole).norm(), 0, 1e-13);
}

TEST(MassProperties, BoxInertiaIsThatOfTheTextbook) {
  const Matrix3 inertia = solid_box_inertia(12, {1, 2, 3});
  EXPECT_EQ(inertia, Matrix3(Vector3(4 + 9, 1 + 9, 1 + 4).asDiagonal()));
}

TEST(MassProperties, PayloadsAndTurnedCastersCount) {
  EquipmentModel item = cart();
  item.payloads = {{"load", 50, {0.2, 0, 0.9}, Matrix3::Zero()}};
  const MassProperties loaded = chassis_with_payloads(item);
  EXPECT_DOUBLE_EQ(loaded.mass, 100);
  EXPECT_NEAR((loaded.center_of_mass - Vector3(0.1, 0, 0.7)).norm(), 0, 1e-15);

  item.payloads.clear();
  item.casters[0].heading = std::numbers::pi / 2;  // trails towards -y
  const MassProperties whole = whole_item(item);
  EXPECT_DOUBLE_EQ(whole.mass, 50.5);
  // y: fork of 0.25 kg at the mount, wheel of 0.25 kg one trail behind it.
  EXPECT_NEAR(whole.center_of_mass.y(), (0.25 * 0.1 + 0.25 * (0.1 - 0.034)) / 50.5, 1e-15);
  EXPECT_NEAR(whole.center_of_mass.z(), (50 * 0.5 + 0.25 * 0.131 + 0.25 * 0.05) / 50.5, 1e-15);
}

TEST(MassProperties, InertiaOfATurnedWheelTurnsWithIt) {
  EquipmentModel item = cart();
  const auto axial_share = [&](double heading) {
    item.casters[0].heading = heading;
    item.casters[0].trail = 0;
    item.casters[0].fork_inertia.setZero();
    return whole_item(item).inertia;
  };
  // The axle lies along y at heading 0 and along x at 90 degrees: the difference moves over.
  const double difference = 3e-4 - 1.7e-4;
  const Matrix3 change = axial_share(std::numbers::pi / 2) - axial_share(0);
  EXPECT_NEAR(change(0, 0), difference, 1e-13);
  EXPECT_NEAR(change(1, 1), -difference, 1e-13);
  EXPECT_NEAR(change(2, 2), 0, 1e-13);
}

TEST(ValidateEquipment, AcceptsACart) { EXPECT_EQ(problems(cart()), "(no error)"); }

TEST(ValidateEquipment, NamesEveryConstantOutsideItsRange) {
  EquipmentModel item = cart();
  item.chassis_mass = -50;
  item.shape[0].size.x() = 0;
  item.payloads = {{"load", std::nan(""), {0, 0, 1}, Matrix3::Zero()}};
  item.casters[0].wheel_radius = 0;
  item.casters[0].tread.kinetic_friction = 0.9;
  item.marked_points = {{"top", {0, 0, INFINITY}}};
  EXPECT_EQ(problems(item),
            "item 'cart': chassis_mass = -50: must be > 0 and finite\n"
            "item 'cart': shape[0].size = (0, 0.5, 0.8): each must be > 0 and finite\n"
            "item 'cart': payload 'load': mass = nan: must be > 0 and finite\n"
            "item 'cart': caster 'c': wheel_radius = 0: must be > 0 and finite\n"
            "item 'cart': caster 'c': tread.static_friction = 0.6: must be >= "
            "tread.kinetic_friction and finite\n"
            "item 'cart': marked point 'top': position = (0, 0, inf): must be finite");
}

TEST(ValidateEquipment, RefusesInertiasNoBodyHas) {
  EquipmentModel item = cart();
  item.chassis_inertia = Vector3(1, 1, 3).asDiagonal();
  EXPECT_EQ(problems(item),
            "item 'cart': chassis_inertia with principal moments 1, 1, 3 kg m2: the largest must "
            "not exceed the sum of the others");
  item.chassis_inertia = Vector3(-1, 1, 1).asDiagonal();
  EXPECT_EQ(problems(item),
            "item 'cart': chassis_inertia with principal moments -1, 1, 1 kg m2: each must be > 0");
  item.chassis_inertia = Matrix3::Identity();
  item.chassis_inertia(0, 1) = 0.5;
  EXPECT_EQ(problems(item), "item 'cart': chassis_inertia: must be symmetric");
  item = cart();
  item.casters[0].wheel_axial_inertia = 4e-4;
  EXPECT_EQ(problems(item),
            "item 'cart': caster 'c': wheel_axial_inertia = 0.0004: must be <= 2 "
            "wheel_transverse_inertia");
}

TEST(ValidateEquipment, CountsCastersAndAllowsInfiniteBrakes) {
  EquipmentModel item = cart();
  item.casters.resize(9, item.casters[0]);
  EXPECT_EQ(problems(item), "item 'cart': 9 casters: must be 0 to 8");
  item = cart();
  item.casters[0].brake_torque = INFINITY;
  EXPECT_EQ(problems(item), "(no error)");
  item.casters[0].mount.z() = 0.2;
  EXPECT_EQ(problems(item),
            "item 'cart': caster 'c': mount.z = 0.2: must be the height of the caster");
}

}  // namespace
}  // namespace gurney
