#pragma once

#include <Eigen/Core>

namespace gurney::groundmotions {

/// A part of a record.
struct TimeInterval {
  double from = 0;  ///< [s]
  double to = 0;    ///< [s]
};

/// The part of a record between two shares of its Husid curve (Husid 1969), significant_part() of
/// measures/cumulative.h: 0.05 and 0.95 give the significant duration D5-95.
/// @param time_step  > 0 [s]
/// @param from, to   0 <= from < to <= 1
/// @throws Error for other shares and for a motion that is all zero.
TimeInterval significant_interval(double time_step, const Eigen::VectorXd& acceleration,
                                  double from, double to);

/// Samples of a record.
struct SampleRange {
  Eigen::Index first = 0;
  Eigen::Index count = 0;
};

/// The fewest samples that cover an interval; what lies outside the record is left out.
/// @param samples  of the record
/// @throws Error unless from < to, and for an interval with less than 2 samples of the record.
SampleRange samples_within(const TimeInterval& interval, double time_step, Eigen::Index samples);

/// Cosine tapers (Hann): the samples of the first `start` seconds times (1 - cos(pi t / start)) /
/// 2, with t the time since the first sample, and likewise those of the last `end` seconds
/// backwards. The end samples become zero.
/// @param time_step   > 0 [s]
/// @param start, end  >= 0, together at most the duration; 0: no taper there [s]
/// @throws Error for other lengths.
Eigen::VectorXd tapered(double time_step, const Eigen::VectorXd& acceleration, double start,
                        double end);

}  // namespace gurney::groundmotions
