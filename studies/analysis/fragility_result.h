#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "studies/analysis/curve_audit.h"
#include "studies/analysis/fitted_curve.h"
#include "studies/analysis/study_data.h"
#include "studies/statistics/bands.h"
#include "studies/statistics/fragility.h"
#include "studies/statistics/hazard.h"
#include "studies/statistics/vector_fragility.h"

namespace gurney::study {

/// A larger part of a rate from intensities that were not analysed is cautioned against.
inline constexpr double kLargestShare = 0.1;

/// Mean annual rate of a limit state at a site, and how far the runs support it. NaN where it would
/// exceed that of motions above the lowest analysed intensity: a limit state that needs such a
/// motion cannot, and that the others matter is the form of the curve alone.
struct SiteRate : statistics::MeanRate {
  statistics::Interval interval{0, 0};  ///< of the band's lines; an end above `of_lowest`: infinite
  bool has_interval = false;
  double lowest = 0, highest = 0;           ///< im of the runs
  double share_below = 0, share_above = 0;  ///< of the rate, from motions beyond these
  std::optional<double> of_lowest;          ///< the hazard's rate at `lowest`

  /// The hazard curve is long enough, and the integral lies within the analysed intensities.
  bool is_supported() const;
};

SiteRate site_rate(const statistics::LognormalCurve& curve, const statistics::FragilityBand& band,
                   const CurveAudit& audit, const statistics::HazardCurve& hazard);

/// `0.0012 times a year (0.0007 to 0.0021), 6 % in 50 years`
std::string rate_text(const SiteRate& rate, const CurveAudit& audit);
std::string rate_interval_text(const SiteRate& rate, const CurveAudit& audit);

std::vector<std::string> cautions(const SiteRate& rate, const ReportUnit& unit);

/// Subject of a fragility curve.
struct FragilityRequest {
  std::size_t state = 0, configuration = 0;
  std::string measure = {};  ///< of StudyData::measures(); empty: the study's own
  double confidence = 0.95;  ///< of intervals and bands
  CurveMethod method = CurveMethod::kOwn;
};

/// How likely a limit state is, given an intensity. Intensities are SI.
struct FragilityResult : FittedCurve {
  std::string configuration, state, words;  ///< words: the definition of the state
  RunMeasure measure;                       ///< without its values
  std::size_t runs = 0, exceeded = 0, records = 0, failed = 0;

  statistics::FragilityBand band;  ///< of curve(), at `im`
  std::vector<double> im;          ///< grid over the intensities of the runs, logarithmic
  std::vector<statistics::Stripe> stripes;
  std::optional<statistics::ProfileIntervals> profile;  ///< of stripes; capacities have no others
  std::optional<double> p_of_fit;                       ///< small: a lognormal curve fits badly
  /// False where a record has several runs at one intensity (angles, draws, replicas) or several
  /// capacities: the tests suppose independent ones and would call good fits bad.
  bool fit_is_judged = true;
  std::vector<double> isotonic;  ///< at the stripes

  std::string demand_units = "1";  ///< of the cloud, SI

  std::optional<SiteRate> rate;  ///< with the study's hazard

  Eigen::Matrix2d covariance() const;  ///< of ln theta and ln beta
};

/// @throws Error for a measure that the file lacks
FragilityResult fragility_of(const StudyData& data, const FragilityRequest& request);

/// Fit of outcomes that somebody else has judged, by run; runs without one are left out.
/// @param request  its state is not asked for
/// @throws Error for a measure or a run that the file lacks
FragilityResult fragility_of_outcomes(const StudyData& data,
                                      const std::map<std::size_t, bool>& exceeded,
                                      const FragilityRequest& request);

/// Over the study's own measure, of each configuration that has runs and each limit state.
std::vector<FragilityResult> fragilities_of(const StudyData& data);

/// How likely each performance level is the worst that is reached, at some intensities.
struct PerformanceTable {
  std::string configuration;
  std::vector<std::string> levels;                 ///< limit states, mildest first
  std::vector<double> im;                          ///< SI
  std::vector<statistics::LevelProbabilities> at;  ///< for each im
};

/// From the curves of the study's performance levels; where a level has no curve, from the
/// isotonic fractions of its stripes. None without performance levels, and without stripes.
/// @param results  of one configuration and one measure, of each level among them
std::vector<PerformanceTable> performance_tables(const StudyData& data,
                                                 const std::vector<FragilityResult>& results);

/// Two measures of StudyData::measures(), not the same.
using MeasurePair = std::array<std::string, 2>;

/// How likely a limit state is, given two intensities. Intensities are SI.
struct VectorResult {
  std::string configuration, state, words;
  std::array<RunMeasure, 2> measures;
  std::vector<statistics::VectorObservation> runs;  ///< those that have both measures
  std::size_t left_out = 0, failed = 0;
  statistics::VectorFit fit;                      ///< of capacities after an IDA, else of outcomes
  std::array<statistics::FragilityFit, 2> alone;  ///< of the same with one measure
  CurveAudit audit;  ///< of outcomes and records; two measures have no range to leave
};

/// @throws Error for a measure that the file lacks, or the same one twice; after an IDA, unless one
/// is scaled with the record and the other in proportion or not at all
VectorResult vector_of(const StudyData& data, std::size_t state, std::size_t configuration,
                       const MeasurePair& measures);

}  // namespace gurney::study
