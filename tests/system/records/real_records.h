#pragma once

#include <gmock/gmock.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "engine/base/units.h"
#include "groundmotions/formats/format.h"
#include "groundmotions/formats/numbers.h"
#include "groundmotions/measures/peaks.h"
#include "tests/support/error_text.h"

namespace gurney::groundmotions {

/// Tests with real files, which may not be part of the project: a folder named by GURNEY_RECORDS,
/// with reference_values.csv, one row for each component in the order of its file.
class RealRecords : public testing::Test {
 protected:
  struct Reference {
    std::string file;  ///< from the folder
    std::string component;
    double samples, time_step, pga, time_of_pga, mean, pgv;  ///< SI; pgv without detrending
  };

  static constexpr int kUp = -1, kNoDirection = -2;  ///< else an azimuth in degrees

  void SetUp() override {
    const char* folder = std::getenv("GURNEY_RECORDS");
    if (!folder) GTEST_SKIP() << "GURNEY_RECORDS names no folder of real records";
    folder_ = folder;
  }

  /// The reference values of files whose path starts with `start`.
  std::vector<Reference> references(const std::string& start = "") const {
    std::ifstream stream(folder_ / "reference_values.csv");
    std::vector<Reference> rows;
    std::string line;
    for (std::getline(stream, line); std::getline(stream, line);) {
      if (!line.starts_with(start)) continue;
      std::istringstream text(line);
      std::vector<std::string> cells;
      for (std::string cell; std::getline(text, cell, ',');) cells.push_back(cell);
      const auto value = [&](std::size_t k) { return number(cells[k]).value_or(0); };
      rows.push_back(
          {cells[0], cells[1], value(3), value(5), value(6), value(7), value(8), value(10) / 100});
    }
    return rows;
  }

  /// Samples and step exactly, PGA to 0.1 %, PGV to 0.5 %. The reference prints nine digits.
  static void expect_values(const Reference& reference, const Component& component) {
    SCOPED_TRACE(reference.file + " " + reference.component);
    EXPECT_EQ(component.acceleration.size(), reference.samples);
    EXPECT_NEAR(component.time_step, reference.time_step, 1e-12);
    const Peaks p = peaks(component.time_step, component.acceleration);
    EXPECT_NEAR(p.acceleration, reference.pga, 0.001 * reference.pga);
    EXPECT_NEAR(p.time_of_acceleration, reference.time_of_pga, 0.5 * component.time_step);
    EXPECT_NEAR(p.velocity, reference.pgv, 0.005 * reference.pgv);
  }

  std::vector<Component> read(const std::string& file, const ReadOptions& options = {}) const {
    return read_components(folder_ / file, options);
  }

  std::string error(const std::string& file, const ReadOptions& options = {}) const {
    return error_text([&] { read(file, options); });
  }

  /// @param directions  of the components of a file: azimuth in degrees, kUp or kNoDirection
  std::vector<Component> expect_directions(const std::string& file,
                                           const std::vector<int>& directions,
                                           const ReadOptions& options = {}) const {
    SCOPED_TRACE(file);
    const auto components = read(file, options);
    EXPECT_EQ(components.size(), directions.size());
    for (std::size_t i = 0; i < std::min(components.size(), directions.size()); ++i) {
      EXPECT_EQ(components[i].direction == Direction::kVertical, directions[i] == kUp) << i;
      EXPECT_EQ(components[i].azimuth.has_value(), directions[i] >= 0) << i;
      if (!components[i].azimuth) continue;
      EXPECT_NEAR(*components[i].azimuth, directions[i] * kRadiansPerDegree, 1e-12) << i;
    }
    return components;
  }

  std::filesystem::path folder_;
};

}  // namespace gurney::groundmotions
