#include "engine/record/energy_balance.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gurney {
namespace {

TEST(EnergyBalance, MissesNothingWhereWorkIsStoredAndLost) {
  EnergyBalance balance(2);
  balance.observe({.kinetic = 6, .elastic = 2, .work_of_floor = 10, .sliding_loss = 4});
  EXPECT_EQ(balance.error(), 0);
}

TEST(EnergyBalance, MissesWhatNoWorkPaidFor) {
  EnergyBalance balance(0);
  balance.observe({.kinetic = 10, .work_of_floor = 8});
  EXPECT_DOUBLE_EQ(balance.error(), 0.2);
  EXPECT_EQ(balance.source(), "its terms do not close (energy closure)");
}

// The account closes: the made energy is booked as a negative loss.
TEST(EnergyBalance, ALossThatGivesEnergyBackHidesNothing) {
  EnergyBalance balance(0);
  balance.observe({.kinetic = 2, .work_of_floor = 10, .contact_loss = 8});
  balance.observe({.kinetic = 10, .work_of_floor = 10});
  EXPECT_EQ(balance.closure(), 0);
  EXPECT_DOUBLE_EQ(balance.error(), 0.8);
  EXPECT_EQ(balance.source(), "losses, which can only grow, gave energy back");
}

TEST(EnergyBalance, CountsWhatTheIntegrationAdded) {
  EnergyBalance balance(0);
  balance.observe({.kinetic = 10, .work_of_floor = 9, .numerical_loss = -1});
  EXPECT_DOUBLE_EQ(balance.error(), 0.1);
  EXPECT_EQ(balance.source(), "the time integration added energy (numerical loss -0.1)");
  EnergyBalance damped(0);
  damped.observe({.kinetic = 9, .work_of_floor = 10, .numerical_loss = 1});
  EXPECT_EQ(damped.error(), 0);
}

// Relaxation alone may swing: what it gives the same patch takes by sliding and damping.
TEST(EnergyBalance, WhatAPatchTakesIsOneLoss) {
  EnergyBalance balance(0);
  balance.observe({.kinetic = 10, .work_of_floor = 12, .relaxation_loss = 1, .tread_loss = 1});
  balance.observe({.kinetic = 10,
                   .work_of_floor = 12,
                   .sliding_loss = 0.5,
                   .relaxation_loss = 0,
                   .tread_loss = 1.5});
  EXPECT_EQ(balance.error(), 0);
}

TEST(EnergyBalance, ATermThatIsNoNumberMissesAnyBalance) {
  EnergyBalance balance;
  EnergyAccount now;
  now.kinetic = 1;
  now.numerical_loss = std::nan("");
  balance.observe(now);
  now.numerical_loss = 0;
  now.work_of_floor = 1;
  balance.observe(now);
  EXPECT_GT(balance.error(), EnergyBalance::kTrusted);
  EXPECT_FALSE(std::isnan(balance.error()));
}

}  // namespace
}  // namespace gurney
