#pragma once

#include "studies/convergence/convergence.h"
#include "studies/findings/findings.h"
#include "studies/units/unit_system.h"

namespace gurney::report {

/// In SI unless units are chosen.
findings::Section convergence_findings(const study::Convergence& found,
                                       const study::UnitSystem& units = {});

}  // namespace gurney::report
