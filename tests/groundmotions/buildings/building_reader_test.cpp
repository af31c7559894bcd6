#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

#include "groundmotions/buildings/building.h"
#include "groundmotions/buildings/modal_building.h"
#include "tests/support/error_text.h"
#include "tests/support/key_table.h"

namespace gurney::groundmotions {
namespace {

using std::numbers::pi;
using testing::HasSubstr;

Building read(const std::string& text) {
  config::Document document(text, "b.toml");
  config::Table table = document.root();
  const Building building = read_building(table);
  document.finish();
  return building;
}

std::string errors(const std::string& text) {
  return error_text([&] { read(text); });
}

const std::string kShear =
    "kind = 'shear'\nstoreys = 3\nperiod_s = [0.5, 0.6]\ndamping_ratio = 0.05\n";

TEST(BuildingReader, ReadsAShearBuilding) {
  const Building building = read(kShear);
  EXPECT_EQ(building.storeys, 3);
  ASSERT_EQ(building[Direction::kH1].size(), 3U);
  EXPECT_NEAR(building[Direction::kH1][0].omega, 2 * pi / 0.5, 1e-12);
  EXPECT_NEAR(building[Direction::kH2][0].omega, 2 * pi / 0.6, 1e-12);
  EXPECT_EQ(building[Direction::kH2][2].damping, 0.05);
  EXPECT_TRUE(building[Direction::kVertical].empty());
  EXPECT_FALSE(building.isolation.has_value());
}

TEST(BuildingReader, ReadsStoreyStiffnesses) {
  const Building building = read(
      "kind = 'shear'\nstoreys = 2\ndamping_ratio = 0.05\nmodes = 1\n"
      "storey_mass_kg = [1e5, 1e5]\nstorey_stiffness_h1_n_per_m = [1e8, 1e8]\n"
      "storey_stiffness_h2_n_per_m = [4e8, 4e8]\n");
  ASSERT_EQ(building[Direction::kH1].size(), 1U);
  const double omega = 2 * std::sqrt(1e3) * std::sin(pi / 10);
  EXPECT_NEAR(building[Direction::kH1][0].omega, omega, 1e-10);
  EXPECT_NEAR(building[Direction::kH2][0].omega, 2 * omega, 1e-10);
}

TEST(BuildingReader, ReadsModes) {
  const Building building = read(
      "kind = 'modal'\nstoreys = 2\n"
      "h1 = [{ period_s = 0.5, damping_ratio = 0.05, effective_shape = [0.7, 1.2] }]\n"
      "vertical = [{ period_s = 0.1, damping_ratio = 0.02, effective_shape = [1, 1] }]\n");
  EXPECT_EQ(building[Direction::kH1][0].effective_shape, Eigen::Vector3d(0, 0.7, 1.2));
  EXPECT_NEAR(building[Direction::kH1][0].omega, 4 * pi, 1e-12);
  EXPECT_TRUE(building[Direction::kH2].empty());
  EXPECT_EQ(building[Direction::kVertical].size(), 1U);
}

TEST(BuildingReader, ReadsIsolation) {
  const Building lead = read(kShear +
                             "[isolation]\nkind = 'lead_rubber'\nperiod_s = 2.5\n"
                             "strength_ratio = 0.06\nyield_displacement_mm = 10\n"
                             "base_mass_ratio = 0.2\ndisplacement_capacity_mm = 500\n");
  ASSERT_TRUE(lead.isolation.has_value());
  EXPECT_EQ(lead.isolation->yield_displacement, 0.01);
  EXPECT_EQ(lead.isolation->capacity, 0.5);
  EXPECT_EQ(lead.isolation->base_mass_ratio, 0.2);
  const Building pendulum = read(kShear +
                                 "[isolation]\nkind = 'friction_pendulum'\nradius_m = 2\n"
                                 "friction_slow = 0.03\nfriction_fast = 0.06\n"
                                 "friction_rate_s_per_m = 50\nvertical_load = false\n"
                                 "base_mass_ratio = 0.2\n");
  EXPECT_EQ(pendulum.isolation->strength_rate, 50);
  EXPECT_FALSE(pendulum.isolation->follows_vertical);
  EXPECT_TRUE(std::isinf(pendulum.isolation->capacity));
}

TEST(BuildingReader, ShippedBuildingsAreRead) {
  const std::string folder = std::string(GURNEY_SOURCE_DIR) + "/groundmotions/buildings/";
  const Building fixed = building_from_file(folder + "concrete_hospital.toml");
  EXPECT_EQ(fixed.storeys, 4);
  EXPECT_NEAR(2 * pi / fixed[Direction::kH1][0].omega, 0.565, 1e-3);
  EXPECT_NEAR(fixed[Direction::kVertical].at(0).omega, 2 * pi * 10.7, 1e-12);
  const Building lead = building_from_file(folder + "lead_rubber_hospital.toml");
  EXPECT_EQ(lead.isolation->name, "lead rubber");
  const Building pendulum = building_from_file(folder + "friction_pendulum_hospital.toml");
  EXPECT_NEAR(2 * pi / std::sqrt(pendulum.isolation->stiffness), 3, 1e-3);
}

TEST(BuildingReader, ReadsVerticalFloorsOnColumns) {
  const Building building = read(kShear +
                                 "[vertical]\nfloor_frequency_hz = 10\ndamping_ratio = 0.03\n"
                                 "column_frequency_hz = 20\n");
  ASSERT_EQ(building[Direction::kVertical].size(), 6U);
  EXPECT_LT(building[Direction::kVertical][0].omega, 2 * pi * 10);
  EXPECT_EQ(building[Direction::kVertical][5].damping, 0.03);
}

TEST(BuildingReader, FloorsAreNumbersOrTheRoof) {
  const Building building = read(kShear);
  const auto floor = [&](const std::string& text) {
    config::Document document(text, "b.toml");
    config::Table table = document.root();
    const int result = read_floor(table, building);
    document.finish();
    return result;
  };
  EXPECT_EQ(floor("floor = 0"), 0);
  EXPECT_EQ(floor("floor = 3"), 3);
  EXPECT_EQ(floor("floor = 'roof'"), 3);
  EXPECT_EQ(error_text([&] { floor("floor = 4"); }),
            "b.toml:1:9: floor = 4: must be a whole number in 0..3");
  EXPECT_EQ(error_text([&] { floor("floor = 'rof'"); }),
            "b.toml:1:9: floor = \"rof\": must be \"roof\" or a whole number in 0..3");
}

TEST(BuildingReader, SaysEveryErrorInOnePass) {
  EXPECT_EQ(
      errors("kind = 'shaer'\nstoreys = 0\n"),
      "b.toml:1:1: damping_ratio: missing; must be a finite number >= 0 and <= 0.99\n"
      "b.toml:1:1: period_s: missing; must be a finite number > 0\n"
      "b.toml:1:8: kind = \"shaer\": must be one of shear, generic, modal, tables; did you mean "
      "'shear'?\n"
      "b.toml:2:11: storeys = 0: must be a whole number in 1..200");
}

TEST(BuildingReader, RefusesKeysThatContradictEachOther) {
  EXPECT_THAT(errors(kShear + "storey_stiffness_h1_n_per_m = [1, 1, 1]\n"
                              "storey_stiffness_h2_n_per_m = [1, 1, 1]\n"),
              testing::AllOf(HasSubstr("period_s: must not be given with storey stiffnesses"),
                             HasSubstr("storey_mass_kg: missing; storey stiffnesses need masses")));
  const std::string generic = "kind = 'generic'\nstoreys = 3\ndamping_ratio = 0.05\n";
  EXPECT_THAT(errors(generic + "period_s = 1\nframe = 'other'\nheight_m = 9\n"),
              HasSubstr("period_s: must not be given with frame"));
  EXPECT_THAT(errors(generic + "period_s = 1\nheight_m = 9\n"),
              HasSubstr("height_m: must not be given with period_s"));
}

TEST(BuildingReader, RefusesImpossibleValues) {
  EXPECT_THAT(errors(kShear + "rayleigh_modes = [2, 1]\n"),
              HasSubstr("b.toml:5:18: rayleigh_modes = [2, 1]: must be two whole numbers, the "
                        "first lower"));
  // With omega_2 = 2.998 omega_1, omega_8 = 14.79 omega_1: 0.3 (2.998 / 14.79 + 14.79) / 3.998
  // = 1.12.
  EXPECT_EQ(errors("kind = 'shear'\nstoreys = 40\nperiod_s = 4\ndamping_ratio = 0.3\n"
                   "rayleigh_modes = [1, 2]\n"),
            "b.toml:5:18: rayleigh_modes: gives mode 8 the damping ratio 1.12; must be below 1: "
            "choose a higher second mode, or fewer `modes`");
  EXPECT_THAT(errors(kShear + "[isolation]\nkind = 'friction_pendulum'\nradius_m = 2\n"
                              "friction_slow = 0.07\nfriction_fast = 0.06\n"
                              "friction_rate_s_per_m = 50\nbase_mass_ratio = 0.2\n"),
              HasSubstr("isolation.friction_fast = 0.06: must be at least friction_slow = 0.07"));
  const std::string mode = "{ damping_ratio = 0.05, effective_shape = [1], ";
  EXPECT_THAT(errors("kind = 'modal'\nstoreys = 1\nh1 = [" + mode + "period_s = 0.5 }, " + mode +
                     "period_s = 0.6 }]\n"),
              HasSubstr("h1[1].period_s = 0.6: must be shorter than that of the mode before, 0.5"));
  EXPECT_THAT(errors("kind = 'modal'\nstoreys = 1\nh1 = [" + mode +
                     "period_s = 0.5 }]\n[isolation]\nkind = 'linear'\nperiod_s = 2\n"
                     "damping_ratio = 0.1\nbase_mass_ratio = 0.2\n"),
              HasSubstr("h1: effective_mass_ratio must be > 0 for each mode of an isolated"));
}

TEST(BuildingReader, ReadsRotationOfTheFloors) {
  const Building building = read(kShear + "[floor_rotation]\nheight_m = 12\nbending_share = 0.5\n");
  const Mode& mode = building[Direction::kH2][0];
  ASSERT_EQ(mode.effective_rotation.size(), 4);
  EXPECT_NEAR(mode.effective_rotation[1], 0.5 * mode.effective_shape[2] / 8, 1e-15);
  EXPECT_TRUE(rocks(building, 3));
  EXPECT_FALSE(rocks(building, 0));
  EXPECT_FALSE(rocks(read(kShear), 3));
  const Building modal = read(
      "kind = 'modal'\nstoreys = 2\nh1 = [{ period_s = 0.5, damping_ratio = 0.05, effective_shape "
      "= [0.7, 1.2], effective_rotation_rad_per_m = [0.1, 0.15] }]\n");
  EXPECT_EQ(modal[Direction::kH1][0].effective_rotation, Eigen::Vector3d(0, 0.1, 0.15));
  const std::string folder = std::string(GURNEY_SOURCE_DIR) + "/groundmotions/buildings/";
  EXPECT_TRUE(rocks(building_from_file(folder + "wall_hospital.toml"), 6));
}

TEST(BuildingReader, RefusesRotationsWithTheirPlace) {
  const std::string table = kShear + "[floor_rotation]\n";
  EXPECT_EQ(errors(table + "height_m = 12\nbending_share = 1.5\n"),
            "b.toml:7:17: floor_rotation.bending_share = 1.5: must be a finite number "
            ">= 0 and <= 1");
  EXPECT_EQ(errors(table + "height_m = -3\nbending_share = 1\n"),
            "b.toml:6:12: floor_rotation.height_m = -3: must be a finite number > 0");
  EXPECT_THAT(errors(table + "bending_share = 1\n"), HasSubstr("floor_rotation.height_m: missing"));
  EXPECT_THAT(errors(table + "height_m = 12\nbending_share = 1\nbend_share = 1\n"),
              HasSubstr("did you mean 'bending_share'?"));
  EXPECT_THAT(errors("kind = 'generic'\nstoreys = 3\ndamping_ratio = 0.05\nframe = 'other'\n"
                     "height_m = 9\n[floor_rotation]\nheight_m = 9\nbending_share = 1\n"),
              HasSubstr("floor_rotation.height_m: must not be given with the height_m of a frame"));
  EXPECT_THAT(
      errors("kind = 'modal'\nstoreys = 1\nvertical = [{ period_s = 0.5, damping_ratio = "
             "0.05, effective_shape = [1], effective_rotation_rad_per_m = [1] }]\n"),
      HasSubstr("vertical[0].effective_rotation_rad_per_m: must go with a mode of h1 or h2"));
  EXPECT_THAT(errors("kind = 'modal'\nstoreys = 2\nh1 = [{ period_s = 0.5, damping_ratio = "
                     "0.05, effective_shape = [1, 1], effective_rotation_rad_per_m = [1] }]\n"),
              HasSubstr("h1[0].effective_rotation_rad_per_m"));
}

TEST(BuildingReader, UnknownKeysAreErrors) {
  EXPECT_THAT(errors(kShear + "storey = 3\n"), HasSubstr("storey"));
  EXPECT_THAT(errors(kShear + "dampin_ratio = 3\n"), HasSubstr("did you mean 'damping_ratio'?"));
}

TEST(BuildingReader, ReadsFloorsThatTwist) {
  const std::string torsion = "[torsion]\nradius_of_gyration_m = 9\nfrequency_ratio = 1.2\n";
  const Building building = read(kShear + torsion + "eccentricity_h1_m = [1, 2, 1]\n");
  ASSERT_EQ(building.torsion.size(), 9U);
  EXPECT_EQ(building.torsion.back().damping, 0.05);
  // Along h1 nothing is coupled.
  const auto uncoupled = [](const TorsionMode& mode) {
    return std::abs(mode.omega - 2 * pi / 0.5) < 1e-10;
  };
  EXPECT_TRUE(std::ranges::any_of(building.torsion, uncoupled));
  EXPECT_TRUE(read(kShear + torsion).torsion.empty());  // no eccentricity: does not twist
  const auto errors_with = [&](const std::string& more) {
    return errors(kShear + more + torsion + "eccentricity_h2_m = 1\n");
  };
  EXPECT_THAT(errors_with("modes = 2\n"), HasSubstr("modes: must not be given with torsion"));
  EXPECT_THAT(errors_with("[floor_rotation]\nheight_m = 9\nbending_share = 1\n"),
              HasSubstr("floor_rotation: must not be given with torsion"));
  EXPECT_THAT(errors(kShear + torsion + "eccentricity_h1_m = [1, 2]\n"),
              HasSubstr("torsion.eccentricity_h1_m = [1, 2]: must be an array of 3 numbers"));
}

TEST(BuildingReader, ReadsStoreysThatYield) {
  const Building building = read(kShear +
                                 "[yield]\nheight_m = 12\ndrift_ratio = [0.01, 0.008, 0.005]\n"
                                 "hardening_ratio = 0.05\n");
  ASSERT_TRUE(building.yielding);
  EXPECT_EQ(building.height, 12);
  const YieldingStoreys& storeys = *building.yielding;
  EXPECT_TRUE(storeys.yield_drift.isApprox(Eigen::Vector3d(0.04, 0.032, 0.02), 1e-15));
  EXPECT_EQ(storeys.hardening, 0.05);
  EXPECT_EQ(storeys.damping[1], Eigen::Vector3d::Constant(0.05));
  // Its elastic stiffness has the stated periods.
  for (std::size_t i = 0; i < 2; ++i)
    EXPECT_NEAR(modes_of(storeys.mass, shear_stiffness(storeys.stiffness[i])).front().omega,
                building.axes[i].front().omega, 1e-10);
}

TEST(BuildingReader, ReadsPinchedStoreys) {
  const std::string yield =
      kShear + "[yield]\nheight_m = 12\ndrift_ratio = 0.01\nhardening_ratio = 0.05\n";
  EXPECT_FALSE(read(yield).yielding->pinching);
  const Building building =
      read(yield + "pinching_drift_ratio = 0.8\npinching_force_ratio = 0.25\n");
  ASSERT_TRUE(building.yielding && building.yielding->pinching);
  EXPECT_EQ(building.yielding->pinching->drift, 0.8);
  EXPECT_EQ(building.yielding->pinching->force, 0.25);
}

// K_t = Omega^2 r^2 K_x = K_x b^2 + K_y a^2, with K_y = 4 K_x here: the period along h2 is half as long.
TEST(BuildingReader, ReadsStoreysThatYieldAndTwist) {
  const std::string yield = "[yield]\nheight_m = 12\ndrift_ratio = 0.01\nhardening_ratio = 0.05\n";
  const std::string torsion =
      "[torsion]\nradius_of_gyration_m = 6\nfrequency_ratio = 1.5\neccentricity_h1_m = 2\n";
  const std::string shear =
      "kind = 'shear'\nstoreys = 3\nperiod_s = [1, 0.5]\ndamping_ratio = 0.05\n";
  const Building alike = read(shear + yield + torsion);
  ASSERT_TRUE(alike.yielding && alike.yielding->twist);
  const YieldingTwist& twist = *alike.yielding->twist;
  EXPECT_TRUE(twist.columns.isApprox(Eigen::Matrix2Xd::Constant(2, 3, 9 / std::sqrt(5)), 1e-12));
  EXPECT_EQ(twist.damping, Eigen::VectorXd::Constant(9, 0.05));
  EXPECT_EQ(twist.eccentricity.row(0), Eigen::RowVector3d::Constant(2));
  const std::string far = "column_distance_h1_m = 4\n";
  const Building stated = read(shear + yield + far + torsion);
  EXPECT_TRUE(stated.yielding->twist->columns.row(1).isApprox(
      Eigen::RowVector3d::Constant(std::sqrt(81.0 - 4 * 16)), 1e-12));
  // At 4.5 m along h1 the columns have all of the stiffness.
  EXPECT_EQ(errors(shear + yield + "column_distance_h1_m = 5\n" + torsion),
            "b.toml:9:24: yield.column_distance_h1_m = 5: must be a finite number >= 0 and <= 4.5");
  EXPECT_THAT(errors(shear + yield + far),
              HasSubstr("column_distance_h1_m: must not be given with storeys that do not twist"));
  const Building straight =
      read(shear + yield + far + "[torsion]\nradius_of_gyration_m = 6\nfrequency_ratio = 1.5\n");
  EXPECT_FALSE(straight.yielding->twist);
}

TEST(BuildingReader, RefusesYieldThatMeansNothing) {
  const std::string yield = "[yield]\nheight_m = 12\nhardening_ratio = 0.05\n";
  EXPECT_EQ(errors(kShear + yield + "drift_ratio = 1.5\n"),
            "b.toml:8:15: yield.drift_ratio = 1.5: must be a finite number > 0 and <= 1");
  EXPECT_THAT(errors(kShear + yield), HasSubstr("yield.drift_ratio: missing"));
  EXPECT_THAT(errors(kShear + yield + "drift_ratio = [0.01, 0.01]\n"), HasSubstr("drift_ratio"));
  const std::string right = yield + "drift_ratio = 0.01\n";
  EXPECT_THAT(errors(kShear + "modes = 2\n" + right),
              HasSubstr("modes: must not be given with yield"));
  EXPECT_THAT(errors(kShear + right + "[floor_rotation]\nheight_m = 12\nbending_share = 1\n"),
              HasSubstr("floor_rotation: must not be given with yield"));
  EXPECT_THAT(errors(kShear + right +
                     "[isolation]\nkind = 'linear'\nperiod_s = 2\n"
                     "damping_ratio = 0.1\nbase_mass_ratio = 0.2\n"),
              HasSubstr("isolation: must not be given with yield"));
  EXPECT_THAT(errors("kind = 'generic'\nstoreys = 3\nperiod_s = 1\ndamping_ratio = 0\n" + right),
              HasSubstr("yield"));
  EXPECT_THAT(errors(kShear + right + "pinching_drift_ratio = 0.8\n"),
              HasSubstr("yield.pinching_force_ratio: missing"));
  EXPECT_EQ(errors(kShear + right + "pinching_drift_ratio = 2\npinching_force_ratio = 0\n"),
            "b.toml:9:24: yield.pinching_drift_ratio = 2: must be a finite number >= 0 and <= 1\n"
            "b.toml:10:24: yield.pinching_force_ratio = 0: must be a finite number > 0 and <= 1");
}

/// Keys asked for by a building with everything in it; the last part of each.
std::set<std::string> asked(const std::string& text) {
  config::Document document(text, "b.toml");
  config::Table table = document.root();
  read_building(table);
  std::set<std::string> keys;
  for (const std::string& key : document.asked_keys()) keys.insert(key.substr(key.rfind('.') + 1));
  return keys;
}

TEST(BuildingReader, EveryKeyIsDocumented) {
  const std::string page = std::string(GURNEY_SOURCE_DIR) + "/docs/formats/building_file.md";
  const auto documented = [&](std::initializer_list<const char*> sections) {
    std::set<std::string> keys;
    for (const char* section : sections) keys.merge(documented_keys(page, section));
    return keys;
  };
  const std::string isolation =
      "[isolation]\nkind = 'friction_pendulum'\n[vertical]\nfloor_frequency_hz = 10\n"
      "[floor_rotation]\nbending_share = 1\n";
  std::set<std::string> shear = asked("kind = 'shear'\nperiod_s = 1\n" + isolation);
  shear.merge(
      asked("kind = 'shear'\nstorey_stiffness_h1_n_per_m = [1]\n"
            "[isolation]\nkind = 'lead_rubber'\n"));
  const std::string torsion =
      "[torsion]\neccentricity_h1_m = 1\nradius_of_gyration_m = 5\nfrequency_ratio = 1\n";
  shear.merge(asked(kShear + "[yield]\ndrift_ratio = 0.01\n" + torsion));
  EXPECT_EQ(shear, documented({"All buildings", "Shear", "Yield", "Floor rotation", "Torsion",
                               "Vertical", "Isolation"}));
  std::set<std::string> generic = asked("kind = 'generic'\nframe = 'other'\n" + isolation);
  generic.merge(asked("kind = 'generic'\n[isolation]\nkind = 'lead_rubber'\n"));
  generic.merge(
      asked("kind = 'generic'\nstoreys = 2\nperiod_s = 1\ndamping_ratio = 0\n" + torsion));
  EXPECT_EQ(generic, documented({"All buildings", "Generic", "Floor rotation", "Torsion",
                                 "Vertical", "Isolation"}));
  const std::set<std::string> modal =
      asked("kind = 'modal'\nh1 = [{ period_s = 1, effective_rotation_rad_per_m = [] }]\n");
  EXPECT_EQ(modal, documented({"All buildings", "Modal"}));
  EXPECT_EQ(asked("kind = 'tables'\ntime_step_s = 0.01\n"), documented({"Tables"}));
}

}  // namespace
}  // namespace gurney::groundmotions
