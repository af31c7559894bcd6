#pragma once

#include <string>
#include <vector>

#include "studies/analysis/fitted_curve.h"
#include "studies/analysis/study_data.h"
#include "studies/statistics/lognormal.h"

namespace gurney::study {

/// What of a study is exported; an empty text: all configurations, all limit states, the study's
/// own measure.
struct ExportChoice {
  std::string configuration{}, measure{}, limit{};
  bool separate = false;  ///< a component for each limit state, not for those of one quantity
  bool discrete = false;  ///< NRML with probabilities at intensities, not parameters
  CurveMethod method = CurveMethod::kOwn;
};

/// Indices of the configurations that are chosen.
/// @throws Error with the nearest name
std::vector<std::size_t> chosen_configurations(const StudyData& data, const ExportChoice& choice);

/// A fragility curve that may be exported.
struct ChosenCurve {
  std::string configuration;
  LimitState state;
  statistics::LognormalCurve curve;  ///< im in SI
  std::size_t records = 0, failed = 0;
  CurveAudit audit;

  /// Neither extrapolated nor from few outcomes or records.
  bool is_supported() const {
    return !is_extrapolated(audit) && !has_few_outcomes(audit) && !has_few_records(audit);
  }
};

struct ChosenCurves {
  RunMeasure measure;
  std::vector<ChosenCurve> curves;    ///< in order of configurations, then of limit states
  std::vector<std::string> left_out;  ///< those without a curve, and why: a line each
};

/// `capacities of 20 records, of which 18 exceed`
std::string basis_text(const ChosenCurve& curve);

/// ` Caution: ...` for each.
std::string caution_text(const ChosenCurve& curve, const ReportUnit& unit);

/// @throws Error for unknown names, and where no curve is left
ChosenCurves chosen_curves(const StudyData& data, const ExportChoice& choice);

}  // namespace gurney::study
