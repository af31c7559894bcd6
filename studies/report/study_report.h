#pragma once

#include <cstddef>
#include <string>

#include "studies/analysis/fragility_result.h"
#include "studies/analysis/measure_choice.h"
#include "studies/analysis/overview.h"
#include "studies/analysis/scale_factors.h"
#include "studies/analysis/study_sensitivity.h"
#include "studies/findings/findings.h"

namespace gurney::report {

/// The median intensity of each limit state, or why there is none.
findings::List answers_of(const study::StudyOverview& overview, const study::StudyData& data,
                          const std::vector<study::FragilityResult>& fragilities);

/// Which of two configurations exceeds the limit states less often, and how sure that is; empty
/// where there are not two that share runs.
findings::List compared_answers(const study::StudyOverview& overview, const study::StudyData& data);

/// "58 runs with a warning, such as: ..." for each kind of warning.
findings::Texts warning_cautions(const study::StudyOverview& overview);

/// What a reader has to know before any number of a study is used.
findings::Texts cautions_of(const study::StudyOverview& overview, const study::StudyData& data,
                            const std::vector<study::FragilityResult>& fragilities);

/// How often items stood in the zones of the room.
findings::Table zone_findings(const study::StudyData& data);

/// "3 failed", or "3 failed (2 untrusted)" when some of them are.
std::string failed_runs(std::size_t failed, std::size_t untrusted);

/// @param note   for people, after the factors
/// @param shown  for people too
inline findings::Section scale_factor_findings(const study::ScaleFactors& factors,
                                               const std::string& note = {}, bool shown = true) {
  findings::Section all{"scale_factors"};
  all.json("lowest", factors.lowest()).json("highest", factors.highest());
  all.json("records", factors.records());
  all.json("limits", findings::Numbers{study::kSmallestFactor, study::kLargestFactor});
  all.json("records_above", factors.above()).json("records_below", factors.below());
  if (shown) all.text("scaling", "factors " + factors.text() + note);
  return all;
}

/// Report of `gurney measures` on one limit state of one configuration.
struct MeasureReport {
  std::string configuration;
  std::string state, words;  ///< name and meaning of the limit state
  study::MeasureChoice choice;
  study::UnitSystem units = {};
};

/// Which is best and whether the difference matters, in a sentence or two. It matters where it
/// stays in 95 % of the resamples of records, and does not where another comes first in a fifth.
std::string verdict(const study::MeasureChoice& choice);

/// Report on the choice of a measure, in SI unless units are chosen.
findings::Section measure_findings(const MeasureReport& report);

/// Report of `gurney sensitivity` on one configuration.
struct SensitivityReport {
  std::string configuration;
  study::StudySensitivity found;
  std::string why_not;  ///< nothing was found; empty: it was
  study::UnitSystem units = {};
};

/// "mass_kg", or "static_friction and 7 equal to it".
std::string name_of(const study::SensitiveInput& input);

/// Indices and tornado of the inputs.
findings::Table sensitive_inputs(const SensitivityReport& report);

/// Meaning of the indices and how far to trust them, a sentence each.
findings::Texts sensitivity_remarks(const study::StudySensitivity& found);

/// "peak_tilt, brakes on: mean 3.2 deg, standard deviation 0.4 deg, 100 runs"
std::string sensitivity_title(const SensitivityReport& report);

/// Report of a sensitivity analysis, in SI unless units are chosen.
findings::Section sensitivity_findings(const SensitivityReport& report);

}  // namespace gurney::report
