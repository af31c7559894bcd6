#pragma once

#include "engine/response/response.h"
#include "studies/findings/findings.h"
#include "studies/results/run_facts.h"
#include "studies/units/unit_system.h"

namespace gurney::report {

/// Everything that is known of a run: what ran, the floor's motion, the narrative, every number of
/// a single item or a row for each of several, quality, warnings, draws, assumptions. JSON has SI
/// units and the names of the results file.
findings::Section run_findings(const study::RunFacts& facts, const Response& response,
                               const study::UnitSystem& units = {});

/// Narrative of a run in sentences: how far each item moved and what lifted, what overturned and why,
/// what hit what (fastest first), which zones are blocked, which tethers got taut or broke, and how
/// far the numbers can be trusted: predictability, the change with half the time step, and within
/// which fraction each demand is settled.
findings::Section narrative(const study::RunFacts& facts, const Response& response,
                            const study::UnitSystem& units = {});

}  // namespace gurney::report
