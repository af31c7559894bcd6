#pragma once

#include "engine/response.h"
#include "engine/scene/scene.h"
#include "engine/scene/settings.h"

namespace gurney {

/// The identical scene on stock Bullet, set up as well as it allows: what `solver = "bullet"` and
/// `"bullet-dantzig"` run, so that their error and cost are numbers.
///
/// A btMultiBody with sphere wheels (one contact point each) on a static plane; rolling resistance,
/// bearing friction and brakes as motors on the axles with the limit Cr N of the last step's normal
/// force; the floor's acceleration as the exact mean of each step in gravity. `bullet`: sequential
/// impulse, 50 iterations. `bullet-dantzig`: direct solve, m_globalCfm = 1e-9.
///
/// Limits: rigid treads (no compliance, damping or scrub); no energy account beyond kinetic and
/// gravitational energy.
/// @throws Error for drop weights, blocks and fixtures, which it does not know.
Response simulate_on_stock_bullet(const Scene& scene, const Excitation& excitation,
                                  const SimulationSettings& settings);

}  // namespace gurney
