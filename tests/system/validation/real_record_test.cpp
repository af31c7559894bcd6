#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "engine/base/input_file.h"
#include "tests/system/validation/small_runs.h"

// studies/jobs/validation_long_period.toml with a recorded motion, which may not be part of the
// project: TCU068 of the Chi-Chi earthquake, in a folder named by GURNEY_RECORDS.
namespace gurney::study {
namespace {

namespace fs = std::filesystem;

void replace(std::string& text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  ASSERT_NE(at, std::string::npos) << from;
  text.replace(at, from.size(), to);
}

/// The job as docs/validation.md says to change it for a record.
std::string job_with(const std::string& files) {
  std::string text = read_input_file(GURNEY_SOURCE_DIR "/studies/jobs/validation_long_period.toml");
  replace(text, R"(synthetic = { kind = "long_period" })", "file = [" + files + "]");
  replace(text, "synthetic_records = 10", "");
  const auto begin = text.find("[[study.factor]]\nname = \"period\""),
             end = text.find("[[study.factor]]\nname = \"item\"");
  text.erase(begin, end - begin);
  return text;
}

TEST(ValidationRealRecord, FreeItemsTravelMetresAndBrakedOnesStay) {
  const char* folder = std::getenv("GURNEY_RECORDS");
  if (!folder) GTEST_SKIP() << "GURNEY_RECORDS names no folder of real records";
  std::string files;
  for (const char* component : {"N", "E", "V"}) {
    const fs::path file =
        fs::path(folder) / "peer_nga_at2" / fmt::format("RSN1505_CHICHI_TCU068-{}.AT2", component);
    if (!fs::exists(file)) GTEST_SKIP() << file << " is not there";
    files += fmt::format("\"{}\", ", file.string());
  }
  const SmallRuns study(job_with(files), GURNEY_SOURCE_DIR "/studies/jobs/real_record.toml");
  // Largest displacements without brakes as docs/validation.md states them, to its digits.
  const std::map<std::string, double> free = {
      {"bed", 2.77}, {"dialysis", 3.05}, {"ultrasound", 2.09}};
  for (const auto& [item, expected] : free) {
    const auto moved = [&](const char* brakes) {
      return demands_of(study.runs({{"item", item}, {"brakes", brakes}})[0]).peak_displacement;
    };
    EXPECT_NEAR(moved("off"), expected, 0.005) << item;
    EXPECT_LT(moved("half"), 0.1) << item;
    EXPECT_LT(moved("on"), 0.04) << item;
  }
}

}  // namespace
}  // namespace gurney::study
