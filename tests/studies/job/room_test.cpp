#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "engine/run/simulate.h"
#include "studies/job/room_reader.h"
#include "studies/prepare/run_job.h"
#include "tests/studies/job/job_text.h"
#include "tests/support/error_text.h"
#include "tests/support/temp_folder.h"

namespace gurney::study {
namespace {

using testing::HasSubstr;

Job job_of(const std::string& text) { return job_of_text("schema = \"gurney-job/1\"\n" + text); }

std::string errors(const std::string& text) {
  return error_text([&] { job_of(text); });
}

constexpr const char* kTwo = R"([[item]]
equipment = "icu_ventilator"
name = "ventilator"
position_m = [1, 1]
[[item]]
equipment = "infusion_pole"
name = "pole"
position_m = [-1, 0]
)";

constexpr const char* kWall =
    "[[room.wall]]\nname = \"west\"\nfrom_m = [3, -1]\nto_m = [3, 1]\nthickness_m = 0.1\nheight_m "
    "= "
    "2\n";

constexpr const char* kTether = R"([[tether]]
item = "pole"
kind = "power_cord"
point_m = [0, 0, 1]
anchor_m = [-1, 1, 1]
slack_length_m = 2
)";

bool rests_on(const Job& job, const std::string& key) {
  return std::ranges::any_of(job.assumptions,
                             [&](const equipment::Assumption& each) { return each.key == key; });
}

TEST(JobRoom, WhatTheJobSaysIsAddedToTheFile) {
  const Job job = job_of(std::string(kTwo) + "[room]\nfile = \"icu_bay\"\n" + kWall);
  EXPECT_TRUE(std::ranges::any_of(job.scene.room,
                                  [](const RoomShape& each) { return each.name == "west"; }));
  EXPECT_TRUE(std::ranges::any_of(
      job.scene.room, [](const RoomShape& each) { return each.name == "door wall lintel 1"; }));
  EXPECT_EQ(job.scene.zones.at(0).name, "doorway");
}

TEST(JobRoom, WarnsOfZonesThatAreOccupiedAtTheStart) {
  const auto warnings = [](const std::string& center) {
    return job_of(std::string(kTwo) + "[[room.zone]]\nname = \"way out\"\ncenter_m = " + center +
                  "\nlength_m = 1\nwidth_m = 0.8\n")
        .warnings;
  };
  EXPECT_EQ(warnings("[1, 1]"),
            (std::vector<std::string>{"zone 'way out': 'ventilator' stands in it at the start, so "
                                      "that every run counts as an entry"}));
  EXPECT_TRUE(warnings("[5, 5]").empty());
}

TEST(JobRoom, WarnsOfItemsOutsideOfTheWalls) {
  const auto warnings = [](const std::string& position, const std::string& height) {
    std::string walls;
    for (const char* y : {"-3", "3"})
      walls += "[[room.wall]]\nname = \"at " + std::string(y) + "\"\nfrom_m = [-3, " + y +
               "]\nto_m = [3, " + y + "]\nthickness_m = 0.1\nheight_m = " + height + "\n";
    return job_of("[item]\nequipment = \"icu_ventilator\"\nposition_m = " + position + "\n" + walls)
        .warnings;
  };
  EXPECT_TRUE(warnings("[1, 1]", "2.5").empty());
  EXPECT_TRUE(warnings("[1000, 0]", "0.3").empty()) << "kerbs are around nothing";
  const auto far = warnings("[1000, 0]", "2.5");
  ASSERT_EQ(far.size(), 1u);
  EXPECT_EQ(far[0],
            "'icu_ventilator' stands outside of the walls of the room, at (1000, 0) m: they reach "
            "from (-3, -3.05) m to (3, 3.05) m");
}

TEST(JobRoom, PairsThatMayTouchHaveConstantsAndTheirAssumptions) {
  const Job job = job_of(std::string(kTwo) + kWall);
  EXPECT_EQ(job.scene.floor_material, "floor");
  EXPECT_EQ(job.scene.items[0].model.material, "equipment");
  EXPECT_EQ(job.scene.pairs.size(), 3u);  // with the floor, the wall, each other
  EXPECT_TRUE(rests_on(job, "equipment-plasterboard/contact.restitution"));
  EXPECT_TRUE(rests_on(job, "equipment-floor/contact.friction"));
  EXPECT_TRUE(rests_on(job, "equipment-equipment/contact.restitution"));
  EXPECT_FALSE(rests_on(job, "equipment-concrete/contact.restitution"));
}

