#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "engine/base/units.h"
#include "equipment/catalogue/support.h"

namespace gurney::equipment {
namespace {

constexpr double kTrail = 0.034;

/// A chassis with its centre of mass at `center` on casters at `mounts`, whose own mass is nearly
/// nothing, so that the formulas need not count it.
EquipmentModel cart(const Vector3& center, const std::vector<Vector2>& mounts) {
  EquipmentModel item;
  item.name = "cart";
  item.chassis_mass = 100;
  item.chassis_center_of_mass = center;
  item.chassis_inertia = Matrix3::Identity();
  item.shape = {{center, {0.1, 0.1, 0.1}}};
  for (const Vector2& mount : mounts) {
    Caster caster;
    caster.mount = {mount.x(), mount.y(), caster.height};
    caster.trail = kTrail;
    caster.wheel_mass = caster.fork_mass = 1e-9;
    caster.wheel_axial_inertia = caster.wheel_transverse_inertia = 1e-12;
    item.casters.push_back(caster);
  }
  return item;
}

std::vector<Vector2> ring(int legs, double radius) {
  std::vector<Vector2> mounts;
  for (int i = 0; i < legs; ++i) {
    const double angle = 2 * std::numbers::pi * i / legs;
    mounts.push_back(radius * Vector2(std::cos(angle), std::sin(angle)));
  }
  return mounts;
}

const std::vector<Vector2> kRectangle = {{0.3, 0.2}, {0.3, -0.2}, {-0.3, 0.2}, {-0.3, -0.2}};

TEST(Stability, ARectangleLosesOneTrailOnItsShortSide) {
  const Stability s = stability_of(cart({0, 0, 0.5}, kRectangle));
  // Both casters of a long side turn inwards: b = 0.2 - trail. The light casters move the centre by
  // less than 1e-11 m.
  EXPECT_NEAR(s.base, 0.2 - kTrail, 1e-10);
  EXPECT_NEAR(s.tilt, std::atan((0.2 - kTrail) / 0.5), 1e-9);
  EXPECT_NEAR(std::abs(s.direction), std::numbers::pi / 2, 1e-9);
  // As placed, all trail to the rear: the side edges stay at 0.2.
  EXPECT_NEAR(s.tilt_as_placed, std::atan(0.2 / 0.5), 1e-9);
  EXPECT_TRUE(s.warnings.empty());
}

TEST(Stability, WarnsOfAMassAtTheBasePlateAsOfMetresInMillimetres) {
  const double plate = cart({0, 0, 1}, kRectangle).casters[0].mount.z();
  const auto warnings = [&](double above) {
    return stability_of(cart({0, 0, plate + above}, kRectangle)).warnings;
  };
  ASSERT_EQ(warnings(0.45e-3).size(), 1u);
  EXPECT_NE(warnings(0.45e-3)[0].find("0.45 mm above the underside of its base plate"),
            std::string::npos);
  EXPECT_TRUE(warnings(3e-3).empty());
}

TEST(Stability, RigidAndLockedForksDoNotTurn) {
  EquipmentModel item = cart({0, 0, 0.5}, kRectangle);
  item.casters[0].swivels = item.casters[1].swivels = false;
  item.casters[2].swivel_lock_torque = item.casters[3].swivel_lock_torque = 1;
  const Stability s = stability_of(item);
  EXPECT_NEAR(s.base, 0.2, 1e-10);
  EXPECT_NEAR(s.tilt, s.tilt_as_placed, 1e-12);
}

TEST(Stability, AgreesWithASearchOverDirectionsAndSwivelAngles) {
  // Unequal trails and a rigid fork on an uneven five-leg base. Normals every 0.1 degrees miss the
  // worst one by at most 0.05, where b changes by at most 0.35 m x sin(0.05 deg) = 3.1e-4 m; swivel
  // angles every degree miss the innermost contact by 0.08 m x (1 - cos(0.5 deg)) = 3e-6 m. The
  // search never comes out lower.
  EquipmentModel item = cart({0.03, -0.02, 0.8}, ring(5, 0.3));
  item.casters[1].trail = 0.08;
  item.casters[2].swivels = false;
  item.casters[2].heading = 1;
  item.casters[4].mount.x() = 0.2;
  const Vector2 center = whole_item(item).center_of_mass.head<2>();
  const double step = 0.1 * kRadiansPerDegree;
  double smallest = 1;
  for (double angle = 0; angle < 2 * std::numbers::pi; angle += step) {
    const Vector2 n(std::cos(angle), std::sin(angle));
    double reach = -1;
    for (const Caster& caster : item.casters) {
      double lowest = 1;
      for (double turn = 0; turn < 2 * std::numbers::pi; turn += 10 * step) {
        const double heading = caster.swivels ? turn : caster.heading;
        const Vector2 back(-std::cos(heading), -std::sin(heading));
        lowest = std::min(lowest, (caster.mount.head<2>() + caster.trail * back).dot(n));
      }
      reach = std::max(reach, lowest);
    }
    smallest = std::min(smallest, reach - center.dot(n));
  }
  const Stability s = stability_of(item);
  EXPECT_LE(s.base, smallest + 1e-12);
  EXPECT_NEAR(s.base, smallest, 3.2e-4);
}

TEST(Stability, WarnsBelowTenDegrees) {
  // Tilt atan(0.166 / h): 10 degrees at h = 0.166 / tan 10 deg = 0.941 m.
  EXPECT_TRUE(stability_of(cart({0, 0, 0.93}, kRectangle)).warnings.empty());
  const auto warnings = stability_of(cart({0, 0, 1.2}, kRectangle)).warnings;
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].substr(0, warnings[0].find(" towards")),
            "cart: with the casters turned the worst way a tilt of 7.9 degrees");
}

