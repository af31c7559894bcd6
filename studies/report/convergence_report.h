#pragma once

#include <string>

#include "studies/study/convergence/convergence.h"

namespace gurney::report {

std::string convergence_text(const study::Convergence& found);
std::string convergence_json(const study::Convergence& found);

}  // namespace gurney::report
