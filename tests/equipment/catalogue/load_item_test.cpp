#include "equipment/catalogue/load_item.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <numbers>

#include "engine/base/units.h"
#include "equipment/catalogue/at_rest.h"
#include "equipment/catalogue/catalogue.h"
#include "equipment/catalogue/support.h"
#include "tests/support/catalogue_list.h"
#include "tests/support/error_text.h"
#include "tests/support/temp_folder.h"

namespace gurney::equipment {
namespace {

std::string item_file(const std::string& name) { return find_data(DataKind::kItem, name, ""); }

CasterType caster(const std::string& name) {
  return load_caster_type(find_data(DataKind::kCaster, name, "")).stated();
}

bool assumes(const LoadedItem& item, const std::string& key) {
  return std::any_of(item.assumptions.begin(), item.assumptions.end(),
                     [&](const Assumption& each) { return each.key == key; });
}

/// Lines that each begin with the file.
std::string at(const std::string& file, const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) {
    if (!text.empty()) text += '\n';
    text += file + line;
  }
  return text;
}

constexpr const char* kCart = R"(schema = "gurney-item/1"
name = "cart"
[chassis]
mass_kg = 50
center_of_mass_mm = [0, 0, 400]
inertia_kg_m2 = [4, 5, 3]
inertia_products_kg_m2 = [0.1, 0.2, 0.3]
[[shape]]
center_mm = [0, 0, 400]
size_mm = [600, 500, 800]
[[caster]]
type = "R100"
position_mm = [250, 200, 0]
[[caster]]
type = "R100"
position_mm = [250, -200, 0]
[[caster]]
type = "R100"
position_mm = [-250, 0, 0]
heading_deg = 90
brake = true
)";

TEST(LoadItem, PutsTheTrolleyOfThePaperOnItsCasters) {
  const EquipmentModel trolley = load_item(item_file("xu_trolley")).model;
  EXPECT_EQ(trolley.chassis_mass, 96.5);
  // 487 mm above the base plate, which is as high as the casters: 131 mm or 160 mm.
  EXPECT_DOUBLE_EQ(trolley.chassis_center_of_mass.z(), 0.618);
  ASSERT_EQ(trolley.casters.size(), 4u);
  EXPECT_DOUBLE_EQ(trolley.casters[0].trail, 0.034);
  EXPECT_DOUBLE_EQ(trolley.casters[0].mount.z(), 0.131);
  // Cr / R = 0.02 for 100 mm and 0.016 for 125 mm.
  EXPECT_DOUBLE_EQ(
      trolley.casters[0].tread.rolling_friction_length / trolley.casters[0].wheel_radius, 0.02);
  ItemOptions options;
  options.caster = caster("R125");
  const EquipmentModel higher = load_item(item_file("xu_trolley"), options).model;
  EXPECT_DOUBLE_EQ(higher.chassis_center_of_mass.z(), 0.647);
  EXPECT_DOUBLE_EQ(higher.casters[0].tread.rolling_friction_length / higher.casters[0].wheel_radius,
                   0.016);
}

TEST(LoadItem, ReadsEveryConstantOfAnItem) {
  const TempFolder folder;
  const LoadedItem cart = load_item(folder.write("cart.toml", kCart));
  Matrix3 inertia;
  inertia << 4, 0.1, 0.2, 0.1, 5, 0.3, 0.2, 0.3, 3;
  EXPECT_EQ(cart.model.chassis_inertia, inertia);
  EXPECT_EQ(cart.model.casters[0].name, "caster 1");
  EXPECT_EQ(cart.model.casters[0].brake_torque, 0);
  EXPECT_EQ(cart.model.casters[2].brake_torque, 10);
  EXPECT_DOUBLE_EQ(cart.model.casters[2].heading, 90 * kRadiansPerDegree);
  EXPECT_NEAR((cart.model.shape[0].center - Vector3(0, 0, 0.531)).norm(), 0, 1e-15);
}

TEST(LoadItem, OptionsChangeHeadingsBrakesLocksAndFloor) {
  const TempFolder folder;
  ItemOptions options;
  options.headings = {0.1, 0.2, 0.3};
  options.brakes = {true, false, false};
  options.swivel_locks = {false, true, false};
  options.floor = FloorCovering{"carpet", 3, 0.5, {}};
  const EquipmentModel cart = load_item(folder.write("cart.toml", kCart), options).model;
  EXPECT_EQ(cart.casters[1].heading, 0.2);
  EXPECT_EQ(cart.casters[0].brake_torque, 10);
  EXPECT_EQ(cart.casters[2].brake_torque, 0);
  EXPECT_EQ(cart.casters[1].swivel_lock_torque, 20);
  EXPECT_DOUBLE_EQ(cart.casters[0].tread.rolling_friction_length, 3e-3);
  EXPECT_DOUBLE_EQ(cart.casters[0].tread.static_friction, 0.3);
  EXPECT_DOUBLE_EQ(cart.casters[0].tread.kinetic_friction, 0.3);
}

