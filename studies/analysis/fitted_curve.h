#pragma once

#include <optional>
#include <string>
#include <vector>

#include "studies/analysis/curve_audit.h"
#include "studies/analysis/study_data.h"
#include "studies/statistics/capacity.h"
#include "studies/statistics/cloud.h"
#include "studies/statistics/fragility.h"

namespace gurney::study {

/// Demands below this fraction of the limit count as "at most" it: they are noise of an item at
/// rest (the time step and the settling of the treads), and would dominate a regression of
/// logarithms. An assumption; 0.01 to 0.0001 is as good.
inline constexpr double kFloorOfLimit = 1e-3;

/// Data that a curve is fitted to.
enum class CurveMethod {
  kOwn,    ///< capacities after an IDA, else outcomes
  kCloud,  ///< the demands, by regression on the intensities
};

/// The fragility curve of a limit state and a configuration, without intervals.
struct FittedCurve {
  CurveMethod method = CurveMethod::kOwn;
  std::vector<statistics::Observation> observations;
  statistics::FragilityFit fit;                       ///< of the outcomes of runs
  std::vector<statistics::Capacity> brackets;         ///< of an IDA: one for each record; else none
  std::optional<statistics::CapacityFit> capacities;  ///< of the brackets
  statistics::MedianBounds median;  ///< where the runs give no curve: see median_bounds()
  CurveAudit audit;

  std::vector<statistics::CloudPoint> demands;  ///< where the state is a demand above a limit
  std::optional<statistics::CloudFit> cloud;    ///< of them
  std::optional<statistics::LognormalCurve> cloud_curve;
  Eigen::Matrix2d cloud_covariance = Eigen::Matrix2d::Zero();  ///< of its ln theta, ln beta

  bool by_cloud() const { return method == CurveMethod::kCloud; }
  bool by_capacities() const { return !by_cloud() && capacities; }

  /// The curve to be used; none: see no_curve().
  std::optional<statistics::LognormalCurve> curve() const {
    return by_cloud() ? cloud_curve : capacities ? capacities->curve : fit.curve;
  }
  statistics::FragilityStatus status() const {
    return by_capacities() ? capacities->status : fit.status;
  }
  /// Highest intensity without, lowest with exceedance; see the status.
  statistics::Interval change() const {
    return by_capacities() ? statistics::Interval{capacities->low, capacities->high}
                           : statistics::Interval{fit.low, fit.high};
  }
};

/// Why there is no curve, and what is known of the median.
std::string no_curve_text(const FittedCurve& fitted, const ReportUnit& unit);

/// An IDA gives capacities for every limit state, over every measure that is scaled with the record:
/// it chooses the runs of a record by the response, so that their outcomes are not those of stripes.
FittedCurve fitted_curve(const StudyData& data, std::size_t state, std::size_t configuration,
                         const RunMeasure& measure, CurveMethod method = CurveMethod::kOwn);

/// The curve of an event that somebody else has judged: of outcomes, or of capacities after an IDA.
/// @param observations  of runs of the configuration, with their analysis cases
FittedCurve curve_of_event(const StudyData& data, std::size_t configuration,
                           const RunMeasure& measure,
                           std::vector<statistics::Observation> observations);

/// Facts of the brackets of an IDA in place of those of its runs, but for theta.
void audit_brackets(const StudyData& data, std::size_t configuration,
                    const std::vector<statistics::Capacity>& brackets, CurveAudit& audit);

/// Confidence band of the curve in use, unless it is a cloud; see fragility_band() and
/// capacity_intervals(). That of an IDA without a curve is that of its outcomes, which supposes no
/// model.
statistics::FragilityBand band_of_curve(const FittedCurve& fitted, const std::vector<double>& im,
                                        double confidence);

}  // namespace gurney::study
