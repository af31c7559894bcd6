#pragma once

#include "studies/cli/case_again.h"
#include "studies/explanation/facts.h"
#include "studies/render/render.h"

namespace gurney::cli {

/// Why a run ended as it did, and what happened in it.
struct Explained {
  explanation::Explanation explanation;
  findings::Section narrative;
};

/// Runs the case again, with histories of single steps, and explains it.
/// @throws Error where its demands are not those of the file
Explained explained(const CaseAgain& again, const study::UnitSystem& units = {});

}  // namespace gurney::cli
