#include "studies/calibration/pulling/simulated_trial.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "studies/calibration/pulling/measured_trial.h"
#include "studies/calibration/pulling/method_check.h"
#include "studies/calibration/pulling/trial_job.h"
#include "studies/calibration/trials/trial.h"
#include "studies/calibration/trials/trial_file.h"
#include "tests/studies/calibration/pulling/pulling_study.h"
#include "tests/support/error_text.h"

namespace gurney::calibration {
namespace {

/// The shipped study, run once.
class PullingTests : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    // Each test may be a process of its own, beside others.
    path() = testing::TempDir() + "gurney_pulling_tests_" + std::to_string(getpid()) + ".h5";
    run_pulling_tests(shipped_pulling_tests(), path());
    trials() = simulated_trials(study::StudyReader(path()));
  }
  static void TearDownTestSuite() { std::filesystem::remove(path()); }

  static std::string& path() {
    static std::string path;
    return path;
  }
  static std::vector<SimulatedTrial>& trials() {
    static std::vector<SimulatedTrial> trials;
    return trials;
  }
};

TEST_F(PullingTests, AreFiftyOverCastersFloorsLoadsAndAlignments) {
  ASSERT_EQ(trials().size(), 50u);
  const auto count = [](auto holds) { return std::ranges::count_if(trials(), holds); };
  for (const char* caster : {"R100", "R125", "P100"})
    EXPECT_GE(count([&](const auto& t) { return t.trial.setup.caster == caster; }), 12) << caster;
  for (const char* floor : {"polyflor_mystique", "polyflor_forest_fx"})
    EXPECT_GE(count([&](const auto& t) { return t.trial.setup.floor == floor; }), 18) << floor;
  for (int pavers = 0; pavers <= 4; ++pavers)
    EXPECT_GE(count([&](const auto& t) { return t.trial.setup.payload_count == pavers; }), 3);
  EXPECT_EQ(count([](const auto& t) { return t.alignment == Alignment::kCrosswise; }), 7);
  EXPECT_EQ(count([](const auto& t) { return t.alignment == Alignment::kReversed; }), 7);
  EXPECT_GE(count([](const auto& t) { return t.left_flooring; }), 5);
}

TEST_F(PullingTests, AreSampledAt120HzAndHaveFourPhases) {
  for (const SimulatedTrial& trial : trials()) {
    SCOPED_TRACE(trial.configuration);
    const std::vector<double>& time = trial.trial.signals.time;
    for (std::size_t i = 1; i < time.size(); ++i)
      ASSERT_NEAR(time[i] - time[i - 1], 1.0 / 120, 1e-9);
    ASSERT_TRUE(trial.phases) << trial.fault;
    ASSERT_TRUE(trial.averages) << trial.fault;
    EXPECT_NEAR(trial.phases->start, 0.5, 0.02) << "as the blocks go";
    EXPECT_EQ(trial.phases->end == Phases::End::kRested, !trial.left_flooring);
    EXPECT_EQ(trial.trial.signals.force.back(), 0) << "the weight lies on the floor";
  }
}

// The closed form has rigid wheels on a rigid floor. What ours has besides is transient: the swing
// of the treads and cable after the release dies away, and f_r is a mean over seconds. 0.1 % of f_r
// is 0.02 N of 58 N.
TEST_F(PullingTests, TheMethodFindsWhatWentIntoAlignedTrials) {
  for (const SimulatedTrial& trial : trials()) {
    if (trial.alignment != Alignment::kAligned) continue;
    SCOPED_TRACE(trial.configuration);
    EXPECT_NEAR(trial.bias_pulled(), 0, 1e-3);
    EXPECT_NEAR(trial.bias_coasting(), 0, 1e-3);
  }
  for (const CasterFit& fit : fits_by_caster(trials())) {
    EXPECT_NEAR(fit.known, 0.001 / fit.wheel_radius, 1e-12) << fit.caster << ": Cr is 1 mm";
    EXPECT_NEAR(fit.found, fit.known, 1e-3 * fit.known) << fit.caster;
  }
}

