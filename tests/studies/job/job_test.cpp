#include "studies/job/job.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "engine/base/units.h"
#include "tests/support/error_text.h"
#include "tests/support/key_table.h"
#include "tests/support/temp_folder.h"

namespace gurney {
namespace {

constexpr const char* kHead = "schema = \"gurney-job/1\"\n[item]\nequipment = \"icu_ventilator\"\n";

/// What `read_job` says of this text.
std::string mistakes(const std::string& text) {
  return error_text([&] {
    config::Document document(text, "a.toml");
    read_job(document);
  });
}

Job job_of(const std::string& text) {
  config::Document document(text, "a.toml");
  return read_job(document);
}

/// A job with every key there is.
constexpr const char* kEverything = R"(schema = "gurney-job/1"
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
[floor]
covering = "polyflor_forest_fx"
slope = 0.005
gravity_m_per_s2 = 9.81
[excitation.record]
x = "record_x.at2"
z = "record_z.at2"
use = "x"
scale = 2
angle_deg = 45
units = "cm/s2"
time_step_s = 0.01
[[excitation.force]]
point_m = [0, 0, 1]
direction = [0, 2, 0]
force_n = 40
from_s = 1
until_s = 3
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
solver = "bullet-dantzig"
time_step_s = 0.002
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
)";

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
  const EquipmentModel& item = job.scene.item;
  EXPECT_EQ(item.name, "cart");
  EXPECT_EQ(item.casters[0].wheel_radius, 0.0625);
  EXPECT_DOUBLE_EQ(item.casters[1].heading, 90 * kRadiansPerDegree);
  EXPECT_GT(item.casters[0].brake_torque, 0);
  EXPECT_EQ(item.casters[1].brake_torque, 0);
  EXPECT_EQ(item.payloads.size(), 2u);
  EXPECT_EQ(job.scene.initial.position, Vector3(1, 2, 0));
  EXPECT_DOUBLE_EQ(job.scene.initial.yaw, 30 * kRadiansPerDegree);
  EXPECT_EQ(job.scene.initial.velocity, Vector3(1, 0, 0));
  EXPECT_DOUBLE_EQ(job.scene.initial.yaw_rate, 180 * kRadiansPerDegree);
  EXPECT_FALSE(job.scene.initial.wheels_roll);
  EXPECT_EQ(job.scene.slope, 0.005);
  EXPECT_EQ(job.scene.gravity, 9.81);
}

TEST(Job, ReadsTheRecordRequest) {
  const TempFolder folder;
  const Job job = read_job(write_everything(folder));
  ASSERT_TRUE(job.record);
  EXPECT_EQ(job.record->x, folder.path() + "/record_x.at2");
  EXPECT_EQ(job.record->y, "");
  EXPECT_EQ(job.record->z, folder.path() + "/record_z.at2");
  EXPECT_EQ(job.record->file, "");
  EXPECT_TRUE(job.record->use_x);
  EXPECT_FALSE(job.record->use_y);
  EXPECT_FALSE(job.record->use_z);
  EXPECT_EQ(job.record->scale, 2);
  EXPECT_DOUBLE_EQ(job.record->angle, 45 * kRadiansPerDegree);
  EXPECT_EQ(job.record->units, "cm/s2");
  EXPECT_EQ(job.record->time_step, 0.01);
  EXPECT_EQ(job.record->where, folder.path() + "/job.toml:25:1");
}

