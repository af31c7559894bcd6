#pragma once

#include <string>

#include "studies/study/analysis/overview.h"

namespace gurney {

/// What a results file holds, to be read in a terminal.
std::string overview_text(const StudyOverview& overview);
std::string overview_text(const RunOverview& overview);

/// The same as JSON: SI units; a number that does not exist is null.
std::string overview_json(const StudyOverview& overview);
std::string overview_json(const RunOverview& overview);

}  // namespace gurney
