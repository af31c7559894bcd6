#pragma once

#include <cmath>
#include <string>

#include "engine/response/energy_account.h"

namespace gurney {

/// Error of the energy balance of one item, over the largest energy in play.
class EnergyBalance {
 public:
  /// Runs that miss more are untrusted. An energy that is off by 5 % moves a peak speed by 2.5 %
  /// and a run-out distance by 5 %, as much as a demand may depend on the time step
  /// (docs/theory/solver.md).
  static constexpr double kTrusted = 0.05;

  /// @param least  smaller energies in play count as this [J]
  explicit EnergyBalance(double stored_at_start = 0, double least = 0)
      : stored_at_start_(stored_at_start), largest_energy_(least) {}

  void observe(const EnergyAccount& now);

  /// Largest |closure| over the largest energy (stored, work or loss); infinite once a term is no number [-].
  double closure() const { return share(largest_closure_); }
  double numerical_loss() const { return share(before_.numerical_loss); }
  /// Energy without a source: the closure, what irreversible losses gave back, or what the
  /// integration added at the end, whichever is largest [-].
  double error() const;
  /// Which of these the error is, in words.
  std::string source() const;

 private:
  double share(double energy) const {
    if (std::isinf(energy)) return energy;
    return largest_energy_ > 0 ? energy / largest_energy_ : 0;
  }

  double stored_at_start_;
  EnergyAccount before_;
  double largest_energy_, largest_closure_ = 0;
  double given_back_ = 0;  // by losses, which only grow
};

}  // namespace gurney
