#pragma once

#include <vector>

#include "engine/response/response.h"
#include "engine/solver/stepper.h"

namespace gurney {

/// How far each part moved on its joint, when its latch let go, and how hard it met its stops.
class JointLog {
 public:
  JointLog(const Assembly& assembly, const SceneState& at_start);

  void observe(const Stepper::Step& step);

  /// Demands of parts: Demands::peak_travel and what follows it.
  void finish(std::vector<ItemResponse>& items) const;

 private:
  struct Course {
    double peak = 0, residual = 0;  ///< of travel or swing
    double released_at = -1;
    double stop_speed = 0;
  };

  const Assembly& assembly_;
  std::vector<Course> courses_;
};

}  // namespace gurney
