#pragma once

#include <string>
#include <vector>

#include "engine/response/settled.h"

namespace gurney::report {

/// "1 %", or "no"
std::string within_text(const SettledDemand& demand);

/// The label of a demand by its place; null: the run was not repeated.
const SettledDemand* find_settled(const std::vector<SettledDemand>& all, DemandNumber::Of of,
                                  std::size_t part, const char* name);

}  // namespace gurney::report
