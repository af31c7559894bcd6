#pragma once

#include <vector>

#include "studies/explanation/facts.h"

namespace gurney::explanation {

/// The energy balance of the explained item at the start, at the first of each kind of event up to
/// the worst, at the worst and at the end; of the sample at or before each.
std::vector<Stage> stages_of(const Explanation& of, const ItemResponse& item);

}  // namespace gurney::explanation
