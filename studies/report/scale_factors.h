#pragma once

#include "studies/analysis/scale_factors.h"
#include "studies/findings/findings.h"

namespace gurney::report {

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

}  // namespace gurney::report
