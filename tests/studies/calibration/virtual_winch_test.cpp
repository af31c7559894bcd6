#include <gmock/gmock.h>

#include "studies/calibration/breakaway.h"
#include "studies/calibration/rebound.h"
#include "tests/studies/calibration/virtual_pulls.h"

namespace gurney {
namespace {

using testing::HasSubstr;

// The winch's force rises by 60 N/s, 12 N in the window of 0.2 s: half of it is smoothed away, 1 %
// of 580 N.
TEST(Breakaway, FindsTheFrictionOfLockedWheels) {
  for (const double kinetic : {0.6, 0.5}) {
    SCOPED_TRACE(kinetic);
    TrialFault fault;
    const auto found = breakaway_of(with_noise(virtual_winch(true, 60, 0.6, kinetic), 1, 0), fault);
    ASSERT_TRUE(found) << fault.text();
    if (kinetic == 0.6) {
      EXPECT_NEAR(found->peak, 0.6, 0.02 * 0.6);
    }
    // Wheels break away one after the other: the sum never reaches mu_s N (docs/calibration.md).
    EXPECT_GT(found->peak, (0.6 + kinetic) / 2);
    EXPECT_LT(found->peak, 0.6 * 1.02);
    EXPECT_NEAR(found->moving, kinetic, 0.005 * kinetic);
    EXPECT_LT(found->moving_error, 0.005 * kinetic);
  }
}

TEST(Breakaway, FindsWhatItTakesToRoll) {
  TrialFault fault;
  const auto found = breakaway_of(with_noise(virtual_winch(false, 3, 0.6, 0.6), 1, 0), fault);
  ASSERT_TRUE(found) << fault.text();
  EXPECT_NEAR(found->moving, 0.02, 0.02 * 0.02);
  // In the engine it takes no more to start. The largest of some twenty windows with an error of
  // 1.5 % each is 2 of these errors high.
  EXPECT_NEAR(found->peak, 0.02, 0.05 * 0.02);
}

TEST(Breakaway, NamesTrialsThatNeverMove) {
  Trial trial = virtual_winch(true, 60, 0.6, 0.6);
  for (std::size_t i = 0; i < trial.signals.time.size(); ++i) trial.signals.displacement[i] = 0;
  trial.lines.assign(trial.signals.time.size(), 7);
  TrialFault fault;
  EXPECT_FALSE(breakaway_of(with_noise(trial, 1, 0), fault));
  EXPECT_EQ(fault.text(), "virtual.csv:7: it never breaks away");
}

TEST(Breakaway, NamesPullsThatSomebodyCalledLocked) {
  Trial trial = virtual_pull({});
  trial.kind = TrialKind::kLockedPull;
  TrialFault fault;
  EXPECT_FALSE(breakaway_of(trial, fault));
  EXPECT_THAT(fault.reason, HasSubstr("the force falls to 0 N while it moves: is it kind = pull?"));
}

// Noise makes an error of about 2 mm/s in each speed, 1 % of e at 0.4 m/s; the engine's own rebound
// and the coasting during the contact make another 2 %.
TEST(Rebound, FindsTheRestitution) {
  for (const double e : {0.3, 0.5, 0.7}) {
    SCOPED_TRACE(e);
    TrialFault fault;
    const auto found = rebound_of(with_noise(virtual_impact(0.5, e), 1, 0), fault);
    ASSERT_TRUE(found) << fault.text();
    EXPECT_NEAR(found->restitution, e, 4 * found->error + 0.02 * e);
    EXPECT_LT(found->error, 0.02);
    EXPECT_NEAR(found->approach, 0.365, 0.01);  // sqrt(0.5^2 - 2 0.195 0.3)
  }
}

TEST(Rebound, NamesTrialsWithoutARebound) {
  Trial trial = virtual_impact(0.5, 0.5);
  trial.signals.displacement.resize(80);
  trial.signals.time.resize(80);
  TrialFault fault;
  EXPECT_FALSE(rebound_of(trial, fault));
  EXPECT_THAT(fault.reason, HasSubstr("0.25 s before and after the impact are needed"));
}

}  // namespace
}  // namespace gurney
