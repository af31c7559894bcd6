#include <gmock/gmock.h>

#include "groundmotions/assembly/read_record.h"
#include "tests/support/error_text.h"

namespace gurney::groundmotions {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Eigen::VectorXd samples(std::vector<double> values) {
  return Eigen::VectorXd::Map(values.data(), static_cast<Eigen::Index>(values.size()));
}

Component component(const char* file, std::vector<double> values, std::optional<double> start) {
  Component result;
  result.file = file;
  result.time_step = 0.1;
  result.start_time = start;
  result.acceleration = samples(std::move(values));
  return result;
}

Record pair(Component h1, Component h2) {
  Record record;
  record.components[0] = std::move(h1);
  record.components[1] = std::move(h2);
  return record;
}

TEST(Align, ShiftsLateComponentsByWholeSamples) {
  Record record = pair(component("a", {1, 2, 3, 4}, 1000.0), component("b", {5, 6, 7}, 1000.19));
  align(record);
  EXPECT_EQ(record[Direction::kH1]->acceleration, samples({1, 2, 3, 4, 0}));
  EXPECT_EQ(record[Direction::kH2]->acceleration, samples({0, 0, 5, 6, 7}));
  EXPECT_THAT(record.warnings,
              ElementsAre("b: starts 0.19 s after the first component: 2 zeros added before it, "
                          "-0.01 s are left",
                          "a: 4 samples, the longest component has 5: 1 zeros added at the end"));
}

TEST(Align, LeavesLessThanHalfASample) {
  Record record = pair(component("a", {1, 2, 3}, 1000.0), component("b", {5, 6, 7}, 1000.04));
  align(record);
  EXPECT_EQ(record[Direction::kH2]->acceleration, Eigen::Vector3d(5, 6, 7));
  EXPECT_THAT(record.warnings,
              ElementsAre("b: starts 0.04 s after the first component: 0 zeros added before it, "
                          "0.04 s are left"));
}

// 0.0005 s are 0.005 of a sample; 0.01 is reported.
TEST(Align, IsSilentOnWhatIsRoundedInAFile) {
  Record record = pair(component("a", {1, 2, 3}, 1000.0), component("b", {5, 6, 7}, 1000.0005));
  align(record);
  EXPECT_THAT(record.warnings, IsEmpty());
}

TEST(Align, ReportsThatStartsAreNotUsed) {
  Record some = pair(component("a", {1, 2, 3}, 1000.0), component("b", {5, 6, 7}, {}));
  align(some);
  EXPECT_EQ(some[Direction::kH2]->acceleration, Eigen::Vector3d(5, 6, 7));
  EXPECT_THAT(some.warnings, ElementsAre("b: states no start, as other components do: all are "
                                         "taken to start at the same time"));
  Record none = pair(component("a", {1, 2, 3}, {}), component("b", {5, 6, 7}, {}));
  align(none);
  EXPECT_THAT(none.warnings, IsEmpty());
}

TEST(Align, RefusesStartsOfOtherEarthquakes) {
  Record record = pair(component("a", {1, 2, 3, 4}, 0.0), component("b", {5, 6, 7}, 86400.0));
  EXPECT_EQ(error_text([&] { align(record); }),
            "b: starts 86400 s after the first component, which is longer than the shortest (0.2 "
            "s): these are not of one earthquake");
}

}  // namespace
}  // namespace gurney::groundmotions
