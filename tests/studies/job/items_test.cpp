#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "engine/base/random/draw.h"
#include "engine/base/units.h"
#include "studies/job/items_reader.h"
#include "tests/studies/job/job_text.h"
#include "tests/support/error_text.h"

namespace gurney::study {
namespace {

Job job_of(const std::string& text) { return job_of_text("schema = \"gurney-job/1\"\n" + text); }

std::string errors(const std::string& text) {
  return error_text([&] { job_of(text); });
}

/// Values of what was drawn for the part, by the names without it.
std::map<std::string, double> drawn_for(const Job& job, const std::string& part) {
  std::map<std::string, double> values;
  for (const equipment::Assumption& each : job.assumptions)
    if (!each.distribution.empty() && each.key.starts_with(part))
      values[each.key.substr(part.size())] = each.value;
  return values;
}

constexpr const char* kThree = R"([[item]]
equipment = "icu_bed"
position_m = [2, 0]
yaw_deg = 90
[[item]]
equipment = "infusion_pole"
position_m = [0, 2]
brakes = false
[[item]]
equipment = "infusion_pole"
name = "pump"
position_m = [0, 4]
)";

TEST(Items, EachHasItsEquipmentNameAndPlace) {
  const Job job = job_of(kThree);
  ASSERT_EQ(job.scene.items.size(), 3u);
  EXPECT_EQ(job.scene.items[0].name, "icu_bed");
  EXPECT_EQ(job.scene.items[1].name, "infusion_pole");
  EXPECT_EQ(job.scene.items[2].name, "pump");
  EXPECT_EQ(job.scene.items[0].initial.position, Vector3(2, 0, 0));
  EXPECT_DOUBLE_EQ(job.scene.items[0].initial.yaw, 90 * kRadiansPerDegree);
  EXPECT_EQ(job.scene.items[2].initial.position, Vector3(0, 4, 0));
  EXPECT_GT(job.scene.items[0].model.chassis_mass, job.scene.items[1].model.chassis_mass);
  EXPECT_EQ(job.scene.items[1].model.chassis_mass, job.scene.items[2].model.chassis_mass);
}

TEST(Items, NamesTakenTwiceAreNumberedAfterTheStatedOnes) {
  const Job job = job_of(
      "[[item]]\nequipment = 'icu_bed'\n[[item]]\nequipment = 'icu_bed'\nposition_m = [3, 0]\n"
      "[[item]]\nequipment = 'icu_bed'\nposition_m = [6, 0]\n[[item]]\nequipment = 'icu_bed'\n"
      "name = 'icu_bed 2'\nposition_m = [9, 0]\n");
  std::vector<std::string> names;
  for (const PlacedItem& item : job.scene.items) names.push_back(item.name);
  EXPECT_EQ(names, (std::vector<std::string>{"icu_bed", "icu_bed 3", "icu_bed 4", "icu_bed 2"}));
}

TEST(Items, OneTableOfAnArrayIsOneItem) {
  const Job job =
      job_of("[[item]]\nequipment = 'icu_bed'\n[initial]\nvelocity_m_per_s = [1, 0, 0]\n");
  ASSERT_EQ(job.scene.items.size(), 1u);
  EXPECT_EQ(job.scene.items[0].initial.velocity, Vector3(1, 0, 0));
}

// The last table [[item]] is the pump's.
TEST(Items, EachHasItsLoadsFixtureAndInitialMotion) {
  const Job job = job_of(std::string(kThree) +
                         "[[item.force]]\npoint_m = [0, 0, 1]\ndirection = [1, 0, 0]\n"
                         "force_n = 40\nuntil_s = 3\n"
                         "[[item.blocks]]\npoint_m = [0, 0, 0.1]\nrelease_time_s = 1\n"
                         "[item.fixture]\nyaw = \"held\"\n"
                         "[item.initial]\nvelocity_m_per_s = [1, 0, 0]\n");
  const PlacedItem& pump = job.scene.items[2];
  ASSERT_EQ(loads_of<PointForce>(pump.loads).size(), 1u);
  EXPECT_EQ(loads_of<PointForce>(pump.loads)[0].name, "force 1");
  EXPECT_EQ(loads_of<Blocks>(pump.loads).size(), 1u);
  EXPECT_EQ(pump.fixture.guides[5].kind, Guide::Kind::kHeld);
  EXPECT_EQ(pump.initial.velocity, Vector3(1, 0, 0));
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_TRUE(job.scene.items[i].loads.empty());
    EXPECT_EQ(job.scene.items[i].fixture.guides[5].kind, Guide::Kind::kFree);
    EXPECT_EQ(job.scene.items[i].initial.velocity, Vector3(0, 0, 0));
  }
}

