#include "studies/job/job.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "engine/base/units.h"
#include "tests/studies/job/job_text.h"
#include "tests/support/error_text.h"
#include "tests/support/key_table.h"
#include "tests/support/temp_folder.h"

namespace gurney::study {
namespace {

constexpr const char* kHead = "schema = \"gurney-job/1\"\n[item]\nequipment = \"icu_ventilator\"\n";

/// A job with every key there is.
constexpr const char* kEverything = R"toml(schema = "gurney-job/1"
title = "everything"
[item]
casters = "R125"
headings_deg = [0, 90, 180]
brakes = [true, false, false]
swivel_locks = false
payloads = { load = 2 }
position_m = [1, 2]
yaw_deg = 30
[item.inline]
name = "cart"
chassis = { mass_kg = 50, center_of_mass_mm = [0, 0, 400], inertia_box_mm = [600, 500, 800] }
shape = [{ center_mm = [0, 0, 400], size_mm = [600, 500, 800] }]
caster = [
  { type = "R100", position_mm = [250, 200, 0] },
  { type = "R100", position_mm = [250, -200, 0] },
  { type = "R100", position_mm = [-250, 0, 0] },
]
payload = [{ name = "load", mass_kg = 5, size_mm = [100, 100, 100], position_mm = [0, 0, 100] }]
[uncertainty]
draw = 3
[floor]
covering = "polyflor_forest_fx"
slope = 0.005
gravity_m_per_s2 = 9.81
[excitation.record]
x = "record_x.at2"
z = "record_z.at2"
use = "x"
scale_to = { measure = "Sa(1.0)", component = "h1", value = 0.2, unit = "g", vertical = "kept" }
processing = [{ step = "baseline", kind = "mean" }, { step = "high_pass", corner_hz = 0.1 }]
plausibility = "refuse"
angle_deg = 45
unit = "cm/s2"
time_step_s = 0.01
[excitation.building]
kind = "shear"
storeys = 3
period_s = 0.5
damping_ratio = 0.05
floor = 2
rotation_factor = 0.5
floor_rotation = { height_m = 10, bending_share = 0.5 }
[[excitation.force]]
point_m = [0, 0, 1]
direction = [0, 2, 0]
force_n = 40
from_s = 1
until_s = 3
speed_limit_m_per_s = 0.8
[[excitation.force]]
name = "push"
point_m = [0, 0, 1]
direction = [1, 0, 0]
force_n = [0, 10, 0]
time_s = [0, 1, 1.5]
[[excitation.drop_weight]]
point_m = [0.5, 0, 0.1]
direction = [1, 0, 0]
mass_kg = 5
drop_height_m = 1
pulley_inertia_kg_m2 = 1e-4
pulley_radius_m = 0.04
potentiometer_tension_n = 1
cable_stiffness_n_per_m = 1e5
cable_damping_n_s_per_m = 100
[[excitation.string_potentiometer]]
point_m = [-0.5, 0, 0.1]
direction = [-1, 0, 0]
tension_n = { value = 2, assumption = "a guess", range = [0, 3] }
[[excitation.blocks]]
point_m = [0.5, 0, 0.05]
stiffness_n_per_m = 1e6
damping_n_s_per_m = 1e3
release_time_s = 0.5
[fixture]
x = { velocity_m_per_s = 0.4 }
y = { stiffness_n_per_m = 100, damping_n_s_per_m = 2 }
z = { stiffness_n_per_m = 100 }
roll = "held"
pitch = "free"
yaw = { velocity_deg_per_s = 90 }
[initial]
velocity_m_per_s = [1, 0, 0]
yaw_rate_deg_per_s = 180
wheels_roll = false
[settings]
solver = "implicit"
time_step_s = 0.002
tolerance = 0.02
residual = 1e-8
max_newton_iterations = 50
max_subdivisions = 5
settle_time_s = 10
duration_s = 12
rest_speed_m_per_s = 0.002
rest_hold_s = 1
overturn_tilt_deg = 45
skip_clear_collision_passes = false
[output]
histories = true
history_step_s = 0.02
)toml";

/// What needs another solver than kEverything has.
constexpr const char* kRoomAndTether = R"toml(position_m = [2, 0]
[room]
file = "icu_bay"
[[tether]]
name = "cord"
item = "icu_ventilator"
kind = "power_cord"
point_m = [0, 0, 0.5]
anchor_m = [0, 1, 0.5]
slack_length_m = 3
)toml";

