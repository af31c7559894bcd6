#pragma once

#include <memory>

#include "engine/baselines/stock_model.h"

namespace gurney::baselines {

/// `bullet-paper` and `bullet-paper-dantzig`: the model of Xu, Ma & Kurata 2022 (5th SPONSE
/// workshop, section 4), which ran on Unity, on stock Bullet: chassis, forks and wheels are rigid
/// bodies; a hinge between chassis and fork, and one between fork and wheel; wheels are capsules
/// with the inertia of the wheel; the floor is a box. `bullet-paper`: sequential impulse, 50
/// iterations, which 25 kg on a wheel of 0.25 kg keep from converging. `bullet-paper-dantzig`:
/// direct solve, m_globalCfm = 1e-8.
///
/// Rolling resistance is a force on the centre of each wheel against its motion, (Cr / R) N with
/// the vertical contact force N of the last step; it has no state of rest, so what should stand
/// still chatters. The paper gives the hinges a spring and a damper and states neither: here the
/// swivel's spring, to its initial heading, has the torque of the caster's Coulomb friction at 1
/// rad, and the dampers have the viscous friction of the bearings. The capsule's straight part is
/// as long as the wheel is wide.
/// @throws Error for brakes and locks, which the paper's model has not
std::unique_ptr<StockModel> make_paper_model(const Scene& scene, const Mechanism& mechanism,
                                             bool direct);

}  // namespace gurney::baselines
