#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/studies/job/job_text.h"

// Parts and contents of items in jobs.
namespace gurney::study {
namespace {

using testing::HasSubstr;
using testing::Not;

/// A job of one item on feet; lines of the job, of the item, and tables of the item follow.
std::string job_with(const std::string& item, const std::string& tables) {
  return "schema = \"gurney-job/1\"\n[item]\nname = \"desk\"\nposition_m = [1, 2]\nyaw_deg = 90\n" +
         item +
         "[item.inline]\nname = \"Desk\"\n[item.inline.chassis]\nmass_kg = 50\ncenter_of_mass_mm = "
         "[0, 0, 300]\n"
         "inertia_box_mm = [900, 600, 700]\n[item.inline.contact]\nmaterial = \"feet\"\nfriction = "
         "0.5\n"
         "restitution = 0.2\n[[item.inline.shape]]\ncenter_mm = [0, 0, 350]\nsize_mm = [900, 600, "
         "700]\n" +
         tables;
}

/// A part of 2 kg, a cube of 100 mm, at `center`.
std::string part(const std::string& name, const std::string& center, const std::string& more) {
  return "[[item.inline.part]]\nname = \"" + name + "\"\nposition_mm = " + center +
         "\nmass_kg = 2\n" + "center_of_mass_mm = " + center +
         "\ninertia_box_mm = [100, 100, 100]\n" + more +
         "[[item.inline.part.shape]]\ncenter_mm = " + center + "\nsize_mm = [100, 100, 100]\n";
}

const std::string kDrawer =
    part("drawer", "[0, 0, 400]",
         "joint = \"slider\"\naxis = [2, 0, 0]\nlower_mm = 0\nupper_mm = 300\n"
         "friction_n = 4\nlatch_n = 15\nrelatches = true\n");
const std::string kArm =
    part("arm", "[400, 0, 900]",
         "joint = \"hinge\"\naxis = [0, 0, 1]\nlower_deg = -90\nupper_deg = 45\n"
         "friction_n_m = 2\n");
const std::string kBag =
    part("bag", "[400, 0, 700]", "on = \"arm\"\njoint = \"ball\"\ndamping_n_m_s_per_rad = 0.01\n");
const std::string kLamp =
    "[[item.inline.content]]\nname = \"lamp\"\nposition_mm = [100, 0, 700]\nyaw_deg = 30\nsize_mm "
    "= [100, 100, 400]\n"
    "mass_kg = 1\n[item.inline.content.contact]\nmaterial = \"rubber\"\nfriction = "
    "0.6\nrestitution = 0.1\n";

const std::string kFiles =
    "[[item.inline.payload]]\nname = \"files\"\non = \"drawer\"\nposition_mm = [0, 0, 380]\n"
    "mass_kg = 3\nsize_mm = [80, 80, 20]\ncount = 2\n";

TEST(JobParts, CarryPayloads) {
  const Scene scene = job_of_text(job_with("", kDrawer + kFiles)).scene;
  EXPECT_TRUE(scene.items[0].model.payloads.empty());
  const MassProperties drawer = chassis_with_payloads(scene.items[1].model);
  EXPECT_DOUBLE_EQ(drawer.mass, 2 + 2 * 3);
  // The drawer's centre at 400 mm, the files' at 390 and 410 mm.
  EXPECT_DOUBLE_EQ(drawer.center_of_mass.z(), 0.4);
  EXPECT_DOUBLE_EQ(
      chassis_with_payloads(
          job_of_text(job_with("payloads = {files = 5}\n", kDrawer + kFiles)).scene.items[1].model)
          .mass,
      2 + 5 * 3);
  EXPECT_THAT(errors_of_text(job_with("", kFiles)),
              HasSubstr("payload[0].on = \"drawer\": must be \"chassis\" or a part"));
}

TEST(JobParts, AreBodiesOfTheScene) {
  const Job job = job_of_text(job_with("", kDrawer + kArm + kBag + kLamp));
  const Scene& scene = job.scene;
  ASSERT_EQ(scene.items.size(), 5U);
  EXPECT_EQ(scene.items[1].name, "desk/drawer");
  EXPECT_EQ(scene.items[3].name, "desk/bag");
  EXPECT_EQ(scene.items[4].name, "desk/lamp");
  ASSERT_EQ(scene.joints.size(), 3U);
  const Joint& drawer = scene.joints[0];
  EXPECT_EQ(drawer.kind, Joint::Kind::kSlider);
  EXPECT_EQ(drawer.base, 0U);
  EXPECT_EQ(drawer.part, 1U);
  EXPECT_EQ(drawer.axis, Vector3::UnitX());
  EXPECT_DOUBLE_EQ(drawer.upper, 0.3);
  EXPECT_DOUBLE_EQ(drawer.lower, 0);
  EXPECT_EQ(drawer.latch, 15);
  EXPECT_TRUE(drawer.relatches);
  EXPECT_NEAR(scene.joints[1].lower, -std::numbers::pi / 2, 1e-12);
  EXPECT_EQ(scene.joints[2].base, 2U) << "the bag hangs on the arm";
  EXPECT_EQ(scene.joints[2].damping, 0.01);
  for (std::size_t i : {1u, 2u, 3u}) {
    EXPECT_EQ(scene.items[i].initial.position, scene.items[0].initial.position);
    EXPECT_EQ(scene.items[i].model.material, scene.items[0].model.material);
  }
  const PlacedItem& lamp = scene.items[4];
  ASSERT_TRUE(lamp.on);
  EXPECT_EQ(lamp.on->index, 0U);
  EXPECT_DOUBLE_EQ(lamp.on->height, 0.7);
  EXPECT_NEAR(lamp.initial.position.y(), 2.1, 1e-12) << "0.1 m ahead of a desk turned by 90 deg";
  EXPECT_NEAR(lamp.initial.yaw, 2 * std::numbers::pi / 3, 1e-12);
  EXPECT_NO_THROW(validate(scene));
}

std::string changed(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

std::string locked(const std::string& part) {
  return changed(part, "relatches = true", "relatches = true\nlocked = true");
}

TEST(JobParts, AreChosenByTheJob) {
  const Job job = job_of_text(
      job_with("locked_parts = [\"arm\"]\ncontents = []\n", locked(kDrawer) + kArm + kLamp));
  ASSERT_EQ(job.scene.items.size(), 3U);
  EXPECT_EQ(job.scene.joints[0].latch, 15) << "these parts and no others are locked";
  EXPECT_TRUE(std::isinf(job.scene.joints[1].latch));
  EXPECT_THAT(errors_of_text(job_with("locked_parts = [\"drawr\"]\n", kDrawer)),
              HasSubstr("Desk has none of this name; did you mean 'drawer'?"));
}

TEST(JobParts, OnlyHingesAndSlidersAreLocked) {
  EXPECT_THAT(errors_of_text(job_with("locked_parts = [\"bag\"]\n", kArm + kBag)),
              HasSubstr(":6:16: item.locked_parts = \"bag\": its joint is \"ball\"; must be "
                        "\"hinge\" or \"slider\""));
  EXPECT_THAT(errors_of_text(job_with("locked_parts = [\"arm\", \"arm\"]\n", kArm)),
              HasSubstr("item.locked_parts = \"arm\": stands twice"));
}

// I about the foot across the axis: 2 (0.1^2 / 6 + 0.6^2) of the mast, 2 (0.1^2 / 6 + 0.8^2 + 0.3^2
// / 2) of the bag 0.3 m beside it; they lift by 0.6 and 0.8 m. The desk stands at (1, 2), turned by
// 90 degrees: the arm's point (400, 0, 900) mm is at (1, 2.4, 0.9) m of the room, the lamp's top,
// (100, 0, 700) + (0, 0, 400) mm, at (1, 2.1, 1.1) m.
TEST(JobParts, TethersHoldThemToTheRoomAndToEachOther) {
  const std::string to_room =
      "[[tether]]\nitem = \"desk/arm\"\nkind = \"power_cord\"\npoint_m = [0.4, 0, 0.9]\n"
      "anchor_m = [1, 3.4, 0.9]\nslack_length_m = 1.01\n";
  const std::string strap =
      "[[tether]]\nitem = \"desk/lamp\"\nkind = \"strap\"\npoint_m = [0, 0, 0.4]\n"
      "anchor_item = \"desk/arm\"\nanchor_m = [0.4, 0, 0.9]\nslack_length_m = 0.37\n";
  const Job job = job_of_text(job_with("", kArm + kLamp) + to_room + strap);
  ASSERT_EQ(job.scene.tethers.size(), 2u);
  EXPECT_EQ(job.scene.tethers[0].item, 1u);
  EXPECT_FALSE(job.scene.tethers[0].anchor_item);
  EXPECT_EQ(job.scene.tethers[1].item, 2u);
  EXPECT_EQ(job.scene.tethers[1].anchor_item, std::size_t{1});
  EXPECT_NEAR(placed_length(job.scene, job.scene.tethers[0]), 1, 1e-12);
  EXPECT_NEAR(placed_length(job.scene, job.scene.tethers[1]), std::hypot(0.3, 0.2), 1e-12);
  const auto errors = [&](const std::string& tether) {
    return errors_of_text(job_with("", kArm + kLamp) + tether);
  };
  EXPECT_THAT(errors(changed(to_room, "= 1.01", "= 0.9")),
              HasSubstr("tether[0].slack_length_m = 0.9: must be at least 1, the distance from "
                        "'desk/arm' to the anchor at the start"));
  EXPECT_THAT(
      errors(changed(strap, "= 0.37", "= 0.3")),
      HasSubstr("tether[0].slack_length_m = 0.3: must be at least 0.3606, the distance from "
                "'desk/lamp' to 'desk/arm' at the start"));
  EXPECT_THAT(errors(changed(strap, "\"desk/arm\"", "\"desk/arn\"")),
              HasSubstr("anchor_item = \"desk/arn\": no such item; did you mean 'desk/arm'?"));
  EXPECT_THAT(errors(changed(strap, "\"desk/arm\"", "\"desk/lamp\"")),
              HasSubstr("anchor_item = \"desk/lamp\": must not be the tether's own item"));
  EXPECT_THAT(errors(strap + "anchor = \"socket\"\n"),
              HasSubstr("anchor: must not be given with anchor_item, whose place is anchor_m"));
}

TEST(JobParts, FlexibleJointsHaveTheirFrequency) {
  const std::string mast = part("mast", "[0, 0, 1300]",
                                "joint = \"flexible\"\nfrequency_hz = 2\ndamping_ratio = 0.05\n");
  std::string text =
      job_with("", mast + part("bag", "[300, 0, 1500]", "on = \"mast\"\njoint = \"fixed\"\n"));
  const std::string from = "position_mm = [0, 0, 1300]";
  text.replace(text.find(from), from.size(), "position_mm = [0, 0, 700]");
  const Joint joint = job_of_text(text).scene.joints[0];
  const double inertia = 2 * (0.01 / 6 + 0.36) + 2 * (0.01 / 6 + 0.64 + 0.045);
  const double rate = 4 * std::numbers::pi;
  EXPECT_NEAR(joint.stiffness, inertia * rate * rate + 2 * 9.80665 * (0.6 + 0.8),
              1e-9 * joint.stiffness);
  EXPECT_NEAR(joint.damping, 2 * 0.05 * inertia * rate, 1e-9);
}

TEST(JobParts, RefuseWhatCannotBe) {
  const auto errors = [](const std::string& tables) {
    return errors_of_text(job_with("", tables));
  };
  EXPECT_THAT(errors(part("bag", "[0, 0, 900]", "on = \"arm\"\njoint = \"ball\"\n") + kArm),
              HasSubstr("on = \"arm\": must be \"chassis\" or a part before this one"));
  EXPECT_THAT(errors(part("door", "[0, 0, 900]", "joint = \"hing\"\naxis = [0, 0, 1]\n")),
              HasSubstr("did you mean 'hinge'?"));
  EXPECT_THAT(errors(part("door", "[0, 0, 900]", "joint = \"hinge\"\n")),
              HasSubstr("axis: missing"));
  EXPECT_THAT(errors(part("door", "[0, 0, 900]", "joint = \"hinge\"\naxis = [0, 0, 0]\n")),
              HasSubstr("axis = [0, 0, 0]: must have a length"));
  EXPECT_THAT(errors(part("door", "[0, 0, 900]", "joint = \"hinge\"\naxis = [nan, 0, 0]\n")),
              Not(HasSubstr("must have a length")));
  EXPECT_THAT(
      errors(part("door", "[0, 0, 900]", "joint = \"hinge\"\naxis = [0, 0, 1]\nrest_deg = 5\n")),
      HasSubstr("rest_deg: must go with stiffness_n_m_per_rad"));
  EXPECT_THAT(errors(part("drawer", "[0, 0, 400]",
                          "joint = \"slider\"\naxis = [1, 0, 0]\nlower_mm = 10\n")),
              HasSubstr("lower_mm = 10: must be"));
  EXPECT_THAT(errors(part("drawer", "[0, 0, 400]",
                          "joint = \"slider\"\naxis = [1, 0, 0]\nfriction_n_m = 1\n")),
              HasSubstr("friction_n_m: unknown key; did you mean 'friction_n'?"));
  EXPECT_THAT(errors(part("drawer", "[0, 0, 400]",
                          "joint = \"slider\"\naxis = [1, 0, 0]\nrelatches = true\n")),
              HasSubstr("relatches: must go with latch_n > 0"));
  const std::string drawer = "joint = \"slider\"\naxis = [1, 0, 0]\n";
  EXPECT_THAT(errors(part("drawer", "[0, 0, 400]", drawer + "lower_mm = 0\nupper_mm = 0\n")),
              HasSubstr("upper_mm = 0: leaves no way between the stops, as lower_mm = 0"));
  EXPECT_THAT(errors(part("drawer", "[0, 0, 400]", drawer + "stop_restitution = 0.5\n")),
              HasSubstr("stop_restitution: must go with lower_mm or upper_mm"));
  EXPECT_THAT(errors(part("mast", "[0, 0, 900]", "joint = \"flexible\"\n")),
              HasSubstr("frequency_hz: must be given, or stiffness_n_m_per_rad, not both"));
  EXPECT_THAT(errors(kDrawer + kDrawer), HasSubstr("must differ from the name of part[0]"));
  std::string floating = kLamp;
  floating.replace(floating.find("0, 700]"), 7, "0, 750]");
  EXPECT_THAT(
      errors(floating),
      HasSubstr("content 'lamp': no shape of the chassis has a level top below it at 750 mm"));
  EXPECT_THAT(errors(changed(kDrawer, "mass_kg = 2", "mass_kg = 0")),
              HasSubstr("part[0].mass_kg = 0: must be"));
}

// The desk is 900 mm long: the drawer's box, 100 mm, begins 10 m and 1.2 m from its end.
TEST(JobParts, PartsAndContentsAreOfTheSizeOfTheItem) {
  const std::string drawer = "joint = \"slider\"\naxis = [1, 0, 0]\n";
  const auto job = [](const std::string& tables) { return job_with("", tables); };
  EXPECT_THAT(errors_of_text(job(part("drawer", "[10500, 0, 400]", drawer))),
              HasSubstr("a.toml:21:15: part 'drawer': its shapes, its joint and the chassis, which "
                        "carries it, are 10000 mm apart: must be within 5000 mm"));
  const auto warned = [&](const std::string& tables) {
    std::string all;
    for (const std::string& line : job_of_text(job(tables)).warnings) all += line + "\n";
    return all;
  };
  EXPECT_THAT(warned(part("drawer", "[1700, 0, 400]", drawer)),
              HasSubstr("part 'drawer': its shapes, its joint and the chassis, which carries it, "
                        "are 1200 mm apart; positions are in mm"));
  EXPECT_THAT(warned(part("drawer", "[900, 0, 400]", drawer)), Not(HasSubstr("apart")));
  // The drawer's box is 100 mm high, about 400 mm.
  const auto with_mass_at = [&](const std::string& z) {
    return changed(part("drawer", "[0, 0, 400]", drawer), "center_of_mass_mm = [0, 0, 400]",
                   "center_of_mass_mm = [0, 0, " + z + "]");
  };
  EXPECT_THAT(warned(with_mass_at("0.4")),
              HasSubstr("part 'drawer': its centre of mass is 350 mm outside of its shapes"));
  EXPECT_THAT(warned(with_mass_at("500")), Not(HasSubstr("outside")));
  EXPECT_THAT(errors_of_text(job(with_mass_at("40000"))), HasSubstr("must be within 5000 mm"));
  // A hinge far from its door; of a slider the point is any.
  const auto displaced = [&](const std::string& joint) {
    return changed(part("door", "[0, 0, 400]", "joint = \"" + joint + "\"\naxis = [1, 0, 0]\n"),
                   "position_mm = [0, 0, 400]", "position_mm = [0, 6000, 400]");
  };
  EXPECT_THAT(errors_of_text(job(displaced("hinge"))), HasSubstr("must be within 5000 mm"));
  EXPECT_THAT(warned(displaced("slider")), Not(HasSubstr("apart")));
  EXPECT_THAT(errors_of_text(job(changed(kLamp, "100, 100, 400]", "1, 100, 400]"))),
              HasSubstr("content 'lamp': is 1 mm in its smallest extent: must be 2 mm or more"));
}

TEST(JobParts, ContentsThatOverlapAreAnError) {
  std::string second = kLamp;
  second.replace(second.find("\"lamp\""), 6, "\"vase\"");
  EXPECT_THAT(errors_of_text(job_with("", kLamp + second)),
              HasSubstr("content 'vase' stands 100 mm deep in content 'lamp'"));
}

}  // namespace
}  // namespace gurney::study