TEST(LoadItem, BrakesOfACasterMaySlideWithLessThanTheyHold) {
  std::ifstream file(find_data(DataKind::kCaster, "R100", ""));
  std::string text((std::istreambuf_iterator<char>(file)), {});
  const auto with = [&](const std::string& ratio) {
    std::string changed = text;
    return changed.insert(changed.find("\nname = ") + 1, "brake_sliding_ratio = " + ratio + "\n");
  };
  const TempFolder folder;
  folder.write("slides.toml", with("0.6"));
  std::string cart = kCart;
  for (auto at = cart.find("R100"); at != std::string::npos; at = cart.find("R100"))
    cart.replace(at, 4, "slides.toml");
  const EquipmentModel item = load_item(folder.write("cart.toml", cart)).model;
  EXPECT_EQ(item.casters[0].brake_sliding_ratio, 1);  // it is off
  EXPECT_EQ(item.casters[2].brake_sliding_ratio, 0.6);

  const std::string bad = folder.write("bad.toml", with("1.2"));
  const std::string error = error_text([&] { load_caster_type(bad); });
  EXPECT_NE(error.find("brake_sliding_ratio = 1.2: must be"), std::string::npos) << error;
}

TEST(LoadItem, StacksPayloads) {
  ItemOptions options;
  options.payloads = {{"paver", 2}};
  const LoadedItem loaded = load_item(item_file("xu_trolley"), options);
  ASSERT_EQ(loaded.model.payloads.size(), 2u);
  EXPECT_EQ(loaded.model.payloads[1].name, "paver 2");
  EXPECT_EQ(loaded.model.payloads[1].mass, 13.6);
  // Base plate at 131 mm, first paver 10 mm above its underside, each 37 mm thick.
  EXPECT_NEAR(loaded.model.payloads[0].center_of_mass.z(), 0.131 + 0.010 + 0.0185, 1e-15);
  EXPECT_NEAR(loaded.model.payloads[1].center_of_mass.z(), 0.131 + 0.010 + 0.0555, 1e-15);
  EXPECT_NEAR(
      (loaded.model.payloads[0].inertia - solid_box_inertia(13.6, {0.4, 0.4, 0.037})).norm(), 0,
      1e-15);
}

TEST(LoadItem, ListsOnlyAssumptionsInUse) {
  const LoadedItem free = load_item(item_file("xu_trolley"));
  EXPECT_TRUE(assumes(free, "chassis.mass_kg"));
  EXPECT_TRUE(assumes(free, "trail_mm"));
  EXPECT_TRUE(assumes(free, "tread.patch_width_mm"));
  EXPECT_FALSE(assumes(free, "brake_torque_n_m"));
  EXPECT_FALSE(assumes(free, "swivel_lock_torque_n_m"));
  EXPECT_FALSE(assumes(free, "payload[0].size_mm.x"));
  ItemOptions other;
  other.caster = caster("R125");
  EXPECT_TRUE(assumes(load_item(item_file("icu_ventilator")), "caster[3].type"));
  EXPECT_FALSE(assumes(load_item(item_file("icu_ventilator"), other), "caster[3].type"));
  ItemOptions options;
  options.brakes = {false, false, false, true};
  options.payloads = {{"paver", 1}};
  const LoadedItem braked = load_item(item_file("xu_trolley"), options);
  EXPECT_TRUE(assumes(braked, "brake_torque_n_m"));
  EXPECT_TRUE(assumes(braked, "payload[0].size_mm.x"));
}

