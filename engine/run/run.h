#pragma once

#include "engine/base/floor_motion.h"
#include "engine/response/response.h"
#include "engine/scene/scene.h"
#include "engine/scene/settings.h"

namespace gurney {

/// Who solves the contact problem of each step.
enum class Solver {
  kImplicit,  ///< ours: casters eliminated analytically, one 6x6 system (docs/theory/solver.md)
  kBullet,    ///< stock Bullet: sequential impulse, 50 iterations; a baseline
  kBulletDantzig,  ///< stock Bullet, well configured: direct (Dantzig) contact solver; a baseline
  kBulletPaper,    ///< the model of Xu, Ma & Kurata 2022 on stock Bullet; a baseline
  kBulletPaperDantzig,  ///< the same with the direct solver; a baseline
};

/// Options of run(): how each integration is made, by whom, and how accurately.
struct RunOptions : SimulationSettings {
  Solver solver = Solver::kImplicit;
  double peak_error = 0;  ///< > 0: the time step is halved until the peaks are this accurate, [0,
                          ///< 0.1] (refine.h); 0: as it is. Of our solver only
};

/// The engine: runs a scene under a floor motion and returns what it did.
///
///     Scene scene = scene_of(model);                    // engine/scene: items, room, loads
///     const FloorMotion floor(0.005, accelerations);    // 3 rows: x, y, z [m/s2]
///     const Response response = run(scene, floor, {});  // engine/response: demands, histories
///
/// Options take any solver and any way to choose the time step: fixed steps (`time_step`), steps as
/// short as a `tolerance` needs, or fixed steps halved until the peaks are as accurate as
/// `peak_error` says; ours or, for comparison, a baseline on stock Bullet (`solver`). An ensemble of
/// slightly different runs is made by run() of perturbed() scenes (engine/scene/perturbed.h).
///
/// Keeps no state between calls and may be called from several threads at once; the response has
/// the same bits whatever runs beside it.
///
/// @param floor  none: a floor at rest
/// @throws Error for a scene or options outside their ranges, and for what a baseline does not know.
///         Physics or numerics gone wrong is no error but an Outcome (Response::outcome).
Response run(const Scene& scene, const FloorMotion& floor, const RunOptions& options);

/// The response of a run with its ItemResponse::predictability.
struct JudgedRun {
  Response response;
  double seconds = 0;  ///< time that the run took, without those that judge it [s]
};

/// Runs a scene as run() does, and beside it a twin with slightly other masses and a run with half
/// the time step, which show how predictable each item is and which of its demands are settled
/// (ItemResponse::predictability). Together they take four times the CPU time of the run, and half
/// of that time on two threads. Nothing is judged where a baseline made the run or where it failed.
/// @param threads  > 0, the same bits for any number
/// @throws Error as run()
JudgedRun run_judged(const Scene& scene, const FloorMotion& floor, const RunOptions& options,
                     int threads);

}  // namespace gurney
