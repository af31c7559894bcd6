#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "groundmotions/record.h"

namespace gurney {

/// An intensity measure, with its parameter where it has one.
struct Measure {
  enum class Kind {
    kPga,    ///< peak ground (or floor) acceleration, at samples
    kPgv,    ///< peak velocity of the exact integral from rest, no baseline correction
    kPgd,    ///< likewise displacement
    kArias,  ///< measures/duration.h
    kCav,    ///< measures/duration.h
    kD5_75,  ///< measures/duration.h
    kD5_95,  ///< measures/duration.h
    kTm,     ///< measures/duration.h
    kTp,     ///< period of the largest PSA (5 %) of 200 periods from 0.02 to 5 s
    kSi,  ///< Housner's spectrum intensity: integral of PSV (5 %) over T from 0.1 to 2.5 s (Housner
          ///< 1952, in: Symposium on Earthquake and Blast Effects on Structures, 20-36)
    kSa,  ///< PSA (5 %) at the period, at samples
    kSaAvg,  ///< geometric mean of PSA at 10 periods evenly from 0.2 T to 3 T (Eads, Miranda &
             ///< Lignos 2015, Earthquake Engineering and Structural Dynamics 44(12), 2057-2073)
    kFiv3    ///< measures/fiv3.h
  };
  Kind kind = Kind::kPga;
  double period = 0;  ///< of kSa >= 0, kSaAvg and kFiv3 > 0 [s]
};

/// How the horizontals are made one number. The vertical stands alone.
enum class Combination {
  kH1,
  kH2,
  kVertical,
  kGeometricMean,
  kLarger,
  kSrss,  ///< root of the sum of squares
  kRotD00,
  kRotD50,
  kRotD100
};

/// Reads "PGA", "PGV", "PGD", "Arias", "CAV", "D5-75", "D5-95", "Tm", "Tp", "SI", "Sa(1.0)",
/// "SaAvg(1.0)" or "FIV3(1.0)", letter case and blanks apart.
/// @throws Error with the names there are.
Measure parse_measure(std::string_view text);

std::string name_of(const Measure& measure);     ///< as parse_measure takes it
std::string unit_of(const Measure& measure);     ///< "m/s2", "m/s", "m" or "s"
std::string meaning_of(const Measure& measure);  ///< one sentence

/// What a measure does when a record is multiplied by f: it is multiplied by f to this power. 0:
/// it does not change, and no record can be scaled to it.
double scaling_power(const Measure& measure);

const char* name_of(Combination combination);
std::vector<std::string> combination_names();  ///< in the order of Combination

/// Of one component. @param time_step  > 0 [s]
double value_of(const Measure& measure, double time_step, const Eigen::VectorXd& acceleration);

/// Of a record. RotD of the spectral measures and of PGA, PGV and PGD rotates their histories;
/// RotD of the others takes the measure of each of the 180 rotated motions. Of a duration or a
/// period the geometric mean is meant as such, though it has no source.
/// @throws Error for a component that the record does not have.
double value_of(const Measure& measure, Combination combination, const Record& record);

/// The measures that describe a record, for tables.
std::vector<Measure> usual_measures();

}  // namespace gurney
