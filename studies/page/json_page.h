#pragma once

#include <string>

#include "studies/page/html.h"

namespace gurney::page {

/// Whether a file begins as a JSON object does.
bool is_json(const std::string& path);

/// The page of what `gurney calibrate` and `gurney verify` print as JSON.
/// @throws Error `file:/constants/0/value: must be a number` for what they do not write
Document json_document(const std::string& path);

}  // namespace gurney::page
