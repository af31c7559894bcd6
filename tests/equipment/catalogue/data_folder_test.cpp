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
  const DataFolder found = find_data_folder(nullptr, program);
  EXPECT_EQ(found.path, folder.path() + "/share/gurney");
  EXPECT_EQ(found.origin, DataFolder::Origin::kBesideProgram);
}

TEST(DataFolder, IsWhatTheEnvironmentSaysEvenIfItIsMissing) {
  const TempFolder folder;
  folder.write("share/gurney/equipment/contacts.toml", "");
  const DataFolder found = find_data_folder("/nowhere", folder.path() + "/bin/gurney");
  EXPECT_EQ(found.path, "/nowhere");
  EXPECT_EQ(found.origin, DataFolder::Origin::kEnvironment);
}

TEST(DataFolder, IsTheSourceThatABuildFolderNames) {
  const TempFolder folder;
  folder.write("share/gurney/other.toml", "");  // of another package: no catalogue
  folder.write("build/source_folder", "/source of it\n");
  const DataFolder found = find_data_folder("", folder.path() + "/build/gurney");
  EXPECT_EQ(found.path, "/source of it");
  EXPECT_EQ(found.origin, DataFolder::Origin::kSource);
}

// No path of the machine that built it: a folder there could be anybody's.
TEST(DataFolder, IsThatOfAnInstallationWhereNoneIsThere) {
  const TempFolder folder;
  EXPECT_EQ(find_data_folder("", folder.path() + "/bin/gurney").path,
            folder.path() + "/share/gurney");
  EXPECT_EQ(find_data_folder(nullptr, "").path, "/usr/share/gurney");
}

}  // namespace
}  // namespace gurney::equipment
