#include <gmock/gmock.h>

#include <atomic>
#include <thread>

#include "engine/base/error.h"
#include "studies/plan/study_motions.h"

namespace gurney::study {
namespace {

/// One component of `samples` samples, 8 bytes each, that says which motion it is.
groundmotions::Record motion(double value, Eigen::Index samples = 100) {
  groundmotions::Record record;
  record.components[0].emplace();
  record.components[0]->time_step = 0.01;
  record.components[0]->acceleration = Eigen::VectorXd::Constant(samples, value);
  return record;
}

TEST(FloorRecords, MakesEachOnce) {
  FloorRecords records(1 << 20);
  int made = 0;
  const auto of = [&](std::size_t record, double scale) {
    return records.of({0, record, scale}, [&] { return ++made, motion(scale); });
  };
  EXPECT_EQ(of(0, 1)->components[0]->acceleration[0], 1);
  EXPECT_EQ(of(0, 2)->components[0]->acceleration[0], 2);
  EXPECT_EQ(of(0, 1)->components[0]->acceleration[0], 1);
  of(1, 1);
  of(1, 1);
  EXPECT_EQ(made, 3);
}

TEST(FloorRecords, ForgetsThatAskedForLongestAgo) {
  FloorRecords records(2 * 800);
  std::vector<std::size_t> made;
  const auto of = [&](std::size_t record) {
    records.of({0, record, 1}, [&] { return made.push_back(record), motion(1); });
  };
  of(0);
  of(1);
  of(0);
  of(2);  // in place of 1
  of(0);
  of(1);
  EXPECT_THAT(made, testing::ElementsAre(0, 1, 2, 1));
}

TEST(FloorRecords, OneLargerThanAllIsGivenAndNotKept) {
  FloorRecords records(100);
  int made = 0;
  for (int i = 0; i < 2; ++i)
    EXPECT_EQ(records.of({0, 0, 1}, [&] { return ++made, motion(1); })->samples(), 100);
  EXPECT_EQ(made, 2);
}

TEST(FloorRecords, AnErrorIsThatOfEveryCaller) {
  FloorRecords records(1 << 20);
  for (int i = 0; i < 2; ++i)
    EXPECT_THROW(records.of({0, 0, 1}, []() -> groundmotions::Record { throw Error("no"); }),
                 Error);
  EXPECT_EQ(records.of({0, 0, 1}, [] { return motion(1); })->samples(), 100);
}

TEST(FloorRecords, ThreadsWaitForTheOneThatMakesIt) {
  FloorRecords records(1 << 20);
  std::atomic<int> made = 0, right = 0;
  std::vector<std::thread> threads;
  for (int i = 0; i < 8; ++i)
    threads.emplace_back([&] {
      for (int k = 0; k < 100; ++k) {
        const double scale = k;
        const auto got = records.of({0, 0, scale}, [&] {
          std::this_thread::yield();
          return ++made, motion(scale);
        });
        right += got->components[0]->acceleration[99] == scale;
      }
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(made, 100);
  EXPECT_EQ(right, 800);
}

}  // namespace
}  // namespace gurney::study
