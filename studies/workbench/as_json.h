#pragma once

#include <nlohmann/json_fwd.hpp>

#include "engine/config/node.h"
#include "engine/response/response.h"
#include "studies/findings/findings.h"
#include "studies/results/run_facts.h"

namespace gurney::workbench {

/// Findings as people read them; null: nothing is for people.
nlohmann::json shown(const findings::Section& section);

/// A file as it is written: what stands where in its text, so that a page can change it there.
nlohmann::json tree_of(const config::Node& node);

/// The default limit states of a run, with those that it exceeded.
nlohmann::json limit_states_of(const study::RunFacts& facts, const Response& response);

}  // namespace gurney::workbench
