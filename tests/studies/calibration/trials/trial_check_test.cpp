#include "studies/calibration/trials/trial_check.h"

#include <gmock/gmock.h>

#include "tests/studies/calibration/trials/synthetic_trial.h"

namespace gurney::calibration {
namespace {

using testing::HasSubstr;

/// The reason for which a trial is left out; empty: it is good.
std::string judged(const Trial& trial) {
  try {
    check_samples(trial);
    const Phases phases = find_phases(trial);
    check_averages(averages_of(trial, phases), !trial.signals.displacement.empty());
    check_phases(trial, phases);
    return "";
  } catch (const UnusableTrial& error) {
    return error.what();
  }
}

TEST(WithNoise, DisturbsEverySample) {
  const Trial exact = make_pull({.displacement_noise = 0, .force_noise = 0});
  const TrialSignals a = exact.signals, b = with_noise(exact, 1, 0).signals;
  ASSERT_EQ(a.displacement.size(), b.displacement.size());
  for (std::size_t i = 0; i < a.time.size(); ++i) {
    EXPECT_NE(a.displacement[i], b.displacement[i]) << i;
    EXPECT_LT(std::abs(a.displacement[i] - b.displacement[i]), 6 * kDisplacementNoise) << i;
    EXPECT_NE(a.force[i], b.force[i]) << i;
    EXPECT_LT(std::abs(a.force[i] - b.force[i]), 6 * kForceNoise) << i;
  }
}

TEST(TrialCheck, LetsGoodTrialsPass) {
  for (unsigned seed = 1; seed <= 50; ++seed) {
    SyntheticPull made;
    made.seed = seed;
    made.resistance = 0.01 + 0.0004 * seed;
    made.force = 1.5 * made.resisting() + seed;
    Trial trial = make_pull(made);
    trial.setup.drop_mass = 1.05 * made.force / kStandardGravity;
    EXPECT_EQ(judged(trial), "") << seed;
  }
}

TEST(TrialCheck, NamesGapsAndClocks) {
  const Trial good = make_pull({});
  Trial trial = good;
  trial.signals.displacement[100] = std::nan("");
  EXPECT_EQ(judged(trial), "made.csv:102: gap: displacement is empty");
  trial = good;
  for (std::size_t i = 300; i < trial.signals.time.size(); ++i) trial.signals.time[i] += 0.05;
  EXPECT_THAT(judged(trial), HasSubstr("made.csv:302: gap: 0.05833 s without a sample"));
  trial = good;
  trial.signals.time[300] = trial.signals.time[299];
  EXPECT_THAT(judged(trial), HasSubstr("made.csv:302: clock: time goes from"));
  trial = good;
  trial.signals.time[300] += 0.002;
  EXPECT_THAT(judged(trial), HasSubstr("made.csv:302: clock: a step of 0.01033 s among steps of"));
  trial = good;
  for (double& t : trial.signals.time) t += 0.002 * t * t;  // 2.4 % slower at the end
  EXPECT_THAT(judged(trial), HasSubstr("clock drift: the step is"));
  trial = good;  // the load cell has another clock
  trial.signals.force.erase(trial.signals.force.begin(), trial.signals.force.begin() + 24);
  trial.signals.force.resize(trial.signals.time.size());
  EXPECT_THAT(judged(trial), HasSubstr("clock: the force falls at 2.3"));
}

TEST(TrialCheck, NamesForcesThatPush) {
  Trial trial = make_pull({});
  for (std::size_t i = 400; i < 410; ++i) trial.signals.force[i] = -20;
  EXPECT_THAT(judged(trial), HasSubstr("made.csv:402: negative force: -20 N"));
}

TEST(TrialCheck, NamesSwappedUnits) {
  const Trial good = make_pull({});
  Trial trial = good;
  for (double& x : trial.signals.displacement) x *= 1000;
  EXPECT_THAT(judged(trial), HasSubstr("units: is the displacement a thousand times too large"));
  trial = good;
  for (double& f : trial.signals.force) f /= 1000;
  EXPECT_THAT(judged(trial), HasSubstr("or the force in kN in a column of N?"));
  trial = good;
  for (double& f : trial.signals.force) f /= kStandardGravity;  // kg
  EXPECT_THAT(judged(trial), HasSubstr("units: is the force in kg in a column of N?"));
  trial = good;
  for (double& t : trial.signals.time) t *= 1000;
  EXPECT_NE(judged(trial), "");
  trial = good;
  trial.setup.mass = 120;  // somebody forgot what lay on it
  EXPECT_THAT(judged(trial), HasSubstr("must be 1: is the mass of 120 kg right ("));
  EXPECT_THAT(judged(trial), HasSubstr(" kg would give 1)? Or: mass, force or clock are wrong"));
  trial = good;
  trial.setup.drop_mass = 7;
  EXPECT_THAT(judged(trial), HasSubstr("the force in phase I is 47."));
}

/// A typo in the mass is nearly the ratio of m/s2 to g, in a trial that has no acceleration.
TEST(TrialCheck, BlamesOnlyColumnsThatAreThere) {
  const Trial good = make_pull({});
  Trial trial = good;
  trial.setup.mass *= 10;
  EXPECT_THAT(judged(trial), HasSubstr("is the mass of"));
  EXPECT_THAT(judged(trial), testing::Not(HasSubstr("acceleration in")));
  for (const double ratio : {1e3, 1e-3, kStandardGravity, 1 / kStandardGravity}) {
    EXPECT_THAT(cause_of_ratio(ratio, 1.2, true), testing::Not(HasSubstr("acceleration")));
    EXPECT_THAT(cause_of_ratio(ratio, 1.2, false), testing::Not(HasSubstr("displacement")));
  }
  EXPECT_THAT(cause_of_ratio(1e6, 1.2, false), HasSubstr("mass, force or clock"));
}

/// Each unit in place of another gives its ratio, within a factor of 1.2.
TEST(TrialCheck, NamesTheUnitsOfEachRatio) {
  const struct {
    double ratio;
    const char *displacement, *acceleration;
  } rows[] = {{1e3, "mm in a column of m", "mm/s2 in a column of m/s2"},
              {1e-3, "m in a column of mm", "force in N in a column of kN"},
              {1e-6, "ms in a column of s?", "mass, force or clock"},
              {1e6, "s in a column of ms?", "mass, force or clock"},
              {9.80665, "is the force in kg in a column of N?", "m/s2 in a column of g"},
              {1 / 9.80665, "is the force in N in a column of kg?", "g in a column of m/s2"}};
  for (const auto& row : rows)
    for (const double factor : {1 / 1.19, 1.0, 1.19}) {
      EXPECT_THAT(cause_of_ratio(row.ratio * factor, 1.2, true), HasSubstr(row.displacement));
      EXPECT_THAT(cause_of_ratio(row.ratio * factor, 1.2, false), HasSubstr(row.acceleration));
    }
  for (const double factor : {1 / 1.21, 1.21})
    for (const auto& row : rows)
      EXPECT_THAT(cause_of_ratio(row.ratio * factor, 1.2, true), HasSubstr("mass, force or clock"));
}

TEST(TrialCheck, NamesPhasesThatAreTooShort) {
  SyntheticPull made;
  made.pull = 0.4;
  EXPECT_THAT(judged(make_pull(made)), HasSubstr("phase II is missing: 0.1"));
}

}  // namespace
}  // namespace gurney::calibration
