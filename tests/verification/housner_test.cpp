#include "studies/verification/scenes/housner.h"

#include <gtest/gtest.h>

namespace gurney {
namespace {

TEST(SineRegions, AreThoseOfTheTableOfAnIndependentIntegration) {
  // alpha = 0.25, p = 2.14 /s, eta = 0.9, the full equation; strengths to their digits. For
  // ratio 5 the linearised equation has 3.02, 6.32 and 7.17.
  const RockingBlock block{0.25, 2.14, 0.9};
  struct Row {
    double ratio, a, b, c;
  };
  for (const Row& row :
       {Row{2, 1.2509, 2.3742, 2.4081}, Row{4, 1.8443, 5.0794, 5.4368},
        Row{5, 3.0323, 6.7430, 7.4930}, Row{7, 7.6143, 10.1394, 12.7193}, Row{8, 0, 0, 15.9049}}) {
    const SineRegions found(block, row.ratio);
    EXPECT_NEAR(found.a, row.a, 5e-4) << row.ratio;
    EXPECT_NEAR(found.b, row.b, 5e-4) << row.ratio;
    EXPECT_NEAR(found.c, row.c, 5e-4) << row.ratio;
  }
}

}  // namespace
}  // namespace gurney
