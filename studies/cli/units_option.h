#pragma once

#include <CLI/CLI.hpp>

#include "studies/units/unit_system.h"

namespace gurney::cli {

/// The option --units: those in which results are printed and drawn instead of those of the job.
/// @param usual  what rules without it
CLI::Option* add_units_option(CLI::App& command, study::UnitSystem& units,
                              const char* usual = "those of the job");

}  // namespace gurney::cli
