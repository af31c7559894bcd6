#pragma once

#include <string>

#include "studies/verification/verify.h"

namespace gurney::figures {

/// One page of SVG: each quantity that was compared all through the case, computed on reference,
/// and beside it the error. Empty where nothing was.
std::string verification_figure(const verification::CaseRun& run);

}  // namespace gurney::figures
