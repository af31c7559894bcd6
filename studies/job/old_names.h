#pragma once

#include <string>
#include <vector>

#include "engine/config/document.h"

namespace gurney::study {

/// Gives what a job of an earlier version states its name of today.
/// @returns a note on each with its place
std::vector<std::string> rename_old_keys(config::Document& job);

}  // namespace gurney::study