TEST(JobRoom, TheJobsContactComesFirst) {
  const Job job = job_of(std::string(kTwo) + kWall + R"([[room.contact]]
materials = ["plasterboard", "equipment"]
restitution = 0.7
friction = 0.1
)");
  EXPECT_EQ(contact_constants(job.scene, "equipment", "plasterboard").restitution, 0.7);
  EXPECT_FALSE(rests_on(job, "equipment-plasterboard/contact.restitution"));
}

TEST(JobRoom, ContactsAreDrawnByTheNamesOfTheirMaterials) {
  const Job job = job_of(std::string(kTwo) + kWall + R"([[room.contact]]
materials = ["equipment", "plasterboard"]
restitution = { value = 0.3, distribution = { kind = "uniform", low = 0.2, high = 0.6, source = "s" } }
friction = 0.1
[uncertainty]
draw = 4
)");
  EXPECT_EQ(
      contact_constants(job.scene, "equipment", "plasterboard").restitution,
      0.2 +
          0.4 *
              Draw(1, 4).of_part("equipment-plasterboard").probability("room.contact.restitution"));
}

TEST(BadJobRoom, AllErrorsAtOnce) {
  const std::string text = errors(std::string(kTwo) + R"([room]
file = "icu_bya"
[[room.wall]]
name = "pole"
from_m = [3, -1]
to_m = [3, 1]
thickness_m = 0.1
height_m = 2
door = [{ at_m = 0, width_m = 3, height_m = 2 }]
[floor]
material = "flor"
)");
  EXPECT_THAT(text, HasSubstr("a.toml:8:8: item[1].name = \"pole\": must differ from the name at "
                              "a.toml:13:8"));
  EXPECT_THAT(text, HasSubstr("a.toml:11:8: room.file = \"icu_bya\": unknown room; did you mean "
                              "'icu_bay'?"));
  EXPECT_THAT(text, HasSubstr("a.toml:18:31: room.wall[0].door[0].width_m = 3: the door is wider "
                              "than the wall, 2 m long"));
  EXPECT_THAT(text, HasSubstr("a.toml:20:12: floor.material = \"flor\": no contact names this "
                              "material; did you mean 'floor'?"));
}

TEST(BadJobRoom, APairNeedsConstantsAndIsNamedOnce) {
  EXPECT_EQ(errors(std::string(kTwo) + "[floor]\nmaterial = \"steel\"\n" + kWall +
                   "material = \"foam\"\n[[room.contact]]\nmaterials = [\"rug\", \"foam\"]\n"
                   "restitution = 0.5\nfriction = 0.5\n"),
            "a.toml:3:13: item[0].equipment: no [[room.contact]] for the materials 'equipment' of "
            "ventilator and 'foam' of west\n"
            "a.toml:20:13: room.contact[0].materials: nothing is of the material 'rug'; known: "
            "equipment, foam, steel");
}

TEST(BadJobRoom, AContactIsOfMaterialsThatAreThere) {
  const auto contact = [](const std::string& material) {
    return errors(std::string(kTwo) + kWall + "[[room.contact]]\nmaterials = [\"equipment\", \"" +
                  material + "\"]\nrestitution = 0.5\nfriction = 0.5\n");
  };
  EXPECT_EQ(
      contact("plasterbord"),
      "a.toml:17:13: room.contact[0].materials: nothing is of the material 'plasterbord'; did you "
      "mean 'plasterboard'?");
  EXPECT_EQ(contact("plasterboard"), "(no error)");
  EXPECT_EQ(contact("floor"), "(no error)");
}

TEST(BadJobTether, AnItemHasThirtyTwoAtMost) {
  std::string tethers;
  for (int i = 0; i < 32; ++i) tethers += kTether;
  EXPECT_EQ(errors(kTwo + tethers), "(no error)");
  EXPECT_EQ(errors(kTwo + tethers + kTether),
            "a.toml:203:8: tether[32].item: must not have more than 32 tethers");
}

TEST(BadJobRoom, BulletsOwnSolversKnowNoRoom) {
  EXPECT_EQ(
      errors(std::string(kTwo) + "[settings]\nsolver = \"bullet\"\n"),
      "a.toml:11:10: settings.solver: must be \"implicit\" with a room, tethers or several items; "
      "Bullet's own solvers are baselines for one item on a floor");
}

TEST(BadJobRoom, PassesOnTheErrorsOfTheFile) {
  const TempFolder folder;
  const std::string room =
      folder.write("bay.toml", "schema = \"gurney-room/1\"\nname = \"bay\"\n[[wal]]\n");
  const std::string job = folder.write("job.toml", std::string("schema = \"gurney-job/1\"\n") +
                                                       kTwo + "[room]\nfile = \"bay.toml\"\n");
  EXPECT_THAT(error_text([&] { read_job(job); }),
              HasSubstr(room + ":3:3: wal: unknown key; did you mean 'wall'?"));
}

