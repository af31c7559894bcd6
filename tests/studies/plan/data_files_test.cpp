#include <gmock/gmock.h>

#include "engine/base/hash/sha256.h"
#include "equipment/catalogue/catalogue.h"
#include "studies/plan/study_job.h"
#include "tests/studies/small_study.h"
#include "tests/support/temp_folder.h"

namespace gurney::study {
namespace {

using testing::Contains;
using testing::Key;
using testing::Not;
using testing::Pair;

TEST(DataFilesTest, AreThoseTheJobNamesAndThoseTheyName) {
  const TempFolder folder;
  const std::string item =
      contents_of(equipment::find_data(equipment::DataKind::kItem, "xu_trolley", ""));
  folder.write("items/mine.toml", item);
  std::string text = small_job(
      "[[study.factor]]\nname = \"covering\"\nkey = \"floor.covering\"\n"
      "values = [\"polyflor_mystique\", \"rubber\"]\n");
  text.replace(text.find("\"xu_trolley\""), 12, "\"../items/mine.toml\"");
  const auto files = data_files(StudyJob(folder.write("jobs/a.toml", text)));
  EXPECT_THAT(files, Contains(Pair("../items/mine.toml", sha256(item))));
  const std::string caster =
      contents_of(equipment::find_data(equipment::DataKind::kCaster, "R100", ""));
  EXPECT_THAT(files, Contains(Pair("equipment/casters/R100.toml", sha256(caster))));
  EXPECT_THAT(files, Contains(Key("equipment/floors/polyflor_mystique.toml")));
  EXPECT_THAT(files, Contains(Key("equipment/floors/rubber.toml")));
  EXPECT_THAT(files, Contains(Key("equipment/contacts.toml")));
  EXPECT_THAT(files, Contains(Key("equipment/levelness.toml")));
  EXPECT_THAT(files, Not(Contains(Key("equipment/items/bookcase.toml"))));
}

TEST(DataFilesTest, AnEditWhileTheStudyRunsChangesNothing) {
  const TempFolder folder;
  const std::string item =
      contents_of(equipment::find_data(equipment::DataKind::kItem, "xu_trolley", ""));
  const std::string path = folder.write("mine.toml", item);
  std::string text = small_job("");
  text.replace(text.find("\"xu_trolley\""), 12, "\"mine.toml\"");
  const StudyJob job(folder.write("a.toml", text));
  const auto mass = [&] { return job.job(0, {}).scene.items[0].model.chassis_mass; };
  const double before = mass();
  std::string heavy = item;
  heavy.replace(heavy.find("value = 96.5"), 12, "value = 93.5");
  folder.write("mine.toml", heavy);
  EXPECT_NE(StudyJob(folder.file("a.toml")).job(0, {}).scene.items[0].model.chassis_mass, before);
  EXPECT_EQ(mass(), before);
  std::filesystem::remove(path);
  EXPECT_EQ(mass(), before);
  EXPECT_THAT(data_files(job), Contains(Pair("mine.toml", sha256(item))));
}

TEST(DataFilesTest, ATextThatEqualsAFileNameIsNone) {
  const TempFolder folder;
  folder.write("Small", "a file named like the job's title");
  const auto files = data_files(StudyJob(folder.write("a.toml", small_job(""))));
  EXPECT_THAT(files, Not(Contains(Key("Small"))));
  EXPECT_THAT(files, Not(Contains(Key("a.toml"))));
  EXPECT_THAT(files, Contains(Key("equipment/items/xu_trolley.toml")));
}

TEST(DataFilesTest, HaveTheListOfRecords) {
  const TempFolder folder;
  folder.write("a.txt", "0\n1\n0\n-1\n0\n1\n0\n-1\n0\n0\n");
  folder.write("list.csv", "name, h1, unit, time_step_s, scale\nfirst, a.txt, m/s2, 0.01, 1.5\n");
  std::string text = small_job("");
  const std::string stated = "synthetic = { kind = \"ricker\", period_s = 0.1 }";
  text.replace(text.find(stated), stated.size(), "suite = \"list.csv\"");
  const StudyJob job(folder.write("a.toml", text));
  const StudyMotions motions(job);
  EXPECT_THAT(data_files(job),
              Contains(Pair("list.csv", sha256(contents_of(folder.file("list.csv"))))));
}

}  // namespace
}  // namespace gurney::study
