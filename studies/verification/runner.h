#pragma once

#include "engine/run/run.h"
#include "studies/verification/check.h"

namespace gurney::verification {

/// Runs the scenes of a case with one solver.
class Runner {
 public:
  explicit Runner(Solver solver = Solver::kImplicit) : solver_(solver) {}

  /// run() with this solver. A run that diverges, or steps of our solver that do not converge,
  /// are checks that fail.
  Response operator()(Findings& findings, const Scene& scene, const FloorMotion& floor,
                      const SimulationSettings& settings) const;

  /// Stock Bullet knows no fixtures (engine/baselines/stock_baseline.h): a case leaves them out.
  bool stock() const { return solver_ != Solver::kImplicit; }

 private:
  Solver solver_;
};

}  // namespace gurney::verification
