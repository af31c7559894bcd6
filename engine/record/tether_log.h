#pragma once

#include <vector>

#include "engine/response/response.h"
#include "engine/solver/stepper.h"

namespace gurney {

/// When each tether got taut, how hard it pulled and when it broke.
class TetherLog {
 public:
  TetherLog(const Assembly& assembly, std::size_t tethers)
      : assembly_(assembly), outcomes_(tethers) {}

  void observe(const Stepper::Step& step);
  const std::vector<TetherOutcome>& outcomes() const { return outcomes_; }

 private:
  const Assembly& assembly_;
  std::vector<TetherOutcome> outcomes_;
};

}  // namespace gurney
