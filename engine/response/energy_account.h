#pragma once

namespace gurney {

/// The energy balance since the start [J]. In the floor's frame the floor's inertia does work and
/// gravity is constant. Every entry is computed from its own force and velocity; `closure()` is
/// what they miss.
struct EnergyAccount {
  double kinetic = 0;
  double gravitational = 0;  ///< relative to the start
  double elastic = 0;        ///< stored in treads, stuck bearings, guides, blocks, cables
  double weight_energy = 0;  ///< kinetic and gravitational energy of drop weights and pulleys

  /// Work of the floor's inertia forces and of gravity that its rotation tilts.
  double work_of_floor = 0;
  double work_of_forces = 0;    ///< of point forces and string potentiometers
  double work_of_fixtures = 0;  ///< of guides with prescribed motion and guides that hold
  /// Work of contacts between items, at the later item's side: what it gives, the earlier one takes. And what springs
  /// between the two take while one rides on the other.
  double work_of_neighbours = 0;
  double rolling_loss = 0;     ///< rolling resistance, W_R
  double sliding_loss = 0;     ///< sliding and scrub of the patch
  double relaxation_loss = 0;  ///< deflection that rolls out of the patch
  double tread_loss = 0;       ///< damping of the treads, normal and tangential
  double axle_loss = 0;        ///< axle bearings and brakes
  double swivel_loss = 0;      ///< swivel bearings and locks
  double damper_loss = 0;      ///< dampers of guides, blocks and cables; weights that land
  double contact_loss = 0;     ///< bodies in contact with other things than wheels with the floor
  /// Dissipated by the integrator, from its own formula, and by joints whose constraints it missed.
  double numerical_loss = 0;

  double stored() const { return kinetic + gravitational + elastic + weight_energy; }
  double work() const {
    return work_of_floor + work_of_forces + work_of_fixtures + work_of_neighbours;
  }
  double loss() const;
  /// stored now - stored at the start - work + loss: zero for a perfect account [J].
  double closure(double stored_at_start) const {
    return stored() - stored_at_start - work() + loss();
  }
};

}  // namespace gurney