TEST(Stability, WarnsWhenTheItemCanFallByItself) {
  const auto warnings = stability_of(cart({0.28, 0, 0.5}, kRectangle)).warnings;
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(
      warnings[0],
      "cart: the centre of mass can leave the support of the wheels: with the casters turned "
      "the worst way it is 14 mm outside, towards 0 degrees; the item is statically unstable");
}

TEST(Stability, AFiveLegBaseBeyondItsChassisIsNoFault) {
  const Stability s = stability_of(cart({0, 0, 0.6}, ring(5, 0.32)));
  EXPECT_TRUE(s.warnings.empty());
  // The edge of a regular pentagon is radius cos 36 deg away.
  EXPECT_NEAR(s.base, 0.32 * std::cos(36 * kRadiansPerDegree) - kTrail, 1e-10);
}

TEST(Stability, ThreeWheelsShareTheWeightByStatics) {
  EquipmentModel item = cart({0.05, 0.02, 0.5}, {{0.3, 0.25}, {0.3, -0.25}, {-0.3, 0}});
  for (Caster& caster : item.casters) caster.trail = 0;
  item.casters[1].tread.normal_stiffness = 1e5;  // statically determinate: makes no difference
  const std::vector<double> loads = stability_of(item).wheel_loads;
  const double weight = 100 * kStandardGravity;
  // Moments about y: rear = W (0.3 - 0.05) / 0.6; about x: left - right = W 0.02 / 0.25.
  const double rear = weight * 0.25 / 0.6, front = weight - rear, difference = weight * 0.02 / 0.25;
  EXPECT_NEAR(loads[2], rear, 1e-6);
  EXPECT_NEAR(loads[0], (front + difference) / 2, 1e-6);
  EXPECT_NEAR(loads[1], (front - difference) / 2, 1e-6);
}

TEST(Stability, FourEqualWheelsShareTheWeightByStiffness) {
  EquipmentModel item = cart({0.06, 0.05, 0.5}, kRectangle);
  for (Caster& caster : item.casters) caster.trail = 0;
  const std::vector<double> loads = stability_of(item).wheel_loads;
  const double weight = 100 * kStandardGravity;
  // N = W/4 (1 + x e_x / 0.09 + y e_y / 0.04): a rigid plate on four equal springs.
  for (int i = 0; i < 4; ++i)
    EXPECT_NEAR(
        loads[i],
        weight / 4 * (1 + kRectangle[i].x() * 0.06 / 0.09 + kRectangle[i].y() * 0.05 / 0.04), 1e-6);
}

TEST(Stability, WheelsDoNotPull) {
  // The centre of mass beyond the middle third of a long base of five: one wheel lifts.
  EquipmentModel item = cart({0.25, 0.16, 0.5}, kRectangle);
  for (Caster& caster : item.casters) caster.trail = 0;
  const std::vector<double> loads = stability_of(item).wheel_loads;
  for (const double load : loads) EXPECT_GE(load, 0);
  EXPECT_EQ(loads[3], 0);
  EXPECT_NEAR(std::accumulate(loads.begin(), loads.end(), 0.0), 100 * kStandardGravity, 1e-6);
}

TEST(Stability, ASingleWheelCarriesAll) {
  EquipmentModel item = cart({0, 0, 0.5}, {{0, 0}});
  item.casters[0].trail = 0;
  EXPECT_NEAR(stability_of(item).wheel_loads.at(0), 100 * kStandardGravity, 1e-6);
}

}  // namespace
}  // namespace gurney::equipment
