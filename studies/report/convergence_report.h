#pragma once

#include "studies/findings/findings.h"
#include "studies/study/convergence/convergence.h"
#include "studies/study/units/unit_system.h"

namespace gurney::report {

/// In SI unless units are chosen.
findings::Section convergence_findings(const study::Convergence& found,
                                       const study::UnitSystem& units = {});

}  // namespace gurney::report