TEST(LoadItem, NotesEveryErrorOfAnItemAndItsCasters) {
  const TempFolder folder;
  const std::string caster_file = folder.write("bad.toml", R"(schema = "gurney-caster/1"
name = "bad"
height_mm = 100
wheel_diameter_mm = 0
)");
  const std::string file = folder.write("cart.toml", R"(schema = "gurney-item/2"
name = "cart"
[chassis]
mass_kg = -3
center_of_mass_mm = [0, 0, nan]
[[caster]]
type = "R12"
position_mm = [250, 200, 0]
brakes = true
[[caster]]
type = "bad.toml"
position_mm = [250, "left", 0]
name = "caster 1"
)");
  const std::string text = error_text([&] { load_item(file); });
  EXPECT_EQ(
      text.substr(0, text.find("\n" + caster_file)),
      at(file, {":1:1: shape: must have at least one box or other solid [[shape]]",
                ":1:10: schema = \"gurney-item/2\": must be \"gurney-item/1\"",
                ":3:1: chassis.inertia_box_mm: missing; must be given, or inertia_kg_m2 in its "
                "place",
                ":4:11: chassis.mass_kg = -3: must be a finite number > 0",
                ":5:28: chassis.center_of_mass_mm[2] = nan: must be a finite number",
                ":6:1: caster[1].name = \"caster 1\": must differ from the name of caster[0]",
                ":7:8: caster[0].type = \"R12\": unknown caster; did you mean 'R125'?",
                ":9:1: caster[0].brakes: unknown key; did you mean 'brake'?",
                ":12:21: caster[1].position_mm[1] = \"left\": must be a finite number"}));
  EXPECT_NE(text.find(caster_file + ":4:21: wheel_diameter_mm = 0: must be a finite number > 0"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find(caster_file + ":1:1: tread: missing; must be a table"), std::string::npos);
}

TEST(LoadItem, RefusesBrakesThatAreNotThereAndUnequalHeights) {
  const TempFolder folder;
  ItemDescription item = load_item_description(folder.write("cart.toml", kCart)).stated();
  item.casters[2].type.brake_torque = 0;
  item.casters[1].swivel_locked = true;
  item.casters[1].type.swivel_lock_torque = 0;
  item.casters[1].mount.z() = 0.02;
  EXPECT_EQ(error_text([&] { assemble_item(item); }),
            item.casters[1].where +
                ": caster 'caster 2': the swivel is locked, but caster R100 has no "
                "swivel_lock_torque_n_m\n" +
                item.casters[1].where +
                ": caster 'caster 2': its base plate would be 111 mm above the floor, that of "
                "caster 'caster 1' 131 mm: must be equal (height_mm minus z of position_mm)\n" +
                item.casters[2].where +
                ": caster 'caster 3': the brake is on, but caster R100 has no brake_torque_n_m");
  EXPECT_TRUE(item.casters[1].where.starts_with(item.file + ":"));
}

TEST(LoadItem, DescribesACasterInsideAnItem) {
  const TempFolder folder;
  const std::string inline_caster = R"(
[[caster]]
position_mm = [0, 0, 0]
swivels = false
brake = true
[caster.inline]
name = "disc"
height_mm = 60
wheel_diameter_mm = 100
wheel_width_mm = 2
trail_mm = 0
wheel_mass_kg = 2
wheel_inertia_ratio = 1
fork_mass_kg = 0.1
fork_center_of_mass_mm = [0, 0, 0]
fork_box_mm = [0, 0, 0]
brake_torque_n_m = inf
tread = { normal_stiffness_n_per_m = 1e6, normal_damping_n_s_per_m = 0, tangential_stiffness_n_per_m = 1e6, tangential_damping_n_s_per_m = 0, relaxation_length_mm = 10, patch_width_mm = 0, rolling_resistance_mm = 0, static_friction = 0.5, kinetic_friction = 0.4 }
axle = { coulomb_n_m = 0, viscous_n_m_s_per_rad = 0 }
swivel = { coulomb_n_m = 0, viscous_n_m_s_per_rad = 0 }
)";
  const std::string text = std::string(kCart).substr(0, std::string(kCart).find("[[caster]]"));
  const Caster wheel =
      load_item(folder.write("wheel.toml", text + inline_caster)).model.casters.at(0);
  EXPECT_FALSE(wheel.swivels);
  EXPECT_TRUE(std::isinf(wheel.brake_torque));
  EXPECT_DOUBLE_EQ(wheel.wheel_axial_inertia, 2 * 0.05 * 0.05);  // a hoop: m R^2
  EXPECT_DOUBLE_EQ(wheel.wheel_transverse_inertia, 0.0025 + 2 * 0.002 * 0.002 / 12);
  EXPECT_EQ(wheel.tread.kinetic_friction, 0.4);
}

std::string tail_of_cart(const std::string& joint) {
  return "[[part]]\nname = \"tail\"\nposition_mm = [-200, 0, 400]\nmass_kg = 10\n"
         "center_of_mass_mm = [-400, 0, 400]\ninertia_box_mm = [200, 400, 400]\n" +
         joint + "[[part.shape]]\ncenter_mm = [-400, 0, 400]\nsize_mm = [200, 400, 400]\n";
}