TEST(Items, LoadsOfASingleItemMayStandAtTheTop) {
  const std::string item = "[item]\nequipment = 'icu_bed'\n";
  const std::string force =
      "point_m = [0, 0, 1]\ndirection = [1, 0, 0]\nforce_n = 40\nuntil_s = 3\n";
  const Job top = job_of(item + "[[excitation.force]]\n" + force);
  const Job below = job_of(item + "[[item.force]]\n" + force);
  EXPECT_EQ(loads_of<PointForce>(top.scene.items[0].loads)[0].force,
            loads_of<PointForce>(below.scene.items[0].loads)[0].force);
}

TEST(Items, LoadsOfSeveralMustBeWithOneOfThem) {
  const std::string text = std::string(kThree) +
                           "[[excitation.force]]\npoint_m = [0, 0, 1]\n"
                           "direction = [1, 0, 0]\nforce_n = 40\nuntil_s = 3\n"
                           "[initial]\nvelocity_m_per_s = [1, 0, 0]\n";
  const std::string errors = error_text([&] { job_of(text); });
  EXPECT_THAT(errors, testing::HasSubstr("excitation.force: must be with one of the items, "
                                         "[[item.force]] below its [[item]]"));
  EXPECT_THAT(errors, testing::HasSubstr("initial: must be with one of the items, [item.initial] "
                                         "below its [[item]]"));
  EXPECT_THAT(errors, testing::Not(testing::HasSubstr("unknown")));
}

TEST(Items, RefusesTwoFixturesOfOneItem) {
  EXPECT_THAT(error_text([] {
                job_of(
                    "[item]\nequipment = 'icu_bed'\n[item.fixture]\nyaw = 'held'\n"
                    "[fixture]\nyaw = 'held'\n");
              }),
              testing::HasSubstr("fixture: must not be given beside item.fixture"));
}

constexpr const char* kYaw =
    "yaw_deg = { value = 0, distribution = { kind = 'uniform', low = 0, high = 360, source = 's' } "
    "}\n";

TEST(Items, AreDrawnApartWhateverElseStandsThere) {
  const std::string draw = "[uncertainty]\nseed = 7\ndraw = 3\n";
  const std::string a = std::string("[[item]]\nequipment = 'icu_ventilator'\nname = 'a'\n") + kYaw;
  const std::string b =
      std::string("[[item]]\nequipment = 'icu_ventilator'\nname = 'b'\nposition_m = [4, 0]\n") +
      kYaw;
  const Job both = job_of(a + b + draw), turned = job_of(b + a + draw), alone = job_of(a + draw);
  const auto of_a = drawn_for(both, "a/"), of_b = drawn_for(both, "b/");
  // mass, three of the centre of mass, yaw; nine constants of each caster.
  EXPECT_EQ(of_a.size(), 4u + 1 + 4 * 9);
  EXPECT_EQ(of_b.size(), of_a.size());
  EXPECT_EQ(of_a, drawn_for(turned, "a/"));
  EXPECT_EQ(of_a, drawn_for(alone, "a/"));
  EXPECT_EQ(of_b, drawn_for(turned, "b/"));
  EXPECT_NE(of_a.at("chassis.mass_kg"), of_b.at("chassis.mass_kg"));
  EXPECT_NE(of_a.at("item.yaw_deg"), of_b.at("item.yaw_deg"));
  EXPECT_EQ(of_a.at("item.yaw_deg"), 360 * Draw(7, 3).of_part("a").probability("item.yaw_deg"));
  EXPECT_EQ(both.scene.items[1].model.chassis_mass, of_b.at("chassis.mass_kg"));
  // [item] is drawn under no part.
  EXPECT_EQ(
      drawn_for(job_of(std::string("[item]\nequipment = 'icu_ventilator'\n") + kYaw + draw), "")
          .at("item.yaw_deg"),
      360 * Draw(7, 3).probability("item.yaw_deg"));
}

TEST(Items, WhatIsWrittenInTheJobIsDrawnByTheNameOfItsItem) {
  const std::string inline_item = R"([item.inline]
name = "block"
chassis = { mass_kg = { value = 50, distribution = { kind = "uniform", low = 40, high = 60, source = "s" } }, center_of_mass_mm = [0, 0, 400], inertia_box_mm = [600, 500, 800] }
shape = [{ center_mm = [0, 0, 400], size_mm = [600, 500, 800] }]
caster = [
  { type = "P100", position_mm = [250, 200, 0] },
  { type = "P100", position_mm = [250, -200, 0] },
  { type = "P100", position_mm = [-250, 0, 0] },
]
)";
  const Job job = job_of("[[item]]\nequipment = 'icu_bed'\nposition_m = [5, 0]\n[[item]]\n" +
                         inline_item + "[uncertainty]\ndraw = 2\n");
  EXPECT_EQ(job.scene.items[1].name, "block");
  EXPECT_EQ(job.scene.items[1].model.chassis_mass,
            40 + 20 * Draw(1, 2).of_part("block").probability("item.inline.chassis.mass_kg"));
}

