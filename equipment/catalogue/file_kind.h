#pragma once

#include <string>

#include "engine/config/document.h"

namespace gurney::equipment {

/// @throws Error where the file states the schema of another kind of file of ours: what it is, and
///         which command takes it. Any other schema is left to the reader.
/// @param wanted  such as `gurney-job/1`; empty: any that `gurney equipment check` takes
void refuse_other_kind(config::Document& document, const std::string& wanted);

/// Whether the file is one that check_data_file() takes: an item, a caster, a floor covering, a room
/// or a kind of tether.
/// @throws Error if it is missing or cannot be parsed
bool holds_equipment(const std::string& file);

}  // namespace gurney::equipment
