#include "studies/analysis/zone_occupancy.h"

#include <gmock/gmock.h>

#include <cmath>

#include "tests/studies/analysis/small_study.h"
#include "tests/support/temp_folder.h"

namespace gurney::study {
namespace {

/// Of a run in which nothing entered, say, with the free width left.
ZoneOutcome never(double width) { return {.least_free_width = width}; }

ZoneOutcome entered(double time, bool at_end, double width) {
  return {.time_of_entry = 1,
          .occupied_time = time,
          .occupied_at_end = at_end,
          .least_free_width = width};
}

std::vector<ZoneOccupancy> occupancy_of(const std::vector<SmallRun>& runs,
                                        const std::vector<SmallZone>& zones) {
  const TempFolder folder;
  write_small_study(folder.file("a.h5"), runs, kSmallStudy, zones);
  return zone_occupancy(StudyData(folder.file("a.h5")));
}

TEST(ZoneOccupancy, CountsRunsOfEachZone) {
  const auto all =
      occupancy_of({{0, 1, 0}, {1, 1, 0}, {2, 1, 0}}, {{0, "door", never(0.9)},
                                                       {0, "way", never(1.2)},
                                                       {1, "door", entered(2, false, 0.5)},
                                                       {1, "way", never(1.2)},
                                                       {2, "door", entered(4, true, 0.1)},
                                                       {2, "way", entered(1.5, true, 0)}});
  ASSERT_EQ(all.size(), 2);
  const ZoneOccupancy &door = all[0], &way = all[1];
  EXPECT_EQ(door.zone, "door");
  EXPECT_EQ(door.configuration, "all");
  EXPECT_EQ(door.runs, 3);
  EXPECT_EQ(door.entered, 2);
  EXPECT_EQ(door.occupied_at_end, 1);
  EXPECT_DOUBLE_EQ(door.occupied_time, 2);
  EXPECT_DOUBLE_EQ(door.least_free_width, 0.5);
  EXPECT_DOUBLE_EQ(door.smallest_free_width, 0.1);
  EXPECT_EQ(way.entered, 1);
  EXPECT_DOUBLE_EQ(way.occupied_time, 0.5);
  EXPECT_DOUBLE_EQ(way.least_free_width, 1.2);
  EXPECT_EQ(way.smallest_free_width, 0);
}

TEST(ZoneOccupancy, CountsRunsThatBeginInside) {
  ZoneOutcome inside = entered(9, true, 0.2);
  inside.time_of_entry = 0;
  const auto all = occupancy_of(
      {{0, 1, 0}, {1, 1, 0}, {2, 1, 0}},
      {{0, "door", never(0.9)}, {1, "door", inside}, {2, "door", entered(1, true, 0)}});
  ASSERT_EQ(all.size(), 1);
  EXPECT_EQ(all[0].entered, 2);
  EXPECT_EQ(all[0].from_start, 1);
}

TEST(ZoneOccupancy, LeavesFailedRunsOut) {
  const auto all = occupancy_of({{0, 1, 0}, {1, 1, 0, false, true}},
                                {{0, "door", never(0.9)}, {1, "door", entered(9, true, 0)}});
  ASSERT_EQ(all.size(), 1);
  EXPECT_EQ(all[0].runs, 1);
  EXPECT_EQ(all[0].entered, 0);
  EXPECT_DOUBLE_EQ(all[0].smallest_free_width, 0.9);
}

TEST(ZoneOccupancy, KnowsNoWidthWhereNoRunDoes) {
  const auto all = occupancy_of(
      {{0, 1, 0}, {1, 1, 0}},
      {{0, "door", never(std::nan(""))}, {0, "way", never(std::nan(""))}, {1, "way", never(2)}});
  ASSERT_EQ(all.size(), 2);
  EXPECT_TRUE(std::isnan(all[0].least_free_width));
  EXPECT_TRUE(std::isnan(all[0].smallest_free_width));
  EXPECT_EQ(all[1].runs, 2);
  EXPECT_EQ(all[1].least_free_width, 2);
}

TEST(ZoneOccupancy, OfAFileWithoutZonesIsNone) {
  EXPECT_TRUE(occupancy_of({{0, 1, 0}}, {}).empty());
}

}  // namespace
}  // namespace gurney::study
