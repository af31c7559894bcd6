#pragma once

#include <optional>
#include <string>
#include <vector>

namespace gurney::study {

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
