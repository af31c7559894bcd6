#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "groundmotions/models/spectrum_distribution.h"

namespace gurney::groundmotions {

/// Spectra that a suite of records should have together.
struct SelectionTarget {
  std::string name;  ///< with its parameters
  SpectrumDistribution spectrum;
  std::optional<Eigen::Index> conditioning = {};  ///< index of T*, where the spectrum is given
  double damping = 0.05;                          ///< share of critical
};

/// Records to select from, as far as selection knows them.
struct Candidates {
  Eigen::MatrixXd ln_spectra;         ///< ln Sa, a row for each record, Sa in m/s2
  std::vector<std::string> events;    ///< of each record; empty: not known, never limited
  std::vector<std::string> stations;  ///< the same
};

struct SelectionOptions {
  Eigen::Index count = 20;        ///< N, records to select, >= 2
  bool scaled = true;             ///< false: every factor is 1
  double smallest_factor = 0.25;  ///< > 0; an assumption, as in SuiteScalingOptions
  double largest_factor = 4;      ///< > smallest_factor
  int per_event = 0;              ///< most records of one event; 0: any number
  int per_station = 0;            ///< of one station
  std::uint64_t seed = 1;
  int trials = 20;          ///< sets of simulated spectra of which the best is matched, >= 1
  double sigma_weight = 2;  ///< w, Jayaram, Lin & Baker (2011)
};

/// Differences of a set of N spectra from the target, at each period.
struct SpectraErrors {
  Eigen::VectorXd mean;   ///< mean of ln Sa - mu
  Eigen::VectorXd sigma;  ///< standard deviation of ln Sa (N - 1) - sigma

  /// sum over the periods of mean^2 + w sigma^2
  double total(double sigma_weight) const;
};

/// @param ln_spectra  a row for each record, at least 2
SpectraErrors spectra_errors(const Eigen::MatrixXd& ln_spectra, const SpectrumDistribution& target);

/// Selected records, in the order of the candidates.
struct Selection {
  std::vector<Eigen::Index> records;  ///< indices of candidates
  Eigen::VectorXd factors;
  Eigen::MatrixXd ln_spectra;  ///< scaled, a row for each selected record
  Eigen::VectorXd misfits;     ///< of each: root mean square over the periods of ln Sa - mu
  SpectraErrors errors;
  double nearest_total = 0;   ///< SpectraErrors::total() before the improvement
  double total = 0;           ///< and after it, never larger
  Eigen::Index excluded = 0;  ///< candidates whose factor would be out of its limits
};

/// N spectra of the target: mu + V sqrt(lambda) z with the eigenvalues and -vectors of the
/// covariance (those below 0, which a fitted correlation may have, are taken as 0) and z a Latin
/// hypercube of standard normal numbers. Of several sets the one with the smallest total() error.
///
/// @returns ln Sa, a row for each spectrum
Eigen::MatrixXd simulated_spectra(const SpectrumDistribution& target,
                                  const SelectionOptions& options);

/// Selects records whose spectra have the mean and the variance of the target: Jayaram, Lin & Baker
/// (2011), A computationally efficient ground-motion selection algorithm for matching a target
/// response spectrum mean and variance, Earthquake Spectra 27(3), 797-815.
///
/// 1. N spectra are simulated.
/// 2. Each gets the nearest candidate that is not taken, by sum_k (ln f Sa_k - ln Sa_k,simulated)^2.
///    The factor f makes Sa(T*) that of a conditional target; without T* it minimises this sum,
///    held within its limits.
/// 3. Greedy improvement: record after record is replaced by the candidate that lowers the total
///    error most, until a round lowers it by less than 0.1 %.
///
/// A candidate whose factor is out of its limits (T*, or not scaled: never) is excluded. Limits of
/// events and stations hold in every step. The result is a function of the arguments alone.
///
/// @throws Error for options out of range, fewer candidates than N, and if the limits leave too few:
///         with limits of both events and stations, step 2 may miss a selection that exists.
Selection select_records(const SelectionTarget& target, const Candidates& candidates,
                         const SelectionOptions& options);

}  // namespace gurney::groundmotions
