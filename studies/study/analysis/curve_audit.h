#pragma once

#include <optional>
#include <string>
#include <vector>

#include "studies/statistics/fragility.h"
#include "studies/study/analysis/report_unit.h"
#include "studies/study/analysis/scale_factors.h"

namespace gurney::study {

/// Fewer runs that exceed, or that do not, than ten a parameter of interest do not determine a
/// regression of outcomes (Peduzzi, Concato, Kemper, Holford & Feinstein 1996, Journal of Clinical
/// Epidemiology 49(12), 1373-1379).
inline constexpr std::size_t kFewOutcomes = 10;

/// What a user of a fragility curve has to know of the runs behind it.
struct CurveAudit {
  std::optional<double> theta;             ///< none: there is no curve
  double lowest = 0, highest = 0;          ///< im of the runs
  bool of_capacities = false;              ///< outcomes are capacities, not runs
  const char* counted = "runs";            ///< of capacities: records or analysis cases
  std::size_t outcomes = 0, exceeded = 0;  ///< of these
  std::size_t overturned = 0;              ///< runs of an IDA
  ScaleFactors factors;
};

/// Of a curve that is fitted to the outcomes of runs.
CurveAudit outcome_audit(const statistics::FragilityFit& fit,
                         const std::vector<statistics::Observation>& observations,
                         const ScaleFactors& factors);

/// A sentence for each reason not to use the curve as it stands, or with care.
std::vector<std::string> cautions(const CurveAudit& audit, const ReportUnit& unit);

/// `no run exceeds: median above 1.2 g`
std::string no_curve_text(statistics::FragilityStatus status,
                          const statistics::MedianBounds& median, const ReportUnit& unit);

/// `median above about 1.2 g`; empty where nothing is known of it.
std::string median_text(statistics::FragilityStatus status, const statistics::MedianBounds& median,
                        const ReportUnit& unit);

}  // namespace gurney::study
