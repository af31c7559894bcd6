#pragma once

#include <optional>
#include <string>
#include <vector>

#include "groundmotions/buildings/building.h"
#include "groundmotions/buildings/isolated_motion.h"
#include "groundmotions/record/record.h"

namespace gurney::groundmotions {

/// Response of the isolation layer.
struct IsolatorResponse {
  Eigen::Matrix2Xd displacement;       ///< of the base relative to the ground, at the samples [m]
  double peak = 0;                     ///< largest |u| at the samples [m]
  Vector2 residual = Vector2::Zero();  ///< at the end [m]
  IsolationEnergy energy;              ///< at the end
  double energy_error = 0;             ///< largest |closure| over the largest input [-]
  double time_step = 0;                ///< that the layer was solved with [s]
  double change = 0;  ///< of floor acceleration and displacement at the last halving of it, over
                      ///< their peaks [-]
};

/// Response of storeys that yield, of the column of each that drifts most; from the ground up.
struct StoreyResponse {
  Eigen::VectorXd ductility;       ///< largest |d| / d_y at the samples [-]
  Eigen::VectorXd residual_drift;  ///< |d| at the end [m]
  StoreyEnergy energy;             ///< at the end
  double energy_error = 0;         ///< largest |closure| over the largest input [-]
  double time_step = 0;            ///< that the storeys were solved with [s]
  double change = 0;               ///< of floor acceleration and largest storey drift at the last
                                   ///< halving of it, over their peaks [-]
};

struct BuildingResponse {
  Record floor;
  std::optional<IsolatorResponse> isolators;  ///< if the building has any
  std::optional<StoreyResponse> storeys;      ///< if they yield
  /// Largest difference of the displacements of two floors over the height of a storey; empty: no
  /// height is stated.
  std::optional<double> storey_drift_ratio;
  /// The same of the drift that is left when the building rests; empty unless its storeys yield.
  std::optional<double> residual_drift_ratio;
  /// Effects of the building on its floors, in a line each: amplified vertical motion, drift, ductility.
  std::vector<std::string> findings;
};

/// The absolute acceleration of one floor under a ground motion.
///
/// Components that the ground lacks stay absent and count as rest; a floor that twists has both
/// horizontals where the ground has one. The floor's samples are as far
/// apart as the ground's, or finer by a whole factor: at least 20 in the shortest period of the
/// building, down to periods of 1/33 s, which isolators that yield or slide always count as. After
/// the ground's last sample the ground rests and the building vibrates on, until each component has
/// stayed below 1 % of its peak for the longest period of the building and 1 s at least; at most
/// for 120 s. Floor 0 of a building without isolation is the ground, as it is.
///
/// Isolated buildings are solved with ever finer steps, until halving the step changes neither the
/// floor's horizontal acceleration nor the isolators' displacement by more than 0.03 % of their
/// peaks. Buildings whose storeys yield are solved likewise, for acceleration and storey drift.
///
/// Warnings go to the floor's record: vertical acceleration above 1 g, a storey drift ratio above
/// 1 % of an elastic building, beyond which it would yield, or above 4 % of one that yields, where
/// strength and stiffness degrade, displacement capacity exceeded, isolators unloaded, motion cut
/// after 120 s, accuracy not reached, energies that do not add up.
///
/// @param floor  0 to building.storeys
/// @param place  on a floor that twists, from the axis of stiffness along h1 and h2; others move alike
///               everywhere [m]
/// @throws Error for another floor and for a ground without components, and as floor_from_tables()
BuildingResponse building_response(const Record& ground, const Building& building, int floor,
                                   const Vector2& place = Vector2::Zero());

Record floor_record(const Record& ground, const Building& building, int floor,
                    const Vector2& place = Vector2::Zero());

}  // namespace gurney::groundmotions
