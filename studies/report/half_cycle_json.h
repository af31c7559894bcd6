#pragma once

#include <nlohmann/json.hpp>
#include <optional>

#include "studies/report/half_cycle.h"

namespace gurney::report {

/// null where there is none.
nlohmann::ordered_json half_cycle_json(const std::optional<HalfCycle>& of);

}  // namespace gurney::report
