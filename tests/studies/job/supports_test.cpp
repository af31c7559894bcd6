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