TEST(Items, AssumptionsOfEachAreKeptOnce) {
  const auto count = [](const Job& job, const std::string& key) {
    return std::count_if(job.assumptions.begin(), job.assumptions.end(),
                         [&](const equipment::Assumption& each) { return each.key == key; });
  };
  const Job job = job_of(kThree);
  EXPECT_GT(count(job, "chassis.mass_kg"), 0);
  EXPECT_EQ(count(job, "chassis.mass_kg"),
            count(job_of("[[item]]\nequipment = 'icu_bed'\n[[item]]\nequipment = 'infusion_pole'\n"
                         "position_m = [3, 0]\n"),
                  "chassis.mass_kg"));
}

TEST(BadItems, AreAllNamedAtOnce) {
  EXPECT_EQ(errors(R"([[item]]
equipment = "icu_bad"
[[item]]
equipment = "icu_bed"
name = "bed"
headings_deg = [1, 2]
brake = true
[[item]]
equipment = "icu_bed"
name = "bed"
[[item]]
equipment = "icu_bed"
name = "floor"
variant = "brakes onn"
)")
                .substr(0, 74),
            "a.toml:3:13: item[0].equipment = \"icu_bad\": unknown item of equipment; did");
  const std::string text = errors(R"([[item]]
equipment = "icu_bed"
name = "bed"
headings_deg = [1, 2]
brake = true
[[item]]
equipment = "icu_bed"
name = "bed"
[[item]]
equipment = "icu_bed"
name = "floor"
)");
  EXPECT_EQ(text,
            "a.toml:5:16: item[0].headings_deg = [1, 2]: must be an array of 4 numbers, or one "
            "number for all\n"
            "a.toml:6:1: item[0].brake: unknown key; did you mean 'brakes'?\n"
            "a.toml:9:8: item[1].name = \"bed\": must differ from the name at a.toml:4:8\n"
            "a.toml:12:8: item[2].name = \"floor\": must not be empty or 'floor'");
  EXPECT_EQ(
      errors("[[item]]\nequipment = \"icu_bed\"\nname = \"m/laptop\"\n"),
      "a.toml:4:8: item[0].name = \"m/laptop\": must have no '/', which stands between an item and "
      "its parts and contents");
  EXPECT_EQ(errors("item = []\n"), "a.toml:2:8: item: must be tables [[item]], 1 or more");
  EXPECT_EQ(errors("item = [1]\n"), "a.toml:2:8: item = [1]: must be an array of tables [[item]]");
}

TEST(BadItems, KeysOfTheFileOfAnItemAreNamedAsSuch) {
  EXPECT_EQ(errors("[item]\nequipment = \"icu_bed\"\nmass_kg = 5\n"),
            "a.toml:4:11: item.mass_kg: unknown key; it belongs to the item's file, or to "
            "[item.inline]");
  EXPECT_EQ(errors("[item]\nequipment = \"icu_bed\"\n[[limit_state]]\nname = \"a\"\n"),
            "a.toml:4:3: limit_state: unknown key; did you mean 'study.limit_state'?");
}

TEST(Warnings, AreGivenForAHeightInMetresUnderAKeyInMillimetres) {
  const auto warnings = [](const std::string& height) {
    return job_of_text(
               "schema = \"gurney-job/1\"\n[item.inline]\nname = \"block\"\n"
               "chassis = { mass_kg = 30, center_of_mass_mm = [0, 0, " +
               height +
               "], inertia_box_mm = [900, 900, 800] }\n"
               "shape = [{ center_mm = [0, 0, 400], size_mm = [900, 900, 800] }]\n"
               "contact = { material = \"feet\", friction = 0.5, restitution = 0.2 }\n")
        .warnings;
  };
  EXPECT_TRUE(warnings("400").empty());
  EXPECT_EQ(warnings("0.45"),
            (std::vector<std::string>{
                "block: the centre of mass of the chassis is 0.45 mm above the floor, under 1 % of "
                "the height of 800 mm; center_of_mass_mm is in mm"}));
}

/// The casters of the second are wrong only once it is put together.
TEST(BadItems, WhatCannotBePutTogetherIsNamedBesideTheErrorsOfOthers) {
  const std::string text = errors(R"([[item]]
equipment = "icu_bed"
yaw = 3
headings_deg = "any"
[[item]]
position_m = [4, 0]
[item.inline]
name = "cart"
chassis = { mass_kg = 30, center_of_mass_mm = [0, 0, 400], inertia_box_mm = [600, 400, 800] }
shape = [{ center_mm = [0, 0, 400], size_mm = [600, 400, 800] }]
caster = [
  { type = "R100", position_mm = [250, 150, 0] },
  { type = "R125", position_mm = [250, -150, 0] },
  { type = "R100", position_mm = [-250, 0, 0] },
]
)");
  EXPECT_THAT(text, testing::HasSubstr("a.toml:4:1: item[0].yaw: unknown key"));
  EXPECT_THAT(text, testing::HasSubstr("a.toml:5:16: item[0].headings_deg = \"any\""));
  EXPECT_THAT(text, testing::HasSubstr("a.toml:14:34: caster 'caster 2': its base plate would be"));
}

}  // namespace
}  // namespace gurney::study
