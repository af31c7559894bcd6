#pragma once

#include <optional>
#include <string>

#include "studies/page/document.h"
#include "studies/page/json_value.h"

namespace gurney::page {

/// Whether a file begins as a JSON object does.
/// @throws Error where it cannot be read
bool is_json(const std::string& path);

/// The page of what `gurney calibrate` or `gurney verify` wrote, by its `schema`.
/// @throws Error for any other JSON, with what is accepted
Document json_document(const std::string& path);

Document calibration_document(const JsonValue& calibration);
Document verification_document(const JsonValue& verification);

}  // namespace gurney::page
