#pragma once

#include <string>

#include "studies/analysis/measure_choice.h"
#include "studies/findings/findings.h"

namespace gurney::report {

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

/// In SI unless units are chosen.
findings::Section measure_findings(const MeasureReport& report);

}  // namespace gurney::report
