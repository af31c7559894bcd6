#pragma once

#include <optional>

#include "engine/config/table.h"
#include "groundmotions/scaling/target_spectrum.h"

namespace gurney::groundmotions {

/// Reads `target` and its parameters: "asce7" (sds_g, sd1_g, tl_s), "eurocode8" (type, ground,
/// ag_g, damping_ratio, vertical), "nzs1170" (site_class, hazard_factor, return_factor,
/// fault_distance_km), "ac156" (sds_g, height_ratio, vertical) or "table" (file). Errors are
/// noted in the table's document; the result is empty then.
std::optional<TargetSpectrum> read_target(config::Table& table);

}  // namespace gurney::groundmotions
