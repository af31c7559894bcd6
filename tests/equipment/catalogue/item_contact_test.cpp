#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "equipment/catalogue/check_file.h"
#include "equipment/catalogue/contact_table.h"
#include "equipment/catalogue/load_item.h"
#include "tests/support/error_text.h"
#include "tests/support/temp_folder.h"

namespace gurney::equipment {
namespace {

using testing::HasSubstr;

constexpr const char* kCabinet = R"(schema = "gurney-item/1"
name = "cabinet"
[chassis]
mass_kg = 50
center_of_mass_mm = [0, 0, 400]
inertia_box_mm = [400, 500, 800]
[[shape]]
center_mm = [0, 0, 400]
size_mm = [400, 500, 800]
[[shape]]  # a foot across the front and one across the rear
center_mm = [150, 0, -20]
size_mm = [50, 500, 40]
[[shape]]
center_mm = [-150, 0, -20]
size_mm = [50, 500, 40]
)";

constexpr const char* kContact = R"([contact]
material = "steel"
friction = { value = 0.35, assumption = "a guess", range = [0.2, 0.6] }
restitution = 0.2
stiffness_n_per_m = 2e6
)";

class ItemContactFile : public testing::Test {
 protected:
  LoadedItem load(const std::string& contact, const ItemOptions& options = {}) {
    return load_item(write(contact), options);
  }
  std::string error(const std::string& contact) {
    const std::string file = write(contact);
    std::string text = error_text([&] { load_item(file); });
    EXPECT_EQ(text.rfind(file + ":", 0), 0u) << text;
    return text.substr(file.size() + 1);
  }
  std::string write(const std::string& contact) {
    return folder_.write("cabinet.toml", kCabinet + contact);
  }

 private:
  TempFolder folder_;
};

TEST_F(ItemContactFile, StandsOnTheLowestBoxes) {
  const LoadedItem item = load(kContact);
  // The feet are 40 mm high, so all is lifted by them.
  EXPECT_DOUBLE_EQ(item.model.chassis_center_of_mass.z(), 0.44);
  EXPECT_DOUBLE_EQ(item.model.shape[1].center.z(), 0.02);
  EXPECT_TRUE(item.model.casters.empty());
  EXPECT_TRUE(item.warnings.empty());
}

TEST_F(ItemContactFile, MakesTheConstantsOfTheMaterial) {
  const LoadedItem item = load(kContact);
  EXPECT_EQ(item.model.material, "steel");
  EXPECT_EQ(item.floor_material, "");
  ASSERT_EQ(item.pairs.size(), 1u);
  EXPECT_EQ(item.pairs[0].item, "steel");
  EXPECT_EQ(item.pairs[0].other, "");
  const ContactConstants& floor = floor_contact(item);
  EXPECT_EQ(floor.kind, ContactConstants::Kind::kRestitution);
  EXPECT_EQ(floor.friction, 0.35);
  EXPECT_EQ(floor.restitution, 0.2);
  EXPECT_EQ(floor.stiffness, 2e6);
  ASSERT_EQ(item.assumptions.size(), 1u);
  EXPECT_EQ(item.assumptions[0].key, "contact.friction");
  EXPECT_EQ(item.assumptions[0].high, 0.6);
}

TEST_F(ItemContactFile, ACoveringChangesTheFrictionOnTheFloorAlone) {
  ItemOptions options;
  options.floor = FloorCovering{"Rubber", 1.3, 1.2, {}};
  const LoadedItem item = load(kContact, options);
  EXPECT_EQ(item.floor_material, "Rubber");
  ASSERT_EQ(item.pairs.size(), 2u);
  EXPECT_EQ(item.pairs[0].constants.friction, 0.35);  // walls
  EXPECT_EQ(item.pairs[1].other, "Rubber");
  EXPECT_DOUBLE_EQ(floor_contact(item).friction, 0.42);
  EXPECT_EQ(floor_contact(item).restitution, 0.2);
  EXPECT_EQ(floor_contact(item).stiffness, 2e6);
}

TEST_F(ItemContactFile, WhatIsRoundResistsRolling) {
  const std::string ball =
      std::string(kContact) + "rolling_resistance_mm = 0.8\n" +
      "[[shape]]\nkind = \"sphere\"\ncenter_mm = [0, 0, 500]\nradius_mm = 50\n";
  ItemOptions options;
  options.floor = FloorCovering{"Carpet", 3, 1, {}};
  const LoadedItem item = load(ball, options);
  EXPECT_DOUBLE_EQ(item.pairs[0].constants.rolling_resistance, 0.8e-3);
  EXPECT_DOUBLE_EQ(floor_contact(item).rolling_resistance, 2.4e-3);
  EXPECT_DOUBLE_EQ(floor_contact(load(kContact)).rolling_resistance, 0.5e-3) << "the default";
  EXPECT_THAT(
      error(std::string(kContact) + "rolling_resistance_mm = 0.8\n"),
      HasSubstr("contact.rolling_resistance_mm: has no effect: only cylinders and spheres roll"));
}

TEST_F(ItemContactFile, MayBeCompliant) {
  const LoadedItem item = load(
      "[contact]\nmaterial = \"steel\"\nfriction = 0.3\nstiffness_n_per_m = 1e5\n"
      "damping_n_s_per_m = 300\n");
  EXPECT_EQ(floor_contact(item).kind, ContactConstants::Kind::kCompliant);
  EXPECT_EQ(floor_contact(item).damping, 300);
}

TEST_F(ItemContactFile, IsNeededWithoutCasters) {
  EXPECT_EQ(error(""),
            "1:1: contact: missing; an item without casters needs a table [contact], how it meets "
            "the floor");
}

TEST_F(ItemContactFile, ReportsEveryError) {
  EXPECT_THAT(
      error("[contact]\nmaterial = \"\"\nfriction = -0.1\nstiffness_n_per_m = 0\n"),
      testing::AllOf(HasSubstr("17:12: contact.material = \"\": must be the name of a"),
                     HasSubstr("18:12: contact.friction = -0.1: must be a finite number >= 0"),
                     HasSubstr("19:21: contact.stiffness_n_per_m = 0: must be a finite number > 0"),
                     HasSubstr("contact.restitution: must be given, or "
                               "damping_n_s_per_m, not both")));
  EXPECT_THAT(error(std::string(kContact) + "damping_n_s_per_m = 3\n"), HasSubstr("not both"));
  EXPECT_THAT(error("[contact]\nmaterial = \"steel\"\nfriktion = 0.3\nrestitution = 2\n"
                    "stiffness_n_per_m = 1e6\n"),
              testing::AllOf(
                  HasSubstr("did you mean 'friction'?"),
                  HasSubstr("contact.restitution = 2: must be a finite number >= 0.01 and <= 1")));
}

TEST_F(ItemContactFile, WarnsOfASlenderOne) {
  const std::string file = write(kContact);
  EXPECT_TRUE(check_data_file(file).warnings.empty());
  const std::string slender =
      write(std::string(kContact) + "[variant.high]\nchassis.center_of_mass_mm = [0, 0, 2000]\n");
  // atan(0.175 / 2.04) = 4.9 degrees, to the front or the rear.
  EXPECT_THAT(check_data_file(slender).warnings,
              testing::Contains(testing::AllOf(
                  HasSubstr("cabinet: a tilt of 4.9 degrees"),
                  HasSubstr("IEC 60601-1 asks 5 degrees of equipment that is not mobile"))));
}

}  // namespace
}  // namespace gurney::equipment