/// kEverything with its records beside it.
std::string write_everything(const TempFolder& folder) {
  folder.write("record_x.at2", "");
  folder.write("record_z.at2", "");
  return folder.write("job.toml", kEverything);
}

TEST(Job, ReadsTheItemAndItsPlace) {
  const TempFolder folder;
  const Job job = read_job(write_everything(folder));
  EXPECT_EQ(job.title, "everything");
  EXPECT_EQ(job.text, kEverything);
  const EquipmentModel& item = job.scene.items[0].model;
  EXPECT_EQ(item.name, "cart");
  EXPECT_EQ(item.casters[0].wheel_radius, 0.0625);
  EXPECT_DOUBLE_EQ(item.casters[1].heading, 90 * kRadiansPerDegree);
  EXPECT_GT(item.casters[0].brake_torque, 0);
  EXPECT_EQ(item.casters[1].brake_torque, 0);
  EXPECT_EQ(item.payloads.size(), 2u);
  EXPECT_EQ(job.scene.items[0].initial.position, Vector3(1, 2, 0));
  EXPECT_DOUBLE_EQ(job.scene.items[0].initial.yaw, 30 * kRadiansPerDegree);
  EXPECT_EQ(job.scene.items[0].initial.velocity, Vector3(1, 0, 0));
  EXPECT_DOUBLE_EQ(job.scene.items[0].initial.yaw_rate, 180 * kRadiansPerDegree);
  EXPECT_FALSE(job.scene.items[0].initial.wheels_roll);
  EXPECT_EQ(job.scene.slope, 0.005);
  EXPECT_EQ(job.scene.gravity, 9.81);
}

TEST(Job, ReadsTheRecordRequest) {
  const TempFolder folder;
  const Job job = read_job(write_everything(folder));
  ASSERT_TRUE(job.record);
  ASSERT_EQ(job.record->files.size(), 2u);
  EXPECT_EQ(job.record->files[0].path, folder.path() + "/record_x.at2");
  EXPECT_EQ(job.record->files[0].direction, groundmotions::Direction::kH1);
  EXPECT_EQ(job.record->files[1].path, folder.path() + "/record_z.at2");
  EXPECT_EQ(job.record->files[1].direction, groundmotions::Direction::kVertical);
  EXPECT_TRUE(job.record->use_x);
  EXPECT_FALSE(job.record->use_y);
  EXPECT_FALSE(job.record->use_z);
  EXPECT_EQ(job.record->scale, 1);
  ASSERT_TRUE(job.record->scale_to);
  EXPECT_EQ(name_of(job.record->scale_to->measure), "Sa(1)");
  EXPECT_EQ(job.record->scale_to->combination, groundmotions::Combination::kH1);
  EXPECT_DOUBLE_EQ(job.record->scale_to->value, 0.2 * kStandardGravity);
  EXPECT_EQ(job.record->scale_to->vertical.rule, groundmotions::VerticalScaling::Rule::kKept);
  EXPECT_EQ(job.record->processing.size(), 2u);
  EXPECT_TRUE(job.record->refuse_implausible);
  ASSERT_TRUE(job.record->building);
  EXPECT_EQ(job.record->building->floor, 2);
  EXPECT_EQ(job.record->building->building.storeys, 3);
  EXPECT_TRUE(groundmotions::rocks(job.record->building->building, 2));
  EXPECT_EQ(job.rotation_factor, 0.5);
  EXPECT_DOUBLE_EQ(job.record->angle, 45 * kRadiansPerDegree);
  EXPECT_EQ(job.record->options.unit, "cm/s2");
  EXPECT_EQ(job.record->options.time_step, 0.01);
  EXPECT_EQ(job.record->where, folder.path() + "/job.toml:27:1");
}

