#pragma once

#include <optional>

#include "engine/config/table.h"
#include "groundmotions/selection/selection.h"

namespace gurney::groundmotions {

/// Reads `target` and its parameters:
///
/// - "bssa14" (magnitude, distance_km, vs30_m_per_s, faulting): spectra of a scenario;
/// - "conditional" (the same with period_s, and epsilon or sa_g): those with a given Sa(T*);
/// - "disaggregation" (file, period_s, poe, vs30_m_per_s, faulting): the same for its mean
///   earthquake; its distance to the rupture is taken as R_JB;
/// - "openquake" (file, poe, period_s): a conditional spectrum of OpenQuake;
/// - "table" (file, period_s), and the other spectra of read_target(): their medians and, where a
///   table has the column sigma_ln, their sigma; without it sigma is 0. With period_s the spectrum
///   is conditional on Sa(T*).
///
/// @param periods  at which spectra are compared, growing, > 0 [s]; T* is added
/// @returns empty where an error is noted in the table's document
std::optional<SelectionTarget> read_selection_target(config::Table& table,
                                                     const Eigen::VectorXd& periods);

}  // namespace gurney::groundmotions
