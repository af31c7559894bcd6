#include "engine/config/file_snapshot.h"

#include <gtest/gtest.h>

#include "engine/config/document.h"
#include "tests/support/error_text.h"
#include "tests/support/temp_folder.h"

namespace gurney::config {
namespace {

std::string text_of(const std::string& path) { return Document(path).text(); }

TEST(FileSnapshotTest, GivesTheBytesOfTheFirstReading) {
  const TempFolder folder;
  const std::string path = folder.write("a.toml", "x = 1\n");
  FileSnapshot snapshot;
  {
    const FileSnapshot::Scope scope(snapshot);
    EXPECT_EQ(text_of(path), "x = 1\n");
  }
  folder.write("a.toml", "x = 2\n");
  EXPECT_EQ(text_of(path), "x = 2\n") << "outside of its scope";
  const FileSnapshot::Scope scope(snapshot);
  EXPECT_EQ(text_of(path), "x = 1\n");
  EXPECT_EQ(text_of(folder.path() + "/./a.toml"), "x = 1\n");
  std::filesystem::remove(path);
  EXPECT_EQ(text_of(path), "x = 1\n");
  EXPECT_TRUE(FileSnapshot::exists(path));
}

TEST(FileSnapshotTest, KnowsOnlyWhatWasRead) {
  const TempFolder folder;
  const std::string path = folder.write("a.toml", "x = 1\n");
  const std::string seen = folder.write("seen", "");
  FileSnapshot snapshot;
  const FileSnapshot::Scope scope(snapshot);
  EXPECT_TRUE(FileSnapshot::exists(path));
  EXPECT_TRUE(FileSnapshot::exists(seen));
  EXPECT_FALSE(FileSnapshot::exists(folder.file("none")));
  std::filesystem::remove(seen);
  EXPECT_TRUE(FileSnapshot::exists(seen)) << "it was there";
  FileSnapshot::note(folder.file("noted"), "bytes");
  EXPECT_EQ(snapshot.files(),
            (std::map<std::string, std::string>{{folder.file("noted"), "bytes"}}));
  EXPECT_EQ(error_text([&] { text_of(folder.file("none")); }),
            folder.file("none") + ": no such file");
  text_of(path);
  EXPECT_EQ(snapshot.files().size(), 2u);
}

TEST(FileSnapshotTest, ScopesNest) {
  const TempFolder folder;
  const std::string path = folder.write("a.toml", "x = 1\n");
  FileSnapshot outer, inner;
  const FileSnapshot::Scope first(outer);
  {
    const FileSnapshot::Scope second(inner);
    text_of(path);
  }
  EXPECT_TRUE(outer.files().empty());
  text_of(path);
  EXPECT_EQ(outer.files(), inner.files());
}

}  // namespace
}  // namespace gurney::config
