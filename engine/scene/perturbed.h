#pragma once

#include <cstddef>

#include "engine/scene/scene.h"

namespace gurney {

/// A relative change of a mass far below what anybody can measure.
inline constexpr double kPerturbation = 1e-9;

/// The scene whose chassis are heavier by `number` times kPerturbation, their inertias as well; 0:
/// the scene itself. No difference between such scenes could be measured.
Scene perturbed(Scene scene, std::size_t number);

}  // namespace gurney