TEST(Job, ReadsTheLoads) {
  const TempFolder folder;
  const PlacedItem item = read_job(write_everything(folder)).scene.items[0];
  const auto forces = loads_of<PointForce>(item.loads);
  ASSERT_EQ(forces.size(), 2u);
  EXPECT_EQ(forces[0].name, "force 1");
  EXPECT_EQ(forces[0].direction, Vector3(0, 1, 0));
  EXPECT_EQ(forces[0].time, (std::vector<double>{1, 3}));
  EXPECT_EQ(forces[0].force, (std::vector<double>{40, 40}));
  EXPECT_EQ(forces[0].speed_limit, 0.8);
  EXPECT_EQ(forces[1].name, "push");
  EXPECT_EQ(forces[1].speed_limit, std::numeric_limits<double>::infinity());
  EXPECT_EQ(forces[1].time, (std::vector<double>{0, 1, 1.5}));
  EXPECT_EQ(forces[1].force, (std::vector<double>{0, 10, 0}));
  const auto weights = loads_of<DropWeight>(item.loads);
  ASSERT_EQ(weights.size(), 1u);
  const DropWeight& weight = weights[0];
  EXPECT_EQ(weight.point, Vector3(0.5, 0, 0.1));
  EXPECT_EQ(weight.mass, 5);
  EXPECT_EQ(weight.drop_height, 1);
  EXPECT_EQ(weight.pulley_inertia, 1e-4);
  EXPECT_EQ(weight.pulley_radius, 0.04);
  EXPECT_EQ(weight.potentiometer_tension, 1);
  EXPECT_EQ(weight.cable_stiffness, 1e5);
  EXPECT_EQ(weight.cable_damping, 100);
  EXPECT_EQ(loads_of<StringPotentiometer>(item.loads).at(0).tension, 2);
  const Blocks blocks = loads_of<Blocks>(item.loads).at(0);
  EXPECT_EQ(blocks.stiffness, 1e6);
  EXPECT_EQ(blocks.damping, 1e3);
  EXPECT_EQ(blocks.release_time, 0.5);
  const Guide* guides = item.fixture.guides;
  EXPECT_EQ(guides[0].kind, Guide::Kind::kVelocity);
  EXPECT_EQ(guides[0].velocity, 0.4);
  EXPECT_EQ(guides[1].kind, Guide::Kind::kSpring);
  EXPECT_EQ(guides[1].stiffness, 100);
  EXPECT_EQ(guides[1].damping, 2);
  EXPECT_EQ(guides[3].kind, Guide::Kind::kHeld);
  EXPECT_EQ(guides[4].kind, Guide::Kind::kFree);
  EXPECT_EQ(guides[5].kind, Guide::Kind::kVelocity);
  EXPECT_DOUBLE_EQ(guides[5].velocity, 90 * kRadiansPerDegree);
}

TEST(Job, ReadsTheSettings) {
  const TempFolder folder;
  const RunOptions settings = read_job(write_everything(folder)).settings;
  EXPECT_EQ(settings.solver, Solver::kImplicit);
  EXPECT_EQ(settings.time_step, 0.002);
  EXPECT_EQ(settings.tolerance, 0.02);
  EXPECT_EQ(settings.residual, 1e-8);
  EXPECT_EQ(settings.max_newton_iterations, 50);
  EXPECT_EQ(settings.max_subdivisions, 5);
  EXPECT_EQ(settings.settle_time, 10);
  EXPECT_EQ(settings.duration, 12);
  EXPECT_EQ(settings.rest_speed, 0.002);
  EXPECT_EQ(settings.rest_hold, 1);
  EXPECT_DOUBLE_EQ(settings.overturn_tilt, 45 * kRadiansPerDegree);
  EXPECT_FALSE(settings.skip_clear_collision_passes);
  EXPECT_EQ(settings.history_step, 0.02);
  EXPECT_EQ(job_of_text(std::string(kHead) + "[output]\nhistories = false\n").settings.history_step,
            0);
  EXPECT_EQ(
      job_of_text(std::string(kHead) + "[settings]\nsolver = \"bullet-dantzig\"\n").settings.solver,
      Solver::kBulletDantzig);
  EXPECT_EQ(job_of_text(std::string(kHead) + "[settings]\nsolver = \"bullet\"\n").settings.solver,
            Solver::kBullet);
  const Job old = job_of_text(std::string(kHead) + "[settings]\nsolver = \"star\"\n");
  EXPECT_EQ(old.settings.solver, Solver::kImplicit);
  EXPECT_THAT(old.warnings, testing::Contains(testing::HasSubstr(
                                "settings.solver = \"star\": is now called \"implicit\"")));
}