TEST(BadJobRoom, NothingStandsInSomethingElse) {
  const std::string text = errors(R"([[item]]
equipment = "icu_bed"
name = "bed"
[[item]]
equipment = "icu_ventilator"
name = "ventilator"
position_m = [0.8, 0]
[[item]]
equipment = "infusion_pole"
name = "pole"
position_m = [3, 0]
)" + std::string(kWall));
  EXPECT_THAT(text, HasSubstr("a.toml:8:14: item[1].position_m: 'ventilator' stands "));
  EXPECT_THAT(text, HasSubstr(" mm deep in 'bed'\n"));
  EXPECT_THAT(text, HasSubstr("a.toml:12:14: item[2].position_m: 'pole' stands "));
  EXPECT_THAT(text, HasSubstr(" mm deep in 'west'"));
}

TEST(JobTether, HasTheConstantsOfItsKind) {
  const Job job = job_of(std::string(kTwo) + kTether);
  ASSERT_EQ(job.scene.tethers.size(), 1u);
  const Tether& tether = job.scene.tethers[0];
  EXPECT_EQ(tether.name, "tether 1");
  EXPECT_EQ(tether.item, 1u);
  EXPECT_EQ(tether.point, Vector3(0, 0, 1));
  EXPECT_EQ(tether.anchor, Vector3(-1, 1, 1));
  EXPECT_EQ(tether.slack_length, 2);
  EXPECT_EQ(tether.stiffness, 2e4 / 2);
  EXPECT_EQ(tether.damping, 50);
  EXPECT_EQ(tether.strength, 80);
  EXPECT_TRUE(rests_on(job, "axial_stiffness_n"));
  EXPECT_TRUE(rests_on(job, "strength_n"));
}

TEST(JobTether, StatedConstantsReplaceThoseOfTheKind) {
  const Job job =
      job_of(std::string(kTwo) + kTether + "stiffness_n_per_m = 500\nstrength_n = inf\n");
  EXPECT_EQ(job.scene.tethers[0].stiffness, 500);
  EXPECT_EQ(job.scene.tethers[0].strength, std::numeric_limits<double>::infinity());
  EXPECT_FALSE(rests_on(job, "axial_stiffness_n"));
  EXPECT_FALSE(rests_on(job, "strength_n"));
  EXPECT_TRUE(rests_on(job, "damping_n_s_per_m"));
}

TEST(JobTether, EndsAtAPointOfTheRoom) {
  const Job job = job_of(std::string(kTwo) + R"([[room.point]]
name = "socket"
position_m = [1, 0, 0.4]
[[tether]]
item = "ventilator"
point_m = [0, 0, 0.4]
anchor = "socket"
slack_length_m = 1
stiffness_n_per_m = 1e4
strength_n = 100
)");
  EXPECT_EQ(job.scene.tethers.at(0).anchor, Vector3(1, 0, 0.4));
  EXPECT_EQ(job.scene.tethers[0].damping, 0);
}

/// Neither the other tether nor the job's items change what is drawn.
TEST(JobTether, IsDrawnByItsName) {
  const auto slack = [](const std::string& before) {
    const Job job = job_of(std::string(kTwo) + before + R"([[tether]]
name = "cord"
item = "pole"
kind = "power_cord"
point_m = [0, 0, 1]
anchor_m = [-1, 1, 1]
slack_length_m = { value = 2, distribution = { kind = "uniform", low = 1.5, high = 3, source = "s" } }
[uncertainty]
draw = 6
)");
    return job.scene.tethers.back().slack_length;
  };
  EXPECT_EQ(slack(""), 1.5 + 1.5 * Draw(1, 6).of_part("cord").probability("tether.slack_length_m"));
  EXPECT_EQ(slack(kTether), slack(""));
}

TEST(JobRoom, AFileIsDrawnAsThePartRoom) {
  const TempFolder folder;
  folder.write("bay.toml", R"(schema = "gurney-room/1"
name = "bay"
[[wall]]
from_m = [3, -1]
to_m = [3, 1]
thickness_m = { value = 0.2, distribution = { kind = "uniform", low = 0.1, high = 0.3, source = "s" } }
height_m = 2
)");
  const Job job = read_job(
      folder.write("job.toml", std::string("schema = \"gurney-job/1\"\n") + kTwo +
                                   "[room]\nfile = \"bay.toml\"\n[uncertainty]\ndraw = 6\n"));
  EXPECT_DOUBLE_EQ(std::get<RoomBox>(job.scene.room.at(0).shape).size.y(),
                   0.1 + 0.2 * Draw(1, 6).of_part("room").probability("wall[0].thickness_m"));
}

