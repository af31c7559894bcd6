#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/config/document.h"
#include "studies/limit_states/limit_state.h"
#include "studies/statistics/hazard.h"

namespace gurney::study {

/// A file of limit states, performance levels, or both.
struct LimitStatesFile {
  std::vector<LimitState> states;        ///< of the job where the file has none
  std::vector<std::string> where;        ///< `file:line:column` of each; empty: of the job
  std::vector<std::size_t> performance;  ///< indices of states, mildest first
};

/// @param of_job  limit states that `performance` may name where the file has none of its own
/// @throws Error with all errors, each with file:line:column
LimitStatesFile read_limit_states_file(const std::string& path,
                                       const std::vector<LimitState>& of_job);

/// Annual rates of exceedance at the site.
struct SiteHazard {
  statistics::HazardCurve curve;  ///< im in SI
  std::string measure;            ///< "PGA geomean"
  std::string where;              ///< of a file: `file:line:column` of its measure
};

/// @throws Error with all errors, each with file:line:column
SiteHazard read_hazard_file(const std::string& path);
SiteHazard read_site_hazard(config::Document& document);

}  // namespace gurney::study
