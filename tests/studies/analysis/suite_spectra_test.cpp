#include "studies/analysis/suite_spectra.h"

#include <gmock/gmock.h>

#include "engine/base/units.h"
#include "studies/analysis/stored_histories.h"
#include "studies/run/study_file.h"
#include "tests/studies/small_study.h"
#include "tests/support/expect_error.h"
#include "tests/support/temp_folder.h"

namespace gurney::study {
namespace {

class SuiteSpectraTest : public testing::Test {
 protected:
  SuiteSpectraTest() {
    const SmallStudy study(
        small_job("[study.intensity]\nmeasure = \"PGA\"\ncomponent = \"h1\"\nunit = \"g\"\n"
                  "levels = [0.1, 0.2]\n",
                  "kind = \"ricker\", period_s = 1, pga_g = 0.5, time_step_s = 0.001"));
    write_study_file(path_, study.batch, [&](std::size_t task) { return study.run(task); });
  }

  const TempFolder folder_;
  const std::string path_ = folder_.file("study.h5");
};

TEST_F(SuiteSpectraTest, AreScaledToTheLevel) {
  const StudyData data(path_);
  for (const auto& [level, pga] : {std::pair(std::optional<std::size_t>(0), 0.1), {{}, 0.2}}) {
    const auto suites = suite_spectra(data, {.job = "", .level = level, .periods = 20});
    ASSERT_EQ(suites.size(), 1);
    ASSERT_EQ(suites[0].records.size(), 1);
    const SuiteSpectra::Record& record = suites[0].records[0];
    EXPECT_EQ(suites[0].combination, groundmotions::Combination::kH1);
    EXPECT_EQ(record.floor.size(), 0);
    EXPECT_EQ(record.factor, data.file().numbers("runs/scale")[level ? 0 : 1]);
    // At T = 0.02 s under a pulse of T_p = 1 s the response is rigid within about (T / T_p)^2 =
    // 4e-4; its samples miss at most (pi dt / T)^2 / 2 (PSA + PGA) = 2.5 % (response_spectrum.h).
    EXPECT_NEAR(record.factor * record.ground[0] / kStandardGravity, pga, 0.026 * pga);
  }
}

TEST_F(SuiteSpectraTest, HasNoOtherLevels) {
  EXPECT_ERROR(suite_spectra(StudyData(path_), {.job = "", .level = 2}),
               "has no level 3; it has 2");
}

TEST_F(SuiteSpectraTest, OfAFloorNeedItsHistory) {
  EXPECT_FALSE(floor_spectra(StoredHistories(path_)).has_value());
}

TEST_F(SuiteSpectraTest, ImpactsOfRuns) {
  EXPECT_TRUE(stored_impacts(path_).empty());
  const std::vector<StoredImpact> impacts{{.run = 0, .item = "a", .other = "wall"},
                                          {.run = 2, .item = "a", .other = "b"},
                                          {.run = 5, .item = "b", .other = "wall"}};
  const auto found = impacts_of_runs(impacts, {1, 2, 5});
  ASSERT_EQ(found.size(), 2);
  EXPECT_EQ(found[0].run, 2);
  EXPECT_THAT(hit_by_items(impacts), testing::ElementsAre("wall", "b"));
}

}  // namespace
}  // namespace gurney::study
