#pragma once

#include "studies/analysis/study_data.h"
#include "studies/findings/findings.h"
#include "studies/loss/study_loss.h"

namespace gurney::report {

/// Losses of a study, configuration by configuration.
findings::Section loss_findings(const study::StudyData& data,
                                const study::Consequences& consequences,
                                const std::vector<study::StudyLoss>& losses);

}  // namespace gurney::report
