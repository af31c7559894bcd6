#pragma once

#include <optional>
#include <string>

#include "studies/explanation/what_if.h"
#include "studies/findings/findings.h"

namespace gurney::report {

/// Why a run ended as it did: headline, events, the floor's pulse, margins, energies, other items,
/// variants. JSON has SI units and radians; what is not there is null.
/// @param what  null: variants were not asked for
findings::Section explanation_findings(const explanation::Explanation& of,
                                       const explanation::WhatIf* what = nullptr);

/// The numbers of a half cycle for programs; none: null.
void add_pulse(const std::string& key, const std::optional<explanation::HalfCycle>& pulse,
               findings::Section& all);

}  // namespace gurney::report
