#pragma once

#include <string>

#include "engine/config/document.h"

namespace gurney::equipment {

/// @throws Error where the file states the schema of another kind of file of ours: what it is, and
///         which command takes it. Any other schema is left to the reader.
/// @param wanted  such as `gurney-job/1`; empty: any that `gurney equipment check` takes
void refuse_other_kind(config::Document& document, const std::string& wanted);

}  // namespace gurney::equipment
