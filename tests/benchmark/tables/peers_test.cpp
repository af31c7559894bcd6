#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "tests/benchmark/peers/curves.h"

// A part of docs/performance/peers.csv, which `./dev bench --peers FOLDER` makes.
namespace gurney::benchmark {
namespace {

/// The errors of the three peaks in the row that begins so.
std::array<double, 3> errors_of(const std::string& begin) {
  std::ifstream file(GURNEY_SOURCE_DIR "/docs/performance/peers.csv");
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with(begin)) continue;
    std::istringstream rest(line.substr(begin.size()));
    std::array<double, 4> values{};  // CPU time, then errors
    for (double& value : values) {
      rest >> value;
      rest.ignore();
    }
    return {values[1], values[2], values[3]};
  }
  ADD_FAILURE() << "no row " << begin;
  return {};
}

// The file has four digits: half a unit of the last one is up to 5e-4 of an error. Both jobs are
// predictable: another compiler's rounding, 1e-13 of the path, grows by less than 1000.
TEST(PeersTable, HasTheErrorsOfTenMilliseconds) {
  const std::vector<Engine> all = own_engines({0.01}, {});
  for (const Job& job : {free_trolley_job(3), half_locked_job(3)})
    for (const Point& point : work_precision(job, {all[0], all[2]}, 0.00025)) {
      const auto expected = errors_of(point.job + ",Gurney,\"" + point.setup + "\",10,,");
      for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(point.error[i], expected[i], 6e-4 * expected[i])
            << point.job << ", " << point.setup << ": " << kPeakNames[i];
    }
}

}  // namespace
}  // namespace gurney::benchmark
