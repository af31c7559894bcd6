#pragma once

#include <string>

#include "studies/explanation/facts.h"

namespace gurney::explanation {

/// One figure of the time around the event, as SVG: the floor with its pulse, displacement, tilt
/// against critical, force against grip, energies; numbered events, listed below.
std::string figure(const Explanation& of);

}  // namespace gurney::explanation
