#pragma once

#include <string>

#include "studies/study/analysis/overview.h"

namespace gurney::report {

/// What a results file holds, to be read in a terminal.
std::string overview_text(const study::StudyOverview& overview);
std::string overview_text(const study::RunOverview& overview, const study::UnitSystem& units = {});

/// Runs of each configuration and level, and the shares of them that exceed the limit states.
/// @param most_rows  further ones are counted
std::string shares_text(const study::StudyOverview& overview, std::size_t most_rows);

/// "uncertainties not propagated", by data file.
std::string undrawn_text(const std::optional<study::UndrawnRanges>& undrawn);

/// The same as JSON: SI unless units are chosen; a number that does not exist is null.
std::string overview_json(const study::StudyOverview& overview);
std::string overview_json(const study::RunOverview& overview, const study::UnitSystem& units = {});

}  // namespace gurney::report
