#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "groundmotions/formats/format.h"
#include "groundmotions/formats/numbers.h"
#include "groundmotions/measures/peaks.h"
#include "tests/support/error_text.h"

/// Real files, which may not be part of the project: a folder named by GURNEY_RECORDS, with
/// reference_values.csv (columns file, ..., npts, dt_s, pga_mps2, pgv_raw_cmps).
namespace gurney {
namespace {

using testing::HasSubstr;

class RealRecords : public testing::Test {
 protected:
  void SetUp() override {
    const char* folder = std::getenv("GURNEY_RECORDS");
    if (!folder) GTEST_SKIP() << "GURNEY_RECORDS names no folder of real records";
    folder_ = folder;
  }

  /// Rows of the reference values whose file starts with `start`.
  std::vector<std::vector<std::string>> references(const std::string& start) const {
    std::ifstream stream(folder_ / "reference_values.csv");
    std::vector<std::vector<std::string>> rows;
    for (std::string line; std::getline(stream, line);) {
      if (!line.starts_with(start)) continue;
      std::istringstream cells(line);
      rows.emplace_back();
      for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(cell);
    }
    return rows;
  }

  void expect_reference(const std::vector<std::string>& row, const ReadOptions& options) const {
    SCOPED_TRACE(row[0]);
    const auto components = read_components(folder_ / row[0], options);
    ASSERT_EQ(components.size(), 1u);
    const Component& component = components[0];
    EXPECT_EQ(component.acceleration.size(), number(row[3]));
    EXPECT_EQ(component.time_step, number(row[5]));
    const Peaks p = peaks(component.time_step, component.acceleration);
    const double pga = *number(row[6]), pgv = *number(row[10]) / 100;
    EXPECT_NEAR(p.acceleration, pga, 0.001 * pga);
    EXPECT_NEAR(p.time_of_acceleration, *number(row[7]), 0.5 * component.time_step);
    EXPECT_NEAR(p.velocity, pgv, 0.005 * pgv);
  }

  std::filesystem::path folder_;
};

TEST_F(RealRecords, ReadsEveryAt2File) {
  std::size_t count = 0;
  for (const char* folder : {"peer_nga_at2/", "at2_variants/"})
    for (const auto& row : references(folder)) {
      expect_reference(row, {});
      ++count;
    }
  EXPECT_GT(count, 30u);
}

TEST_F(RealRecords, LeavesNoAt2FileWithoutAReferenceAndRefusesVelocities) {
  for (const char* folder : {"peer_nga_at2", "at2_variants"})
    for (const auto& entry : std::filesystem::directory_iterator(folder_ / folder)) {
      const std::string name = std::string(folder) + "/" + entry.path().filename().string();
      if (name.ends_with("AT2") || name.ends_with("at2"))
        EXPECT_EQ(references(name + ",").size(), 1u) << name;
      else
        EXPECT_THAT(error_text([&] { read_components(entry.path()); }),
                    HasSubstr("a record must be acceleration, but this is a "))
            << name;
    }
}

TEST_F(RealRecords, ReadsPlainColumns) {
  for (const char* name :
       {"plain_text/IELC180.acc", "fema_p695_text/120711.th", "fema_p695_text/121112.th"})
    for (const auto& row : references(name))
      expect_reference(row, {.unit = "g", .time_step = number(row[5])});
}

// Formats that are not read yet must be refused, not taken for one that is.
TEST_F(RealRecords, TakesNoOtherFormatForOneOfOurs) {
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_)) {
    const std::string folder = entry.path().parent_path().filename().string();
    if (!entry.is_regular_file() || folder == "peer_nga_at2" || folder == "at2_variants" ||
        folder == "plain_text" || folder == "fema_p695_text")
      continue;
    EXPECT_NE(error_text([&] { read_components(entry.path(), {.unit = "g", .time_step = 0.01}); }),
              "")
        << entry.path();
  }
}

}  // namespace
}  // namespace gurney
