#pragma once

#include <string>
#include <vector>

#include "studies/analysis/fragility_result.h"
#include "studies/findings/findings.h"

namespace gurney::report {

/// A row for each configuration and limit state.
/// @param rates  with annual rates of exceedance
findings::Table fragility_table(const std::vector<study::FragilityResult>& results,
                                const study::ReportUnit& unit, bool rates);

/// For each configuration the probability that each level is the worst that is reached.
std::vector<findings::Table> worst_level_tables(
    const study::StudyData& data, const std::vector<study::FragilityResult>& results,
    const std::vector<study::PerformanceTable>& performance);

/// A table with a row for each configuration and limit state, and below it what to know of them.
/// JSON is in SI unless units are chosen; no curve: null.
findings::Section fragility_findings(const study::StudyData& data,
                                     const std::vector<study::FragilityResult>& results);

/// Notes for a reader before using a row, with its cautions.
std::vector<std::string> fragility_notes(const study::FragilityResult& result,
                                         const study::ReportUnit& unit);

/// The notes on all curves, each once, after the names of the curves that it is of.
std::vector<std::string> notes_on_curves(const std::vector<study::FragilityResult>& results,
                                         const study::ReportUnit& unit);

/// For each configuration and limit state the slopes of both measures, whether the second adds to
/// the first, and beta beside those of each alone. JSON is in SI unless units are chosen; no fit:
/// its plane is null.
findings::Section vector_findings(const study::StudyData& data,
                                  const std::vector<study::VectorResult>& results);

}  // namespace gurney::report
