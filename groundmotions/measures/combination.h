#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

#include "groundmotions/measures/measure.h"
#include "groundmotions/measures/rotation.h"
#include "groundmotions/record/record.h"

namespace gurney::groundmotions {

/// How the components of a record make one value.
enum class Combination {
  kH1,             ///< "h1"
  kH2,             ///< "h2"
  kVertical,       ///< "vertical"
  kGeometricMean,  ///< "geomean": sqrt(h1 h2)
  kLarger,         ///< "larger" of h1 and h2
  kSrss,           ///< "SRSS": sqrt(h1^2 + h2^2)
  kRotD00,         ///< "RotD00", smallest over the angles (Boore 2010, BSSA 100(4), 1830-1835)
  kRotD50,         ///< "RotD50", median over the angles
  kRotD100,        ///< "RotD100", largest over the angles
  kResultant       ///< "resultant": largest length of the horizontal vector over time
};

/// @throws Error with the known names or the nearest. Letter case and blanks do not matter.
Combination parse_combination(std::string_view text);
const char* name_of(Combination combination);
std::vector<std::string> known_combinations();

/// @param what  needs the component: "PGA RotD50"
/// @throws Error if the record does not have it.
const Eigen::VectorXd& acceleration_of(const Record& record, Direction direction,
                                       const std::string& what);

/// PGA, PGV, PGD, PFA and PFV have a resultant.
bool has_resultant(const Measure& measure);

/// The measure of a record's components, combined.
///
/// RotD is the percentile of the measure of h1 cos(theta) + h2 sin(theta) over theta = 0, 1, ...,
/// 179 degrees, for any measure. SaAvg is combined at each period and then averaged, as hazard
/// analyses do that start from models of Sa.
///
/// @returns in SI units
/// @throws  Error for a component that the record does not have, a measure without resultant, SRSS
///          of durations and periods, and as value_of() of a component does.
double value_of(const Measure& measure, Combination combination, const Record& record);

/// A measure over the angles of rotation.h; its percentiles are RotD. Not for spectral measures,
/// which are combined at each period.
RotatedValues rotated_values(const Measure& measure, double time_step, const Eigen::VectorXd& h1,
                             const Eigen::VectorXd& h2);

/// Pseudo-acceleration at samples of a record, its components combined at each period.
/// @param periods  >= 0 [s]
/// @param damping  in [0, 1)
/// @returns [m/s2]
/// @throws Error for a component that the record does not have, and for the resultant, which no
///         spectrum has.
Eigen::VectorXd combined_spectrum(Combination combination, const Record& record,
                                  const Eigen::VectorXd& periods, double damping = 0.05);

}  // namespace gurney::groundmotions
