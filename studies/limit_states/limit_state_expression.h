#pragma once

#include <string>

#include "studies/limit_states/limit_state.h"
#include "studies/limit_states/places.h"

namespace gurney::study {

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
