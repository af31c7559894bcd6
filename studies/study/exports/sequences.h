#pragma once

#include <string>
#include <vector>

#include "studies/study/exports/chosen_curves.h"

namespace gurney::study {

/// Curves of one configuration for limit states of one quantity whose limits get stricter: what exceeds
/// one has exceeded all before it. They are the sequential damage states of a component. A curve alone
/// is a sequence as well.
struct CurveSequence {
  std::string configuration;
  std::string name;  ///< of its states, in their order: "moved" or "near_far"
  std::vector<ChosenCurve> curves;
  bool adjusted = false;  ///< the curves would cross, and were changed: see in_order()
};

/// @param combine  false: each curve alone
/// @throws Error for curves that in_order() cannot keep apart
std::vector<CurveSequence> sequences(const ChosenCurves& chosen, bool combine);

/// Probabilities of exceeding the states of a sequence must not grow with the state, and lognormal
/// curves with different betas cross. Where a stricter state is more probable by 0.001 or more, all get
/// the mean beta b' and keep their 10 % points: ln theta' = ln theta + 1.28 (b' - b) (Porter, Kennedy &
/// Bachman 2007, Earthquake Spectra 23(2), 471-489).
/// @returns whether the curves were changed
bool in_order(std::vector<statistics::LognormalCurve>& curves);

/// Of a sequence that in_order() changed.
inline constexpr const char* kAdjusted =
    "the fitted curves cross; they were given their mean beta, and keep their 10 % points (Porter, "
    "Kennedy and Bachman 2007)";

}  // namespace gurney::study
