#include "studies/report/calibration_report.h"

#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/base/random/normal_draw.h"
#include "equipment/catalogue/caster_type.h"
#include "equipment/catalogue/catalogue.h"
#include "equipment/catalogue/check_file.h"
#include "studies/calibration/fit/caster_file.h"
#include "studies/figures/pulling_figures.h"
#include "studies/render/render.h"
#include "tests/studies/calibration/trials/synthetic_trial.h"
#include "tests/support/error_text.h"
#include "tests/support/temp_folder.h"

namespace gurney::calibration {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

/// Pulls of three casters on two floors: Cr 1 mm whatever the wheel, 2 % scatter, one swapped unit.
TrialSet programme() {
  TrialSet set;
  unsigned seed = 0;
  for (const std::string caster : {"R100", "R125", "homemade"})
    for (const std::string floor : {"forest", "mystique"})
      for (int i = 0; i < 5; ++i) {
        const double radius = caster == "R125" ? 0.0625 : 0.05;
        SyntheticPull made;
        made.seed = ++seed;
        made.resistance = 1e-3 / radius * std::exp(0.02 * normal_draw(seed, 9, 0));
        made.mass += i % 2 * 50;
        made.force = 2.2 * 1e-3 / radius * made.mass * kStandardGravity;
        made.pull = std::sqrt(2 * 0.8 / made.a2());  // a drop of 0.8 m
        Trial trial = make_pull(made);
        trial.name = caster + "_" + floor + "_" + std::to_string(i);
        trial.setup.caster = caster;
        trial.setup.floor = floor;
        trial.setup.wheel_radius = radius;
        trial.setup.tread = caster == "homemade" ? "" : "rubber";
        if (i == 4) trial.setup.use = TrialUse::kValidation;
        set.trials.push_back(trial);
      }
  for (double& force : set.trials[2].signals.force) force /= 1000;
  return set;
}

const Constant& constant(const Calibration& c, const std::string& about) {
  for (const Constant& each : c.constants)
    if (each.about() == about) return each;
  throw Error("no " + about);
}

const RollingTest& test_named(const Calibration& c, const std::string& name) {
  for (const RollingTest& each : c.tests)
    if (each.name == name) return each;
  throw Error("no " + name);
}

TEST(Calibration, FindsWhatThePaperFound) {
  const Calibration c = calibrate(programme(), "made");
  ASSERT_EQ(c.constants.size(), 6u);
  EXPECT_NEAR(constant(c, "Cr/R of R100 on mystique").value, 0.02, 0.001);
  EXPECT_NEAR(constant(c, "Cr/R of R125 on forest").value, 0.016, 0.0008);
  // 4 standard errors and more of 24 trials with 2 % scatter.
  const RollingTest& load = test_named(c, "load");
  EXPECT_TRUE(load.interval.contains(1)) << load.estimate;
  EXPECT_LT(load.interval.high - load.interval.low, 0.2);
  EXPECT_TRUE(test_named(c, "floor mystique").interval.contains(1));
  EXPECT_TRUE(test_named(c, "speed between trials").interval.contains(0));
  EXPECT_GT(test_named(c, "speed while coasting").p_adjusted, 0.05);
  EXPECT_TRUE(c.outliers.empty());
  const RollingTest& diameter = test_named(c, "diameter");
  EXPECT_NEAR(diameter.estimate, -1, 0.2);
  EXPECT_LT(*diameter.p_without, 1e-6);
  EXPECT_GT(diameter.p, 0.05);
}

TEST(Calibration, SeesDependences) {
  TrialSet set = programme();
  std::erase_if(set.trials, [](const Trial& t) { return t.setup.use == TrialUse::kValidation; });
  for (Trial& trial : set.trials)  // a load cell that reads 3 % low
    for (double& force : trial.signals.force) force *= 0.97;
  EXPECT_LT(test_named(calibrate(set, "made"), "phase").p_adjusted, 0.01);
  set = programme();
  for (Trial& trial : set.trials)
    if (trial.setup.mass > 100) trial.setup.string_tension = 3;  // 2 N too much: n < 1
  EXPECT_LT(test_named(calibrate(set, "made"), "load").estimate, 0.9);
}

TEST(Calibration, ReportsAllInTextAndJson) {
  const Calibration c = calibrate(programme(), "made");
  const std::string text = render::text(report::calibration_findings(report::calibration_facts(c)));
  EXPECT_THAT(text, HasSubstr("SIMULATED: 30 of 30 trials are not measured"));
  EXPECT_THAT(text, HasSubstr("Excluded\n    made.csv: (M + J)(a_2 + a_3) is "));
  EXPECT_THAT(text, HasSubstr("Cr/R of R100 on mystique"));
  EXPECT_THAT(text, HasSubstr("diameter"));
  EXPECT_THAT(text, ContainsRegex("R100_forest_4 +Cr/R of R100 on forest +0\\.0"));
  EXPECT_THAT(text, HasSubstr(" of 6 within their 95 % interval"));
  const auto json = nlohmann::json::parse(render::json(report::calibration_facts(c)));
  EXPECT_EQ(json["constants"].size(), 6u);
  EXPECT_EQ(json["constants"][0]["name"], "rolling_resistance");
  EXPECT_EQ(json["constants"][0]["interval_95"].size(), 2u);
  EXPECT_EQ(json["validation"].size(), 6u);
  EXPECT_EQ(json["left_out"].size(), 1u);
  EXPECT_EQ(json["pulls"].size(), 23u);
  EXPECT_EQ(json["simulated"], 30);
  const std::string figure = figures::calibration_figure(c);
  for (const char* part : {"III", "R100_mystique_0", "Phases of R100_forest_0", "SIMULATED"})
    EXPECT_THAT(figure, HasSubstr(part));
}

TEST(Calibration, RefusesOneTrialUnderTwoNames) {
  const TempFolder folder;
  const std::string text = trial_file_text(programme().trials.at(0));
  folder.write("a.csv", text);
  folder.write("b.csv", text);
  try {
    calibrate(read_trials(folder.path()), folder.path());
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), testing::AllOf(HasSubstr("b.csv: has the same content as "),
                                             HasSubstr("a.csv; one trial must not count twice")));
  }
}

