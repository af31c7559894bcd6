#pragma once

#include <string>

#include "engine/response/response.h"
#include "studies/results/run_facts.h"
#include "studies/units/unit_system.h"

namespace gurney::report {

/// What a run did, to be read in a terminal of 100 columns.
std::string summary(const study::RunFacts& facts, const Response& response,
                    const study::UnitSystem& units = {});

/// The same facts as JSON: SI units, names as in the results file. A number that does not exist is
/// null.
std::string summary_json(const study::RunFacts& facts, const Response& response);

}  // namespace gurney::report
