#pragma once

#include <optional>
#include <string>
#include <vector>

#include "studies/analysis/scale_factors.h"
#include "studies/analysis/study_data.h"
#include "studies/statistics/bands.h"
#include "studies/statistics/fragility.h"

namespace gurney::study {

/// Fewer runs that exceed, or that do not, than ten a parameter of interest do not determine a
/// regression of outcomes (Peduzzi, Concato, Kemper, Holford & Feinstein 1996, Journal of Clinical
/// Epidemiology 49(12), 1373-1379).
inline constexpr std::size_t kFewOutcomes = 10;

/// Analysis cases of an IDA that another limit state ended before they exceed one are censored by
/// their response, not at random. At this share of the cases theta is too high by up to 0.15 beta
/// and beta by 7 %, about what 40 records leave uncertain (docs/theory/statistics.md).
inline constexpr double kManyEnded = 0.2;

/// Facts of the runs behind a fragility curve that its user has to know.
struct CurveAudit {
  std::optional<double> theta;             ///< none: there is no curve
  double lowest = 0, highest = 0;          ///< im of the runs
  bool of_capacities = false;              ///< outcomes are capacities, not runs
  bool of_demands = false;                 ///< of a cloud: outcomes do not determine the curve
  const char* counted = "runs";            ///< of capacities: records or analysis cases
  std::size_t outcomes = 0, exceeded = 0;  ///< of these
  std::size_t overturned = 0;              ///< runs of an IDA
  std::size_t ended = 0;                   ///< of capacities: cases that another state ended before
  std::string hazard_over;                 ///< the measure of the job's hazard, where it is another
  bool chosen_by_response = false;         ///< outcomes of an IDA, which are not capacities
  std::size_t overturned_short = 0;        ///< runs that overturned short of a limit of length
  std::size_t records = 0;
  double effective = 0, fewest = 0;  ///< records, and how many an interval needs; 0: no curve
  ScaleFactors factors;
};

/// Whether theta lies outside the intensities of the runs.
bool is_extrapolated(const CurveAudit& audit);

/// Whether fewer than kFewOutcomes runs exceed, or do not.
bool has_few_outcomes(const CurveAudit& audit);

/// Whether there are too few effective records for an interval.
bool has_few_records(const CurveAudit& audit);

/// `fewer than 8 effective records (5 of 5): no usable interval`
std::string few_records_text(const CurveAudit& audit);

/// Audit of a curve that is fitted to the outcomes of runs.
CurveAudit outcome_audit(const statistics::FragilityFit& fit,
                         const std::vector<statistics::Observation>& observations,
                         const ScaleFactors& factors);

/// `no annual rate: the hazard of the job is over PGA geomean`
std::string no_rate_text(const std::string& hazard_over);

/// `0.22 to 1.1`; `0.22 to unbounded`; where neither end is bounded `none: fewer than 8 effective
/// records` or `unbounded (12 records)`.
std::string interval_text(const statistics::Interval& interval, double in_si, int digits,
                          const CurveAudit& audit);

/// A sentence for each reason not to use the curve as it stands, or with care.
std::vector<std::string> cautions(const CurveAudit& audit, const ReportUnit& unit);

/// `no run exceeds up to 1.2 g`: where the outcomes of runs without a curve change.
/// @param change  highest im without to lowest with exceedance; an end that is not: 0, infinity
std::string outcomes_text(statistics::FragilityStatus status, const statistics::Interval& change,
                          const ReportUnit& unit);

/// `median above 1.2 g`; empty where nothing is known of it.
std::string median_text(const statistics::MedianBounds& median, const ReportUnit& unit);

}  // namespace gurney::study
