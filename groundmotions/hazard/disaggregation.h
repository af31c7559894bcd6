#pragma once

#include <optional>
#include <string>

namespace gurney::groundmotions {

/// The mean earthquake of those that exceed Sa(T*), by their part in its rate (McGuire 1995, Bulletin
/// of the Seismological Society of America 85(5), 1275-1284; Baker 2011, J. Structural Engineering
/// 137(3), 322-331).
struct Disaggregation {
  double period = 0;              ///< T* [s]
  double acceleration = 0;        ///< Sa(T*) that is exceeded [m/s2]
  double magnitude = 0;           ///< mean moment magnitude
  double distance = 0;            ///< mean distance to the rupture [km]
  std::optional<double> epsilon;  ///< mean of ln Sa(T*) in standard deviations above the median
};

struct DisaggregationRequest {
  std::optional<double> period = {};  ///< T* [s]; none: that of the file, if it has one only
  std::optional<double> poe = {};     ///< of OpenQuake's file, in its investigation time; alike
};

/// Reads the means over all sources of an answer of the disaggregation service of the USGS (a file
/// `*.json`, see UsgsAnswer), or computes them from OpenQuake's `Mag_Dist_Eps-mean-0_12.csv` or
/// `Mag_Dist-mean-0_12.csv`: a line of comment, then the columns `imt, iml, poe, mag, dist`, `eps`
/// and `mean` (of a single realization, `rlz0`), the probability that earthquakes of this bin exceed
/// iml [g]. Their rates -ln(1 - poe) are the weights.
/// @throws Error with `file:line:column`, or the path of the element, for anything else
Disaggregation read_disaggregation(const std::string& path, const DisaggregationRequest& request);

}  // namespace gurney::groundmotions
