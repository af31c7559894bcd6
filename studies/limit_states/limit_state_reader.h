#pragma once

#include <vector>

#include "engine/config/table.h"
#include "studies/limit_states/limit_state.h"

namespace gurney::study {

/// Reads the tables [[limit_state]] of [study] or of a file of limit states; without any,
/// default_limit_states(). Errors are noted in the document.
std::vector<LimitState> read_limit_states(config::Table& in);

/// Reads the key `performance`: indices of limit states, mildest first.
std::vector<std::size_t> read_performance(config::Table& in, const std::vector<LimitState>& states);

/// Index of the state with this name.
/// @throws Error with the nearest name
std::size_t index_of(const std::vector<LimitState>& states, const std::string& name);

}  // namespace gurney::study
