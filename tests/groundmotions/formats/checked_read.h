#pragma once

#include <gmock/gmock.h>

#include <ctime>
#include <string>
#include <vector>

#include "engine/base/error.h"
#include "groundmotions/formats/format.h"

namespace gurney::groundmotions {

using Components = std::vector<Component>;

inline constexpr double kLongestRead = 2;  ///< of a file of a few kilobytes, of CPU time [s]

/// What is read, nothing if the file is refused; fails if neither is sound.
inline Components checked_read(const std::string& bytes, const ReadOptions& options) {
  const std::clock_t start = std::clock();
  Components components;
  try {
    components = read_components(SourceFile("damaged", bytes), options);
    EXPECT_FALSE(components.empty());
    for (const Component& component : components) {
      EXPECT_GE(component.acceleration.size(), 2);
      EXPECT_TRUE(component.acceleration.allFinite());
      EXPECT_TRUE(component.time_step > 0 && component.time_step <= 1);
      EXPECT_FALSE(component.azimuth && !(*component.azimuth >= 0 && *component.azimuth < 7));
    }
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("damaged"));
  }
  EXPECT_LT(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC, kLongestRead);
  return components;
}

inline Eigen::Index samples_in(const Components& components) {
  Eigen::Index sum = 0;
  for (const Component& component : components) sum += component.acceleration.size();
  return sum;
}

inline std::size_t warnings_in(const Components& components) {
  std::size_t sum = 0;
  for (const Component& component : components) sum += component.warnings.size();
  return sum;
}

}  // namespace gurney::groundmotions
