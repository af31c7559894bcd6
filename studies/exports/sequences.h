#pragma once

#include <string>
#include <vector>

#include "studies/exports/chosen_curves.h"

namespace gurney::study {

/// Curves of one configuration for limit states of one quantity whose limits get stricter: what exceeds
/// one has exceeded all before it. They are the sequential damage states of a component. A curve alone
/// is a sequence as well.
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
/// curves with different betas cross. Where a stricter state is more probable by 0.001 or more, all get
/// the mean beta b' and keep their 10 % points: ln theta' = ln theta + 1.28 (b' - b) (Porter, Kennedy &
/// Bachman 2007, Earthquake Spectra 23(2), 471-489). A state whose theta is then still below that of a
/// milder one gets the same.
/// @returns whether the curves were changed
bool in_order(std::vector<statistics::LognormalCurve>& curves);

/// Of a sequence that in_order() changed.
inline constexpr const char* kAdjusted =
    "the fitted curves cross; they were given their mean beta, and keep their 10 % points unless a "
    "stricter state would precede a milder one (Porter, Kennedy and Bachman 2007)";

}  // namespace gurney::study
