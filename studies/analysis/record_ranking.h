#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "studies/analysis/configuration_view.h"

namespace gurney::study {

/// What one record does at one level.
struct RankedRecord {
  std::size_t record = 0;  ///< StudyData::record_of() of its runs
  std::string name;
  std::vector<std::size_t> runs;  ///< at all angles, draws and replicas
  std::size_t overturned = 0;     ///< of these
  double demand = 0;  ///< mean over the runs; one that overturned has what it had before [SI]

  /// The demand by the line ln demand = a + b ln im through the other records, of the measure that
  /// predicts best; NaN where there is none, or this record overturns the item.
  double predicted = std::numeric_limits<double>::quiet_NaN();
};

/// How well one intensity measure predicts the order of the records.
struct RankedMeasure {
  std::string name, units;     ///< SI
  std::vector<double> values;  ///< of each record, the mean over its runs
  /// 1 - (sum of squares of the errors of ln demand, each predicted by the other records) / (the same
  /// for a prediction by the mean of the others); Allen (1974), Technometrics 16(1), 125-127. 1: the
  /// measure explains the order; 0 or less: no better than no measure.
  double explained = 0;
};

/// The records of a study at one level by what they do to one item.
struct RecordRanking {
  std::string item, demand;  ///< demand: "peak_displacement"
  std::string units;         ///< of it, SI
  std::string configuration, level;
  std::vector<RankedRecord> records;    ///< the most overturned first, then the largest demand
  std::vector<RankedMeasure> measures;  ///< the best first; none with fewer than kLeastRecords
  std::size_t predicted = 0;            ///< records that the measures were judged by
};

/// Of a line through others at least four points remain, two more than it has parameters.
inline constexpr std::size_t kLeastRecords = 5;

struct RankingRequest {
  std::string demand = "peak_displacement";
  std::optional<std::size_t> level;  ///< index in Levels; none: the highest that was run
};

/// One ranking for each item that has the demand. Measures that all records share to 1 %, such as
/// that of the level, explain nothing and are left out.
/// @throws Error for an IDA, whose records have other levels; for a study of one record; with the
///         nearest name
std::vector<RecordRanking> rank_records(const ConfigurationView& side,
                                        const RankingRequest& request);

}  // namespace gurney::study