TEST(Job, ReadsTheLoads) {
  const TempFolder folder;
  const Excitation loads = read_job(write_everything(folder)).excitation;
  ASSERT_EQ(loads.forces.size(), 2u);
  EXPECT_EQ(loads.forces[0].name, "force 1");
  EXPECT_EQ(loads.forces[0].direction, Vector3(0, 1, 0));
  EXPECT_EQ(loads.forces[0].time, (std::vector<double>{1, 3}));
  EXPECT_EQ(loads.forces[0].force, (std::vector<double>{40, 40}));
  EXPECT_EQ(loads.forces[1].name, "push");
  EXPECT_EQ(loads.forces[1].time, (std::vector<double>{0, 1, 1.5}));
  EXPECT_EQ(loads.forces[1].force, (std::vector<double>{0, 10, 0}));
  ASSERT_EQ(loads.drop_weights.size(), 1u);
  const DropWeight& weight = loads.drop_weights[0];
  EXPECT_EQ(weight.point, Vector3(0.5, 0, 0.1));
  EXPECT_EQ(weight.mass, 5);
  EXPECT_EQ(weight.drop_height, 1);
  EXPECT_EQ(weight.pulley_inertia, 1e-4);
  EXPECT_EQ(weight.pulley_radius, 0.04);
  EXPECT_EQ(weight.potentiometer_tension, 1);
  EXPECT_EQ(weight.cable_stiffness, 1e5);
  EXPECT_EQ(weight.cable_damping, 100);
  EXPECT_EQ(loads.string_potentiometers.at(0).tension, 2);
  EXPECT_EQ(loads.blocks.at(0).stiffness, 1e6);
  EXPECT_EQ(loads.blocks.at(0).damping, 1e3);
  EXPECT_EQ(loads.blocks.at(0).release_time, 0.5);
  const Guide* guides = loads.fixture.guides;
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
  const SimulationSettings settings = read_job(write_everything(folder)).settings;
  EXPECT_EQ(settings.solver, Solver::kBulletDantzig);
  EXPECT_EQ(settings.time_step, 0.002);
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
  EXPECT_EQ(job_of(std::string(kHead) + "[output]\nhistories = false\n").settings.history_step, 0);
  EXPECT_EQ(job_of(std::string(kHead) + "[settings]\nsolver = \"general\"\n").settings.solver,
            Solver::kGeneral);
  EXPECT_EQ(job_of(std::string(kHead) + "[settings]\nsolver = \"bullet\"\n").settings.solver,
            Solver::kBullet);
}

TEST(Job, DefaultsAreThoseOfTheEngine) {
  const Job job = job_of(kHead);
  const SimulationSettings defaults;
  EXPECT_EQ(job.settings.solver, defaults.solver);
  EXPECT_EQ(job.settings.time_step, defaults.time_step);
  EXPECT_EQ(job.settings.overturn_tilt, defaults.overturn_tilt);
  EXPECT_EQ(job.settings.history_step, defaults.history_step);
  EXPECT_EQ(job.scene.gravity, kStandardGravity);
  EXPECT_FALSE(job.record);
  EXPECT_EQ(job.excitation.fixture.guides[0].kind, Guide::Kind::kFree);
}

TEST(Job, CollectsAssumptionsOfItemCastersFloorAndJob) {
  const TempFolder folder;
  const Job job = read_job(write_everything(folder));
  const auto count = [&](const std::string& key) {
    return std::count_if(job.assumptions.begin(), job.assumptions.end(),
                         [&](const Assumption& each) { return each.key == key; });
  };
  EXPECT_EQ(count("excitation.string_potentiometer[0].tension_n"), 1);
  EXPECT_EQ(count("trail_mm"), 1);  // of R125 only, though the item names R100, and only once
  EXPECT_EQ(count("brake_torque_n_m"), 1);
  EXPECT_EQ(count("friction_factor"), 1);
}

TEST(Job, WarnsAboutAnUnstableItem) {
  const Job job = job_of(std::string(kHead) + "headings_deg = 0\n");
  EXPECT_TRUE(job.warnings.empty());
  std::string text = kEverything;
  text.replace(text.find("[0, 0, 400], inertia"), 11, "[0, 0, 1900]");
  text.erase(text.find("[excitation.record]"),
             text.find("[[excitation.force]]") - text.find("[excitation.record]"));
  ASSERT_EQ(job_of(text).warnings.size(), 1u);
  EXPECT_NE(job_of(text).warnings[0].find("IEC 60601-1"), std::string::npos);
}

TEST(BadJob, FileThatIsNotThere) {
  EXPECT_EQ(error_text([] { read_job("no_such_job.toml"); }), "no_such_job.toml: no such file");
}

TEST(BadJob, EmptyFileNamesWhatItNeeds) {
  EXPECT_EQ(mistakes(""),
            "a.toml:1:1: schema: missing; must be one of gurney-job/1\n"
            "a.toml:1:1: item: missing; must be a table [item]");
}

TEST(BadJob, NamesUnknownItemsCastersAndFloors) {
  EXPECT_EQ(mistakes(R"(schema = "gurney-job/1"
[item]
equipment = "icu_ventilater"
casters = "R101"
[floor]
covering = "carpet"
)"),
            "a.toml:3:13: item.equipment = \"icu_ventilater\": unknown item of equipment; did you "
            "mean 'icu_ventilator'? (the catalogue has icu_ventilator, xu_trolley)\n"
            "a.toml:4:11: item.casters = \"R101\": unknown caster; did you mean 'R100'? (the "
            "catalogue has P100, R100, R125)\n"
            "a.toml:6:12: floor.covering = \"carpet\": unknown floor covering (the catalogue has "
            "polyflor_forest_fx, polyflor_mystique)");
}

