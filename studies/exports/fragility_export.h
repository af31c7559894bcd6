#pragma once

#include <optional>
#include <string>
#include <vector>

#include "studies/analysis/fitted_curve.h"
#include "studies/analysis/study_data.h"
#include "studies/loss/consequences.h"
#include "studies/statistics/special.h"

namespace gurney::study {

/// Part of a study that is exported; an empty text: all limit states, the study's own measure.
struct ExportChoice {
  std::vector<std::string> configurations{};  ///< as named_configurations() reads them; empty: all
  std::string measure{}, limit{};
  bool separate = false;  ///< a component for each limit state, not for those of one quantity
  bool discrete = false;  ///< NRML with probabilities at intensities, not parameters
  CurveMethod method = CurveMethod::kOwn;
  const Consequences* consequences = nullptr;  ///< for pelicun: what the damage states cost
};

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

/// Name of an intensity measure in another format.
struct OutsideMeasure {
  std::string name;
  std::string unit;
  double unit_in_si = 1;
};

/// Name and unit in the vocabulary of the Damage and Loss Model Library (DLML 3.1), which pelicun
/// reads: peak ground and floor acceleration and velocity, and Sa with 5 % damping.
std::optional<OutsideMeasure> dlml_measure(const std::string& measure);

/// Name and unit in NRML: PGA and SA(T) with 5 % damping in g, PGV in cm/s. NRML has no names for
/// what a floor does.
std::optional<OutsideMeasure> nrml_measure(const std::string& measure);

using NameMeasure = std::optional<OutsideMeasure> (*)(const std::string&);

/// @param measure  of the study's measures
/// @throws Error where the format has no name for it, with those of the study that have one
OutsideMeasure outside_measure(const StudyData& data, const std::string& measure,
                               const std::string& format, NameMeasure name);

/// Curves of one configuration for limit states of one quantity whose limits get stricter: what
/// exceeds one has exceeded all before it. They are the sequential damage states of a component. A
/// curve alone is a sequence as well.
struct CurveSequence {
  std::string configuration;
  std::string name;  ///< of its states, in their order: "moved" or "near_far"
  std::vector<ChosenCurve> curves;
  bool adjusted = false;  ///< the curves would cross, and were changed: see in_order()
  std::vector<ChosenCurve> fitted = {};  ///< before
};

/// @param combine  false: each curve alone
std::vector<CurveSequence> sequences(const ChosenCurves& chosen, bool combine);

/// Whether a curve of it is not supported by its runs.
bool is_incomplete(const CurveSequence& sequence);

/// The sequence of its supported curves alone; none has no curves.
CurveSequence supported_part(const CurveSequence& sequence);

/// Probabilities of exceeding the states of a sequence must not grow with the state, and lognormal
/// curves with different betas cross. Where a stricter state is more probable by 0.001 or more, all
/// get the mean beta b' and keep their 10 % points: ln theta' = ln theta + 1.28 (b' - b) (Porter,
/// Kennedy & Bachman 2007, Earthquake Spectra 23(2), 471-489). A state whose theta is then still
/// below that of a milder one gets the same.
/// @returns whether the curves were changed
bool in_order(std::vector<statistics::LognormalCurve>& curves);

/// Warning of a sequence that in_order() changed.
inline constexpr const char* kAdjusted =
    "the fitted curves cross; they were given their mean beta, and keep their 10 % points unless a "
    "stricter state would precede a milder one (Porter, Kennedy and Bachman 2007)";

}  // namespace gurney::study
