#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "engine/base/units.h"
#include "engine/run/simulate.h"
#include "studies/verification/scenes/small_scenes.h"
#include "tests/support/error_text.h"

// The stiffness solution of wheel loads is in studies/verification/cases/standing.cpp.
namespace gurney {
namespace {

constexpr double kGravity = kStandardGravity;

const std::vector<Vector2> kFour = {{0.4, 0.2}, {0.4, -0.2}, {-0.4, 0.2}, {-0.4, -0.2}};

EquipmentModel item_of(const std::vector<Vector2>& mounts, const std::vector<double>& headings,
                       double payload, const Vector3& center) {
  EquipmentModel item = small::item_on(mounts, headings, small::bare_tread(3e5, 1e8));
  item.payloads = {{"payload", payload, center, solid_box_inertia(payload, {0.2, 0.2, 0.2})}};
  for (std::size_t i = 0; i < item.casters.size(); ++i)
    item.casters[i].tread.normal_stiffness *= 1 + 0.2 * static_cast<double>(i);
  return item;
}

TEST(StaticLoads, AnItemWhoseCentreOfMassLiesOutsideItsSupportIsRefused) {
  const std::string refusal =
      "the item does not stand on its casters: its centre of mass lies outside their support";
  Scene scene = scene_of(item_of(kFour, {0, 0, 0, 0}, 200, {0.7, 0, 0.5}));
  EXPECT_EQ(error_text([&] { simulate(scene, {}, {}); }), refusal);
  scene.items[0].model = item_of({{0.4, 0}, {-0.4, 0}}, {0, 0}, 1, {0, 0.01, 0.5});
  EXPECT_EQ(error_text([&] { simulate(scene, {}, {}); }), refusal);
}

TEST(StaticLoads, ARunStartsAtRest) {
  // Nothing drops, swings or creeps: braked rigid casters keep their forces and stand still.
  Scene scene = scene_of(item_of(kFour, {10, 100, 200, 300}, 30, {0.2, 0.1, 0.8}));
  for (Caster& c : scene.items[0].model.casters) {
    c.swivels = false;
    c.brake_torque = INFINITY;
  }
  const Response response = simulate(scene, {}, small::settings_for(0.004, 2, 10));
  for (const Sample& sample : response.items[0].history) {
    // The tilt of 1e-3 rad shifts the treads sideways once they hold: 1e-6 of the weight.
    for (std::size_t i = 0; i < 4; ++i)
      EXPECT_NEAR(sample.wheels[i].normal_force,
                  response.items[0].history[0].wheels[i].normal_force, 1e-3);
    EXPECT_LT(sample.displacement.norm(), 1e-8);
  }
}

TEST(StaticLoads, ThreeCastersFollowFromStaticsAlone) {
  // Stiff treads: no tilt, and the lever rule holds.
  Scene scene = scene_of(small::item_on({{0.4, 0}, {-0.2, 0.3}, {-0.2, -0.3}}, {0, 0, 0},
                                        small::bare_tread(1e10, 1e5)));
  const MassProperties whole = whole_item(scene.items[0].model);
  const Response response = simulate(scene, {}, small::settings_for(0.004, 0.004));
  const double trail = scene.items[0].model.casters[0].trail;
  const double front = whole.mass * kGravity * (whole.center_of_mass.x() + 0.2 + trail) / 0.6;
  // Tilt N / k / 0.6 m of about 1e-7 rad.
  EXPECT_NEAR(response.items[0].history[0].wheels[0].normal_force, front, 1e-6 * front);
  EXPECT_NEAR(response.items[0].history[0].wheels[1].normal_force,
              0.5 * (whole.mass * kGravity - front), 1e-6 * front);
}

}  // namespace
}  // namespace gurney
