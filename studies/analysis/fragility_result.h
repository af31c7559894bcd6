#pragma once

#include <optional>
#include <string>
#include <vector>

#include "studies/analysis/fitted_curve.h"
#include "studies/analysis/site_rate.h"
#include "studies/analysis/study_data.h"
#include "studies/statistics/bands.h"

namespace gurney::study {

/// What a fragility is asked of.
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
};

/// @throws Error for a measure that the file lacks
FragilityResult fragility_of(const StudyData& data, const FragilityRequest& request);

}  // namespace gurney::study
