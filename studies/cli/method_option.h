#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "studies/analysis/fitted_curve.h"

namespace gurney::cli {

/// --method of what fits or draws fragility curves.
inline CLI::Option* add_method_option(CLI::App& command, std::string& method) {
  return command
      .add_option("--method", method,
                  "outcomes: of the runs, or capacities after an IDA (default); cloud: regression "
                  "of the demands, of limit states with a demand above a limit")
      ->check(CLI::IsMember({"outcomes", "cloud"}));
}

inline study::CurveMethod curve_method(const std::string& method) {
  return method == "cloud" ? study::CurveMethod::kCloud : study::CurveMethod::kOwn;
}

}  // namespace gurney::cli
