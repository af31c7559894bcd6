#pragma once

#include <string>
#include <vector>

#include "studies/analysis/configuration_view.h"
#include "studies/analysis/fragility_result.h"
#include "studies/statistics/intensity_table.h"

namespace gurney::study {

/// How well each intensity measure of a study file predicts the demand of one limit state.
struct MeasureChoice {
  std::vector<statistics::IntensityRow> rows;  ///< best first; those without information last
  std::vector<std::string> units;              ///< of each row, SI
  std::vector<std::string> unknown;            ///< measures that no run has
  std::vector<std::string> properties;         ///< of IntensityRow::sufficiency
  double floor = 0;                            ///< demands below are "at most" this [SI]
  std::string demand_units = "1";              ///< of it, SI
  std::size_t runs = 0, records = 0, overturned = 0, at_floor = 0;

  std::size_t ties = 0;  ///< rows after the first whose likelihood is the same: in one proportion

  /// ln likelihood of the first row less that of the first row that is not as good; NaN unless both
  /// rest on the same runs.
  double lead = 0;

  /// Share of resamples of records in which the first row's likelihood is the largest, or as
  /// large; NaN with fewer than two records or rows.
  double stays_best = 0;
};

/// Rows are ranked by likelihood. Those that rest on fewer runs (the measure is unknown for some)
/// stand behind, by efficiency. Properties of records are the factor on them (sufficiency against
/// it says whether scaling biases the demand), and magnitude and distance where every run has them.
/// @param state  one whose demand has a size, as StudyData::cloud()
/// @throws Error as StudyData::cloud()
MeasureChoice rank_measures(const ConfigurationView& side, std::size_t state, int resamples = 200,
                            std::uint64_t seed = 1);

/// The states that rank_measures() takes.
std::vector<std::size_t> sized_states(const StudyData& data);

}  // namespace gurney::study
