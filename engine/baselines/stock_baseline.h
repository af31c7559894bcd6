#pragma once

#include "engine/response/response.h"
#include "engine/scene/scene.h"
#include "engine/scene/settings.h"

namespace gurney::baselines {

/// Which model and which of Bullet's solvers.
struct StockBullet {
  bool paper = false;   ///< paper_model.h; else stock_multibody.h
  bool direct = false;  ///< Dantzig; else sequential impulse
};

/// The identical scene on stock Bullet, set up as well as it allows: what `solver = "bullet"`,
/// `"bullet-dantzig"`, `"bullet-paper"` and `"bullet-paper-dantzig"` run, so that their error and
/// cost are numbers.
///
/// The floor's acceleration is the exact mean of each step in gravity. What differs is the item:
/// stock_multibody.h of `bullet` and `bullet-dantzig`, paper_model.h of the others.
///
/// Boxes of a room (`bullet` and `bullet-dantzig`): the chassis touches them, with the restitution
/// and friction of its materials; wheels do not, and impacts are not listed.
///
/// Limits: rigid treads (no compliance, damping or scrub); no energy balance beyond kinetic and
/// gravitational energy.
/// @throws Error for drop weights, blocks, fixtures, tethers, zones, other shapes of a room and a
///         floor that rotates, which it does not know; the paper's model for brakes, locks and any
///         room too.
Response simulate_on_stock_bullet(const Scene& scene, const FloorMotion& floor,
                                  const SimulationSettings& settings, StockBullet choice);

}  // namespace gurney::baselines
