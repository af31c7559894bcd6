#pragma once

#include "studies/analysis/overview.h"
#include "studies/findings/findings.h"

namespace gurney::report {

/// Contents of a results file. JSON of a run is in SI unless units are chosen.
findings::Section overview_findings(const study::StudyOverview& overview);
findings::Section overview_findings(const study::RunOverview& overview,
                                    const study::UnitSystem& units = {});

// Parts of it.
findings::Section energy_findings(const study::StudyOverview& overview);
findings::Section outcome_findings(const study::RunOverview& overview);
findings::Section design_findings(const study::StudyOverview& overview);
findings::Section provenance_findings(const study::FileOverview& file,
                                      const std::string& what = "");
findings::Section assumption_findings(const study::FileOverview& file);
findings::Section undrawn_findings(const std::optional<study::UndrawnRanges>& undrawn);
findings::Section step_check_findings(const study::StepCheck& check);
findings::Table failure_findings(const study::StudyOverview& overview);

/// Runs of each configuration and level, and the shares of them that exceed the limit states.
findings::Table share_findings(const study::StudyOverview& overview);

}  // namespace gurney::report
