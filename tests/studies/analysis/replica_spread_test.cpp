#include "studies/analysis/replica_spread.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "studies/run/study_file.h"
#include "tests/studies/small_study.h"
#include "tests/support/temp_folder.h"

namespace gurney::study {
namespace {

std::string written(const TempFolder& folder, const std::string& study) {
  const SmallStudy small(small_job(study));
  const std::string path = folder.file("a.h5");
  write_study_file(path, small.batch, [&](std::size_t task) { return small.run(task); });
  return path;
}

TEST(ReplicaSpread, IsThatOfTheRunsOfOneCase) {
  const TempFolder folder;
  const StudyReader file(written(folder, "replicas = 3\n[study.intensity]\nscales = [1, 2]\n"));
  const std::vector<double> scale = file.numbers("runs/scale");
  const std::vector<double> peaks = file.numbers("items/peak_displacement");
  for (std::size_t run = 0; run < 6; ++run) {
    std::vector<double> same;
    for (std::size_t i = 0; i < 6; ++i)
      if (scale[i] == scale[run]) same.push_back(peaks[i]);
    ASSERT_EQ(same.size(), 3u);
    std::ranges::sort(same);
    const auto spread = replica_spread(file, run);
    ASSERT_TRUE(spread);
    EXPECT_EQ(spread->runs, 3u);
    EXPECT_EQ(spread->failed, 0u);
    EXPECT_EQ(spread->overturned, 0u);
    EXPECT_EQ(spread->lowest, same[0]);
    EXPECT_EQ(spread->median, same[1]);
    EXPECT_EQ(spread->highest, same[2]);
  }
}

TEST(ReplicaSpread, IsNoneWithoutReplicas) {
  const TempFolder folder;
  EXPECT_FALSE(replica_spread(StudyReader(written(folder, "")), 0));
}

}  // namespace
}  // namespace gurney::study
