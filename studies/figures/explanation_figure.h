#pragma once

#include <string>

#include "studies/explanation/facts.h"

namespace gurney::figures {

/// One figure of the time around the event, as SVG: the floor with its pulse, displacement, tilt
/// against critical, force against grip, energies; numbered events, listed below.
std::string explanation_figure(const explanation::Explanation& of);

}  // namespace gurney::figures
