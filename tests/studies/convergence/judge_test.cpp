#include <gtest/gtest.h>

#include <cmath>

#include "studies/convergence/convergence.h"

namespace gurney::study {
namespace {

/// A number that goes as 1 + c h^p with the step h, in units of the job's.
ConvergedNumber going_as(double c, double p, const std::vector<Variant>& variants) {
  ConvergedNumber number;
  for (const Variant& each : variants)
    number.values.push_back(each.varied == Varied::kTimeStep ? 1 + c * std::pow(each.factor, p)
                                                             : 1 + c);
  return number;
}

class JudgeTest : public testing::Test {
 protected:
  void judge(ConvergedNumber& number) { study::judge(number, variants_, settings_, 0.02, 1e-6); }

  SimulationSettings settings_;
  std::vector<Variant> variants_ = variants_for(settings_);
};

TEST_F(JudgeTest, SmallChangesAreConverged) {
  ConvergedNumber number = going_as(0.01, 2, variants_);
  judge(number);
  EXPECT_EQ(number.step, StepVerdict::kConverged);
  // From h to h/8 the term falls from c to c/64; the larger of both is 1 + c.
  EXPECT_NEAR(number.change, 0.01 * (1 - 1.0 / 64) / 1.01, 1e-12);
  EXPECT_NEAR(number.order, 2, 1e-9);
}

TEST_F(JudgeTest, ChangesThatShrinkAskForASmallerStep) {
  ConvergedNumber number = going_as(0.2, 1, variants_);
  judge(number);
  EXPECT_EQ(number.step, StepVerdict::kConverging);
  EXPECT_NEAR(number.order, 1, 1e-9);
  EXPECT_NEAR(number.step_needed, settings_.time_step * 0.02 / number.change, 1e-12);
}

TEST_F(JudgeTest, ChangesThatDoNotShrinkAreSensitive) {
  ConvergedNumber number = going_as(0, 1, variants_);
  for (std::size_t i = 0; i < variants_.size(); ++i)
    if (variants_[i].varied == Varied::kTimeStep)
      number.values[i] = std::abs(std::log2(variants_[i].factor)) == 1 ? 1.3 : 1.0;
  number.values.back() = 1;
  for (std::size_t i = 0; i < variants_.size(); ++i)
    if (variants_[i].varied == Varied::kTimeStep && variants_[i].factor == 0.125)
      number.values[i] = 1.4;
  judge(number);
  EXPECT_EQ(number.step, StepVerdict::kSensitive);
  number.scatter = 1;  // half of it is more than the change of 0.4
  judge(number);
  EXPECT_EQ(number.step, StepVerdict::kScattered);
}

TEST_F(JudgeTest, WhatCannotBeMeasuredIsNoChange) {
  EXPECT_EQ(relative_change(1e-7, 5e-7, 1e-6), 0);
  EXPECT_NEAR(relative_change(1, 3, 1e-6), 2.0 / 3, 1e-15);
  ConvergedNumber number = going_as(0, 1, variants_);
  for (std::size_t i = 0; i < variants_.size(); ++i)
    if (variants_[i].varied == Varied::kTreadStiffness) number.values[i] = variants_[i].factor;
  judge(number);
  EXPECT_NEAR(number.stiffness_change, 0.5, 1e-15);  // of a half and twice, not of four times
  EXPECT_EQ(number.solver_change, 0);
}

TEST(VariantTest, StaysWithinTheEnginesRange) {
  RunOptions settings;
  settings.time_step = 0.02;
  settings.residual = 1e-4;
  for (const Variant& each : variants_for(settings)) {
    RunCase run;
    run.settings = settings;
    EXPECT_NO_THROW(validate(varied(run, each).settings));
  }
}

TEST(VariantTest, StifferTreadsKeepTheirShareOfCriticalDamping) {
  RunCase run;
  run.scene.items.emplace_back();
  run.scene.items[0].model.casters.emplace_back();
  const Tread before = run.scene.items[0].model.casters[0].tread;
  const Tread after =
      varied(run, {Varied::kTreadStiffness, 4}).scene.items[0].model.casters[0].tread;
  EXPECT_EQ(after.normal_stiffness, 4 * before.normal_stiffness);
  EXPECT_EQ(after.normal_damping, 2 * before.normal_damping);
  EXPECT_EQ(after.tangential_stiffness, 4 * before.tangential_stiffness);
  EXPECT_EQ(after.tangential_damping, 2 * before.tangential_damping);
}

}  // namespace
}  // namespace gurney::study
