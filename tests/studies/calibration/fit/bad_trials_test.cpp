#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "engine/base/error.h"
#include "engine/base/units.h"
#include "studies/calibration/fit/calibration.h"
#include "tests/studies/calibration/fit/virtual_pulls.h"

/// Each kind of bad trial is named for each kind of trial; for pulls see
/// trials/trial_check_test.cpp.
namespace gurney::calibration {
namespace {

using testing::HasSubstr;

using Spoil = std::function<void(Trial&)>;

struct Bad {
  Spoil spoil;
  std::string named;
};

/// Why it is left out; empty: it is used.
std::string judged(const Trial& good, const Spoil& spoil) {
  Trial trial = good;
  trial.lines.clear();
  for (std::size_t i = 0; i < trial.signals.time.size(); ++i)
    trial.lines.push_back(static_cast<int>(i) + 2);
  spoil(trial);
  trial.lines.resize(trial.signals.time.size());
  TrialSet set;
  set.trials = {trial};
  try {
    calibrate(set, "made");
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

void expect_named(const Trial& good, const std::vector<Bad>& all) {
  for (const Bad& bad : all) EXPECT_THAT(judged(good, bad.spoil), HasSubstr(bad.named));
}

Spoil times(std::vector<double> TrialSignals::*series, double factor) {
  return [=](Trial& trial) {
    for (double& value : trial.signals.*series) value *= factor;
  };
}

/// 3 % slower at the end.
void drift(Trial& trial) {
  const double end = trial.signals.time.back();
  for (double& t : trial.signals.time) t += 0.015 * t * t / end;
}

/// The force `samples` later (< 0: earlier); its ends go on.
Spoil lag(int samples) {
  return [=](Trial& trial) {
    std::vector<double>& f = trial.signals.force;
    const std::vector<double> good = f;
    const int last = static_cast<int>(f.size()) - 1;
    for (int i = 0; i <= last; ++i)
      f[static_cast<std::size_t>(i)] =
          good[static_cast<std::size_t>(std::clamp(i - samples, 0, last))];
  };
}

/// Only the samples whose displacement lies within these shares of the last one, as one stretch.
Spoil part(double from, double to) {
  return [=](Trial& trial) {
    TrialSignals& s = trial.signals;
    const double path = *std::ranges::max_element(s.displacement);
    const auto beyond = [&](double share) {
      return std::ranges::find_if(s.displacement, [&](double x) { return x > share * path; }) -
             s.displacement.begin();
    };
    const auto begin = from > 0 ? beyond(from) : 0, end = beyond(to);
    for (auto series : {&TrialSignals::time, &TrialSignals::force, &TrialSignals::displacement})
      if (std::vector<double>& v = s.*series; !v.empty())
        v = std::vector<double>(v.begin() + begin, v.begin() + end);
  };
}

void push(Trial& trial) {
  for (std::size_t i = 40; i < 50; ++i) trial.signals.force[i] = -30;
}

void skip(Trial& trial) {
  for (std::size_t i = 60; i < trial.signals.time.size(); ++i) trial.signals.time[i] += 0.05;
}

void leave_empty(Trial& trial) { trial.signals.displacement[50] = std::nan(""); }

/// What is read alike of every kind.
std::vector<Bad> samples() {
  return {{leave_empty, "gap: displacement is empty"},
          {skip, "gap: 0.05833 s without a sample"},
          {times(&TrialSignals::time, 1000), "units: a step of time is 8.333 s: is the time in ms"},
          {times(&TrialSignals::time, 1e-3), "units: a step of time is 8.333e-06 s"},
          {drift, "clock drift: the step is"}};
}

const char* const kLarge = "units: is the displacement a thousand times too large";
const char* const kSmall = "units: is the displacement a thousandth, such as m in a column of mm";

void expect_winch_named(
    const VirtualWinch& winch,
    const char* ahead = "s ahead of the motion; force and motion must have one clock") {
  const Trial good = with_noise(virtual_winch(winch), 1, 2);
  EXPECT_EQ(judged(good, [](Trial&) {}), "");
  expect_named(good, samples());
  expect_named(
      good, {{push, "negative force: -30 N; a cable only pulls"},
             {times(&TrialSignals::displacement, 1000), kLarge},
             {times(&TrialSignals::displacement, 1e-3), kSmall},
             {times(&TrialSignals::force, 1000), kSmall},
             {times(&TrialSignals::force, 1e-3), "or the force in kN in a column of N?"},
             {times(&TrialSignals::force, 1 / kStandardGravity), "units: is the force in kg"},
             {times(&TrialSignals::displacement, -1), "displacement falls while the force pulls"},
             {lag(24), "s behind the motion; force and motion must have one clock"},
             {lag(-24), ahead},
             {part(0.1, 1), "it does not stand still before it is pulled"},
             {times(&TrialSignals::displacement, 0), "it never breaks away"}});
}

TEST(BadTrials, OfLockedPullsAreNamed) {
  for (const LockedWheels locked :
       {LockedWheels::kFront, LockedWheels::kRear, LockedWheels::kAll}) {
    SCOPED_TRACE(static_cast<int>(locked));
    // Of a front axle the law of motion misses a force that is ahead, before its lag is sure.
    if (locked == LockedWheels::kFront)
      expect_winch_named({40, locked, 0.6, 0.5, 0.02}, "mass, force or clock are wrong");
    else
      expect_winch_named({40, locked, 0.6, 0.5, 0.02});
  }
}

TEST(BadTrials, OfStartPullsAreNamed) { expect_winch_named({2, {}, 0.6, 0.6, 0.02}); }

TEST(BadTrials, OfCrosswisePullsAreNamed) {
  VirtualPull pull;
  pull.heading = 90 * kRadiansPerDegree;
  pull.drop_mass = 8;
  Trial good = with_noise(virtual_pull(pull), 1, 1);
  good.kind = TrialKind::kCrosswisePull;
  expect_named(good, samples());
  expect_named(good, {{push, "negative force: -30 N; a cable only pulls"},
                      {times(&TrialSignals::displacement, 1000), kLarge},
                      {times(&TrialSignals::displacement, 1e-3), kSmall},
                      {times(&TrialSignals::force, 1e-3), "or the force in kN in a column of N?"},
                      {lag(24), "force and motion must have one clock"},
                      {lag(-24), "force and motion must have one clock"},
                      {part(0.1, 1), "phase I is missing"},
                      {part(0, 0.2), "phase III is missing"}});
}

TEST(BadTrials, OfImpactsAreNamed) {
  const Trial good = with_noise(virtual_impact(0.5, 0.4), 1, 5);
  EXPECT_EQ(judged(good, [](Trial&) {}), "");
  expect_named(good, samples());
  expect_named(good, {{times(&TrialSignals::displacement, 1000), "m/s: must be > 0.02 and < 5 m/s"},
                      {times(&TrialSignals::displacement, 1e-3), "m/s: must be > 0.02 and < 5 m/s"},
                      {times(&TrialSignals::displacement, 10), "it slows down by 2 m/s2 before"},
                      {part(0.9, 0.9999), "0.25 s before and after the impact are needed"},
                      {part(0, 0.9), "0.25 s before and after the impact are needed"}});
}

}  // namespace
}  // namespace gurney::calibration