// Casters that turn into line take energy from phase II, by scrub and by their way round, and none
// from phase III: the method's bias is there, grows with the angle and is above zero.
TEST_F(PullingTests, CastersThatTurnBiasPhaseTwoOnly) {
  const auto rows = bias_by_alignment(trials());
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[0].trials, 36u);
  EXPECT_GT(rows[1].pulled.mean, 0.01);
  EXPECT_GT(rows[2].pulled.mean, 2 * rows[1].pulled.mean);
  for (const AlignmentBias& row : rows)
    EXPECT_NEAR(row.coasting.mean, 0, 1e-3) << name_of(row.alignment);
}

// Energy decides where an aligned trolley rests, and the weight always falls 1 m.
TEST_F(PullingTests, RestWhereTheClosedFormSays) {
  for (const SimulatedTrial& trial : trials()) {
    if (trial.alignment != Alignment::kAligned) continue;
    SCOPED_TRACE(trial.configuration);
    const TheoryError error = theory_error(trial);
    EXPECT_EQ(std::isnan(error.rest), trial.left_flooring);
    if (!trial.left_flooring) {
      EXPECT_NEAR(error.rest, 0, 1e-3);
    }
    EXPECT_NEAR(error.release, 0, 1e-2) << "treads wind up before they resist";
  }
}

// W_F = E_KT + W_R + what treads, swivels and scrub take: 1 % where the casters are in line.
TEST_F(PullingTests, KeepTheirEnergyAccount) {
  const SimulatedTrial& trial = trials()[0];
  ASSERT_EQ(trial.work.size(), trial.trial.signals.time.size());
  for (std::size_t i = 0; i < trial.work.size(); ++i)
    EXPECT_NEAR(trial.work[i], trial.kinetic[i] + trial.rolling_loss[i], 0.01 * trial.work.back());
  const double expected = trial.theory.held_force - trial.theory.string_tension;
  EXPECT_LT(trial.work.back(), expected) << "the weight keeps what it has when it lands";
  EXPECT_GT(trial.work.back(), 0.8 * expected);
}

TEST_F(PullingTests, WrittenAsTrialsReadBackAsMeasured) {
  const TempFolder folder;
  std::size_t files = 0;
  export_trials(path(), {}, [&](const std::string& name, std::string_view bytes) {
    folder.write(name, std::string(bytes));
    ++files;
  });
  ASSERT_EQ(files, 50u);
  const std::string text = contents_of(folder.file("trial_36.csv"));
  EXPECT_NE(text.find("# note = SYNTHETIC: run 36 of job a by gurney "), std::string::npos)
      << text.substr(0, 300);
  EXPECT_NE(text.find("# origin = simulated\n"), std::string::npos);
  EXPECT_NE(text.find("# kind = crosswise_pull\n"), std::string::npos);
  const std::vector<MeasuredTrial> measured = measured_trials(folder.path());
  ASSERT_EQ(measured.size(), 50u);
  for (std::size_t i = 0; i < measured.size(); ++i) {
    SCOPED_TRACE(trials()[i].configuration);
    ASSERT_EQ(measured[i].fault, "");
    EXPECT_EQ(measured[i].trial.name, trials()[i].trial.name);
    EXPECT_NEAR(mean_resistance(*measured[i].averages), mean_resistance(*trials()[i].averages),
                0.01)
        << "rounded to 0.1 um";
  }
  EXPECT_EQ(find_matching(trials()[40], measured), &measured[40]);
}

