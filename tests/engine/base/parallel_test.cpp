#include "engine/base/parallel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <new>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace gurney {
namespace {

TEST(ParallelFor, CallsEachOnce) {
  std::vector<int> calls(100, 0);
  parallel_for(calls.size(), 3, [&](std::size_t i) { ++calls[i]; });
  EXPECT_EQ(calls, std::vector<int>(100, 1));
}

TEST(ParallelFor, ThrowsWhatACallThrowsAndBeginsNoMore) {
  std::atomic<int> calls = 0;
  const auto work = [&](std::size_t i) {
    ++calls;
    if (i == 0) throw std::bad_alloc();
  };
  EXPECT_THROW(parallel_for(100000, 1, work), std::bad_alloc);
  EXPECT_EQ(calls, 1);
  EXPECT_THROW(parallel_for(100000, 4, work), std::bad_alloc);
}

TEST(ParallelFor, ThrowsOneOfSeveral) {
  const auto work = [](std::size_t i) { throw std::runtime_error(std::to_string(i)); };
  EXPECT_THROW(parallel_for(8, 4, work), std::runtime_error);
}

TEST(ThreadsOrAll, AreThoseThatAreAskedForOrTheMachines) {
  EXPECT_EQ(threads_or_all(3), 3);
  EXPECT_EQ(threads_or_all(0), std::max(1, static_cast<int>(std::thread::hardware_concurrency())));
}

}  // namespace
}  // namespace gurney
