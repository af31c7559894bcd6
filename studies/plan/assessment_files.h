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

/// A hazard curve of OpenQuake's `hazard_curve-mean-PGA_12.csv`, as its points.
struct OpenQuakeHazard {
  std::string measure;       ///< "PGA", "PGV", "Sa(0.2)"
  std::vector<double> im;    ///< increases [SI]
  std::vector<double> rate;  ///< decreases [1/year]
};

/// Reads the curve of one site. OpenQuake states probabilities of exceedance in the investigation
/// time T, accelerations in g and PGV in cm/s; of a Poisson process rate = -ln(1 - poe) / T.
/// Intensities that are certain (poe = 1) or never exceeded (poe = 0) have no rate and are left
/// out; of those that are exceeded equally often the largest stays.
/// @param site  row of the site, from 1; none: the file must have one site
/// @throws Error with `file:line:column` for another kind of file, another measure, numbers that are
///         no probabilities or do not decrease
OpenQuakeHazard read_openquake_hazard(const std::string& path, std::optional<int> site);

}  // namespace gurney::study
