#pragma once

#include <string>

#include "studies/explanation/facts.h"
#include "studies/explanation/what_if.h"

namespace gurney::explanation {

/// Everything in SI units, radians; what is not there is null.
/// @param what  null: variants were not asked for
std::string json(const Explanation& of, const WhatIf* what);

}  // namespace gurney::explanation