// Phase II again under the force that was found, for the time that was found. The release is known
// to half a sample, 1/240 s, in which the force T changes the speed v by T / (M + J) / 240: 0.3 % of
// it, and twice as much of the way that is left. The start, from two points of a parabola, is as
// good.
TEST_F(PullingTests, DrivenByTheirForceTheyMoveAlike) {
  constexpr std::array<std::size_t, 3> kRuns = {0, 36, 49};
  std::vector<MeasuredTrial> measured;
  for (const std::size_t run : kRuns) {
    const SimulatedTrial& trial = trials()[run];
    measured.push_back({trial.trial, trial.phases, trial.averages, ""});
  }
  const TempFolder folder;
  const TrialJob job = job_of_trials(measured, "three");
  EXPECT_TRUE(job.left_out.empty());
  run_pulling_tests(job.text, folder.file("driven.h5"));
  const auto driven = simulated_trials(study::StudyReader(folder.file("driven.h5")));
  ASSERT_EQ(driven.size(), 3u);
  for (std::size_t i = 0; i < driven.size(); ++i) {
    const PullTheory& of = trials()[kRuns[i]].theory;
    const double share = of.force / (of.mass + of.added_mass) / 240 / of.release_velocity;
    SCOPED_TRACE(driven[i].driven_by);
    EXPECT_EQ(find_matching(driven[i], measured), &measured[i]);
    const auto error = driven_error(driven[i], measured);
    ASSERT_TRUE(error);
    EXPECT_NEAR(error->speed, 0, 2 * share);
    EXPECT_NEAR(error->release, 0, 2 * share);
    if (!std::isnan(error->rest)) {
      EXPECT_NEAR(error->rest, 0, 4 * share);
    }
    EXPECT_LT(error->largest, 4 * share * of.rest_displacement);
    // The closed form of a sampled force: what the treads' wind-up leaves, as of the weight.
    if (driven[i].alignment == Alignment::kAligned) {
      EXPECT_NEAR(theory_error(driven[i]).release, 0, 1e-2);
    }
  }
}

TEST_F(PullingTests, TrialsWithoutItemOrForceAreLeftOutOfTheJob) {
  MeasuredTrial good{trials()[0].trial, trials()[0].phases, trials()[0].averages, ""};
  MeasuredTrial nothing = good;
  nothing.trial.name = "no_item";
  nothing.trial.setup.item.clear();
  MeasuredTrial averages = good;
  averages.trial.name = "averages";
  averages.phases = {};
  const TrialJob job = job_of_trials({nothing, good, averages}, "some");
  ASSERT_EQ(job.left_out.size(), 2u);
  EXPECT_EQ(job.left_out[0], "no_item: no `item` is stated");
  EXPECT_EQ(job.left_out[1], "averages: only its averages are known, a force history is needed");
  EXPECT_EQ(job.text.find("no_item"), std::string::npos);
  EXPECT_EQ(job_of_trials({nothing}, "none").text, "");
}

// Phase II begins at 0.05 s, between the samples of 1 and 11 N, where the force is 6 N, and is let go after 0.25 s.
TEST(TrialJob, HasTheForceOfPhaseTwoBetweenItsSamples) {
  MeasuredTrial trial;
  trial.trial.name = "ramp";
  trial.trial.setup.item = "trolley";
  trial.trial.setup.pull_point = {0.3, 0, 0.5};
  trial.trial.signals.time = {0, 0.1, 0.2, 0.3};
  trial.trial.signals.force = {1, 11, 21, 0};
  trial.phases.emplace();
  trial.phases->start = 0.05;
  trial.phases->release = 0.25;
  trial.phases->stop = 0.3;
  const std::string text = job_of_trials({trial}, "ramps").text;
  EXPECT_NE(text.find("[\n  0.500000, 0.550000, 0.650000, 0.700000]"), std::string::npos) << text;
  EXPECT_NE(text.find("[\n  6.000, 11.000, 21.000, 21.000]"), std::string::npos) << text;
}

// The top of the trolley moves as its base but for the pitch on the treads, whose rate is zero at
// rest: over the whole trial both accelerations have the same integral, 0. Their samples at 120 Hz
// have it to some 1/120 s of the largest difference.
TEST_F(PullingTests, TheAccelerometerOnTopMeasuresThePitchToo) {
  const SimulatedTrial& trial = trials()[0];
  const std::vector<double>& base = trial.trial.signals.acceleration;
  ASSERT_EQ(trial.accelerometer, "top");
  ASSERT_EQ(trial.accelerometer_signal.size(), base.size());
  double integral = 0, largest = 0;
  for (std::size_t i = 0; i < base.size(); ++i) {
    const double difference = trial.accelerometer_signal[i] - base[i];
    integral += difference / 120;
    largest = std::max(largest, std::abs(difference));
  }
  EXPECT_GT(largest, 0.5 * trial.theory.acceleration) << "it rocks when the blocks go";
  EXPECT_NEAR(integral, 0, largest / 120);
}

