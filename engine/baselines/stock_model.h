#pragma once

#include <vector>

#include "engine/scene/scene.h"
#include "engine/solver/loads.h"
#include "engine/solver/mechanism.h"
#include "engine/solver/state.h"

namespace gurney::baselines {

/// One item on the floor in a world of stock Bullet.
class StockModel {
 public:
  virtual ~StockModel() = default;

  virtual void place(const State& state) = 0;

  /// One step of Bullet.
  /// @param duration  > 0 [s]
  /// @param gravity   mean over the step, less the floor's acceleration [m/s2]
  /// @param rows      loads on the chassis, constant over the step
  virtual void step(double duration, const Vector3& gravity, const std::vector<Loads::Row>& rows,
                    const State& before, State& after) = 0;

  /// Vertical force of the floor on each wheel in the last step [N].
  virtual const std::vector<double>& normal_forces() const = 0;
};

}  // namespace gurney::baselines
