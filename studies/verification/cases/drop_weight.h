#pragma once

#include "studies/verification/check.h"
#include "studies/verification/scenes/scenes.h"

/// The pulling rig of Xu, Ma & Kurata 2022: blocks hold the trolley (phase I), a weight m_d on a
/// cable over a pulley pulls it (II) until it lands, and the trolley coasts (III). String
/// potentiometers pull back on the trolley (F_s) and up on the weight (F_w).
namespace gurney::verification::rig {

constexpr double kReleaseTime = 0.5;     // [s]
constexpr double kCableStiffness = 1e7;  // [N/m]
constexpr double kPullHeight = 0.618;    // of the cable [m]

struct Rig {
  double weight, drop, resistance;  ///< m_d [kg], [m], Cr / R
  double trolley_string = 0, weight_string = 0;
  double pulley_inertia = 0;
  double block_height = kPullHeight;  ///< where the blocks hold
  double mass = 96.5;
};

EquipmentModel pulled_trolley(const Rig& rig, double normal_stiffness);
std::vector<Load> rigged(const Rig& rig);

/// The rigid train of trolley, cable, pulley and weight, t since the release.
struct Exact {
  double pulley, resistance;  ///< I_p / r_p^2 [kg], f_r [N]
  double a1, a2, tension, landing, velocity, distance, stop;

  Exact(const Rig& rig, const EquipmentModel& item);
  double displacement(double t) const;
  double speed(double t) const;
};

}  // namespace gurney::verification::rig
