#include "studies/templates/templates.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "equipment/catalogue/check_file.h"
#include "studies/plan/study_job.h"
#include "studies/prepare/run_job.h"
#include "tests/support/expect_error.h"
#include "tests/support/temp_folder.h"

namespace gurney::templates {
namespace {

using testing::HasSubstr;
using testing::Not;

/// A new file of this kind. @return its path
std::string written(const TempFolder& folder, const std::string& kind, Wishes wishes) {
  wishes.name = "my_" + kind;
  const std::string text = file_text(kind, wishes);
  EXPECT_THAT(text, Not(HasSubstr("NAME")));
  return folder.write(wishes.name + ".toml", text);
}

TEST(Templates, AreValidAsTheyAre) {
  const TempFolder folder;
  for (const char* kind : {"item", "caster", "room"}) {
    const equipment::CheckedFile checked = equipment::check_data_file(written(folder, kind, {}));
    EXPECT_EQ(checked.name, "my_" + std::string(kind));
    EXPECT_THAT(checked.warnings, testing::IsEmpty()) << kind;
  }
  const study::PreparedRun run = study::prepare_run(written(folder, "job", {}));
  EXPECT_EQ(run.facts.title, "my_job");
  EXPECT_THAT(run.facts.warnings, testing::IsEmpty());
  const study::StudyJob study(written(folder, "study", {}));
  EXPECT_EQ(study.configurations().size(), 2U);
  EXPECT_THAT(study.notes(), testing::IsEmpty());
}

TEST(Templates, NameEachOther) {
  const TempFolder folder;
  written(folder, "caster", {});
  written(folder, "room", {});
  written(folder, "item", {.caster = "my_caster.toml"});
  const study::PreparedRun run =
      study::prepare_run(written(folder, "job", {.item = "my_item.toml", .room = "my_room.toml"}));
  EXPECT_EQ(run.facts.scene.items[0].model.name, "my_item");
  EXPECT_FALSE(run.facts.scene.room.empty());
}

TEST(Templates, RefuseWhatTheyHaveNoUseFor) {
  EXPECT_ERROR(file_text("caster", {.name = "a", .item = "b"}), "has no use for --item");
  EXPECT_ERROR(file_text("job", {.name = "a", .suite = "b"}), "has no use for --from");
  EXPECT_ERROR(file_text("job", {.name = "a\"b"}), "quotation marks");
}

}  // namespace
}  // namespace gurney::templates
