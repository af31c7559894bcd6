#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "studies/job/job.h"
#include "studies/plan/study_job.h"
#include "tests/studies/job/job_text.h"
#include "tests/support/error_text.h"

namespace gurney::study {
namespace {

constexpr const char* kHead = "schema = \"gurney-job/1\"\n[item]\nequipment = \"icu_ventilator\"\n";

std::string errors(const std::string& text) { return errors_of_text(kHead + text); }

std::string errors_of_study(const std::string& text) {
  return error_text([&] { StudyJob(kHead + text, "a.toml"); });
}

TEST(InputsWithoutEffect, SettingsOfASolverThatIsNotUsed) {
  EXPECT_EQ(errors("[settings]\nresidual = 1e-6\nmax_newton_iterations = 50\n"), "(no error)");
  EXPECT_EQ(errors("[settings]\nsolver = \"bullet\"\nresidual = 1e-6\n"
                   "max_newton_iterations = 50\nmax_subdivisions = 3\n"
                   "skip_clear_collision_passes = false\n"),
            "a.toml:6:12: settings.residual: has no effect with the solver \"bullet\"\n"
            "a.toml:7:25: settings.max_newton_iterations: has no effect with the solver "
            "\"bullet\"\n"
            "a.toml:8:20: settings.max_subdivisions: has no effect with the solver \"bullet\"\n"
            "a.toml:9:31: settings.skip_clear_collision_passes: has no effect with the solver "
            "\"bullet\"");
}

TEST(InputsWithoutEffect, WarnsWhereADurationEndsTheRun) {
  const std::string text = std::string(kHead) + "[settings]\nduration_s = 3\nrest_hold_s = 1\n";
  EXPECT_THAT(job_of_text(text).warnings,
              testing::Contains("settings.rest_hold_s: no effect beside duration_s, which ends the "
                                "run"));
  EXPECT_EQ(errors("[settings]\nduration_s = 3\nsettle_time_s = 0\n"), "(no error)");
}

TEST(InputsWithoutEffect, AFactorOnTheRotationOfFloorsThatStayLevel) {
  const auto job = [](const std::string& building) {
    return "[excitation]\nrecord.synthetic.kind = \"ac156\"\n[excitation.building]\n"
           "kind = \"shear\"\nstoreys = 2\nperiod_s = 0.5\ndamping_ratio = 0.05\n"
           "floor = \"roof\"\nrotation_factor = 2\n" +
           building;
  };
  EXPECT_EQ(errors(job("")),
            "a.toml:12:19: excitation.building.rotation_factor: has no effect on a floor that does "
            "not rotate: the building has no floor_rotation");
  EXPECT_EQ(errors(job("floor_rotation = { height_m = 8, bending_share = 1 }\n")), "(no error)");
}

TEST(InputsWithoutEffect, TheSpacingOfHistoriesThatAreNotKept) {
  EXPECT_EQ(errors("[output]\nhistories = false\nhistory_step_s = 0.02\n"),
            "a.toml:6:18: output.history_step_s: has no effect with histories = false");
}

TEST(InputsWithoutEffect, WheelsOfAnItemWithoutThem) {
  EXPECT_EQ(errors("[initial]\nwheels_roll = false\n"), "(no error)");
  EXPECT_EQ(errors_of_text("schema = \"gurney-job/1\"\n[item]\nequipment = \"bookcase\"\n"
                           "[initial]\nwheels_roll = false\n"),
            "a.toml:5:15: initial.wheels_roll: has no effect on an item without casters");
}

constexpr const char* kStudy = R"([settings]
residual = 1e-6
[study]
[[study.factor]]
name = "solver"
key = "settings.solver"
)";

TEST(InputsWithoutEffect, AreErrorsOfAStudyWhereNoConfigurationNeedsThem) {
  EXPECT_EQ(errors_of_study(std::string(kStudy) + "values = [\"implicit\", \"bullet\"]\n"),
            "(no error)");
  EXPECT_EQ(errors_of_study(std::string(kStudy) + "values = [\"bullet\"]\n"),
            "a.toml:5:12: settings.residual: has no effect with the solver \"bullet\"");
}

TEST(InputsWithoutEffect, AHeadingForAllWhereOneConfigurationHasOnlyRigidWheels) {
  const std::string cart = R"(schema = "gurney-job/1"
[item.inline]
name = "cart"
chassis = { mass_kg = 30, center_of_mass_mm = [0, 0, 400], inertia_box_mm = [600, 400, 800] }
shape = [{ center_mm = [0, 0, 400], size_mm = [600, 400, 800] }]
caster = [
  { type = "R100", position_mm = [250, 150, 0] },
  { type = "R100", position_mm = [250, -150, 0] },
  { type = "R100", position_mm = [-250, 0, 0] },
]
[item]
headings_deg = 90
[study]
[[study.factor]]
name = "wheels"
)";
  const std::string rigid =
      "[study.factor.level.rigid]\nitem.inline.caster.\"*\".swivels = false\n";
  const std::string free = "[study.factor.level.free]\nitem.inline.caster.\"*\".swivels = true\n";
  EXPECT_EQ(error_text([&] { StudyJob(cart + rigid + free, "a.toml"); }), "(no error)");
  EXPECT_EQ(error_text([&] { StudyJob(cart + rigid, "a.toml"); }),
            "a.toml:12:16: item.headings_deg: has no effect: no caster of cart swivels");
}

TEST(InputsWithoutEffect, DrawsOfAJobThatHasNothingToDraw) {
  const std::string block = R"(schema = "gurney-job/1"
[item.inline]
name = "block"
chassis = { mass_kg = 30, center_of_mass_mm = [0, 0, 400], inertia_box_mm = [600, 400, 800] }
shape = [{ center_mm = [0, 0, 400], size_mm = [600, 400, 800] }]
contact = { material = "wood", friction = 0.4, stiffness_n_per_m = 1e6, restitution = 0.3 }
[floor]
slope = 0  # its usual values have a distribution
)";
  EXPECT_EQ(errors_of_text(block), "(no error)");
  EXPECT_EQ(errors_of_text(block + "[uncertainty]\ndraw = 2\n"),
            "a.toml:9:1: uncertainty: has no effect: no parameter of the job has a distribution");
  EXPECT_EQ(error_text([&] { StudyJob(block + "[study]\ndraws = 3\n", "a.toml"); }),
            "a.toml:10:9: study.draws: has no effect: no parameter of the job has a distribution");
}

}  // namespace
}  // namespace gurney::study
