#include "studies/limit_states/limit_state.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "studies/results/columns.h"

namespace gurney::study {
namespace {

using Of = Quantity::Of;

TEST(LimitState, OfNoItemIsOfThoseOfTheJob) {
  EXPECT_TRUE(counts_of({Of::kItem, "peak_displacement", "", ""}, "cart"));
  EXPECT_FALSE(counts_of({Of::kItem, "peak_displacement", "", ""}, "cart/drawer"));
  EXPECT_FALSE(counts_of({Of::kItem, "impacts", "", ""}, "cart/drawer"));
  EXPECT_TRUE(counts_of({Of::kItem, "peak_travel", "", ""}, "cart/drawer"));
  EXPECT_TRUE(counts_of({Of::kItem, "time_of_release", "", ""}, "cart/drawer"));
  EXPECT_TRUE(counts_of({Of::kItem, "peak_displacement", "cart/drawer", ""}, "cart/drawer"));
  EXPECT_FALSE(counts_of({Of::kItem, "peak_displacement", "cart/drawer", ""}, "cart"));
  EXPECT_TRUE(counts_of({Of::kPoint, "peak_absolute_acceleration", "", "screen"}, "cart/arm"));
}

// A misspelt column would never count.
TEST(LimitState, OfPartsAndContentsHasTheirNineDemands) {
  const auto counted = std::ranges::count_if(demand_columns(), [](const auto& column) {
    return counts_of({Of::kItem, column.name, "", ""}, "cart/drawer");
  });
  EXPECT_EQ(counted, 9);
}

// The values of a run that was just made, as those of its file (study_data_test.cpp).
TEST(LimitState, OfARunCountsWhatItIsOf) {
  Scene scene;
  scene.items.resize(2);
  scene.items[0].name = "cart";
  scene.items[1].name = "cart/jug";
  Response response;
  response.items.resize(2);
  response.items[0].demands.peak_displacement = 0.1;
  response.items[1].demands.peak_displacement = 3;
  response.items[1].demands.time_of_fall = 2;
  const Values values = values_of(scene, response);
  EXPECT_THAT(values({Of::kItem, "peak_displacement", "", ""}), testing::ElementsAre(0.1));
  EXPECT_THAT(values({Of::kItem, "time_of_fall", "", ""}), testing::ElementsAre(-1, 2));
}

}  // namespace
}  // namespace gurney::study
