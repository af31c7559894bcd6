#pragma once

#include <string>

#include "studies/findings/findings.h"
#include "studies/page/document.h"

namespace gurney::page {

/// Whether a file begins as a JSON object does.
bool is_json(const std::string& path);

/// The page of what `gurney calibrate` and `gurney verify` print as JSON.
/// @throws Error `file:/constants/0/value: must be a number` for what they do not write
Document json_document(const std::string& path);

Document calibration_document(const findings::Section& calibration);
Document verification_document(const findings::Section& verification);

}  // namespace gurney::page
