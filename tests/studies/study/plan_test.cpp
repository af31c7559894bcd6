#include "studies/study/plan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "tests/studies/study/small_study.h"

namespace gurney {
namespace {

constexpr const char* kUncertainYaw =
    "[item.yaw_deg]\nvalue = 0\n"
    "distribution = { kind = \"uniform\", low = 0, high = 360, assumption = \"any\" }\n";

/// 2 configurations, 3 records, 2 angles, 4 draws.
std::string job_with(const std::string& sampling) {
  return small_job(R"(angles_deg = [0, 30]
synthetic_records = 3
seed = 5
draws = 4
)" + sampling + R"([[study.factor]]
key = "item.brakes"
values = [false, true]
)" + kUncertainYaw,
                   "kind = \"ac156\"");
}

TEST(Plan, CountsDrawsInAnglesInRecordsInConfigurations) {
  const SmallStudy study(job_with(""));
  ASSERT_EQ(study.plan.units(), 2u * 3 * 2 * 4);
  std::size_t index = 0;
  for (std::size_t configuration = 0; configuration < 2; ++configuration)
    for (std::size_t record = 0; record < 3; ++record)
      for (std::size_t angle = 0; angle < 2; ++angle)
        for (std::size_t draw = 0; draw < 4; ++draw, ++index) {
          const Unit unit = study.plan.unit(index);
          EXPECT_EQ(unit.configuration, configuration) << index;
          EXPECT_EQ(unit.record, record) << index;
          EXPECT_EQ(unit.angle, angle) << index;
          EXPECT_EQ(unit.draw, draw) << index;
        }
  EXPECT_EQ(study.plan.runs_of_unit(), 1u);
}

TEST(Plan, ConfigurationsAndAnglesHaveTheSameDrawsAndRecordsOthers) {
  const SmallStudy study(job_with(""));
  std::set<std::uint64_t> numbers;
  for (std::size_t i = 0; i < study.plan.units(); ++i) {
    const Unit unit = study.plan.unit(i);
    const Draw draw = *study.plan.draw(unit);
    EXPECT_EQ(draw.seed(), 5u);
    EXPECT_EQ(draw.run(), unit.record * 4 + unit.draw);
    numbers.insert(draw.run());
  }
  EXPECT_EQ(numbers.size(), 12u);
  const auto yaw = [&](Unit unit) {
    return study.job.job(unit.configuration, study.plan.draw(unit)).scene.items[0].initial.yaw;
  };
  EXPECT_EQ(yaw({0, 1, 0, 2}), yaw({1, 1, 1, 2})) << "paired";
  EXPECT_NE(yaw({0, 1, 0, 2}), yaw({0, 2, 0, 2}));
}

TEST(Plan, AHypercubeHasOneDrawInEachCellOfEachVariable) {
  const SmallStudy study(job_with("sampling = \"latin-hypercube\"\n"));
  constexpr std::size_t kDraws = 12;
  for (const std::string variable : {"item.yaw_deg", "another"}) {
    std::set<int> cells;
    for (std::size_t record = 0; record < 3; ++record)
      for (std::size_t i = 0; i < 4; ++i)
        cells.insert(static_cast<int>(
            kDraws * study.plan.draw({.record = record, .draw = i})->probability(variable)));
    EXPECT_EQ(cells.size(), kDraws) << variable;
    EXPECT_EQ(*cells.begin(), 0);
    EXPECT_EQ(*cells.rbegin(), 11);
  }
}

TEST(Plan, SobolDrawsAreOnePointOfEachVariable) {
  // 3 records of 4 draws: of the first 8 points of a Sobol sequence one lies in each eighth.
  const SmallStudy study(job_with("sampling = \"sobol\"\n"));
  std::set<int> cells;
  for (std::size_t i = 0; i < 8; ++i)
    cells.insert(static_cast<int>(
        8 * study.plan.draw({.record = i / 4, .draw = i % 4})->probability("item.yaw_deg")));
  EXPECT_EQ(cells.size(), 8);
}

}  // namespace
}  // namespace gurney
