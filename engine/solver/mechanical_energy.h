#pragma once

#include <vector>

#include "engine/solver/mechanism.h"

namespace gurney {

/// Energies of one item at a state [J].
struct MechanicalEnergy {
  double kinetic = 0;
  double gravitational = 0;  ///< any constant origin
  double elastic = 0;        ///< in treads, stuck bearings, springs and cables
};

/// Evaluates them, four casters side by side.
class MechanicalEnergies {
 public:
  explicit MechanicalEnergies(const Mechanism& mechanism);

  MechanicalEnergy at(const State& state) const;

 private:
  /// Lanes beyond the last caster are zero.
  struct Casters {
    std::size_t first, count;
    CasterConstants<Lanes> body;
    TreadConstants<Lanes> tread;
    Lanes swivel_stiffness{}, axle_stiffness{};
  };
  void add(const Casters& casters, const State& state, const Pose& pose,
           MechanicalEnergy& energy) const;

  const Mechanism& mechanism_;
  std::vector<Casters> casters_;
};

}  // namespace gurney
