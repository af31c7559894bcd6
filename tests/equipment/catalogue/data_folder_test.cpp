#include "equipment/catalogue/data_folder.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "tests/support/temp_folder.h"

namespace gurney::equipment {
namespace {

TEST(DataFolder, IsBesideAnInstalledProgram) {
  const TempFolder folder;
  folder.write("share/gurney/equipment/contacts.toml", "");
  const std::string program = folder.path() + "/bin/gurney";
  const DataFolder found = find_data_folder(nullptr, program, "/source");
  EXPECT_EQ(found.path, folder.path() + "/share/gurney");
  EXPECT_EQ(found.origin, DataFolder::Origin::kBesideProgram);
}

TEST(DataFolder, IsWhatTheEnvironmentSaysEvenIfItIsMissing) {
  const TempFolder folder;
  folder.write("share/gurney/equipment/contacts.toml", "");
  const DataFolder found = find_data_folder("/nowhere", folder.path() + "/bin/gurney", "/source");
  EXPECT_EQ(found.path, "/nowhere");
  EXPECT_EQ(found.origin, DataFolder::Origin::kEnvironment);
}

TEST(DataFolder, IsTheSourceOfAProgramThatIsNotInstalled) {
  const TempFolder folder;
  folder.write("share/gurney/other.toml", "");  // of another package: no catalogue
  for (const std::string& program : {folder.path() + "/bin/gurney", std::string()}) {
    const DataFolder found = find_data_folder("", program, "/source");
    EXPECT_EQ(found.path, "/source");
    EXPECT_EQ(found.origin, DataFolder::Origin::kSource);
  }
}

}  // namespace
}  // namespace gurney::equipment
