#pragma once

#include "studies/cli/case_again.h"
#include "studies/explanation/facts.h"

namespace gurney::cli {

/// Runs the case again, with histories of single steps, and explains it.
/// @throws Error where its demands are not those of the file
explanation::Explanation explained(const CaseAgain& again, const study::UnitSystem& units = {});

}  // namespace gurney::cli
