#include "studies/run/crash_log.h"

#include <gmock/gmock.h>
#include <signal.h>

#include "tests/studies/small_study.h"
#include "tests/support/error_text.h"
#include "tests/support/temp_folder.h"

namespace gurney::study {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Pair;

void crash_in_a_run(const std::string& file) {
  const CrashLog log(file);
  const RunMark mark(12, 3);
  raise(SIGSEGV);
}

void crash_between_runs(const std::string& file) {
  const CrashLog log(file);
  { const RunMark mark(12, 3); }
  raise(SIGSEGV);
}

TEST(CrashLogTest, ACrashLeavesALineAndSaysSo) {
  const TempFolder folder;
  const std::string file = folder.file("crashes");
  EXPECT_EXIT(
      crash_in_a_run(file), testing::KilledBySignal(SIGSEGV),
      "gurney: crashed \\(signal 11\\) in run 3 of analysis case 12; finished runs are kept");
  EXPECT_EQ(contents_of(file), "12 3 11\n");
}

TEST(CrashLogTest, ACrashOutsideOfRunsLeavesNone) {
  const TempFolder folder;
  const std::string file = folder.file("crashes");
  EXPECT_EXIT(crash_between_runs(file), testing::KilledBySignal(SIGSEGV), "");
  EXPECT_EQ(contents_of(file), "");
}

TEST(CrashLogTest, GivesUpAfterTwo) {
  const TempFolder folder;
  EXPECT_THAT(CrashLog(folder.write("once", "12 3 11\n12 4 11\n")).given_up(), IsEmpty());
  const CrashLog twice(folder.write("twice", "12 3 11\n12 4 11\n12 3 6\n"));
  EXPECT_THAT(twice.given_up(),
              ElementsAre(Pair(Pair(12, 3), "crashed the program 2 times: Aborted")));
}

TEST(CrashLogTest, ReportsAndIgnoresForeignLines) {
  const TempFolder folder;
  const std::string file = folder.write("crashes", "12 3 11\n12 three 11\n50 %  9 runs\n12 3 11\n");
  const CrashLog log(file);
  EXPECT_THAT(log.given_up(), ElementsAre(Pair(Pair(12, 3), testing::_)));
  EXPECT_THAT(
      log.warnings(),
      ElementsAre(file + ":2: is not a line `case run signal` and was ignored: '12 three 11'",
                  file + ":3: is not a line `case run signal` and was ignored: '50 %  9 runs'"));
}

TEST(CrashLogTest, CutsATornLastLineOff) {
  const TempFolder folder;
  for (const std::string torn : {"3 1", "3 1 11", "3"}) {
    const std::string file = folder.write("crashes", "12 3 11\n" + torn);
    const CrashLog log(file);
    EXPECT_THAT(log.given_up(), IsEmpty());
    EXPECT_THAT(log.warnings(), IsEmpty());
    EXPECT_EQ(contents_of(file), "12 3 11\n") << "so that the next line stands alone";
  }
}

TEST(CrashLogTest, ARunThatIsGivenUpFailsAndTheOthersAreMade) {
  const SmallStudy study(small_job("[study.intensity]\nscales = [1, 2, 3]\n"));
  const TaskResult result =
      run_task(study.batch, 0, [] { return true; }, {{{0, 1}, "crashed the program 2 times: x"}});
  ASSERT_EQ(result.runs.size(), 3);
  EXPECT_EQ(result.runs[1].response.outcome, Outcome::kDiverged);
  EXPECT_EQ(result.runs[1].response.cause, "crashed the program 2 times: x");
  EXPECT_EQ(result.runs[0].response.outcome, study.run(0).runs[0].response.outcome);
  EXPECT_EQ(result.runs[2].response.items[0].demands.peak_displacement,
            study.run(0).runs[2].response.items[0].demands.peak_displacement);
}

}  // namespace
}  // namespace gurney::study
