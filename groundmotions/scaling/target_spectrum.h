#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/error.h"
#include "engine/config/table.h"
#include "groundmotions/formats/source_file.h"

namespace gurney::groundmotions {

/// A response spectrum that records are scaled to. Spectra of records must be of its damping.
struct TargetSpectrum {
  std::string name;                            ///< with its parameters
  double shortest_period = 0;                  ///< [s]
  double longest_period = 0;                   ///< may be infinite [s]
  std::function<double(double)> acceleration;  ///< Sa(T) [m/s2]
  double damping = 0.05;                       ///< share of critical, in (0, 1)
  std::function<double(double)> sigma = {};    ///< of ln Sa(T), >= 0; none: not stated

  /// @throws Error for a period outside of shortest_period..longest_period.
  double at(double period) const;
};

/// Two-period design spectrum of ASCE/SEI 7-16, 11.4.6 (7-22: 11.4.5.2):
/// T_0 = 0.2 S_D1 / S_DS, T_S = S_D1 / S_DS, and
///
///     S_DS (0.4 + 0.6 T / T_0), S_DS, S_D1 / T, S_D1 T_L / T^2     up to T_0, T_S, T_L, beyond
///
/// The multi-period spectra of 7-22, 11.4.5.1 are tables: table_spectrum().
/// @throws Error unless 0 < S_D1 / S_DS <= T_L.
TargetSpectrum asce7_spectrum(double short_period_acceleration, double one_second_acceleration,
                              double long_period);

/// Elastic spectrum of EN 1998-1:2004: horizontal 3.2.2.2, equations (3.2)-(3.6), tables 3.2 and
/// 3.3; vertical 3.2.2.3, equations (3.8)-(3.11), table 3.4. Up to 4 s.
struct Eurocode8 {
  int type = 1;                    ///< 1 or 2
  char ground = 'A';               ///< 'A' to 'E'
  double ground_acceleration = 0;  ///< a_g > 0, with the importance factor [m/s2]
  double damping = 0.05;           ///< share of critical, in (0, 1)
  bool vertical = false;           ///< a_vg = 0.9 a_g (type 1) or 0.45 a_g (type 2)
};

/// @throws Error for another type or ground, and for numbers out of range.
TargetSpectrum eurocode8_spectrum(const Eurocode8& parameters);

/// Elastic site spectrum of NZS 1170.5:2004, 3.1.1: C(T) = C_h(T) Z R N(T,D), with the spectral
/// shape of table 3.1 for modal and time history analysis, by the equations of its commentary;
/// N(T,D) of 3.1.6 (1 for R <= 0.75), table 3.7; Z R at most 0.7.
struct Nzs1170 {
  char site_class = 'C';        ///< 'A' to 'E'
  double hazard = 0;            ///< Z > 0 [-]
  double return_period = 1;     ///< R > 0 [-]
  double fault_distance = 1e3;  ///< D >= 0; 20 and more: no near-fault factor [km]
};

/// @throws Error for another site class.
TargetSpectrum nzs1170_spectrum(const Nzs1170& parameters);

/// Required response spectrum of AC156 (synthetic/ac156.h) from 0 to 10 s. AC156 itself compares at
/// 1.3 Hz and above, up to 0.77 s.
/// @throws Error unless S_DS > 0 and 0 <= z/h <= 1.
TargetSpectrum ac156_spectrum(double short_period_acceleration, double height_ratio, bool vertical);

/// A table with the columns `period_s, sa_g` or `period_s, sa_m_per_s2`, and `sigma_ln` after them
/// where the standard deviation of ln Sa is known: `#` comments, a header row, then rows with
/// growing periods. Between the rows Sa is straight in logarithms (straight where a row is at 0 s),
/// sigma straight in ln T; undefined outside.
/// @throws Error for anything else, one line for each error.
TargetSpectrum table_spectrum(const SourceFile& file);

/// A conditional spectrum of OpenQuake (calculation_mode = conditional_spectrum), a CSV with the
/// columns `poe, stat, period, mea, std`: probability of exceedance, "mean" or a quantile, period
/// [s], median Sa [g], standard deviation of ln Sa. Rows of `stat` mean and of the probability make
/// a table as above.
/// @param poe  none: that of the file, if it has one only
/// @throws Error for anything else, and for a probability that the file does not have.
TargetSpectrum openquake_spectrum(const SourceFile& file, std::optional<double> poe = {});

/// Reads `target` and its parameters: "asce7" (sds_g, sd1_g, tl_s), "eurocode8" (type, ground,
/// ag_g, damping_ratio, vertical), "nzs1170" (site_class, hazard_factor, return_factor,
/// fault_distance_km), "ac156" (sds_g, height_ratio, vertical) or "table" (file). Errors are
/// noted in the table's document; the result is empty then.
/// @param others  further targets that the caller knows, named in errors
std::optional<TargetSpectrum> read_target(config::Table& table,
                                          const std::vector<std::string>& others = {});

/// The file that a target names, from the folder of the table's document.
std::filesystem::path target_file(config::Table& table);

/// Notes an error of that file with its own place, any other at the target.
void note_target(config::Table& table, const Error& error);

}  // namespace gurney::groundmotions
