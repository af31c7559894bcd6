#pragma once

#include "engine/solver/assembly.h"

namespace gurney {

/// An item before it settles: on the floor, or on the surface above it that it stands on.
State placed_above(const Assembly& assembly, const Scene& scene, std::size_t item);

/// Static equilibrium of a whole item, with its parts, on its treads, from which a run starts. What stands
/// on it loads it with its weight; what it stands on has settled before. A latch that would bear more than it
/// holds is open, and its part rests where that leads.
///
/// First the item settles under the normal part of gravity with its horizontal motion held; then,
/// where blocks or a slope load it sideways, it is let go: if the stuck treads hold it, that is the
/// start, and if they do not (a slope it rolls down) the first state is.
///
/// @throws Error when the item does not stand: its centre of mass is outside the support; when a part moves by
/// itself, or would once it is pushed by 1e-3 rad.
void settle(const Assembly& assembly, const Scene& scene, std::size_t item, SceneState& state);

}  // namespace gurney
