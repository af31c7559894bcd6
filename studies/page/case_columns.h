#pragma once

#include <string>
#include <vector>

#include "studies/analysis/study_data.h"

namespace gurney::page {

/// A column of the table of all runs: numbers, or indices of texts.
struct CaseColumn {
  std::string title;  ///< with its unit
  study::ReportUnit unit{"1", 1};
  bool whole = false;
  std::vector<std::string> texts = {};  ///< not empty: values are their indices
  std::vector<double> values = {};      ///< SI, for each run; NaN: none
};

/// The run itself first; demands are the largest over the items. Columns with one value for all
/// runs are left out, but for the outcome.
std::vector<CaseColumn> case_columns(const study::StudyData& data);

/// As JSON that may stand in a page, with each number as the file has it.
/// @param replay  the command that re-runs a case, but for its number
std::string case_json(const std::vector<CaseColumn>& columns, const std::string& replay);

}  // namespace gurney::page
