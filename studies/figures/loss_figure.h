#pragma once

#include <string>
#include <vector>

#include "studies/loss/consequences.h"
#include "studies/loss/study_loss.h"
#include "studies/units/unit_system.h"

namespace gurney::figures {

/// Expected loss by level; with intensities, how likely, and with a hazard, how often a year the loss
/// is above a value; as SVG.
/// @param losses  of one measure, one for each configuration
/// @param unit    of that measure
/// @throws Error where there is none of these
std::string loss_figure(const study::Consequences& consequences,
                        const std::vector<study::StudyLoss>& losses, const study::ReportUnit& unit);

}  // namespace gurney::figures
