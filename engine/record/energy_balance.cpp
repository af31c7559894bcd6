#include "engine/record/energy_balance.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace gurney {
namespace {

/// Energies that can only grow. Sliding, relaxation and damping are parts of what one patch takes: a damped
/// deflection that rolls out of it gives to one part what it takes from another.
std::array<double, 6> losses(const EnergyAccount& e) {
  return {e.rolling_loss, e.sliding_loss + e.relaxation_loss + e.tread_loss,
          e.axle_loss,    e.swivel_loss,
          e.damper_loss,  e.contact_loss};
}

}  // namespace

void EnergyBalance::observe(const EnergyAccount& now) {
  largest_energy_ = std::max({largest_energy_, now.kinetic, std::abs(now.work()), now.loss(),
                              std::abs(now.weight_energy), now.elastic});
  // A number that is none misses any balance; std::max would pass over it.
  const double closure = std::abs(now.closure(stored_at_start_));
  largest_closure_ = std::isfinite(closure) ? std::max(largest_closure_, closure)
                                            : std::numeric_limits<double>::infinity();
  const auto then = losses(before_), here = losses(now);
  for (std::size_t i = 0; i < here.size(); ++i) given_back_ += std::max(then[i] - here[i], 0.0);
  before_ = now;
}

double EnergyBalance::error() const {
  return std::max({closure(), share(given_back_), -numerical_loss()});
}

std::string EnergyBalance::source() const {
  if (error() == closure()) return "its terms do not close (energy closure)";
  if (error() == -numerical_loss())
    return fmt::format("the time integration added energy (numerical loss {:.2g})",
                       numerical_loss());
  return "losses, which can only grow, gave energy back";
}

}  // namespace gurney
