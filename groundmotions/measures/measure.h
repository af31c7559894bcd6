#pragma once

#include <Eigen/Core>
#include <cctype>
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

/// Definition of the measure, in a sentence.
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

/// `text` without blanks, in small letters: what names of measures are compared by.
inline std::string plain_name(std::string_view text) {
  std::string result;
  for (const char c : text)
    if (!std::isspace(static_cast<unsigned char>(c)))
      result += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

/// Mean period Tm = sum(C_i^2 / f_i) / sum(C_i^2) over 0.25 Hz <= f_i <= 20 Hz [s], C_i the Fourier
/// amplitudes (Rathje, Abrahamson & Bray 1998, J. Geotech. Geoenviron. Eng. 124(2), 150-159;
/// Rathje, Faraj, Russell & Bray 2004, Earthquake Spectra 20(1), 119-144, who ask for a frequency
/// step of at most 0.05 Hz). The record is padded with zeros to a power of two of at least twice
/// its length and at least 20 s. 0 if there is nothing in this band.
/// @param time_step     > 0 [s]
/// @param acceleration  [m/s2]
double mean_period(double time_step, const Eigen::VectorXd& acceleration);

/// Predominant period Tp: where PSA at 5 % damping (at the samples) is largest [s] (Rathje et al.
/// 1998), among 400 logarithmically spaced periods from 0.02 to 10 s, which are 1.6 % apart. The
/// shortest of equals; 0 for a motion that is all zero.
double predominant_period(double time_step, const Eigen::VectorXd& acceleration);

/// The periods of SaAvg(T): 0.01 s apart from 0.2 T to 3 T, as Eads, Miranda & Lignos (2015, EESD
/// 44(12), 2057-2073) have them; at least ten, then evenly spaced.
/// @param period  > 0 [s]
Eigen::VectorXd average_periods(double period);

/// Periods between two periods 0 < from < to [s].
Eigen::VectorXd average_periods(double from, double to);

/// Average spectral acceleration: the geometric mean of `spectral_accelerations` [m/s2], 0 if one
/// of them is 0.
double geometric_mean(const Eigen::VectorXd& spectral_accelerations);

/// Spectrum intensity SI = int_0.1^2.5 PSV dT [m] (Housner 1952, Spectrum intensities of
/// strong-motion earthquakes, Proc. Symposium on Earthquake and Blast Effects on Structures, Los
/// Angeles), here at 5 % damping, peaks at the samples, by the trapezoid in steps of 0.02 s
/// (damping and step are assumptions).
double spectrum_intensity(double time_step, const Eigen::VectorXd& acceleration);

}  // namespace gurney::groundmotions
