#include "engine/base/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <thread>

namespace gurney {

void parallel_for(std::size_t count, int threads, const std::function<void(std::size_t)>& work) {
  std::exception_ptr problem;
  std::atomic<bool> broken = false;
#pragma omp parallel for schedule(dynamic, 1) num_threads(threads)
  for (std::size_t i = 0; i < count; ++i) {
    if (broken) continue;
    try {
      work(i);
    } catch (...) {
      if (!broken.exchange(true)) problem = std::current_exception();
    }
  }
  if (problem) std::rethrow_exception(problem);
}

int threads_or_all(int asked) {
  return asked > 0 ? asked : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

}  // namespace gurney
