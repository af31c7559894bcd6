#pragma once

#include "engine/solver/mechanism.h"

namespace gurney {

/// Static equilibrium of the item on its treads, from which a run starts.
///
/// First the item settles under the normal part of gravity with its horizontal motion held; then,
/// where blocks or a slope load it sideways, it is let go: if the stuck treads hold it, that is the
/// start, and if they do not (a slope it rolls down) the first state is.
///
/// @throws Error when the item does not stand: its centre of mass is outside the support.
void settle(const Mechanism& mechanism, const Scene& scene, const Excitation& excitation,
            State& state);

}  // namespace gurney
