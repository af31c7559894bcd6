#pragma once

#include <optional>
#include <string>
#include <vector>

namespace gurney::groundmotions {

/// A hazard curve as OpenQuake or the USGS publishes it, as its points. Intensities that are never
/// exceeded have no rate and are left out; of those that are exceeded equally often the largest
/// stays.
struct PublishedHazard {
  std::string measure;       ///< "PGA", "PGV", "Sa(0.2)"
  std::vector<double> im;    ///< increases [SI]
  std::vector<double> rate;  ///< decreases [1/year]
};

/// Reads the curve of one site in OpenQuake's `hazard_curve-mean-PGA_12.csv`: probabilities of
/// exceedance in the investigation time T, accelerations in g and PGV in cm/s; of a Poisson process
/// rate = -ln(1 - poe) / T. Intensities that are certain (poe = 1) have no rate either.
/// @param site  row of the site, from 1; none: the file must have one site
/// @throws Error with `file:line:column` for another kind of file, another measure, numbers that are
///         no probabilities or do not decrease
PublishedHazard read_openquake_hazard(const std::string& path, std::optional<int> site);

/// Reads the total mean curve in an answer of the hazard service of the USGS (National Seismic
/// Hazard Models), which is JSON: `response.hazardCurves[]` of the present one (ws/nshmp/MODEL/
/// dynamic/hazard), or `response[]` of the one before it (nshmp-haz-ws), which the Unified Hazard
/// Tool asks. Accelerations in g, PGV in cm/s, annual frequencies of exceedance.
/// @param measure  as name_of(Measure); empty: the file must have one measure
/// @throws Error with the path of the element for anything else, also for a disaggregation
PublishedHazard read_usgs_hazard(const std::string& path, const std::string& measure);

}  // namespace gurney::groundmotions
