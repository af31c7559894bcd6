#pragma once

#include <vector>

#include "engine/config/table.h"
#include "studies/study/limit_states/limit_state.h"

namespace gurney::study {

/// Reads the tables [[study.limit_state]]; without any, default_limit_states(). Errors are noted
/// in the document.
std::vector<LimitState> read_limit_states(config::Table& study);

/// Index of the state with this name.
/// @throws Error with the nearest name
std::size_t index_of(const std::vector<LimitState>& states, const std::string& name);

}  // namespace gurney::study