TEST(Job, DefaultsAreThoseOfTheEngine) {
  const Job job = job_of_text(kHead);
  const RunOptions defaults;
  EXPECT_EQ(job.settings.solver, defaults.solver);
  EXPECT_EQ(job.settings.time_step, defaults.time_step);
  EXPECT_EQ(job.settings.overturn_tilt, defaults.overturn_tilt);
  EXPECT_EQ(job.settings.history_step, defaults.history_step);
  EXPECT_EQ(job.scene.gravity, kStandardGravity);
  EXPECT_FALSE(job.record);
  EXPECT_EQ(job.scene.items[0].fixture.guides[0].kind, Guide::Kind::kFree);
}

TEST(Job, CollectsAssumptionsOfItemCastersFloorAndJob) {
  const TempFolder folder;
  const Job job = read_job(write_everything(folder));
  const auto count = [&](const std::string& key) {
    return std::count_if(
        job.assumptions.begin(), job.assumptions.end(),
        [&](const equipment::Assumption& each) { return each.key.ends_with(key); });
  };
  EXPECT_EQ(count("excitation.string_potentiometer[0].tension_n"), 1);
  EXPECT_EQ(count("wheel_mass_kg"), 1);  // of R125 only, though the item names R100, and only once
  std::ptrdiff_t braked = 0;
  for (const Caster& caster : job.scene.items[0].model.casters) {
    braked += caster.brake_torque > 0;
    EXPECT_EQ(count(caster.name + "/brake_torque_n_m"), caster.brake_torque > 0);
  }
  EXPECT_GT(braked, 0);
  EXPECT_EQ(count("friction_factor"), 1);
}

TEST(Job, WarnsAboutAnUnstableItem) {
  const Job job = job_of_text(std::string(kHead) + "headings_deg = 0\n");
  EXPECT_TRUE(job.warnings.empty());
  std::string text = kEverything;
  text.replace(text.find("[0, 0, 400], inertia"), 11, "[0, 0, 1900]");
  text.erase(text.find("[excitation.record]"),
             text.find("[[excitation.force]]") - text.find("[excitation.record]"));
  ASSERT_EQ(job_of_text(text).warnings.size(), 1u + 3);  // and three of what duration_s makes idle
  EXPECT_NE(job_of_text(text).warnings[0].find("IEC 60601-1"), std::string::npos);
}

TEST(BadJob, RefusesBrakesTheCasterDoesNotHave) {
  std::string text = kEverything;
  text.erase(text.find("[excitation.record]"),
             text.find("[[excitation.force]]") - text.find("[excitation.record]"));
  text.replace(text.find("casters = \"R125\""), 16, "");
  text.replace(
      text.find("type = \"R100\""), 13,
      R"(inline = { name = "plain", height_mm = 131, )"
      R"(wheel_diameter_mm = 100, wheel_width_mm = 32, trail_mm = 34, wheel_mass_kg = 1, )"
      R"(wheel_inertia_ratio = 0.5, fork_mass_kg = 1, fork_center_of_mass_mm = [0, 0, 0], )"
      R"(fork_box_mm = [1, 1, 1], axle = { coulomb_n_m = 0, viscous_n_m_s_per_rad = 0 }, )"
      R"(swivel = { coulomb_n_m = 0, viscous_n_m_s_per_rad = 0 }, tread = { )"
      R"(normal_stiffness_n_per_m = 1, normal_damping_n_s_per_m = 0, )"
      R"(tangential_stiffness_n_per_m = 1, tangential_damping_n_s_per_m = 0, )"
      R"(relaxation_length_mm = 1, patch_width_mm = 33, rolling_resistance_mm = 0, )"
      R"(static_friction = 0.4, kinetic_friction = 0.5 } })");
  const std::string wrong = errors_of_text(text);
  EXPECT_NE(wrong.find("item.inline.caster[0].inline.tread.patch_width_mm = 33: must be a finite "
                       "number >= 0 and <= 32"),
            std::string::npos)
      << wrong;
  EXPECT_NE(wrong.find("kinetic_friction = 0.5: must be <= static_friction, 0.4"),
            std::string::npos)
      << wrong;
  text.replace(text.find("patch_width_mm = 33"), 19, "patch_width_mm = 3");
  text.replace(text.find("kinetic_friction = 0.5"), 22, "kinetic_friction = 0.4");
  EXPECT_EQ(errors_of_text(text),
            "a.toml:6:11: item.brakes[0] = true: caster 'caster 1' of cart has no brake "
            "(brake_torque_n_m of its caster): must be false");
}

