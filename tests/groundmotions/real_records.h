#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "groundmotions/formats/format.h"
#include "groundmotions/formats/numbers.h"
#include "groundmotions/measures/peaks.h"

namespace gurney {

/// Tests with real files, which may not be part of the project: a folder named by GURNEY_RECORDS,
/// with reference_values.csv, one row for each component.
class RealRecords : public testing::Test {
 protected:
  struct Reference {
    std::string file;  ///< from the folder
    std::string component;
    double samples, time_step, pga, time_of_pga, mean, pgv;  ///< SI; pgv without detrending
  };

  void SetUp() override {
    const char* folder = std::getenv("GURNEY_RECORDS");
    if (!folder) GTEST_SKIP() << "GURNEY_RECORDS names no folder of real records";
    folder_ = folder;
  }

  /// The reference values of files whose path starts with `start`.
  std::vector<Reference> references(const std::string& start) const {
    std::ifstream stream(folder_ / "reference_values.csv");
    std::vector<Reference> rows;
    for (std::string line; std::getline(stream, line);) {
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
    EXPECT_DOUBLE_EQ(component.time_step, reference.time_step);
    const Peaks p = peaks(component.time_step, component.acceleration);
    EXPECT_NEAR(p.acceleration, reference.pga, 0.001 * reference.pga);
    EXPECT_NEAR(p.velocity, reference.pgv, 0.005 * reference.pgv);
    EXPECT_NEAR(component.acceleration.mean(), reference.mean, 1e-5 * reference.pga);
  }

  /// A file with one component.
  void expect_reference(const Reference& reference, const ReadOptions& options = {}) const {
    SCOPED_TRACE(reference.file);
    const auto components = read_components(folder_ / reference.file, options);
    ASSERT_EQ(components.size(), 1u);
    expect_values(reference, components[0]);
  }

  /// The files of a folder, as "folder/name".
  std::vector<std::string> files(const std::string& folder) const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder_ / folder))
      names.push_back(folder + "/" + entry.path().filename().string());
    return names;
  }

  std::filesystem::path folder_;
};

}  // namespace gurney
