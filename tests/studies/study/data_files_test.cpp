#include "studies/study/data_files.h"

#include <gmock/gmock.h>

#include "engine/base/hash/sha256.h"
#include "equipment/catalogue.h"
#include "tests/studies/study/small_study.h"
#include "tests/support/temp_folder.h"

namespace gurney {
namespace {

using testing::Contains;
using testing::Key;
using testing::Not;
using testing::Pair;

TEST(DataFilesTest, AreThoseTheJobNamesAndThoseTheyName) {
  const TempFolder folder;
  const std::string item = contents_of(find_data(DataKind::kItem, "xu_trolley", ""));
  folder.write("items/mine.toml", item);
  std::string text = small_job(
      "[[study.factor]]\nname = \"covering\"\nkey = \"floor.covering\"\n"
      "values = [\"polyflor_mystique\", \"rubber\"]\n");
  text.replace(text.find("\"xu_trolley\""), 12, "\"../items/mine.toml\"");
  const auto files = data_files(StudyJob(folder.write("jobs/a.toml", text)));
  EXPECT_THAT(files, Contains(Pair("../items/mine.toml", sha256(item))));
  const std::string caster = contents_of(find_data(DataKind::kCaster, "R100", ""));
  EXPECT_THAT(files, Contains(Pair("equipment/casters/R100.toml", sha256(caster))));
  EXPECT_THAT(files, Contains(Key("equipment/floors/polyflor_mystique.toml")));
  EXPECT_THAT(files, Contains(Key("equipment/floors/rubber.toml")));
  EXPECT_THAT(files, Contains(Key("equipment/contacts.toml")));
  EXPECT_THAT(files, Contains(Key("equipment/levelness.toml")));
  EXPECT_THAT(files, Not(Contains(Key("equipment/items/bookcase.toml"))));
}

}  // namespace
}  // namespace gurney
