#pragma once

#include <string>

#include "studies/study/convergence/convergence.h"
#include "studies/study/units/unit_system.h"

namespace gurney::report {

/// In SI unless units are chosen.
std::string convergence_text(const study::Convergence& found, const study::UnitSystem& units = {});
std::string convergence_json(const study::Convergence& found, const study::UnitSystem& units = {});

}  // namespace gurney::report
