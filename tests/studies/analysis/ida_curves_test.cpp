#include <gmock/gmock.h>

#include <cmath>

#include "studies/analysis/demand_runs.h"
#include "tests/studies/analysis/small_study.h"
#include "tests/support/error_text.h"
#include "tests/support/temp_folder.h"

namespace gurney::study {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

DemandRun run(std::size_t record, double im, double demand, bool overturned = false) {
  return {im, demand, overturned, record, record};
}

TEST(IdaCurves, AreOrderedAndEndWhereTheItemOverturns) {
  const auto curves =
      ida_curves({run(1, 4, 9, true), run(1, 1, 0.5), run(0, 2, 3), run(1, 8, 7), run(0, 1, 1)});
  ASSERT_EQ(curves.size(), 2u);
  EXPECT_THAT(curves[0].im, ElementsAre(0, 1, 2));
  EXPECT_THAT(curves[0].demand, ElementsAre(0, 1, 3));
  EXPECT_TRUE(std::isinf(curves[0].capacity));
  EXPECT_THAT(curves[1].im, ElementsAre(0, 1)) << "what stands again above a fall counts no more";
  EXPECT_DOUBLE_EQ(curves[1].capacity, 2);  // sqrt(1 * 4)
}

TEST(IdaCurves, AreLinearBetweenRuns) {
  const auto curves = ida_curves({run(0, 1, 1), run(0, 2, 3), run(1, 1, 0.5), run(1, 4, 9, true)});
  EXPECT_DOUBLE_EQ(curves[0].demand_at(0.5), 0.5);
  EXPECT_DOUBLE_EQ(curves[0].demand_at(1.5), 2);
  EXPECT_TRUE(std::isnan(curves[0].demand_at(2.1)));
  EXPECT_DOUBLE_EQ(curves[1].demand_at(1.9), 0.5);
  EXPECT_TRUE(std::isinf(curves[1].demand_at(2)));
}

TEST(IdaCurves, FractilesCountTheOverturned) {
  // Demands 1, 2, 3 at im = 1, the third overturns from sqrt(1 * 4) = 2 on.
  const auto curves = ida_curves(
      {run(0, 1, 1), run(0, 4, 4), run(1, 1, 2), run(1, 4, 8), run(2, 1, 3), run(2, 4, 5, true)});
  EXPECT_DOUBLE_EQ(fractile_at(curves, 1, 0.5), 2);
  EXPECT_DOUBLE_EQ(fractile_at(curves, 1, 0.25), 1.5)
      << "between the first, at 0, and the second of three";
  EXPECT_DOUBLE_EQ(fractile_at(curves, 4, 0.5), 8);
  EXPECT_TRUE(std::isinf(fractile_at(curves, 4, 0.84)));
  EXPECT_TRUE(std::isnan(fractile_at(curves, 5, 0.5))) << "one of three is known";
}

TEST(DemandRunsTest, AreThoseOfEachItem) {
  const TempFolder folder;
  write_small_study(folder.file("s.h5"),
                    {{0, 1, 0.2}, {0, 2, 0.3, true}, {1, 1, 0.1, false, true}});
  const StudyData data(folder.file("s.h5"));
  const auto all = demand_runs(data, {0}, "peak_displacement", data.measure(""));
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].item, "cart");
  EXPECT_EQ(all[1].item, "bed");
  EXPECT_EQ(all[0].measure_unit.name, "g");
  ASSERT_EQ(all[0].configurations.size(), 1u);
  const auto& runs = all[0].configurations[0].runs;
  ASSERT_EQ(runs.size(), 2u) << "without the run that failed";
  EXPECT_EQ(runs[0].demand, 0.2);
  EXPECT_FALSE(runs[0].overturned);
  EXPECT_TRUE(runs[1].overturned);
  EXPECT_EQ(runs[1].im, 2);
  EXPECT_FALSE(all[1].configurations[0].runs[1].overturned) << "the bed stands";
  EXPECT_THAT(error_text([&] { demand_runs(data, {0}, "peak_displacment", data.measure("")); }),
              HasSubstr("did you mean 'peak_displacement'?"));
}

}  // namespace
}  // namespace gurney::study
