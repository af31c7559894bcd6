#pragma once

#include <CLI/CLI.hpp>

#include "studies/analysis/assessment.h"

namespace gurney::cli {

/// The options --limit-state and --limit-states: limit states instead of those of the job.
void add_limit_state_options(CLI::App& command, study::AssessmentRequest& request);

/// The option --hazard: the hazard of the site instead of that of the job.
CLI::Option* add_hazard_option(CLI::App& command, study::AssessmentRequest& request);

}  // namespace gurney::cli
