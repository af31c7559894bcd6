#pragma once

#include <string>

#include "studies/convergence/convergence.h"

namespace gurney::figures {

/// Change of each demand with the time step, on logarithmic axes.
std::string convergence_figure(const study::Convergence& found);

}  // namespace gurney::figures
