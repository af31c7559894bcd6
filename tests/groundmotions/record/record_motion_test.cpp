#include "groundmotions/record/record_motion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "engine/base/units.h"
#include "tests/support/error_text.h"

namespace gurney::groundmotions {
namespace {

Record three_components() {
  Record record;
  record.name = "r";
  for (const Direction direction : kDirections) {
    Component component;
    component.time_step = 0.1;
    component.acceleration = Eigen::Vector2d(1, -1) * std::pow(10, static_cast<int>(direction));
    record.components[static_cast<std::size_t>(direction)] = component;
  }
  return record;
}

TEST(RecordMotion, TakesTheComponentsAsXYZ) {
  const FloorMotion floor = floor_motion(three_components(), 2);
  EXPECT_EQ(floor.time_step(), 0.1);
  EXPECT_EQ(floor.name(), "r");
  EXPECT_EQ(Vector3(floor.acceleration().col(0)), Vector3(2, 20, 200));
  EXPECT_EQ(Vector3(floor.acceleration().col(1)), Vector3(-2, -20, -200));
}

// At 30 degrees: x = cos 30 * 1 - sin 30 * 10, y = sin 30 * 1 + cos 30 * 10. Rounding only.
TEST(RecordMotion, TurnsCounterClockwise) {
  const double c = std::sqrt(3) / 2, s = 0.5;
  const FloorMotion floor = floor_motion(three_components(), 1, 30 * kRadiansPerDegree);
  EXPECT_TRUE(
      Vector3(floor.acceleration().col(0)).isApprox(Vector3(c - 10 * s, s + 10 * c, 100), 1e-14));
}

TEST(RecordMotion, UsesOnlyTheComponentsAskedFor) {
  const auto first = [](const std::vector<Direction>& use) {
    return Vector3(floor_motion(three_components(), 1, 0, use).acceleration().col(0));
  };
  EXPECT_EQ(first({Direction::kH1}), Vector3(1, 0, 0));
  EXPECT_EQ(first({Direction::kH2, Direction::kVertical}), Vector3(0, 10, 100));
}

TEST(RecordMotion, RefusesWhatCannotBe) {
  Record record = three_components();
  for (const double scale : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()})
    EXPECT_NE(error_text([&] {
                floor_motion(record, scale);
              }).find("the scale of a record must be positive and finite, got "),
              std::string::npos);
  EXPECT_EQ(error_text([&] { floor_motion(record, 1, std::nan("")); }),
            "the angle of a record must be finite, got nan");
  record.components[2].reset();
  EXPECT_EQ(error_text([&] { floor_motion(record, 1, 0, {Direction::kVertical}); }),
            "record 'r' has no vertical component");
  EXPECT_EQ(error_text([] { floor_motion(Record{}); }), "record '' has no component");
}

}  // namespace
}  // namespace gurney::groundmotions