TEST(ShippedJob, PullingTestIsThePapers) {
  const Job job = read_job(GURNEY_SOURCE_DIR "/studies/jobs/pulling_test.toml");
  EXPECT_TRUE(job.warnings.empty());
  EXPECT_EQ(job.scene.items[0].model.chassis_mass, 96.5);
  const std::vector<Load>& loads = job.scene.items[0].loads;
  EXPECT_EQ(loads_of<Blocks>(loads).size(), 1u);
  ASSERT_EQ(loads_of<DropWeight>(loads).size(), 1u);
  EXPECT_EQ(loads_of<StringPotentiometer>(loads).size(), 1u);
  EXPECT_FALSE(job.record);
  // The weight must overcome the rolling resistance, about 0.02 of the weight of the trolley.
  EXPECT_GT(loads_of<DropWeight>(loads)[0].mass, 2 * 0.02 * 99);
}

TEST(ShippedJob, VentilatorIsShakenInThreeDirections) {
  const std::string record = GURNEY_SOURCE_DIR "/groundmotions/records/synthetic_3c.csv";
  ASSERT_TRUE(std::filesystem::exists(record)) << record;
  const Job job = read_job(GURNEY_SOURCE_DIR "/studies/jobs/icu_ventilator_shake.toml");
  EXPECT_TRUE(job.warnings.empty());
  ASSERT_TRUE(job.record);
  EXPECT_EQ(job.record->files.at(0).path, record);
  EXPECT_TRUE(job.record->use_x && job.record->use_y && job.record->use_z);
  EXPECT_EQ(job.scene.items[0].model.casters.size(), 4u);
}

TEST(JobPage, HasEveryKeyTheReaderKnowsAndNoOther) {
  const TempFolder folder;
  std::set<std::string> asked;
  for (const std::string line :
       {"x = { velocity_m_per_s = 0.4 }", "x = { stiffness_n_per_m = 1 }"}) {
    std::string text = kEverything;
    text.replace(text.find("x = { velocity_m_per_s = 0.4 }"), 30, line);
    folder.write("record_x.at2", "");
    folder.write("record_z.at2", "");
    config::Document document(text, folder.path() + "/job.toml");
    read_job(document);
    for (const std::string& key : without_provenance(document.asked_keys())) asked.insert(key);
  }
  config::Document room(std::string(kHead) + kRoomAndTether, folder.path() + "/room.toml");
  read_job(room);
  for (const std::string& key : without_provenance(room.asked_keys())) asked.insert(key);
  for (const char* angle : {"fixture.roll.", "fixture.pitch."})
    asked.insert(std::string(angle) + "velocity_deg_per_s");  // read as yaw is
  std::erase_if(asked, [](const std::string& key) {
    return key.starts_with("item.inline.") || key.starts_with("excitation.record.processing[") ||
           key.starts_with("excitation.record.synthetic.") ||
           (key.starts_with("room.") && key != "room.file") ||
           (key.starts_with("excitation.building.") && key != "excitation.building.file" &&
            key != "excitation.building.floor" &&
            key != "excitation.building.rotation_factor");  // on pages of their own
  });
  for (const char* key :
       {"file", "suite", "suite_by_level", "synthetic", "scale", "scale_to", "unit", "use"})
    asked.erase(std::string("excitation.") +
                key);  // refused, with the name of the table that has them
  asked.erase("item.payloads.load");
  asked.insert("item.payloads.NAME");
  asked.insert(
      "excitation.building.position_m");  // on a floor that twists, which that of the job does not
  asked.insert("excitation.record.scale_to.value");  // taken for a provenance by its name
  const auto documented = documented_keys(GURNEY_SOURCE_DIR "/docs/formats/job_file.md", "");
  for (const std::string& key : asked) EXPECT_TRUE(documented.contains(key)) << key;
  for (const std::string& key : documented) EXPECT_TRUE(asked.contains(key)) << key;
}

}  // namespace
}  // namespace gurney::study
