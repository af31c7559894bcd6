#include "groundmotions/buildings/pinched_loop.h"

#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>
#include <vector>

#include "tests/support/small_steps_of_pinching.h"

namespace gurney::groundmotions {
namespace {

constexpr Pinching kPinching{0.8, 0.2};

/// Moves on to a drift, and returns the work of it.
double go(PinchedLoop& loop, double to, double hardening, const Pinching& pinching) {
  const double by = to - loop.drift;
  const PinchedMove moved = move(loop, by, hardening, pinching);
  loop = moved.end;
  return moved.mean * by;
}

// From yield at 4 unloads to zero at 3. Towards -1, never passed, it bends at
// 3 + 0.8 (-1 + 0.8 - 3) = 0.44 with -0.2; from -4 back to zero at -3, and bends at
// -3 + 0.8 (4 - 0.8 + 3) = 1.96 with 0.2 on the way to 4.
TEST(PinchedLoop, BendsWhereTheRuleSays) {
  PinchedLoop loop;
  EXPECT_NEAR(go(loop, 0.5, 0, kPinching), 0.125, 1e-14);
  EXPECT_NEAR(go(loop, 4, 0, kPinching), 0.375 + 3, 1e-14);
  EXPECT_NEAR(loop.force, 1, 1e-14);
  EXPECT_NEAR(go(loop, 0.44, 0, kPinching), -0.5 + 0.2 * 2.56 / 2, 1e-14);
  EXPECT_NEAR(loop.force, -0.2, 1e-14);
  go(loop, -0.28, 0, kPinching);
  EXPECT_NEAR(loop.force, -0.6, 1e-14) << "half-way to the peak";
  go(loop, -4, 0, kPinching);
  EXPECT_NEAR(loop.force, -1, 1e-14);
  go(loop, 1.96, 0, kPinching);
  EXPECT_NEAR(loop.force, 0.2, 1e-14);
  go(loop, 2.98, 0, kPinching);
  EXPECT_NEAR(loop.force, 0.6, 1e-14) << "half-way to the peak";
  go(loop, 2.78, 0, kPinching);
  EXPECT_NEAR(loop.force, 0.4, 1e-14) << "unloads elastically";
  go(loop, 2.98, 0, kPinching);
  EXPECT_NEAR(loop.force, 0.6, 1e-14) << "and comes back to the path";
  go(loop, 5, 0, kPinching);
  EXPECT_NEAR(loop.force, 1, 1e-14);
}

// Straight from zero to the peak: Clough's model. From 3 back at zero, the peak at -1.
TEST(PinchedLoop, WithoutPinchingAimsAtThePeak) {
  PinchedLoop loop;
  go(loop, 4, 0.1, {1, 1});
  EXPECT_NEAR(loop.force, 1.3, 1e-14);
  go(loop, 4 - 1.3, 0.1, {1, 1});
  EXPECT_NEAR(loop.force, 0, 1e-14);
  go(loop, (2.7 - 1) / 2, 0.1, {1, 1});
  EXPECT_NEAR(loop.force, -0.5, 1e-14);
  go(loop, -1, 0.1, {1, 1});
  EXPECT_NEAR(loop.force, -1, 1e-14);
}

const std::vector<double> kTurns = {0.5,  -0.9, 2,  -3,   1.2, -0.4, 0.8,  3.5, 1.5, 2.5, -2,
                                    -1.5, -3,   -5, -4.9, 4,   -1,   0.01, -6,  6,   -6,  0};

// Small steps of the rule miss a force by a step's change of it at each of its bends, 1e-5, and where they
// stop at zero; some 60 of them add up to less than 1e-3.
TEST(PinchedLoop, FollowsSmallStepsOfTheRule) {
  for (const Pinching& pinching :
       {kPinching, Pinching{0.5, 0.5}, Pinching{1, 1}, Pinching{0, 0.3}, Pinching{1, 0.05}})
    for (const double hardening : {0.0, 0.05, 0.5}) {
      PinchedLoop loop;
      SmallStepsOfPinching steps(hardening, pinching.drift, pinching.force);
      for (const double turn : kTurns) {
        go(loop, turn, hardening, pinching);
        constexpr double kStep = 1e-5;
        while (std::abs(turn - steps.drift) > kStep / 2)
          steps.go(
              std::copysign(std::min(kStep, std::abs(turn - steps.drift)), turn - steps.drift));
        ASSERT_NEAR(loop.force, steps.force, 1e-3)
            << "at " << turn << " X " << pinching.drift << " Y " << pinching.force;
      }
    }
}

// A way in pieces is the way; the energy that cannot come back, work less f^2 / 2, never falls.
TEST(PinchedLoop, PiecesOfAWayAddUpAndDissipate) {
  PinchedLoop whole, pieces;
  double all = 0, sum = 0, lost = 0;
  for (const double turn : kTurns) {
    all += go(whole, turn, 0.05, kPinching);
    const double from = pieces.drift;
    for (const double share : {0.013, 0.2, 0.21, 0.5, 0.77, 0.9, 1.0}) {
      sum += go(pieces, from + share * (turn - from), 0.05, kPinching);
      const double now = sum - pieces.force * pieces.force / 2;
      EXPECT_GE(now, lost - 1e-12);
      lost = now;
    }
    EXPECT_NEAR(whole.force, pieces.force, 1e-12);
    EXPECT_NEAR(all, sum, 1e-12);
  }
  EXPECT_GT(lost, 5);
}

}  // namespace
}  // namespace gurney::groundmotions
