#include "studies/run/shard.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <string>

#include "tests/support/error_text.h"

namespace gurney::study {
namespace {

using testing::HasSubstr;
using Variables = std::map<std::string, std::string>;

Shard shard_in(const Variables& variables) {
  return shard_from("auto", [&](const char* name) {
    const auto found = variables.find(name);
    return found == variables.end() ? nullptr : found->second.c_str();
  });
}

Shard shard_of(const std::string& text) {
  return shard_from(text, [](const char*) { return static_cast<const char*>(nullptr); });
}

TEST(Shard, EveryTaskBelongsToOne) {
  for (const std::size_t count : {1, 2, 3, 7, 16})
    for (const std::size_t tasks : {1, 15, 16, 100}) {
      std::size_t all = 0;
      for (std::size_t number = 1; number <= count; ++number) {
        std::size_t mine = 0;
        for (std::size_t task = 0; task < tasks; ++task) mine += Shard{number, count}.has(task);
        EXPECT_EQ(mine, (Shard{number, count}.tasks_of(tasks)));
        EXPECT_LE(mine, (tasks + count - 1) / count);
        EXPECT_GE(mine, tasks / count);
        all += mine;
      }
      EXPECT_EQ(all, tasks);
    }
}

// Eight angles of each record, in eight shards: no shard has one angle alone.
TEST(Shard, HasNotAlwaysTheSamePlaceOfAPeriod) {
  std::map<std::size_t, int> places;
  for (std::size_t task = 0; task < 64; ++task)
    if (Shard{3, 8}.has(task)) ++places[task % 8];
  EXPECT_EQ(places.size(), 8);
}

TEST(Shard, IsReadFromTextAndFolders) {
  EXPECT_EQ(shard_of("3/8"), (Shard{3, 8}));
  EXPECT_EQ(shard_of_folder("3-of-8"), (Shard{3, 8}));
  EXPECT_EQ((Shard{3, 8}.folder()), "3-of-8");
  for (const char* name : {"3-of-2", "0-of-2", "a-of-2", "3-of-8.log", "study", "3-of-8-of-9"})
    EXPECT_FALSE(shard_of_folder(name)) << name;
  EXPECT_EQ(error_text([] { shard_of("9/8"); }),
            "--shard: 9/8 must be I/N with 1 <= I <= N <= 100000, or auto");
}

TEST(Shard, OfAnArrayGoesBeforeThatOfAStep) {
  const Variables array = {{"SLURM_ARRAY_TASK_ID", "12"},  {"SLURM_ARRAY_TASK_MIN", "10"},
                           {"SLURM_ARRAY_TASK_MAX", "13"}, {"SLURM_ARRAY_TASK_COUNT", "4"},
                           {"SLURM_PROCID", "0"},          {"SLURM_NTASKS", "1"}};
  EXPECT_EQ(shard_in(array), (Shard{3, 4}));
  EXPECT_EQ(shard_in({{"SLURM_PROCID", "5"}, {"SLURM_NTASKS", "6"}}), (Shard{6, 6}));
  EXPECT_EQ(shard_in({{"OMPI_COMM_WORLD_RANK", "0"}, {"OMPI_COMM_WORLD_SIZE", "2"}}),
            (Shard{1, 2}));
}

TEST(Shard, IsNotGuessed) {
  EXPECT_THAT(error_text([] { shard_in({}); }), HasSubstr("give --shard I/N"));
  EXPECT_THAT(error_text([] {
                shard_in({{"SLURM_ARRAY_TASK_ID", "5"},
                          {"SLURM_ARRAY_TASK_MIN", "3"},
                          {"SLURM_ARRAY_TASK_MAX", "5"},
                          {"SLURM_ARRAY_TASK_COUNT", "2"}});
              }),
              HasSubstr("the array has 2 tasks with indices from 3 to 5"));
  EXPECT_THAT(error_text([] {
                shard_in({{"SLURM_PROCID", "6"}, {"SLURM_NTASKS", "6"}});
              }),
              HasSubstr("name shard 7 of 6"));
}

}  // namespace
}  // namespace gurney::study
