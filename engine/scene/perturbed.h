#pragma once

#include <cstddef>

#include "engine/scene/scene.h"

namespace gurney {

/// A relative change of a mass far below what anybody can measure.
inline constexpr double kPerturbation = 1e-9;

/// The scene whose chassis are heavier by `number` times kPerturbation, their inertias as well; 0:
/// the scene itself. No difference between such scenes could be measured.
Scene perturbed(Scene scene, std::size_t number);

/// Largest relative change of a mass in a replica: a tenth of a gram of 100 kg. Where changes grow by
/// 1e7, which is called chaotic, replicas then part wholly; by kPerturbation they would have parted
/// by 1 %, and neighbours be alike (docs/theory/predictability.md).
inline constexpr double kReplicaSpread = 1e-6;

/// The scene whose chassis and their inertias are heavier by kReplicaSpread times a number in (-1, 1),
/// drawn uniformly for each replica, so that replicas are independent samples of one distribution;
/// 0: the scene itself.
Scene replica_of(Scene scene, std::size_t replica);

}  // namespace gurney
