#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

namespace gurney::groundmotions {

/// How a suite of records is scaled to a target spectrum.
struct SuiteScalingOptions {
  double smallest_factor = 0.25;  ///< of one record, >= 0
  double largest_factor = 4;      ///< of one record, > smallest_factor
  bool own_factors = true;        ///< false: one common factor for all records

  /// The suite's mean spectrum that the common factor holds against the target.
  enum class Mean { kArithmetic, kGeometric } mean = Mean::kArithmetic;

  /// The mean is nowhere below this share of the target in the range; 0: no such rule, the mean
  /// meets the target on average.
  double floor_share = 0.9;
};

/// The result; all ratios are after scaling, over the periods of the input.
struct SuiteScaling {
  Eigen::VectorXd own_factors;        ///< of each record, by least squares within the limits
  Eigen::VectorXd factors;            ///< the same with the common factor
  double common_factor = 1;           ///< that followed the least squares
  Eigen::VectorXd misfits;            ///< of each record: root mean square of ln(f Sa / target) [-]
  double suite_misfit = 0;            ///< the same of the suite's mean spectrum [-]
  double smallest_ratio = 0;          ///< of the suite's mean to the target
  double period_of_smallest = 0;      ///< [s]
  Eigen::VectorXd mean;               ///< the suite's mean spectrum [m/s2]
  std::vector<std::string> warnings;  ///< records that hit or pass a limit
};

/// Least squares in logarithms: for each record ln f = sum_j w_j (ln target_j - ln Sa_j), which
/// minimises sum_j w_j ln^2(f Sa_j / target_j); w_j are the trapezoidal weights of ln T, so that
/// the spacing of the periods does not matter. f is held within the limits. Then one common factor
/// raises or lowers all records so that min_j (mean_j / target_j) = floor_share; without a floor,
/// so that the mean of ln(mean / target) is zero. The limits do not hold for the common factor.
///
/// ASCE/SEI 7-16, 16.2.3.2, asks for a mean (arithmetic, of maximum-direction spectra) of at least
/// 90 % of the target from 0.2 to 2 times the fundamental period; EN 1998-1:2004, 3.2.3.1.2(4)c,
/// for a mean of at least 90 % between 0.2 T_1 and 2 T_1 (and b, at zero period, a_g S). Which
/// spectrum of a record goes into `spectra`, and which periods, is the caller's choice.
///
/// @param periods  growing, > 0, at least 2 [s]
/// @param spectra  Sa, one row for each record, one column for each period, > 0 [m/s2]
/// @param target   Sa of the target at the periods, > 0 [m/s2]
/// @param names    of the records, for messages
/// @throws Error for shapes and values that do not fit.
SuiteScaling scale_suite(const Eigen::VectorXd& periods, const Eigen::MatrixXd& spectra,
                         const Eigen::VectorXd& target, const std::vector<std::string>& names,
                         const SuiteScalingOptions& options = {});

/// The spectra of a suite and its target at any periods.
struct SuiteSpectra {
  /// One row for each record, one column for each period [m/s2].
  std::function<Eigen::MatrixXd(const Eigen::VectorXd& periods)> records;
  std::function<double(double period)> target;  ///< [m/s2]
};

/// The same, with the floor kept between the periods too: the common factor is that of the lowest
/// ratio anywhere in the range (lowest_ratio(), to 1e-4, which is added). Least squares and misfits
/// are those at the periods given.
SuiteScaling scale_suite(const Eigen::VectorXd& periods, const SuiteSpectra& spectra,
                         const std::vector<std::string>& names,
                         const SuiteScalingOptions& options = {});

/// The lowest value of a function of the period, and where it is.
struct LowestRatio {
  double period = 0;  ///< [s]
  double ratio = 0;
};

/// Finds the lowest value between given periods too. Intervals are halved until none can go below
/// the lowest value found by more than `tolerance` (relative), if the function is nowhere twice as
/// steep over ln T as beside the steepest interval of its neighbourhood.
/// @param periods    growing, > 0, at least 2 [s]
/// @param ratios     of the periods, > 0
/// @param ratios_at  the function, at periods in any order
LowestRatio lowest_ratio(const Eigen::VectorXd& periods, const Eigen::VectorXd& ratios,
                         const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& ratios_at,
                         double tolerance);

}  // namespace gurney::groundmotions
