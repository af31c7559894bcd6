#pragma once

#include <string>
#include <vector>

#include "studies/statistics/special.h"

namespace gurney {

/// A study file whose outcomes follow known curves, without any simulation: two configurations,
/// `false` and `true`, records at six levels of PGA.
///
/// The capacities of the records are the quantiles of curve(configuration) at (i + 0.5) / records;
/// at and above it the item `ICU bed` ends 0.05 m away (limit state `moved`), below it 0.001 m.
/// Nothing else is exceeded. Run kFailed failed. Runs 0 to 9 were repeated with half the step:
/// peak_displacement of run k is 1 + k % larger there, and run kChanged did not move.
struct SyntheticStudy {
  static constexpr std::size_t kRecords = 40, kFailed = 17, kChanged = 4;
  static const std::vector<double> kLevels;  ///< [g]

  /// @param configuration  0 or 1
  static statistics::LognormalCurve curve(std::size_t configuration);  ///< im in g

  /// Index of a run: levels follow each other, in them records, in them configurations.
  static std::size_t run(std::size_t configuration, std::size_t record, std::size_t level);

  static bool moved(std::size_t configuration, std::size_t record, std::size_t level);

  /// @param step_check  with the runs at half the step
  /// @param ida         as if the levels had been found by an IDA for `moved`
  static void write(const std::string& path, bool step_check = true, bool ida = false);
};

}  // namespace gurney
