#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "studies/doctor/examination.h"
#include "tests/support/temp_folder.h"

namespace gurney::doctor {
namespace {

using State = Finding::State;
using testing::HasSubstr;

TEST(Doctor, WarnsOfLittleMemory) {
  EXPECT_EQ(memory(std::nullopt).state, State::kOk);
  EXPECT_EQ(memory(2'000'000'000).state, State::kOk);
  const Finding little = memory(900'000'000);
  EXPECT_EQ(little.state, State::kWarning);
  EXPECT_EQ(little.text, "0.9 GB available");
}

TEST(Doctor, WarnsOfFewerCpusThanThreads) {
  EXPECT_EQ(threads(8, std::nullopt).state, State::kOk);
  EXPECT_EQ(threads(8, 8.0).state, State::kOk);
  const Finding few = threads(8, 2.5);
  EXPECT_EQ(few.state, State::kWarning);
  EXPECT_THAT(few.advice, HasSubstr("-j 2"));
  EXPECT_THAT(threads(8, 0.5).advice, HasSubstr("-j 1"));
  EXPECT_EQ(threads(0, std::nullopt).state, State::kWarning);
}

TEST(Doctor, KnowsAFolderThatIsMissing) {
  const TempFolder folder;
  EXPECT_THAT(disk(folder.path()).text, HasSubstr("GB free in " + folder.path()));
  EXPECT_EQ(disk(folder.path() + "/none").state, State::kProblem);
}

TEST(Doctor, FindsADamagedCatalogue) {
  const TempFolder folder;
  setenv("GURNEY_DATA", folder.path().c_str(), 1);
  const Finding missing = data();
  for (const char* kind : {"items", "casters", "floors", "rooms"})
    folder.write("equipment/" + std::string(kind) + "/a.toml", "schema = 1\n");
  const Finding damaged = data();
  unsetenv("GURNEY_DATA");
  EXPECT_EQ(missing.state, State::kProblem);
  EXPECT_THAT(missing.text, HasSubstr("the catalogue is not there"));
  EXPECT_EQ(damaged.state, State::kProblem);
  EXPECT_THAT(damaged.text, HasSubstr("rooms/a.toml:1"));
  EXPECT_EQ(data().state, State::kOk) << data().text;
}

TEST(Doctor, RunsTwiceWithTheSameBits) {
  const Finding found = determinism();
  EXPECT_EQ(found.state, State::kOk) << found.text;
  EXPECT_THAT(found.text, HasSubstr("16 runs with 1 and with "));
  EXPECT_EQ(same_bits("aa", "ab", 2, 16).state, State::kProblem);
}

TEST(Doctor, IsContentWithArithmeticAndLibraries) {
  EXPECT_EQ(arithmetic().state, State::kOk);
  EXPECT_EQ(libraries().state, State::kOk) << libraries().text;
}

}  // namespace
}  // namespace gurney::doctor
