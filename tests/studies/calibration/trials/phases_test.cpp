#include "studies/calibration/trials/phases.h"

#include <gmock/gmock.h>

#include "studies/calibration/trials/average_method.h"
#include "tests/studies/calibration/trials/synthetic_trial.h"
#include "tests/support/error_text.h"

namespace gurney::calibration {
namespace {

using testing::HasSubstr;

TEST(PolynomialFit, HasTheErrorOfItsFormula) {
  // s sqrt(720 / n) / T^2 is the limit for many samples: 0.5 % off at n = 240.
  std::vector<double> t, y;
  for (int i = 0; i < 240; ++i) {
    t.push_back(10 + i / 120.0);
    y.push_back(1 + 0.3 * t.back() + 0.1 * t.back() * t.back() +
                1e-4 * normal_draw(7, 0, static_cast<unsigned>(i)));
  }
  const PolynomialFit fit = fit_polynomial(t, y, {0, 240}, 2);
  const double error = fit.residual * std::sqrt(720.0 / 240) / 4;
  EXPECT_NEAR(fit.acceleration_error(), error, 0.02 * error);
  EXPECT_NEAR(fit.acceleration(), 0.2, 4 * error);
  EXPECT_NEAR(fit.rate(10.5), 0.3 + 0.2 * 10.5, 4 * fit.rate_error(10.5));
  EXPECT_NEAR(fit.value(10.5), 1 + 0.3 * 10.5 + 0.1 * 10.5 * 10.5, 1e-4);
}

TEST(Phases, AreThoseOfTheMotion) {
  for (const double noise : {0.0, 1e-4, 5e-4}) {
    SCOPED_TRACE(noise);
    SyntheticPull made;
    made.displacement_noise = noise;
    const Trial trial = make_pull(made);
    const Phases phases = find_phases(trial);
    EXPECT_NEAR(phases.noise, noise, 0.1 * noise + 1e-7);
    // Noise s moves the passing of the mark d = 8 s, at the speed sqrt(2 a d), by sqrt(s / (16 a)),
    // that of 4 d by half as much. start = 2 t(d) - t(4 d): 2.06 times that. Without noise the mark
    // is at 1/2000 of the path, and a parabola between samples is a line: half a sample.
    const auto tolerance = [&](double a) {
      return 4 * 2.06 * std::sqrt(noise / (16 * a)) + 0.0042;
    };
    EXPECT_NEAR(phases.start, made.start, tolerance(made.a2()));
    EXPECT_NEAR(phases.release, made.start + made.pull, 0.0085);
    EXPECT_NEAR(phases.stop, made.stop(), tolerance(made.a3()));
    EXPECT_EQ(phases.end, Phases::End::kRested);
    EXPECT_EQ(phases.held.begin, 0u);
    EXPECT_EQ(phases.stopped.end, trial.signals.time.size());
  }
}

TEST(Phases, TellHowTheyEnd) {
  SyntheticPull made;
  made.end = 4;  // it coasts still
  EXPECT_EQ(find_phases(make_pull(made)).end, Phases::End::kRecordEnds);
  made.end = 6;
  Trial trial = make_pull(made);
  for (std::size_t i = 420; i < trial.signals.time.size(); ++i)  // from 3.5 s on
    trial.signals.displacement[i] = trial.signals.displacement[419];
  const Phases phases = find_phases(trial);
  EXPECT_EQ(phases.end, Phases::End::kEndOfFloor);
  EXPECT_NEAR(phases.stop, 3.5, 0.02);
}

TEST(Phases, NameTheOneThatIsMissing) {
  SyntheticPull made;
  made.end = 2;
  EXPECT_THAT(error_text([&] { find_phases(make_pull(made)); }),
              HasSubstr("made.csv:242: phase III is missing"));
  made.end = 8;
  made.start = 0;
  EXPECT_THAT(error_text([&] { find_phases(make_pull(made)); }), HasSubstr("phase I is missing"));
  made.start = 0.5;
  Trial trial = make_pull(made);
  for (double& x : trial.signals.displacement) x = -x;
  EXPECT_THAT(error_text([&] { find_phases(trial); }),
              HasSubstr("displacement falls while the force pulls"));
  trial = make_pull(made);
  for (double& f : trial.signals.force) f = 0;
  EXPECT_THAT(error_text([&] { find_phases(trial); }), HasSubstr("phase II is missing"));
}

TEST(AverageMethod, GivesTheResistanceBack) {
  for (const double resistance : {0.01, 0.02, 0.03}) {
    SyntheticPull made;
    made.resistance = resistance;
    const Trial trial = make_pull(made);
    const Phases phases = find_phases(trial);
    const TrialAverages averages = averages_of(trial, phases);
    EXPECT_NEAR(averages.pull_acceleration, made.a2(), 4 * averages.acceleration_error);
    EXPECT_NEAR(averages.coast_deceleration, made.a3(), 4 * averages.deceleration_error);
    EXPECT_NEAR(averages.pull_force, made.force, 4 * averages.force_error);
    EXPECT_NEAR(*averages.slope, 0, 4 * averages.slope_error);
    EXPECT_GT(averages.force_error, 0.5 * made.force_noise / std::sqrt(220.0));
    const Resistance r = average_method(averages);
    EXPECT_NEAR(r.pulled, made.resisting(), 4 * r.pulled_error);
    EXPECT_NEAR(r.coasting, made.resisting(), 4 * r.coasting_error);
    EXPECT_NEAR(r.mean, made.resisting(), 4 * r.mean_error);
    EXPECT_LT(r.mean_error, std::min(r.pulled_error, r.coasting_error));
    EXPECT_LT(r.mean_error, 0.003 * made.resisting());
  }
}

TEST(AverageMethod, UsesAccelerationsWhereThereIsNoDisplacement) {
  const SyntheticPull made;
  Trial trial = make_pull(made);
  trial.signals.displacement.clear();
  for (std::size_t i = 0; i < trial.signals.time.size(); ++i) {
    const double t = trial.signals.time[i];
    const double a = t < made.start || t > made.stop() ? 0
                     : t < made.start + made.pull      ? made.a2()
                                                       : -made.a3();
    trial.signals.acceleration.push_back(a + 0.05 + 0.02 * normal_draw(3, 2, i));  // an offset
  }
  const Phases phases = find_phases(trial);
  EXPECT_NEAR(phases.start, made.start, 0.04);
  EXPECT_NEAR(phases.stop, made.stop(), 0.05);
  const Resistance r = average_method(averages_of(trial, phases));
  EXPECT_NEAR(r.pulled, made.resisting(), 4 * r.pulled_error);
  EXPECT_NEAR(r.coasting, made.resisting(), 4 * r.coasting_error);
}

TEST(AverageMethod, IsTheEquilibriumOfFigure5) {
  TrialAverages a;
  a.setup.mass = 99;
  a.setup.added_mass = 1;
  a.setup.string_tension = 2;
  a.pull_force = 50;
  a.pull_acceleration = 0.3;
  a.coast_deceleration = 0.2;
  const Resistance r = average_method(a);
  EXPECT_DOUBLE_EQ(r.pulled, 50 - 2 - 30);
  EXPECT_DOUBLE_EQ(r.coasting, 20 - 2);
  EXPECT_DOUBLE_EQ(r.mean, 18);
}

}  // namespace
}  // namespace gurney::calibration