// Of n = 700 samples and more, whose median has 1.2533 of the scatter of a mean, the noise is known
// to 1.25 / sqrt(2 n) = 3.4 %: four times that.
TEST_F(PullingTests, NoiseIsThatOfTheInstrumentsAndOfItsSeed) {
  const study::StudyReader file(path());
  const auto noisy = simulated_trials(file, 1), again = simulated_trials(file, 1),
             other = simulated_trials(file, 2);
  const TrialSignals& s = noisy[0].trial.signals;
  EXPECT_NEAR(noise_of(s.displacement), kDisplacementNoise, 0.14 * kDisplacementNoise);
  EXPECT_EQ(s.displacement, again[0].trial.signals.displacement);
  EXPECT_NE(s.displacement, other[0].trial.signals.displacement);
  EXPECT_NE(s.displacement[3] - trials()[0].trial.signals.displacement[3],
            noisy[1].trial.signals.displacement[3] - trials()[1].trial.signals.displacement[3])
      << "each run has noise of its own";
  for (const AlignmentBias& row : bias_by_alignment(noisy))
    EXPECT_NEAR(row.coasting.mean, 0, 1e-3) << "the method averages it out";
}

// The numbers of docs/pulling_tests.md; of one caster the pool is the fit through the origin.
TEST_F(PullingTests, ReversedTrialsRaiseAPooledCr) {
  const auto rows = pooled_biases(trials());
  ASSERT_EQ(rows.size(), 4u);
  EXPECT_EQ(rows[2].trials_of, "aligned, reversed");
  EXPECT_EQ(rows[2].trials, 43u);
  EXPECT_NEAR(rows[2].both, 0.0090, 0.5e-4);
  EXPECT_EQ(rows[3].trials, 50u);
  EXPECT_NEAR(rows[3].both, 0.0094, 0.5e-4);
  EXPECT_NEAR(rows[3].coasting, 0.0001, 0.5e-4);
  std::vector<SimulatedTrial> r100;
  double found = 0, known = 0;
  for (const SimulatedTrial& trial : trials()) {
    if (trial.trial.setup.caster != "R100") continue;
    r100.push_back(trial);
    found += mean_resistance(*trial.averages) * trial.theory.normal_force;
    known += trial.theory.resistance * trial.theory.normal_force;
  }
  EXPECT_NEAR(pooled_biases(r100).back().both, found / known - 1, 1e-12);
}

TEST(SimulatedTrials, RefuseStudiesThatAreNoPullingTests) {
  const TempFolder folder;
  const std::string row = "[\"R100\", \"polyflor_mystique\", 0, \"6 kg\", \"aligned\"]";
  const auto error = [&](std::string text) {
    run_pulling_tests(text, folder.file("a.h5"));
    return error_text([&] { simulated_trials(study::StudyReader(folder.file("a.h5"))); });
  };
  std::string job = pulling_tests_of(row);
  job.replace(job.find("histories = \"all\""), 17, "histories = \"none\"");
  EXPECT_EQ(error(job), folder.file("a.h5") +
                            ": keeps no histories; the job needs\n[study.keep]\n"
                            "histories = \"all\"");
  job = pulling_tests_of(row);
  job.replace(job.find("direction = [1, 0, 0]"), 21, "direction = [0, 1, 0]");
  EXPECT_EQ(error(job).substr(0, folder.file("a.h5").size() + 72),
            folder.file("a.h5") +
                ": run 0 (R100, polyflor_mystique, 0, 6 kg, aligned): is no pulling test:");
}

}  // namespace
}  // namespace gurney::calibration
