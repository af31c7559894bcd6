#include <gtest/gtest.h>

#include "studies/job/job.h"
#include "tests/studies/job/job_text.h"
#include "tests/support/error_text.h"
#include "tests/support/temp_folder.h"

namespace gurney::study {
namespace {

constexpr const char* kHead = "schema = \"gurney-job/1\"\n[item]\nequipment = \"icu_ventilator\"\n";

TEST(BadJob, FileThatIsNotThere) {
  EXPECT_EQ(error_text([] { read_job("no_such_job.toml"); }), "no_such_job.toml: no such file");
}

TEST(BadJob, EmptyFileNamesWhatItNeeds) {
  EXPECT_EQ(errors_of_text(""),
            "a.toml:1:1: schema: missing; must be \"gurney-job/1\"\n"
            "a.toml:1:1: item: missing; must be a table [item], or tables [[item]] for several");
}

TEST(BadJob, NamesUnknownItemsCastersAndFloors) {
  EXPECT_EQ(errors_of_text(R"(schema = "gurney-job/1"
[item]
equipment = "icu_ventilater"
casters = "R101"
[floor]
covering = "carpet"
)"),
            "a.toml:3:13: item.equipment = \"icu_ventilater\": unknown item of equipment; did you "
            "mean 'icu_ventilator'?\n"
            "a.toml:4:11: item.casters = \"R101\": unknown caster; did you mean 'R100'?\n"
            "a.toml:6:12: floor.covering = \"carpet\": unknown floor covering; did you mean "
            "'carpet_tile'?");
}

TEST(BadJob, NamesTheTableOfAMisplacedKey) {
  EXPECT_EQ(errors_of_text(R"(schema = "gurney-job/1"
duration_s = 5
[item]
equipment = "icu_ventilator"
[record]
file = "a.at2"
)"),
            "a.toml:2:1: duration_s: unknown key; did you mean 'settings.duration_s'?\n"
            "a.toml:5:2: record: unknown key; did you mean 'excitation.record'?");
}

TEST(BadJob, NamesUnknownKeysAndWrongTypesTogether) {
  EXPECT_EQ(errors_of_text(std::string(kHead) + R"(headings_deg = [0, 90]
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
            "a.toml:4:16: item.headings_deg = [0, 90]: must be an array of 4 numbers, or one "
            "number for all\n"
            "a.toml:5:10: item.brakes = \"on\": must be true or false\n"
            "a.toml:6:22: item.payloads.paver: ICU ventilator on cart has no such payload\n"
            "a.toml:7:1: item.brake: unknown key; did you mean 'brakes'?\n"
            "a.toml:9:10: settings.solver = \"bulet\": must be one of implicit, bullet, "
            "bullet-dantzig, bullet-paper, bullet-paper-dantzig; did you mean 'bullet'?\n"
            "a.toml:10:15: settings.time_step_s = 0.5: must be a finite number > 0 and <= 0.02\n"
            "a.toml:11:1: settings.timestep: unknown key; did you mean 'time_step_s'?\n"
            "a.toml:13:24: initial.velocity_m_per_s[1] = nan: must be a finite number");
}

TEST(BadJob, AnItemWithoutCastersHasNoneToTurnOrBrake) {
  const std::string kBookcase = "schema = \"gurney-job/1\"\n[item]\nequipment = \"bookcase\"\n";
  EXPECT_EQ(errors_of_text(kBookcase), "(no error)");
  EXPECT_EQ(
      errors_of_text(kBookcase + "brakes = true\nheadings_deg = [0, 90]\ncasters = \"R100\"\n"),
      "a.toml:4:10: item.brakes: Bookcase has no casters\n"
      "a.toml:5:16: item.headings_deg: Bookcase has no casters\n"
      "a.toml:6:11: item.casters: Bookcase has no casters");
}

TEST(BadJob, WhatBelongsToSomethingInErrorIsNotCalledUnknown) {
  EXPECT_EQ(
      errors_of_text("schema = \"gurney-job/1\"\n[item]\n"
                     "headings_deg = { value = 0, range = [0, 90] }\nheading = 2\n"),
      "a.toml:2:1: item.equipment: missing; must name an item of the catalogue or its file, or "
      "[item.inline] must describe it\n"
      "a.toml:4:1: item.heading: unknown key; did you mean 'headings_deg'?");
  EXPECT_EQ(errors_of_text("schema = \"gurney-job/1\"\n[item]\nequipment = \"bookcase\"\n"
                           "headings_deg = { value = 0, range = [0, 90] }\n"),
            "a.toml:4:16: item.headings_deg: Bookcase has no casters");
  EXPECT_EQ(errors_of_text(std::string(kHead) +
                           "[[room.wall]]\nname = \"w\"\nfrom_m = [0, 0]\nto_m = [1, 0]\n"
                           "thickness_m = -1\nheight_m = 2\ndoor = [{ name = \"d\" }]\n"),
            "a.toml:8:15: room.wall[0].thickness_m = -1: must be a finite number > 0");
}

TEST(BadJob, HistoriesAreSampledAtWholeTimeSteps) {
  EXPECT_EQ(errors_of_text(std::string(kHead) + "[settings]\ntime_step_s = 0.004\n"
                                                "[output]\nhistory_step_s = 0.01\n"),
            "a.toml:7:18: output.history_step_s = 0.01: must be a whole number of time steps of "
            "0.004 s, such as 0.012");
}

TEST(BadJob, NeedsOneItem) {
  EXPECT_EQ(
      errors_of_text("schema = \"gurney-job/1\"\n[item]\n"),
      "a.toml:2:1: item.equipment: missing; must name an item of the catalogue or its file, or "
      "[item.inline] must describe it");
}

TEST(BadJob, PassesOnTheErrorsOfTheItemsFile) {
  const TempFolder folder;
  const std::string cart = folder.write("cart.toml", "schema = \"gurney-item/1\"\nmass = 3\n");
  const std::string job =
      folder.write("job.toml", "schema = \"gurney-job/1\"\n[item]\nequipment = \"cart.toml\"\n");
  const std::string text = error_text([&] { read_job(job); });
  EXPECT_EQ(text.rfind(cart + ":1:1: name: missing; must be text in quotes\n", 0), 0u) << text;
  EXPECT_NE(text.find(cart + ":2:1: mass: unknown key"), std::string::npos) << text;
}

TEST(BadJob, ExplainsRecords) {
  const std::string head = std::string(kHead) + "[excitation.record]\n";
  EXPECT_EQ(
      errors_of_text(head),
      "a.toml:4:1: excitation.record: no components or too many; must have 'file' (one file "
      "with all components, or an array of files), or files for 'x', 'y', 'z', or 'synthetic', or, "
      "in a study, 'suite' or 'suite_by_level'");
  EXPECT_EQ(
      errors_of_text(head + "file = \"no.csv\"\nunit = \"m/s\"\nscale = inf\ntime_step_s = 0\n"),
      "a.toml:5:8: excitation.record.file = \"no.csv\": no such file: no.csv\n"
      "a.toml:6:8: excitation.record.unit = \"m/s\": must be one of g, m/s2, cm/s2, gal, "
      "mm/s2, mg, %g, ft/s2, in/s2; did you mean 'm/s2'?\n"
      "a.toml:7:9: excitation.record.scale = inf: must be a finite number > 0\n"
      "a.toml:8:15: excitation.record.time_step_s = 0: must be a finite number >= 1e-05 and <= 1");
  const TempFolder folder;
  const std::string x = folder.write("x.at2", "");
  EXPECT_EQ(errors_of_text(head + "x = \"" + x + "\"\nuse = \"xy\"\n"),
            "a.toml:6:7: excitation.record.use = \"xy\": must name components that are there; 'y' "
            "has no file");
  EXPECT_EQ(errors_of_text(head + "x = \"" + folder.path() + "\"\n"),
            "a.toml:5:5: excitation.record.x = \"" + folder.path() +
                "\": is a folder, not a file: " + folder.path());
}

TEST(BadJob, ExplainsLoadsAndGuides) {
  EXPECT_EQ(errors_of_text(std::string(kHead) + R"([[excitation.force]]
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
[[excitation.force]]
point_m = [0, 0, 1]
direction = [1, 0, 0]
force_n = -5
until_s = 3
speed_limit_m_per_s = 0.8
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
            "a.toml:18:11: excitation.force[2].force_n = -5: must be a finite number >= 0\n"
            "a.toml:24:11: excitation.drop_weight[0].mass_kg = -1: must be a finite number > 0\n"
            "a.toml:25:17: excitation.drop_weight[0].drop_height_m = 0: must be a finite number > "
            "0\n"
            "a.toml:27:5: fixture.x = \"fixed\": must be one of free, held\n"
            "a.toml:28:5: fixture.y.velocity_m_per_s: must be given, or stiffness_n_per_m, not "
            "both\n"
            "a.toml:28:7: fixture.y.damping_n_s_per_m: unknown key; known: stiffness_n_per_m, "
            "velocity_m_per_s\n"
            "a.toml:29:7: fixture.yaw.velocity_deg_per_s: missing; must be a finite number\n"
            "a.toml:29:9: fixture.yaw.stiffness_n_per_m: unknown key; known: velocity_deg_per_s");
}

}  // namespace
}  // namespace gurney::study
