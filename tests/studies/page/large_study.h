#pragma once

#include <fmt/format.h>

#include "tests/studies/analysis/synthetic_runs.h"

namespace gurney::page {

/// 100,000 runs of 50 records at two levels.
inline study::SyntheticRuns large_study() {
  constexpr std::size_t kRuns = 100'000, kRecords = 50;
  study::SyntheticRuns study{.job = study::synthetic_job(), .records = {}, .files = {}, .runs = {}};
  for (std::size_t i = 0; i < kRecords; ++i) study.records.push_back(fmt::format("record {}", i));
  for (std::size_t i = 0; i < kRuns; ++i)
    study.runs.push_back({.record = i % kRecords,
                          .level = i % 100 < 50 ? 1.0 : 2.0,
                          .displacement = 0.3 / (1.0 + double(i % 9973)),
                          .fell = i % 1000 == 0});
  return study;
}

}  // namespace gurney::page
