#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/base/units.h"
#include "engine/run/simulate.h"
#include "equipment/catalogue/catalogue.h"
#include "equipment/catalogue/item_sheet.h"
#include "tests/support/standing.h"

// Items of the catalogue without casters, from their files to their motion.
namespace gurney::equipment {
namespace {

using std::numbers::pi;
constexpr double kG = kStandardGravity;

LoadedItem item(const std::string& name) { return load_item(find_data(DataKind::kItem, name, "")); }

TEST(Feet, SheetOfAnItemWithoutCasters) {
  const LoadedItem shelving = item("storage_shelving");
  const ItemSheet sheet = item_sheet(shelving.model, floor_contact(shelving));
  // Four feet at the corners of 457 mm by 1219 mm.
  EXPECT_EQ(sheet.support_polygon.size(), 4u);
  for (const Vector2& corner : sheet.support_polygon) {
    EXPECT_NEAR(std::abs(corner.x()), 0.2285, 1e-9);
    EXPECT_NEAR(std::abs(corner.y()), 0.6095, 1e-9);
  }
  const double height = sheet.whole.center_of_mass.z();
  EXPECT_NEAR(sheet.tilts[0].as_placed, std::atan(0.2285 / height), 1e-9);  // forward
  EXPECT_NEAR(sheet.tilts[6].worst, std::atan(0.6095 / height), 1e-9);      // left
  EXPECT_NEAR(sheet.tipping_share, 0.2285 / height, 1e-9);
  EXPECT_NEAR(sheet.size.z(), 1.829, 1e-9);
  EXPECT_TRUE(sheet.wheels.empty());
  EXPECT_DOUBLE_EQ(sheet.sliding_share, 0.4);
  EXPECT_DOUBLE_EQ(sheet.holding_share, 0.4);
  EXPECT_EQ(sheet.rolling_resistance_force, 0);
}

/// One half-sine of acceleration along `direction`, as a share of gravity.
FloorMotion half_sine(double share, double duration, const Vector3& direction) {
  constexpr double kStep = 1e-3;
  const int samples = static_cast<int>(duration / kStep) + 1;
  Eigen::Matrix3Xd acceleration(3, samples);
  for (int i = 0; i < samples; ++i)
    acceleration.col(i) = share * kG * std::sin(pi * i * kStep / duration) * direction;
  return FloorMotion(kStep, acceleration);
}

/// Shaken towards its narrow side on corners so stiff (1e8 N/m) that the rigid block's b / h holds:
/// under the weight of some 150 kg they yield 4e-6 m, so an item that does not lift off tilts by
/// less than 2e-5 m over the smallest base of 0.28 m.
Response shaken(const std::string& name, double share_of_uplift) {
  const LoadedItem loaded = item(name);
  Scene scene = standing(loaded);
  scene.pairs[0].constants.stiffness = 1e8;
  scene.pairs[0].constants.friction = 1;  // b / h of the filing cabinet is near its friction
  const ItemSheet sheet = item_sheet(loaded.model);
  const double direction = sheet.stability.direction;
  SimulationSettings settings;
  settings.duration = 1.5;
  settings.time_step = 1e-3;
  return simulate(scene,
                  half_sine(share_of_uplift * sheet.tipping_share, 0.4,
                            {std::cos(direction), std::sin(direction), 0}),
                  settings);
}

class StandsOnFeet : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Catalogue, StandsOnFeet,
                         testing::Values("bookcase", "filing_cabinet", "storage_shelving"),
                         [](const auto& test) { return test.param; });

constexpr double kYields = 1e-4;  // [rad] of tilt without lift-off, with a margin

// Uplift of a rigid block at a = g b / h (Housner 1963), also where the item is no block.
TEST_P(StandsOnFeet, RestsJustBelowUplift) {
  const Response response = shaken(GetParam(), 0.95);
  ASSERT_EQ(response.outcome, Outcome::kStopped) << response.cause;
  EXPECT_LT(response.items[0].demands.peak_tilt, kYields);
  EXPECT_LT(response.items[0].demands.peak_displacement, 1e-4);
}

// At 1.2 times that, it is above uplift for 0.15 s, with a mean excess of 0.13 b / h. With
// p^2 = M g R / I_O of about 3 g / (4 R) = 7 / s^2 it turns by 0.13 (b / h) p^2 t^2 / 2 = 1e-2 b /
// h in that time alone, at least 1e-3 for b / h of 0.14; and it falls only from b / h on.
TEST_P(StandsOnFeet, RocksJustAboveUplift) {
  const Response response = shaken(GetParam(), 1.2);
  ASSERT_EQ(response.outcome, Outcome::kStopped) << response.cause;
  const double slenderness = item_sheet(item(GetParam()).model).tipping_share;
  EXPECT_GT(response.items[0].demands.peak_tilt, 1e-3);
  EXPECT_LT(response.items[0].demands.peak_tilt, slenderness);
}

// Pushed with 0.5 m/s along its longer side, a cabinet slides v^2 / (2 mu g); its corners lift by
// the friction but it does not fall. The covering's factor on the friction shortens the way.
TEST(Feet, ACoveringShortensTheWayThatAnItemSlides) {
  const auto way = [](double factor) {
    ItemOptions options;
    options.floor = FloorCovering{"test", 1, factor, {}};
    Scene scene = standing(load_item(find_data(DataKind::kItem, "filing_cabinet", ""), options));
    scene.items[0].initial.velocity = {0.5, 0, 0};
    SimulationSettings settings;
    settings.duration = 1;
    settings.time_step = 1e-3;
    return simulate(scene, {}, settings).items[0].demands.peak_displacement;
  };
  // Friction spread over 1e-3 m of elastic deflection and 4 % of rocking.
  for (const double factor : {0.7, 1.0})
    EXPECT_NEAR(way(factor), 0.25 / (2 * 0.35 * factor * kG),
                0.05 * 0.25 / (2 * 0.35 * factor * kG))
        << factor;
}

TEST(Feet, StandsOnTheFloorOfItsCoveringWithAllItsPairs) {
  ItemOptions options;
  options.floor = load_floor_covering(find_data(DataKind::kFloor, "rubber", "")).stated();
  const Scene scene = standing(load_item(find_data(DataKind::kItem, "bookcase", ""), options));
  EXPECT_NO_THROW(validate(scene));
  EXPECT_DOUBLE_EQ(contact_constants(scene, "coated board", scene.floor_material).friction, 0.36);
  EXPECT_DOUBLE_EQ(contact_constants(scene, "coated board", "").friction, 0.3);
}

}  // namespace
}  // namespace gurney::equipment
