#include "tests/benchmark/free_trolley.h"

#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <sstream>
#include <string>

// A row of docs/performance.md, which `./dev bench --cost` makes.
namespace gurney::benchmark {
namespace {

/// Speed, and the two errors in percent, of the row that begins so.
std::array<double, 3> row_of(const std::string& begin) {
  std::ifstream file(GURNEY_SOURCE_DIR "/docs/performance.md");
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with(begin)) continue;
    std::istringstream rest(line.substr(begin.size()));
    std::array<double, 3> values{};
    for (double& value : values) {
      rest >> value;
      rest.ignore(8, '|');
    }
    return values;
  }
  ADD_FAILURE() << "no row " << begin;
  return {};
}

TEST(CostTable, HasTheErrorsOfTheFreeTrolley) {
  const auto row = row_of("| 12.5 ms | ");
  const FreeTrolleyPoint found = free_trolley({0.0125}, 24)[0];
  // Half a unit of the last digit. The median is of a predictable motion, where another compiler's
  // rounding grows to 1e-10 at most.
  EXPECT_NEAR(100 * found.median_error, row[1], 0.0051);
  EXPECT_NEAR(100 * found.larger_error, row[2], 0.0051);
}

}  // namespace
}  // namespace gurney::benchmark
