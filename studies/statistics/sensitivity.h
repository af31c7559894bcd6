#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "studies/statistics/bands.h"

namespace gurney::statistics {

/// The output at a low and a high value of one input.
struct TornadoBar {
  std::size_t input = 0;  ///< its place among the inputs
  double low = 0, high = 0;
  double low_error = 0, high_error = 0;  ///< standard errors of both; 0 for single runs
  std::size_t low_runs = 0, high_runs = 0;

  double swing() const { return high - low; }
};

/// Means of the output where each input is among its lowest and its highest `share`: a tornado from
/// runs in which all inputs vary. For runs with one input varied fill the bars and sort them.
/// @param inputs  for each input a value for each run
/// @return longest bar first
/// @throws Error unless sizes agree, 0 < share <= 0.5 and share * runs >= 2.
std::vector<TornadoBar> tornado(const std::vector<std::vector<double>>& inputs,
                                const std::vector<double>& output, double share = 0.1);

void sort_by_swing(std::vector<TornadoBar>& bars);  ///< longest first, else by input

struct SensitivityOptions {
  int bins = 0;  ///< of equal counts; 0: sqrt(runs), at most 50
  double confidence = 0.95;
  int resamples = 499;
  std::uint64_t seed = 1;
};

/// Share of an output's variance.
struct VarianceIndex {
  /// Scatters about the truth; 0 where it is below by chance, if there are resamples.
  double estimate = 0;
  Interval interval;  ///< bootstrap over runs, within [0, 1]; holds the estimate

  /// Both within [0, 1].
  static VarianceIndex within_0_and_1(double estimate, const Interval& interval);
};

/// First-order index Var E(y | x) / Var y from any runs with independent inputs, by classes of x
/// (Plischke, Borgonovo & Smith 2013, European J. Operational Research 226(3), 536-550).
/// The variance between the means of classes that chance alone makes is taken off: 1 - (n - 1) / (n
/// - m) SS_within / SS_total for m classes, Kelley's epsilon squared (1935, PNAS 21(9), 554-559).
/// The bootstrap's bias is taken off its percentiles. None where y does not vary or n < 2 m. Values
/// of x that are equal share a class.
/// @throws Error unless there is an x for each y.
std::optional<VarianceIndex> first_order_index(const std::vector<double>& x,
                                               const std::vector<double>& y,
                                               const SensitivityOptions& options = {});

/// First-order index of an input without an order, such as the record: a class for each number.
std::optional<VarianceIndex> first_order_index_of_classes(const std::vector<std::size_t>& classes,
                                                          const std::vector<double>& y,
                                                          const SensitivityOptions& options = {});

/// Share of the variance that is left where all inputs are given, E Var(y | class) / Var y, with
/// Var y = E Var(y | class) + Var E(y | class), the law of total variance. By the analysis of
/// variance of one random factor, unbiased for classes of any sizes n_i (Searle, Casella &
/// McCulloch 1992, Variance components, section 3.6): E Var(y | class) = MS_within = SS_within / (n
/// - m), Var E(y | class) = (MS_between - MS_within) / n_0, MS_between = SS_between / (m - 1), n_0
/// = (n - sum n_i^2 / n) / (m - 1). The interval is by bootstrap over classes. None for fewer than
/// two classes, none with two values, and where y does not vary.
/// @throws Error unless there is a class for each y.
std::optional<VarianceIndex> share_within_classes(const std::vector<std::size_t>& classes,
                                                  const std::vector<double>& y,
                                                  const SensitivityOptions& options = {});

/// Indices of one input from a design made for them.
struct SobolIndices {
  VarianceIndex first, total;
};

/// From outputs of the matrices A, B, and of A with column i from B: S_i = mean f_B (f_ABi - f_A) /
/// V (Saltelli et al. 2010, Computer Physics Communications 181(2), 259-270, table 2 b) and S_Ti =
/// mean (f_A - f_ABi)^2 / 2V (Jansen 1999), V of A and B together, f less its mean.
/// @return for each input; empty where the output does not vary
/// @throws Error unless all are equally long, 2 or more.
std::vector<SobolIndices> sobol_indices(const std::vector<double>& a, const std::vector<double>& b,
                                        const std::vector<std::vector<double>>& ab,
                                        const SensitivityOptions& options = {});

}  // namespace gurney::statistics
