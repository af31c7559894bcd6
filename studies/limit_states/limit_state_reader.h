#pragma once

#include <string>
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

/// Reads a limit state from one line, as reports print it: `peak_displacement > 0.2 m`,
/// `overturned`, `bed/screen: peak_absolute_acceleration > 1 g`, `doorway: least_free_width < 90
/// cm`, `at least 3 items: peak_displacement > 1 m`. `NAME = ` before it gives it a name; without
/// one the line is its name. The rules are those of a table [[limit_state]].
/// @param places  that the line may name
/// @throws Error that begins with --limit-state and the line
LimitState read_limit_state_expression(const std::string& line, const Places& places);

/// `--limit-state "peak_displacement > 0.2 m"`, for messages.
std::string option_of(const std::string& line);

}  // namespace gurney::study