TEST(JobTether, ItsLengthIsMeasuredFromTheItemAsItStands) {
  const auto with_slack = [](const std::string& length) {
    return errors(
        "[item]\nequipment = \"infusion_pole\"\nposition_m = [2, 0]\nyaw_deg = "
        "90\n[[tether]]\nkind "
        "= \"iv_line\"\npoint_m = [1, 0, 1]\nanchor_m = [2, 3, 1]\nslack_length_m = " +
        length + "\n");
  };
  EXPECT_EQ(with_slack("2.001"), "(no error)");
  EXPECT_EQ(with_slack("1.999"),
            "a.toml:10:18: tether[0].slack_length_m = 1.999: must be at least 2, the distance from "
            "'infusion_pole' to the anchor at the start");
}

TEST(BadTether, TheMessagesSayWhatIsAllowed) {
  EXPECT_EQ(errors(std::string(kTwo) + R"([[room.point]]
name = "socket"
position_m = [1.5, 1, 0.4]
[[tether]]
name = "a"
item = "pol"
kind = "power_chord"
point_m = [0, 0, 1]
anchor = "sockt"
slack_length_m = 2
[[tether]]
name = "a"
point_m = [0, 0, 1]
slack_length_m = 0
[[tether]]
item = "ventilator"
kind = "iv_line"
point_m = [0, 0, 0.4]
anchor = "socket"
slack_length_m = 0.4
)"),
            "a.toml:15:8: tether[0].item = \"pol\": no such item; did you mean 'pole'?\n"
            "a.toml:16:8: tether[0].kind = \"power_chord\": unknown kind of tether; did you mean "
            "'power_cord'?\n"
            "a.toml:18:10: tether[0].anchor = \"sockt\": the room has no such point; did you mean "
            "'socket'?\n"
            "a.toml:20:1: tether[1].item: missing; must be text in quotes\n"
            "a.toml:20:1: tether[1].anchor: must name a [[room.point]], or anchor_m must give a "
            "place, not both\n"
            "a.toml:20:1: tether[1].stiffness_n_per_m: missing; must be a finite number > 0\n"
            "a.toml:20:1: tether[1].strength_n: missing; must be a number > 0 or inf\n"
            "a.toml:21:8: tether[1].name = \"a\": must differ from the name at a.toml:14:8\n"
            "a.toml:23:18: tether[1].slack_length_m = 0: must be a finite number > 0\n"
            "a.toml:29:18: tether[2].slack_length_m = 0.4: must be at least 0.5, the distance from "
            "'ventilator' to the anchor at the start");
}

/// The first seconds of a shipped job.
Response start_of(const std::string& name, double duration) {
  PreparedRun run = prepare_run(GURNEY_SOURCE_DIR "/studies/jobs/" + name + ".toml");
  run.facts.settings.duration = duration;
  return simulate(run.facts.scene, run.facts.floor, run.facts.settings);
}

TEST(ShippedJob, TrolleyMeetsTheWallWithAForce) {
  const Response response = start_of("trolley_meets_wall", 2);
  ASSERT_FALSE(response.impacts.empty());
  const Impact& impact = response.impacts[0];
  EXPECT_EQ(impact.other, "wall");
  // It starts at 0.8 m/s and rolls 0.45 m against a resistance of at most 0.04 of its weight.
  EXPECT_LT(impact.approach_speed, 0.8);
  EXPECT_GT(impact.approach_speed, std::sqrt(0.8 * 0.8 - 2 * 0.04 * 9.80665 * 0.45));
  EXPECT_GT(impact.peak_force, 0);
}

TEST(ShippedJob, IcuBayHasItsFourItemsAndTheirTethers) {
  const Response response = start_of("icu_bay", 1);
  EXPECT_FALSE(is_failure(response.outcome)) << response.cause;
  EXPECT_EQ(response.items.size(), 4u);
  EXPECT_EQ(response.tethers.size(), 4u);
  EXPECT_EQ(response.zones.size(), 2u);
}

TEST(ShippedJob, TenItemsShareTheTheatre) {
  const Response response = start_of("ten_items", 1);
  EXPECT_FALSE(is_failure(response.outcome)) << response.cause;
  EXPECT_EQ(response.items.size(), 10u);
}

}  // namespace
}  // namespace gurney::study
