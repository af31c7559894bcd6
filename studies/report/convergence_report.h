#pragma once

#include <string>

#include "studies/study/convergence/convergence.h"

namespace gurney::report {

std::string convergence_text(const study::Convergence& found);
std::string convergence_json(const study::Convergence& found);

/// Change of each demand with the time step, on logarithmic axes.
std::string convergence_figure(const study::Convergence& found);

}  // namespace gurney::report
