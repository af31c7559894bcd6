#include <gtest/gtest.h>

#include "engine/base/units.h"
#include "groundmotions/formats/readers.h"
#include "groundmotions/formats/writers.h"

namespace gurney::groundmotions {
namespace {

// Eight digits: half a unit in the last is 5e-8 of a number.
TEST(At2Text, IsReadBackToEightDigits) {
  Component component;
  component.name = "090";
  component.time_step = 0.005;
  component.acceleration = Eigen::VectorXd::LinSpaced(13, -7, 5) * kStandardGravity / 3;
  const SourceFile file("made.AT2",
                        at2_text(component, "A title", "An event, 1/2/2003, Somewhere"));
  ASSERT_TRUE(recognises_peer_at2(file));
  const auto read = read_peer_at2(file, {});
  ASSERT_EQ(read.size(), 1u);
  EXPECT_EQ(read[0].name, "090");
  EXPECT_EQ(read[0].time_step, 0.005);
  EXPECT_TRUE(read[0].warnings.empty());
  ASSERT_EQ(read[0].acceleration.size(), 13);
  for (Eigen::Index i = 0; i < 13; ++i)
    EXPECT_NEAR(read[0].acceleration[i], component.acceleration[i],
                5.1e-8 * std::abs(component.acceleration[i]) + 1e-15);
}

}  // namespace
}  // namespace gurney::groundmotions
