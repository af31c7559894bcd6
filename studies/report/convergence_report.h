#pragma once

#include <string>

#include "studies/study/convergence/convergence.h"

namespace gurney {

std::string convergence_text(const Convergence& found);
std::string convergence_json(const Convergence& found);

/// Change of each demand with the time step, on logarithmic axes.
std::string convergence_figure(const Convergence& found);

}  // namespace gurney
