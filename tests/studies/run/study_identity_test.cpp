#include "studies/run/study_identity.h"

#include <gmock/gmock.h>

#include "studies/run/study_file.h"
#include "tests/studies/small_study.h"
#include "tests/support/expect_error.h"
#include "tests/support/temp_folder.h"

namespace gurney::study {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

std::string with(const std::string& text, const std::string& from, const std::string& to) {
  std::string changed = text;
  changed.replace(changed.find(from), from.size(), to);
  return changed;
}

TEST(StudyIdentityTest, NamesTheKeysOfTheJobThatDiffer) {
  const std::string text = small_job("");
  const SmallStudy one(text), longer(with(text, "duration_s = 0.2", "duration_s = 0.3"));
  EXPECT_EQ(difference(identity_of(one.batch), identity_of(longer.batch)),
            "settings.duration_s: there '0.2', here '0.3' (in the job)");
  const SmallStudy untitled(with(text, "title = \"Small\"\n", ""));
  EXPECT_EQ(difference(identity_of(one.batch), identity_of(untitled.batch)),
            "title: there '\"Small\"', here nothing (in the job)");
  const SmallStudy commented(text + "# edited\n");
  EXPECT_THAT(difference(identity_of(one.batch), identity_of(commented.batch)),
              StartsWith("the comments or the layout of the job (job_sha256: there '"));
}

TEST(StudyIdentityTest, NamesFilesThatDiffer) {
  EXPECT_EQ(difference("a.toml = 1\nrecord x = 2 x.at2\nanalysis_cases = 7\n\njob",
                       "a.toml = 1\nrecord x = 3 x.at2\nb.toml = 4\nanalysis_cases = 7\n\njob"),
            "b.toml: there nothing, here '4'; record x: there '2 x.at2', here '3 x.at2'");
}

// The file `study` may be anybody's: more digits than a number holds were an exception of the library.
TEST(StudyIdentityTest, TheNumberOfCasesIsAWholeNumber) {
  EXPECT_EQ(tasks_in("a.toml = 1\nanalysis_cases = 7\n\njob"), 7u);
  for (const char* wrong : {"99999999999999999999", "", "7 ", "-1", "x"})
    EXPECT_ERROR(tasks_in("analysis_cases = " + std::string(wrong) + "\n\njob"),
                 "the file 'study' states no number of analysis cases");
}

TEST(StudyIdentityTest, RecordsOfOneNameAreComparedOneByOne) {
  const std::string both = "record x = 1 x.at2\nrecord x = 2 x.at2\n\njob";
  EXPECT_EQ(difference(both, "record x = 3 x.at2\nrecord x = 2 x.at2\n\njob"),
            "record x: there '1 x.at2', here '3 x.at2'");
  EXPECT_EQ(difference(both, "record x = 1 x.at2\n\njob"),
            "record x (2): there '2 x.at2', here nothing");
  EXPECT_EQ(difference(both, both), "");
  EXPECT_EQ(difference("a = 1\nb = 2\n\njob", "b = 2\na = 1\n\njob"),
            "the order of the records or data files");
}

TEST(StudyIdentityTest, ACompleteStudyIsKnownByItsFile) {
  const TempFolder folder;
  const std::string text = small_job("synthetic_records = 2\n",
                                     "kind = \"stochastic\", frequency_hz = 2, "
                                     "frequency_slope_hz_per_s = -0.05, filter_damping = 0.5");
  const SmallStudy study(text);
  const std::string file = folder.file("a.h5");
  write_study_file(file, study.batch, [&](std::size_t task) { return study.run(task); });
  EXPECT_EQ(difference_to_results(file, study.batch), "");
  const SmallStudy other(with(text, "duration_s = 0.2", "duration_s = 0.3"));
  EXPECT_EQ(difference_to_results(file, other.batch),
            "settings.duration_s: there '0.2', here '0.3' (in the job)");
}

TEST(StudyIdentityTest, TheMergeRefusesResultsOfAnotherUnit) {
  const TempFolder folder;
  const SmallStudy study(small_job("angles_deg = [0, 90]\n"));
  std::string text;
  try {
    write_study_file(folder.file("a.h5"), study.batch, [&](std::size_t) { return study.run(0); });
  } catch (const Error& error) {
    text = error.what();
  }
  EXPECT_EQ(text, "the results of analysis case 0 stand where those of case 1 must be");
}

// A hospital's job names more or fewer settings than the results that it is asked of; what a run is must be the same.
TEST(StudyIdentity, RunsAreTheSameWhateverRunsThereAre) {
  const std::string job =
      "title = \"one\"\n[floor]\ncovering = \"a\"\n[study]\ndraws = 2\ncombinations = [[\"up\"]]\n"
      "intensity.levels = [0.2]\n[[study.factor]]\nname = \"storey\"\n[study.factor.level.ground]\n"
      "[study.factor.level.up]\nfloor = 3\n";
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string text = job;
    return text.replace(text.find(from), from.size(), to);
  };
  EXPECT_EQ(run_difference(job, with("one", "other")), "");
  EXPECT_EQ(run_difference(job, with("[[\"up\"]]", "[[\"ground\"], [\"up\"]]")), "");
  EXPECT_EQ(run_difference(job, with("[0.2]", "[0.2, 0.4]")), "");
  EXPECT_EQ(run_difference(job, job + "[study.factor.level.roof]\nfloor = 4\n"), "");
  EXPECT_EQ(run_difference(job + "[study.factor.level.roof]\nfloor = 4\n", job), "");
  EXPECT_EQ(run_difference(job, with("floor = 3", "floor = 2")),
            "study.factor[storey].level.up.floor: there '3', here '2'");
  // The ground floor has become one of a building.
  EXPECT_EQ(run_difference(job, with("level.ground]", "level.ground]\nfloor = 1")),
            "study.factor[storey].level.ground.floor: there nothing, here '1'");
  EXPECT_EQ(run_difference(job, with("\"a\"", "\"b\"")),
            "floor.covering: there '\"a\"', here '\"b\"'");
  // Files lie elsewhere on another machine, and no run has the item of the job.
  const auto placed = [&](const std::string& folder, const std::string& item) {
    return "item.equipment = \"" + item + "\"\n" +
           with("draws = 2", "excitation.file = \"" + folder + "/quake.csv\"\ndraws = 2");
  };
  EXPECT_EQ(run_difference(placed("/a/b", "bed"), placed("/c", "pole")), "");
  EXPECT_EQ(run_difference(job, with("draws = 2", "draws = 3")),
            "study.draws: there '2', here '3'");
}

}  // namespace
}  // namespace gurney::study