TEST(BadJob, NamesUnknownKeysAndWrongTypesTogether) {
  EXPECT_EQ(mistakes(std::string(kHead) + R"(headings_deg = [0, 90]
brakes = "on"
payloads = { paver = 2 }
brake = true
[settings]
solver = "bulet"
time_step_s = 0.5
timestep = 0.001
[initial]
velocity_m_per_s = [1, nan, 0]
)"),
            "a.toml:4:16: item.headings_deg = [0, 90]: must be an array of 4 numbers\n"
            "a.toml:5:10: item.brakes = \"on\": must be true or false\n"
            "a.toml:6:22: item.payloads.paver: ICU ventilator on cart has no such payload\n"
            "a.toml:7:1: item.brake: unknown key; did you mean 'brakes'?\n"
            "a.toml:9:10: settings.solver = \"bulet\": must be one of star, general, bullet, "
            "bullet-dantzig; did you mean 'bullet'?\n"
            "a.toml:10:15: settings.time_step_s = 0.5: must be a finite number > 0 and <= 0.02\n"
            "a.toml:11:1: settings.timestep: unknown key; did you mean 'time_step_s'?\n"
            "a.toml:13:24: initial.velocity_m_per_s[1] = nan: must be a finite number");
}

TEST(BadJob, NeedsOneItem) {
  EXPECT_EQ(mistakes("schema = \"gurney-job/1\"\n[item]\n"),
            "a.toml:2:1: item.equipment: must name an item, or [item.inline] must describe it, not "
            "both");
}

TEST(BadJob, PassesOnTheMistakesOfTheItemsFile) {
  const TempFolder folder;
  const std::string cart = folder.write("cart.toml", "schema = \"gurney-item/1\"\nmass = 3\n");
  const std::string job =
      folder.write("job.toml", "schema = \"gurney-job/1\"\n[item]\nequipment = \"cart.toml\"\n");
  const std::string text = error_text([&] { read_job(job); });
  EXPECT_EQ(text.rfind(cart + ":1:1: name: missing; must be text in quotes\n", 0), 0u) << text;
  EXPECT_NE(text.find(cart + ":2:1: mass: unknown key"), std::string::npos) << text;
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
  const std::string wrong = mistakes(text);
  EXPECT_NE(wrong.find("item.inline.caster[0].inline.tread.patch_width_mm = 33: must be a finite "
                       "number >= 0 and <= 32"),
            std::string::npos)
      << wrong;
  EXPECT_NE(wrong.find("kinetic_friction = 0.5: must be <= static_friction, 0.4"),
            std::string::npos)
      << wrong;
  text.replace(text.find("patch_width_mm = 33"), 19, "patch_width_mm = 3");
  text.replace(text.find("kinetic_friction = 0.5"), 22, "kinetic_friction = 0.4");
  EXPECT_EQ(mistakes(text),
            "a.toml:11:1: item.inline: caster 'caster 1': the brake is on, but caster plain has no "
            "brake_torque_n_m");
}

TEST(BadJob, ExplainsRecords) {
  const std::string head = std::string(kHead) + "[excitation.record]\n";
  EXPECT_EQ(mistakes(head),
            "a.toml:4:1: excitation.record: no components or too many; must have 'file' (one file "
            "with columns), or files for 'x', 'y', 'z', not both");
  EXPECT_EQ(mistakes(head + "file = \"no.csv\"\nunits = \"m/s\"\nscale = inf\ntime_step_s = 0\n"),
            "a.toml:5:8: excitation.record.file = \"no.csv\": no such file: no.csv\n"
            "a.toml:6:9: excitation.record.units = \"m/s\": must be one of g, m/s2, cm/s2, mm/s2; "
            "did you mean 'm/s2'?\n"
            "a.toml:7:9: excitation.record.scale = inf: must be a finite number\n"
            "a.toml:8:15: excitation.record.time_step_s = 0: must be a finite number > 0");
  const TempFolder folder;
  const std::string x = folder.write("x.at2", "");
  EXPECT_EQ(mistakes(head + "x = \"" + x + "\"\nuse = \"xy\"\n"),
            "a.toml:6:7: excitation.record.use = \"xy\": must name components that are there; 'y' "
            "has no file");
  EXPECT_EQ(mistakes(head + "x = \"" + folder.path() + "\"\n"),
            "a.toml:5:5: excitation.record.x = \"" + folder.path() +
                "\": is a folder, not a file: " + folder.path());
}