// Casters on a part have its axes, stand in their order, and brakes, headings and the floor are theirs as well.
TEST(LoadItem, CastersStandUnderParts) {
  const TempFolder folder;
  const std::string file = folder.path() + "/cart.toml", fixed = "joint = \"fixed\"\n";
  const std::string rear =
      "[[caster]]\ntype = \"R100\"\nposition_mm = [-450, 0, 0]\non = \"tail\"\n";
  std::ofstream(file) << kCart << rear << "brake = true\n" << tail_of_cart(fixed);
  const LoadedItem item = load_item(file);
  ASSERT_EQ(item.model.casters.size(), 3u);
  ASSERT_EQ(item.parts[0].model.casters.size(), 1u);
  const Caster& caster = item.parts[0].model.casters[0];
  EXPECT_EQ(caster.name, "caster 4");
  EXPECT_EQ(caster.mount, Vector3(-0.45, 0, caster.height));
  EXPECT_GT(caster.brake_torque, 0);
  EXPECT_EQ(as_rigid(item).casters.size(), 4u);
  // The wheels' loads are those of four.
  EXPECT_EQ(stability_of(as_rigid(item)).wheel_loads.size(), 4u);
  ItemOptions off;
  off.brakes = {false, false, false, false};
  EXPECT_EQ(load_item(file, off).parts[0].model.casters[0].brake_torque, 0);
  std::ofstream(file) << kCart << rear << "trouble = 1\n" << tail_of_cart(fixed);
  EXPECT_NE(error_text([&] { load_item(file); }).find("trouble: unknown key"), std::string::npos);
  std::string far = rear;
  far.replace(far.find("tail"), 4, "tael");
  std::ofstream(file) << kCart << far << tail_of_cart(fixed);
  EXPECT_NE(
      error_text([&] { load_item(file); }).find("on = \"tael\": must be \"chassis\" or a part"),
      std::string::npos);
  std::string all = kCart;
  for (std::size_t at = 0; (at = all.find("type = \"R100\"", at)) != std::string::npos; at += 20)
    all.insert(at, "on = \"tail\"\n");
  std::ofstream(file) << all << tail_of_cart(fixed);
  EXPECT_NE(error_text([&] {
              load_item(file);
            }).find("caster: all are on parts; one at least must be on the chassis"),
            std::string::npos);
}

// A spring of 1000 N/m along z yields by m g / k = 98 mm under 10 kg; its stop is below. To the micrometre by which
// joints yield, and the chassis' tilt under a mass that is off its middle.
TEST(LoadItem, PartsComeToRest) {
  const TempFolder folder;
  const std::string file = folder.path() + "/cart.toml";
  std::ofstream(file)
      << kCart
      << tail_of_cart(
             "joint = \"slider\"\naxis = [0, 0, 1]\nstiffness_n_per_m = 1000\nlower_mm = -300\n");
  const LoadedItem placed = load_item(file), rests = at_rest(placed);
  const double sag = 10 * kStandardGravity / 1000;
  EXPECT_NEAR(rests.parts[0].coordinate, -sag, 2e-5);
  EXPECT_NEAR(rests.parts[0].model.chassis_center_of_mass.z(),
              placed.parts[0].model.chassis_center_of_mass.z() - sag, 2e-5);
  EXPECT_TRUE(rests.parts[0].model.shape[0].is_box());
  EXPECT_NEAR(whole_item(as_rigid(placed)).center_of_mass.z() -
                  whole_item(as_rigid(rests)).center_of_mass.z(),
              sag * 10 / whole_item(as_rigid(placed)).mass, 1e-5);
  // A flap that hangs down turns by a quarter about its upper edge, and its box with it.
  std::ofstream(file) << kCart
                      << tail_of_cart(
                             "joint = \"hinge\"\naxis = [0, 1, 0]\ndamping_n_m_s_per_rad = 1\n");
  const LoadedItem flap = at_rest(load_item(file));
  EXPECT_NEAR(std::abs(flap.parts[0].coordinate), std::numbers::pi / 2, 3e-3);  // the chassis tilts
  EXPECT_NEAR(flap.parts[0].model.chassis_center_of_mass.z(),
              load_item(file).parts[0].model.chassis_center_of_mass.z() - 0.2, 1e-3);
  EXPECT_FALSE(flap.parts[0].model.shape[0].is_box());
  EXPECT_NEAR(flap.parts[0].model.shape[0].size.z(), 0.2, 2e-3);
}

// Keys of a joint of unknown kind, and the way between limits of which one is refused, are no errors of their own.
TEST(LoadItem, AJointInErrorIsSaidOnce) {
  const TempFolder folder;
  const std::string file = folder.path() + "/cart.toml",
                    moves = "axis = [1, 0, 0]\nfriction_n = 2\n";
  for (const auto& [joint, said] :
       {std::pair{"joint = \"slidr\"\nlower_mm = 0\nupper_mm = 300\n", "joint = \"slidr\""},
        {"joint = \"slider\"\nlower_mm = 0\nupper_mm = -300\n", "upper_mm = -300"},
        {"joint = \"slider\"\nlower_mm = 0\nupper_mm = 0\n", "leaves no way"}}) {
    std::ofstream(file) << kCart << tail_of_cart(joint + moves);
    const std::string errors = error_text([&] { load_item(file); });
    EXPECT_NE(errors.find(said), std::string::npos) << errors;
    EXPECT_EQ(std::ranges::count(errors, '\n'), 0) << errors;
  }
}

}  // namespace
}  // namespace gurney::equipment