TEST(Calibration, MakesCasterFilesThatLoad) {
  const TempFolder folder;
  const Calibration c = calibrate(programme(), "made");
  std::vector<std::string> without;
  const std::vector<CasterFile> files = caster_files(c, "", without);
  ASSERT_EQ(files.size(), 4u);
  EXPECT_THAT(without.at(0), HasSubstr("homemade: the catalogue has no caster 'homemade'"));
  for (const CasterFile& each : files) {
    const std::string file = folder.write(each.name, each.text);
    const equipment::CheckedFile checked = equipment::check_data_file(file);
    EXPECT_TRUE(checked.warnings.empty());
    EXPECT_EQ(each.calibrated, std::vector<std::string>{"tread.rolling_resistance_mm"});
    const equipment::CasterType made = equipment::load_caster_type(file).stated();
    const bool large = each.name.starts_with("R125");
    EXPECT_NEAR(made.properties.tread.rolling_friction_length, 1e-3, 5e-5);
    EXPECT_EQ(made.properties.wheel_radius, large ? 0.0625 : 0.05);
    EXPECT_THAT(each.text, HasSubstr("SIMULATED, not measured: gurney calibrate, Cr/R of R1"));
    // All else is the base's.
    const equipment::CasterType base =
        equipment::load_caster_type(
            find_data(equipment::DataKind::kCaster, large ? "R125" : "R100", ""))
            .stated();
    EXPECT_EQ(made.properties.tread.patch_width, base.properties.tread.patch_width);
    EXPECT_EQ(made.properties.fork_inertia, base.properties.fork_inertia);
    EXPECT_EQ(made.brake_torque, base.brake_torque);
    EXPECT_EQ(made.assumptions.size() + 1, base.assumptions.size());
  }
  without.clear();
  const auto based = caster_files(c, "R100", without);
  EXPECT_EQ(based.size(), 4u);  // wheels of R125 are not those of R100
  EXPECT_THAT(without.at(0), HasSubstr("R125: its wheels have 125 mm in the trials, but 100 mm"));
}

TEST(Calibration, UsesOnlyTrialsForCalibration) {
  TrialSet set = programme();
  for (Trial& trial : set.trials) trial.setup.use = TrialUse::kValidation;
  EXPECT_THAT(error_text([&] { calibrate(set, "made"); }),
              HasSubstr("made: no trial with use = calibration can be used\nmade.csv: (M + J)"));
  set = programme();
  const double before = constant(calibrate(set, "made"), "Cr/R of R100 on forest").value;
  for (Trial& trial : set.trials)  // a validation trial that resists more
    if (trial.name == "R100_forest_4") trial.setup.string_tension = 0;
  const Calibration after = calibrate(set, "made");
  EXPECT_EQ(constant(after, "Cr/R of R100 on forest").value, before);
  EXPECT_GT(after.predictions[0].misfit(), 0.02);
}

TEST(Calibration, NamesOutliersAndKeepsThem) {
  TrialSet set = programme();
  for (Trial& trial : set.trials)
    if (trial.name == "R125_forest_1") trial.setup.string_tension = 8;  // it was 1 N
  const Calibration c = calibrate(set, "made");
  EXPECT_EQ(constant(c, "Cr/R of R125 on forest").trials.size(), 4u);
  const std::string text = render::text(report::calibration_findings(report::calibration_facts(c)));
  EXPECT_THAT(text, HasSubstr("Outliers (kept"));
  EXPECT_THAT(text, ContainsRegex("R125_forest_1 +Cr/R of R125 on forest +0\\.01"));
}

TEST(Calibration, TakesTablesOfAverages) {
  TrialSet set;
  for (int i = 0; i < 4; ++i) {
    const SyntheticPull made;
    TrialAverages a;
    a.name = "t" + std::to_string(i);
    a.file = "averages.csv";
    a.line = i + 5;
    a.setup = make_pull(made).setup;
    a.pull_force = made.force;
    a.pull_acceleration = made.a2() * (i == 3 ? 1000 : 1);
    a.coast_deceleration = made.a3() * (1 + 0.01 * i);
    set.averages.push_back(a);
  }
  const Calibration c = calibrate(set, "averages.csv");
  EXPECT_EQ(c.constants.at(0).trials.size(), 3u);
  EXPECT_NEAR(c.constants[0].value, 0.0201, 1e-4);  // half of a3's mean excess of 1 %
  EXPECT_THAT(c.left_out.at(0).text(), HasSubstr("averages.csv:8: (M + J)(a_2 + a_3) is"));
  EXPECT_THAT(figures::calibration_figure(c), HasSubstr("Each point is a pull."));
}

TEST(CalibrationReport, AsksWhetherNamesThatLookAlikeAreOne) {
  TrialSet set = programme();  // of R100 and R125, which are two
  set.trials[7].setup.floor = "mystiqe";
  const Calibration c = calibrate(std::move(set), "alike");
  const std::string text =
      render::text(report::calibration_findings(report::calibration_facts(c, {})));
  EXPECT_THAT(text,
              HasSubstr("floor 'mystiqe' (1 of 30 trials) and floor 'mystique' (14) are taken"));
  EXPECT_THAT(text, Not(HasSubstr("caster 'R100'")));
}

}  // namespace
}  // namespace gurney::calibration