TEST(BadJob, ExplainsLoadsAndGuides) {
  EXPECT_EQ(mistakes(std::string(kHead) + R"([[excitation.force]]
point_m = [0, 0, 1]
direction = [0, 0, 0]
force_n = 40
until_s = 0
[[excitation.force]]
point_m = [0, 0, 1]
direction = [1, 0, 0]
force_n = [0, 1, 2]
time_s = [0, 2, 2]
until_s = 3
[[excitation.drop_weight]]
point_m = [0, 0, 1]
direction = [1, 0, 0]
mass_kg = -1
drop_height_m = 0
[fixture]
x = "fixed"
y = { damping_n_s_per_m = 1 }
yaw = { stiffness_n_per_m = 5 }
)"),
            "a.toml:6:13: excitation.force[0].direction = [0, 0, 0]: must have a length\n"
            "a.toml:8:11: excitation.force[0].until_s = 0: must be a finite number > 0\n"
            "a.toml:13:10: excitation.force[1].time_s[2] = 2: must be more than the time before "
            "it, 2\n"
            "a.toml:14:11: excitation.force[1].until_s: must go with a constant force_n, not with "
            "a table\n"
            "a.toml:18:11: excitation.drop_weight[0].mass_kg = -1: must be a finite number > 0\n"
            "a.toml:19:17: excitation.drop_weight[0].drop_height_m = 0: must be a finite number > "
            "0\n"
            "a.toml:21:5: fixture.x = \"fixed\": must be one of free, held\n"
            "a.toml:22:5: fixture.y.velocity_m_per_s: must be given, or stiffness_n_per_m, not "
            "both\n"
            "a.toml:22:7: fixture.y.damping_n_s_per_m: unknown key; known: stiffness_n_per_m, "
            "velocity_m_per_s\n"
            "a.toml:23:7: fixture.yaw.velocity_deg_per_s: missing; must be a finite number\n"
            "a.toml:23:9: fixture.yaw.stiffness_n_per_m: unknown key; known: velocity_deg_per_s");
}

TEST(ShippedJob, PullingTestIsThePapers) {
  const Job job = read_job(GURNEY_SOURCE_DIR "/studies/jobs/pulling_test.toml");
  EXPECT_TRUE(job.warnings.empty());
  EXPECT_EQ(job.scene.item.chassis_mass, 96.5);
  EXPECT_EQ(job.excitation.blocks.size(), 1u);
  EXPECT_EQ(job.excitation.drop_weights.size(), 1u);
  EXPECT_EQ(job.excitation.string_potentiometers.size(), 1u);
  EXPECT_FALSE(job.record);
  // The weight must overcome the rolling resistance, about 0.02 of the weight of the trolley.
  EXPECT_GT(job.excitation.drop_weights[0].mass, 2 * 0.02 * 99);
}

TEST(ShippedJob, VentilatorIsShakenInThreeDirections) {
  const std::string record = GURNEY_SOURCE_DIR "/groundmotions/records/synthetic_3c.csv";
  if (!std::filesystem::exists(record)) GTEST_SKIP() << record << " is not there";
  const Job job = read_job(GURNEY_SOURCE_DIR "/studies/jobs/icu_ventilator_shake.toml");
  EXPECT_TRUE(job.warnings.empty());
  ASSERT_TRUE(job.record);
  EXPECT_EQ(job.record->file, record);
  EXPECT_TRUE(job.record->use_x && job.record->use_y && job.record->use_z);
  EXPECT_EQ(job.scene.item.casters.size(), 4u);
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
  for (const char* angle : {"fixture.roll.", "fixture.pitch."})
    asked.insert(std::string(angle) + "velocity_deg_per_s");  // read as yaw is
  std::erase_if(asked, [](const std::string& key) { return key.rfind("item.inline.", 0) == 0; });
  asked.erase("item.payloads.load");
  asked.insert("item.payloads.NAME");
  EXPECT_EQ(asked, documented_keys(GURNEY_SOURCE_DIR "/docs/formats/job_file.md", ""));
}

}  // namespace
}  // namespace gurney
