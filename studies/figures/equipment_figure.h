#pragma once

#include <string>

#include "studies/report/equipment_report.h"

namespace gurney::figures {

/// Plan and two sides (SVG).
std::string equipment_figure(const report::EquipmentFacts& facts);

}  // namespace gurney::figures
