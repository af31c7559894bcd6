#pragma once

#include <vector>

#include "studies/run/run_task.h"

namespace gurney::study {

/// What a convergence study varies.
enum class Varied { kTimeStep, kSolverTolerance, kTreadStiffness };

/// A factor on what the job states.
struct Variant {
  Varied varied = Varied::kTimeStep;
  double factor = 1;
};

/// The job itself, first; then twice, a half, a quarter and an eighth of its time step (twice only
/// within the engine's range); 1000 times and a hundredth of its solver tolerance; a quarter, a
/// half, twice and four times its tread stiffness.
std::vector<Variant> variants_for(const SimulationSettings& settings);

/// The stiffness is that of treads, normal and tangential; their damping is proportional to its
/// square root, so that the share of critical damping stays.
RunCase varied(RunCase run, const Variant& variant);

}  // namespace gurney::study
