#pragma once

#include <optional>

#include "engine/config/table.h"
#include "studies/plan/study.h"
#include "studies/statistics/hazard.h"

namespace gurney::study {

/// Reads the table [study.hazard]: rates at which the study's measure is exceeded at the site, as
/// `im` and `rate_per_year` or as `k0` and `k`. Errors are noted in its document.
std::optional<statistics::HazardCurve> read_hazard(config::Table& hazard,
                                                   const IntensityPlan& intensity);

}  // namespace gurney::study
