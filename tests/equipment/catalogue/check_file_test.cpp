#include "equipment/catalogue/check_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/support/error_text.h"
#include "tests/support/temp_folder.h"

namespace gurney::equipment {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

std::string shipped_caster() { return contents_of(find_data(DataKind::kCaster, "R100", "")); }

TEST(CheckFile, KnowsItemsCastersAndFloorsByTheirSchema) {
  const CheckedFile caster = check_data_file(find_data(DataKind::kCaster, "R100", ""));
  EXPECT_EQ(caster.kind, DataKind::kCaster);
  EXPECT_EQ(caster.name, "R100");
  EXPECT_THAT(caster.warnings, IsEmpty());
  const CheckedFile item = check_data_file(find_data(DataKind::kItem, "crash_cart", ""));
  EXPECT_EQ(item.kind, DataKind::kItem);
  EXPECT_EQ(item.name, "Crash cart");
  const CheckedFile floor = check_data_file(find_data(DataKind::kFloor, "linoleum", ""));
  EXPECT_EQ(floor.kind, DataKind::kFloor);
  EXPECT_NE(floor.name, "");
}

TEST(CheckFile, EveryFileOfTheCatalogueIsPlausible) {
  for (const DataKind kind : {DataKind::kItem, DataKind::kCaster, DataKind::kFloor})
    for (const std::string& name : catalogue_names(kind))
      EXPECT_THAT(check_data_file(find_data(kind, name, "")).warnings, IsEmpty()) << name;
}

TEST(CheckFile, ReportsEveryErrorWithItsPlace) {
  const TempFolder folder;
  std::string text = replaced(shipped_caster(), "value = 131", "value = -131");
  text = replaced(text, "wheel_width_mm", "wheel_widht_mm");
  const std::string file = folder.write("bad.toml", text);
  EXPECT_THAT(error_text([&] { check_data_file(file); }),
              AllOf(HasSubstr(file + ":5:"), HasSubstr(file + ":7:"), HasSubstr("-131"),
                    HasSubstr("wheel_width_mm")));
}

TEST(CheckFile, RefusesAnUnknownSchema) {
  const TempFolder folder;
  const std::string file = folder.write("job.toml", "schema = \"gurney-wheel/1\"\n");
  EXPECT_THAT(error_text([&] { check_data_file(file); }),
              AllOf(StartsWith(file + ":1:"), HasSubstr("gurney-caster/1")));
}

TEST(Implausible, ReportsOfACasterThatHardlyIsMeant) {
  CasterType caster;
  caster.name = "odd";
  caster.properties.wheel_width = 0.03;
  caster.properties.tread.patch_width = 0.04;
  caster.properties.wheel_mass = 1;
  caster.properties.wheel_radius = 0.05;
  caster.properties.wheel_axial_inertia = 0.0026;  // a hoop has 0.0025
  EXPECT_THAT(implausible(caster),
              ElementsAre("odd: the contact patch (0.04 m) is wider than the wheel (0.03 m)",
                          "odd: the wheel's inertia is larger than that of a hoop"));
  caster.properties.tread.patch_width = 0.03;
  caster.properties.wheel_axial_inertia = 0.0025;
  EXPECT_THAT(implausible(caster), IsEmpty());
}

TEST(Implausible, ReportsOfADensityAndACentreOfMassOutOfTheShape) {
  EquipmentModel item;
  item.name = "block";
  item.chassis_mass = 301;  // 0.1 m3
  item.chassis_center_of_mass = {0, 0, 0.6};
  item.shape = {{{0, 0, 0.5}, {1, 0.1, 1}}};
  EXPECT_THAT(implausible(item),
              ElementsAre("block: 301 kg in shapes of 0.1 m3 are 3010 kg/m3; 20 to 3000 is usual"));
  item.chassis_mass = 1.9;
  item.chassis_center_of_mass.y() = 0.06;
  EXPECT_THAT(implausible(item),
              ElementsAre("block: 1.9 kg in shapes of 0.1 m3 are 19 kg/m3; 20 to 3000 is usual",
                          "block: the centre of mass (0, 0.06, 0.6) m lies outside the shapes"));
}

TEST(Implausible, ReportsOfASwivelWithoutTrailButNotOfARigidWheel) {
  EquipmentModel item;
  item.name = "block";
  item.chassis_mass = 100;
  item.chassis_center_of_mass = {0, 0, 0.5};
  item.shape = {{{0, 0, 0.5}, {1, 1, 1}}};
  item.casters.resize(2);
  for (Caster& caster : item.casters) caster.trail = 0;
  item.casters[0].name = "front";
  item.casters[1].swivels = false;
  EXPECT_THAT(implausible(item),
              ElementsAre("block: caster 'front' swivels but has no trail to align it"));
}

}  // namespace
}  // namespace gurney::equipment
