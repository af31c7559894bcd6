#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

namespace gurney::groundmotions {

enum class MeasureKind {
  kPga,
  kPgv,
  kPgd,
  kPfa,
  kPfv,
  kArias,
  kCav,
  kD575,
  kD595,
  kTm,
  kTp,
  kSa,
  kSaAvg,
  kFiv3,
  kSi
};

/// An intensity measure of one component.
struct Measure {
  MeasureKind kind = MeasureKind::kPga;
  double period = 0;       ///< of Sa >= 0, of SaAvg and FIV3 > 0; first period of a range [s]
  double last_period = 0;  ///< of SaAvg over a range: its last period; 0: from 0.2 to 3 T [s]
  double damping = 0.05;   ///< of Sa and SaAvg, in [0, 1)
};

/// The text forms: "PGA", "PGV", "PGD", "PFA", "PFV", "Arias", "CAV", "D5-75", "D5-95", "Tm", "Tp",
/// "SI", "Sa(1.0)", "Sa(1.0, 2%)", "SaAvg(1.0)", "SaAvg(0.2:3.0)", "SaAvg(1.0, 2%)", "FIV3(1.0)";
/// periods in s. Letter case and blanks do not matter.
/// @throws Error with the known names, or the nearest.
Measure parse_measure(std::string_view text);

/// The text form that parse_measure() reads: "Sa(1, 2%)".
std::string name_of(const Measure& measure);

/// What the measure is, in a sentence.
std::string definition_of(const Measure& measure);

/// A unit to print a value in.
struct DisplayUnit {
  const char* name;
  double in_si;  ///< SI units in one of these
};

const char* si_unit_of(const Measure& measure);  ///< "m/s2", "m/s", "m" or "s"
DisplayUnit display_unit_of(const Measure& measure);

/// n such that f times the motion has f^n times the measure: 1 for peaks and spectra, 2 for Arias,
/// 0 for durations and periods, to which no motion can be scaled.
double scaling_power(const Measure& measure);

/// The periods whose Sa the measure is the geometric mean of: one for Sa, many for SaAvg, none for
/// other measures [s].
Eigen::VectorXd spectral_periods(const Measure& measure);

/// @param time_step     > 0 [s]
/// @param acceleration  at least 2 samples [m/s2]
/// @returns             in SI units
/// @throws Error if the measure has no value for such a record: FIV3 of a long or very short
/// period.
double value_of(const Measure& measure, double time_step, const Eigen::VectorXd& acceleration);

/// The forms of parse_measure(), for help texts.
std::vector<std::string> known_measures();

}  // namespace gurney::groundmotions
