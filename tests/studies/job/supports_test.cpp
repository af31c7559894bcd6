#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/studies/job/job_text.h"

namespace gurney::study {
namespace {

using testing::HasSubstr;

const std::string kCart =
    "schema = \"gurney-job/1\"\n[[item]]\nname = \"cart\"\nequipment = \"crash_cart\"\n"
    "position_m = [1, 2]\nyaw_deg = 90\n";
const std::string kMonitor = "[[item]]\nname = \"monitor\"\nequipment = \"portable_monitor\"\n";

TEST(Supports, PlaceAnItemInTheAxesOfWhatItStandsOn) {
  const Job job =
      job_of_text(kCart + kMonitor + "on = \"cart\"\nposition_m = [0.1, 0]\nyaw_deg = 30\n");
  const PlacedItem& monitor = job.scene.items[1];
  ASSERT_TRUE(monitor.on);
  EXPECT_EQ(monitor.on->kind, Support::Kind::kItem);
  EXPECT_EQ(monitor.on->index, 0U);
  double top = 0;
  for (const BodyShape& box : job.scene.items[0].model.shape)
    top = std::max(top, box.center.z() + box.size.z() / 2);
  EXPECT_DOUBLE_EQ(monitor.on->height, top);
  EXPECT_NEAR(monitor.initial.position.x(), 1, 1e-12);
  EXPECT_NEAR(monitor.initial.position.y(), 2.1, 1e-12);
  EXPECT_NEAR(monitor.initial.yaw, 120 * 3.14159265358979 / 180, 1e-12);
  EXPECT_NO_THROW(validate(job.scene));
}

TEST(Supports, PutAnItemOnFurnitureAndAnotherOnThat) {
  const Job job = job_of_text(
      "schema = \"gurney-job/1\"\n[[room.box]]\nname = \"table\"\nsize_m = [1, 1, 0.7]\n"
      "center_m = [3, 0, 0.35]\nmaterial = \"wood\"\n" +
      kMonitor + "on = \"table\"\nposition_m = [3.2, 0]\n" +
      "[[item]]\nname = \"pump\"\nequipment = \"infusion_pump\"\non = \"monitor\"\n");
  const PlacedItem &monitor = job.scene.items[0], &pump = job.scene.items[1];
  ASSERT_TRUE(monitor.on && pump.on);
  EXPECT_EQ(monitor.on->kind, Support::Kind::kShape);
  EXPECT_NEAR(monitor.on->height, 0.7, 1e-12);
  EXPECT_NEAR(pump.on->height, 0.7 + 0.26, 1e-12);
  EXPECT_NEAR(pump.initial.position.x(), 3.2, 1e-12);
}

/// A block of 10 kg, 0.4 m wide, whose centre of mass is at (x, 0, 0.4) m.
std::string block(double x) {
  const auto scalar = [](const std::string& key, double value) {
    return fmt::format("{} = {{ value = {}, assumption = \"of a test\", range = [{}, {}] }}\n", key,
                       value, 0.9 * value, 1.1 * value);
  };
  const auto vector = [](const std::string& key, double of_x, double of_y, double of_z) {
    return fmt::format(
        "{} = {{ value = [{}, {}, {}], assumption = \"of a test\", low = [{}, {}, {}], high = [{}, "
        "{}, {}] }}\n",
        key, of_x, of_y, of_z, of_x - 1, of_y - 1, of_z - 1, of_x + 1, of_y + 1, of_z + 1);
  };
  return "schema = \"gurney-job/1\"\n[[item]]\nname = \"block\"\nyaw_deg = 90\n[item.inline]\nname "
         "= "
         "\"block\"\n[item.inline.chassis]\n" +
         scalar("mass_kg", 10) + vector("center_of_mass_mm", x, 0, 400) +
         vector("inertia_box_mm", 400, 400, 800) + "[[item.inline.shape]]\n" +
         vector("size_mm", 400, 400, 800) +
         "center_mm = [0, 0, 400]\n[item.inline.contact]\nmaterial = \"board\"\n" +
         scalar("friction", 0.5) + scalar("restitution", 0.2);
}

TEST(Supports, HoldTheCentreOfMassOfWhatStands) {
  EXPECT_NO_THROW(job_of_text(block(199.9)));
  EXPECT_THAT(
      errors_of_text(block(230)),
      HasSubstr("'block' does not stand on its feet: its centre of mass is 30 mm outside of "
                "their support, towards 0 degrees from its front; must be inside"));
  EXPECT_THAT(errors_of_text(block(-230)), HasSubstr("towards 180 degrees"));
  EXPECT_NO_THROW(job_of_text(block(230) + "[floor]\ngravity_m_per_s2 = 0\n"));
  EXPECT_NO_THROW(job_of_text(block(230) + "[item.fixture]\npitch = \"held\"\n"));
}

TEST(Supports, RefuseWhatCannotBeStoodOn) {
  EXPECT_THAT(
      errors_of_text(kCart + kMonitor + "on = \"cat\"\n"),
      HasSubstr("a.toml:10:6: item[1].on = \"cat\": no item before this one and no shape of the "
                "room is called so; did you mean 'cart'?"));
  EXPECT_THAT(errors_of_text(kCart + kMonitor + "on = \"monitor\"\n"),
              HasSubstr("item[1].on = \"monitor\": is the item itself"));
  EXPECT_THAT(errors_of_text(kCart + kMonitor + "on = \"cart\"\nposition_m = [2, 0]\n"),
              HasSubstr("nothing of it lies below position_m = [2, 0]"));
  EXPECT_THAT(
      errors_of_text(kCart + "[[item]]\nname = \"bed\"\nequipment = \"icu_bed\"\non = \"cart\"\n"),
      HasSubstr("only an item without casters stands on something"));
}

}  // namespace
}  // namespace gurney::study
