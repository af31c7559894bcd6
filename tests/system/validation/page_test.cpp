#include <gtest/gtest.h>

#include <filesystem>

#include "engine/base/input_file.h"
#include "tests/system/validation/small_runs.h"

// docs/validation.md and the studies it reports.
namespace gurney::study {
namespace {

namespace fs = std::filesystem;

/// Every validation_*.toml has its row `| name | runs |`, with the number of its runs.
TEST(ValidationPage, ReportsTheRunsOfEachStudy) {
  const std::string page = read_input_file(GURNEY_SOURCE_DIR "/docs/validation.md");
  int studies = 0;
  for (const auto& entry : fs::directory_iterator(GURNEY_SOURCE_DIR "/studies/jobs")) {
    const std::string name = entry.path().stem().string();
    if (!name.starts_with("validation_")) continue;
    ++studies;
    const std::string row = fmt::format("| `{}` | {} |", name, SmallRuns(name).count());
    EXPECT_NE(page.find(row), std::string::npos) << "docs/validation.md has no row " << row;
  }
  EXPECT_EQ(studies, 8);
}

}  // namespace
}  // namespace gurney::study
